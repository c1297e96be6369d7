// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases of systems in n-space in every number type, and the cross-checks of Chuang and
// Hoffmann: Theorem 3, Corollary 5, and the table of the appendix.

#include "oracle_ladder.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Surfaces/N_space_cross_checks.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

namespace {

using namespace oracles;
using testing_shapes::Random;

N_space_surface_3 surface_of(const Case& c)
{
  std::vector<Expression> equations;
  for (const std::string& f : c.inputs.texts("equations"))
    equations.push_back(parse_expression(f, c.inputs.texts("vars")));
  return N_space_surface_3(N_space_system(c.inputs.texts("vars"), equations));
}

struct System_cases
{
  static constexpr const char* name = "nspace_curvature";
  static constexpr int number = 32;

  template <class Run>
  static void for_each(Run run)
  {
    for (const Case& c : cases(name))
    {
      const Texts& p = c.inputs.texts("point");
      if (has_root(p))
        run(c, surface_of(c), numbers<Quadratic_field>(p));
      else
        run(c, surface_of(c), numbers<Q>(p));
    }
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Oracles_nspace_curvature, Surface_cases, System_cases);

template <class NT>
Coordinates<NT, 3> projected(const std::vector<NT>& v)
{
  return {v[0], v[1], v[2]};
}

template <class NT>
void expect_direction(const Case& c, const Local_shape_3<NT>& s)
{
  if (!c.inputs.has("direction"))
    return;
  const auto v = projected(numbers<NT>(c.inputs.texts("direction")));
  EXPECT_FALSE(refuse_direction(s, v));
  const NT kappa = number<NT>(c.expected.text("kappa_direction_hartmann"));
  EXPECT_EQ(kappa, NT(-number<NT>(c.expected.text("kappa_direction_chuang_hoffmann"))));
  EXPECT_EQ(sign_of_normal_curvature(s, v), CGAL::sign(kappa));
  EXPECT_EQ(squared_normal_curvature(s, v), NT(kappa * kappa));
  if (c.expected.has("literal_section_4_kappa_s_const"))
  {
    const NT literal = number<NT>(c.expected.text("literal_section_4_kappa_s_const"));
    EXPECT_NE(squared_normal_curvature(s, v), NT(literal * literal));
  }
}

TEST(Oracles_nspace_curvature, exact)
{
  Count count("nspace_curvature", "exact rationals or one root");
  Surface_cases<System_cases>::visit(count, [&](const Case& c, const N_space_surface_3& surface,
                                                const auto& p, auto) {
    count.run();
    EXPECT_EQ(surface.system().number_of_variables(), c.expected.integer("n"));
    EXPECT_EQ(surface.system().number_of_equations(), c.expected.integer("m"));
    const auto s = surface.shape(p);
    if (c.is_refused())
    {
      expect_refusal(s, c.expected);
      const Refusal_code code = s.refusal().code();
      if (code == Refusal_code::RANK_DEFICIENT || code == Refusal_code::NOT_TWO_DIMENSIONAL)
      {
        EXPECT_NE(s.refusal().evidence().find("rank " + c.expected.text("rank_J") + " of "),
                  std::string::npos)
          << s.refusal().evidence();
      }
      return;
    }
    ASSERT_TRUE(s) << s.refusal().evidence();
    EXPECT_EQ(s->rank, c.expected.integer("rank_J"));
    EXPECT_EQ(int(s->redundant_equations.size()),
              c.expected.integer("m") - c.expected.integer("rank_J"));
    EXPECT_EQ(s->shape.point(), projected(p));
    expect_block(s->shape, c.expected, false);
    expect_direction(c, s->shape);
  });
}

// --- Theorem 3 and Corollary 5 -------------------------------------------------------------------

// The three ways to one normal curvature, in random tangent directions.
template <class NT>
void expect_agreement(const N_space_surface_3& surface, const std::vector<NT>& p, Random& random)
{
  const auto s = surface.shape(p);
  ASSERT_TRUE(s) << s.refusal().evidence();
  const Combined_hessian<NT> hessian(surface.system(), p, s->multipliers);
  for (int round = 0; round < 3; ++round)
  {
    const NT a(random.integer(-9, 9)), b(random.integer(1, 9));
    std::vector<NT> v;
    for (std::size_t i = 0; i < p.size(); ++i)
      v.push_back(NT(a * s->tangent_basis[0][i] + b * s->tangent_basis[1][i]));
    const auto w = projected(v);
    const NT expected = second_form(s->shape, w, w) /
                        (s->shape.form_denominator() * internal::dot(w, w));
    EXPECT_EQ(hessian.scaled_normal_curvature(v), expected) << "Corollary 5";
    const auto k = normal_curvature_by_shape_operators(surface.system(), p, v);
    ASSERT_TRUE(k) << k.refusal().evidence();
    // The normals are parallel, with any factor mu.
    const auto cross = internal::cross(k->normal, s->shape.normal());
    EXPECT_TRUE(CGAL::is_zero(internal::dot(cross, cross)));
    const NT mu = internal::dot(k->normal, s->shape.normal()) / s->shape.normal_squared_length();
    EXPECT_EQ(k->scaled_curvature, NT(mu * expected)) << "Theorem 3";
  }
}

TEST(N_space_cross_checks, agree_on_all_oracles)
{
  Random random(4711);
  int checked = 0;
  System_cases::for_each([&](const Case& c, const N_space_surface_3& surface, const auto& p) {
    if (c.is_refused())
      return;
    SCOPED_TRACE(c.id);
    ++checked;
    expect_agreement(surface, p, random);
  });
  EXPECT_EQ(checked, 24);
  std::cout << "counts: Theorem 3 and Corollary 5: " << checked
            << " cases, 3 directions each, agree exactly (seed 4711)\n";
}

TEST(N_space_cross_checks, refusals)
{
  const Case c = cases("nspace_curvature")[3]; // a system in 7 variables
  ASSERT_EQ(c.id, "NS-05");
  const auto surface = surface_of(c);
  const auto p = numbers<Q>(c.inputs.texts("point"));
  std::vector<Q> v(7, Q(0));
  const auto zero = normal_curvature_by_shape_operators(surface.system(), p, v);
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.refusal().code(), Refusal_code::DEPENDENT_DIRECTIONS);
  v[0] = 1;
  const auto skew = normal_curvature_by_shape_operators(surface.system(), p, v);
  ASSERT_FALSE(skew);
  EXPECT_EQ(skew.refusal().code(), Refusal_code::NOT_TANGENT);
}

// --- Systems with an order of elimination and an orientation of their own ------------------------

TEST(N_space_system, order_of_elimination_chosen_once_gives_the_same)
{
  int prepared = 0;
  System_cases::for_each([&](const Case& c, const N_space_surface_3& surface, const auto& p) {
    SCOPED_TRACE(c.id);
    N_space_system system = surface.system();
    const bool has_rank = c.expected.integer("rank_J") == c.expected.integer("n") - 2;
    EXPECT_EQ(system.prepare(p), has_rank);
    prepared += has_rank;
    const auto s = N_space_surface_3(system)(p);
    if (c.is_refused())
      return expect_refusal(s, c.expected);
    ASSERT_TRUE(s) << s.refusal().evidence();
    expect_block(*s, c.expected, false);
  });
  EXPECT_GE(prepared, 24);
}

TEST(N_space_system, order_of_another_point_gives_the_same)
{
  // The gradients at the sample have their pivots elsewhere, or vanish at the point.
  const std::vector<std::string> names{"x", "y", "z", "u", "v"};
  std::vector<Expression> equations;
  for (const char* f : {"x*u + y*v - 1", "u^2 + v^2 - x^2 - y^2", "z - u*v"})
    equations.push_back(parse_expression(f, names));
  const std::vector<std::vector<Q>> points{{Q(1), Q(0), Q(0), Q(1), Q(0)},
                                           {Q(0), Q(1), Q(0), Q(0), Q(1)},
                                           {Q(0), Q(-1), Q(0), Q(0), Q(-1)}};
  const N_space_surface_3 plain(N_space_system(names, equations));
  for (const auto& sample : points)
  {
    N_space_system system(names, equations);
    EXPECT_TRUE(system.prepare(sample));
    for (const auto& p : points)
    {
      const auto s = plain(p), t = N_space_surface_3(system)(p);
      ASSERT_TRUE(s && t) << (t ? s : t).refusal().evidence();
      EXPECT_EQ(gaussian_curvature(*s), gaussian_curvature(*t));
      EXPECT_EQ(squared_mean_curvature(*s), squared_mean_curvature(*t));
      EXPECT_EQ(sign_of_mean_curvature(*s), sign_of_mean_curvature(*t));
      EXPECT_TRUE(CGAL::is_zero(internal::cross(s->normal(), t->normal())[2]));
    }
  }
}

TEST(N_space_system, point_with_other_coordinates_than_variables_is_refused)
{
  System_cases::for_each([&](const Case& c, const N_space_surface_3& surface, auto p) {
    SCOPED_TRACE(c.id);
    N_space_system system = surface.system();
    p.pop_back();
    EXPECT_FALSE(system.prepare(p));
    const auto s = surface(p);
    ASSERT_FALSE(s);
    EXPECT_EQ(s.refusal().code(), Refusal_code::NOT_ON_SOLUTION);
  });
}

TEST(N_space_system, orientation_chooses_the_normal)
{
  int checked = 0;
  System_cases::for_each([&](const Case& c, const N_space_surface_3& surface, const auto& p) {
    if (c.is_refused() || has_root(c.expected.texts("N")))
      return;
    SCOPED_TRACE(c.id);
    ++checked;
    for (const int sign : {1, -1})
    {
      auto direction = point<Q, 3>(c.expected.texts("N"));
      for (Q& x : direction)
        x *= sign;
      N_space_system system = surface.system();
      system.set_orientation(direction);
      const auto s = N_space_surface_3(system)(p);
      ASSERT_TRUE(s) << s.refusal().evidence();
      EXPECT_EQ(int(sign_of_mean_curvature(*s)), sign * c.expected.integer("sign_H"));
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(int(CGAL::sign(s->normal()[i])), int(CGAL::sign(direction[i])));
    }
  });
  EXPECT_GE(checked, 20);
}

// --- The table of the appendix -------------------------------------------------------------------

const char* const entry_names[] = {"alpha_1", "alpha_2", "alpha_3", "alpha_4", "alpha_5",
                                   "alpha_6", "alpha_7", "alpha_8", "alpha_9", "alpha_0"};

// As printed, for the equations with cleared denominators.
const double printed_entries[] = {0.2776737, 0.3038138, 0.2372107, 0.4158092, 0.8316184,
                                  0.5553474, 0.4770799, 0.5641258, 1.4232639, 1.7147960};

Case appendix(const std::string& id)
{
  for (const Case& c : cases("nspace_curvature"))
    if (c.id == id)
      return c;
  throw std::runtime_error("no case " + id);
}

// H_0 for the unit normal, which is no longer in the quadratic field.
struct Unit_hessian
{
  Combined_hessian<Quadratic_field> matrix;
  Real length;

  explicit Unit_hessian(const Case& c) : Unit_hessian(c, surface_of(c)) {}

  Real operator()(int i, int j) const { return number_cast<Real>(matrix(i - 1, j - 1)) / length; }

private:
  Unit_hessian(const Case& c, const N_space_surface_3& surface)
    : Unit_hessian(surface, numbers<Quadratic_field>(c.inputs.texts("point")))
  {}
  Unit_hessian(const N_space_surface_3& surface, const std::vector<Quadratic_field>& p)
    : Unit_hessian(surface, p, *surface.shape(p))
  {}
  Unit_hessian(const N_space_surface_3& surface, const std::vector<Quadratic_field>& p,
               const N_space_shape_3<Quadratic_field>& s)
    : matrix(surface.system(), p, s.multipliers),
      length(CGAL::sqrt(number_cast<Real>(s.shape.normal_squared_length())))
  {}
};

void expect_table(const std::string& id)
{
  SCOPED_TRACE(id);
  const Case c = appendix(id);
  const Unit_hessian h(c);
  for (const std::string name : entry_names)
  {
    const Texts& place = c.expected.texts("H0_entries_positions." + name);
    const Real value = number<Real>(c.expected.text("H0_entries_for_unit_normal." + name));
    const bool negated = name == "alpha_2" || name == "alpha_3";
    EXPECT_EQ(h(std::stoi(place[0]), std::stoi(place[1])), negated ? Real(-value) : value) << name;
  }
}

TEST(Appendix_of_chuang_hoffmann, table_of_each_form_of_the_equations)
{
  expect_table("NS-01");
  expect_table("NS-02");
}

TEST(Appendix_of_chuang_hoffmann, whole_matrix_as_printed)
{
  const Unit_hessian h(appendix("NS-02"));
  ASSERT_EQ(h.matrix.dimension(), 16);
  // Place, entry of the table, sign: the upper triangle, everything else is zero.
  const int pattern[][4] = {{4, 14, 1, -1},  {6, 7, 0, -1},  {6, 14, 2, -1}, {7, 7, 3, 1},
                            {7, 9, 0, 1},    {7, 16, 4, -1}, {8, 8, 3, 1},   {9, 16, 5, -1},
                            {10, 14, 6, 1},  {10, 16, 4, 1}, {12, 14, 7, 1}, {12, 16, 5, 1},
                            {13, 13, 8, 1},  {14, 14, 9, 1}};
  double expected[17][17] = {};
  for (const auto& [i, j, entry, sign] : pattern)
    expected[i][j] = expected[j][i] = sign * printed_entries[entry];
  for (int i = 1; i <= 16; ++i)
    for (int j = 1; j <= 16; ++j)
      if (expected[i][j] == 0)
        EXPECT_TRUE(CGAL::is_zero(h.matrix(i - 1, j - 1))) << i << " " << j;
      else
        EXPECT_NEAR(CGAL::to_double(h(i, j)), expected[i][j], 5.1e-8) << i << " " << j;
}

TEST(Appendix_of_chuang_hoffmann, printed_equations_give_other_entries)
{
  const Unit_hessian h(appendix("NS-01"));
  EXPECT_NEAR(CGAL::to_double(h(10, 14)), 0.3038138, 5.1e-8);
  EXPECT_NEAR(CGAL::to_double(h(12, 14)), 0.2372107, 5.1e-8);
  EXPECT_NEAR(CGAL::to_double(h(14, 14)), 1.0527417, 5.1e-8);
}

TEST(Appendix_of_chuang_hoffmann, ruling_is_asymptotic)
{
  for (const char* id : {"NS-01", "NS-02"})
  {
    const Case c = appendix(id);
    const Unit_hessian h(c);
    const auto v = numbers<Quadratic_field>(c.inputs.texts("direction"));
    EXPECT_TRUE(CGAL::is_zero(h.matrix.form(v))) << id;
    const auto s = surface_of(c)(numbers<Quadratic_field>(c.inputs.texts("point")));
    ASSERT_TRUE(s);
    EXPECT_NEAR(CGAL::to_double(mean_curvature(s->cast<Real>())), 0.232971325, 5e-10);
  }
}

} // namespace
