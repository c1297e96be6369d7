// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases about fundamental forms in every number type: three tangents, asymptotic
// directions, Dupin's indicatrix.

#include "oracle_ladder.h"

#include <CGAL/Shape_interrogation/Analysis/asymptotic_directions.h>
#include <CGAL/Shape_interrogation/Analysis/Dupin_indicatrix.h>
#include <CGAL/Shape_interrogation/Analysis/three_tangents.h>

namespace {

using namespace oracles;

template <class NT>
Quadratic_form_2<NT> form(const Fields& fields, const std::string& name)
{
  const std::vector<NT> x = numbers<NT>(fields.texts(name));
  return {x.at(0), x.at(1), x.at(2)};
}

template <class NT>
bool is_same(const Quadratic_form_2<NT>& a, const Quadratic_form_2<NT>& b)
{
  return bool((a - b).is_zero());
}

// In intervals a decision may throw instead of being made; this is how often.
template <class Decision>
void try_to_decide(Count& count, Decision decision)
{
  try
  {
    decision();
    count.decide(true);
  }
  catch (const CGAL::Uncertain_conversion_exception&) { count.decide(false); }
}

// Runs all cases of a kind in all number types.
template <class Kind>
void run_kind(int number)
{
  Counts counts(Kind::name);
  for (const Case& c : cases(Kind::name))
  {
    SCOPED_TRACE(c.id);
    EXPECT_FALSE(c.is_refused());
    counts.exact.run();
    Kind::template run<Q>(c);
    counts.one_root.run();
    Kind::template run<Quadratic_field>(c);
    counts.real.run();
    Kind::template run<Real>(c);
    counts.filtered.run();
    Kind::run_filtered(c);
    Kind::run_numerically(c, counts);
  }
  counts.expect_visited(number);
}

// --- Three tangents ------------------------------------------------------------------------------

template <class NT>
std::array<Coordinates<NT, 2>, 3> tangents(const Case& c)
{
  const std::vector<NT> t = numbers<NT>(c.inputs.texts("directions"));
  return {Coordinates<NT, 2>{t[0], t[1]}, Coordinates<NT, 2>{t[2], t[3]},
          Coordinates<NT, 2>{t[4], t[5]}};
}

template <class NT>
std::array<NT, 3> curvatures(const Quadratic_form_2<NT>& first, const Quadratic_form_2<NT>& second,
                             const std::array<Coordinates<NT, 2>, 3>& t)
{
  const Fundamental_forms<NT> forms{first, second};
  return {forms.normal_curvature(t[0]), forms.normal_curvature(t[1]),
          forms.normal_curvature(t[2])};
}

template <class NT>
bool are_pairwise_independent(const std::array<Coordinates<NT, 2>, 3>& t)
{
  for (int i = 0; i < 3; ++i)
    if (CGAL::is_zero(internal::cross(t[i], t[(i + 1) % 3])))
      return false;
  return true;
}

template <class NT>
void expect_second_surface(const Case& c, const std::array<NT, 3>& kappa)
{
  const auto second = form<NT>(c.inputs, "II2");
  const auto kappa_2 = curvatures(form<NT>(c.inputs, "I"), second, tangents<NT>(c));
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(kappa_2[i], number<NT>(c.expected.texts("normal_curvatures_2").at(i)));
    EXPECT_EQ(kappa[i] == kappa_2[i], c.expected.texts("agree_in_directions").at(i) == "true");
  }
  EXPECT_EQ(is_same(form<NT>(c.inputs, "II1"), second),
            c.expected.flag("equal_for_all_directions"));
}

template <class NT>
void run_three_tangents(const Case& c)
{
  const auto first = form<NT>(c.inputs, "I"), second = form<NT>(c.inputs, "II1");
  const auto t = tangents<NT>(c);
  EXPECT_EQ(three_tangents_determinant(t), number<NT>(c.expected.text("det_L")));
  EXPECT_EQ(are_pairwise_independent(t), c.expected.flag("pairwise_independent"));
  const auto kappa = curvatures(first, second, t);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(kappa[i], number<NT>(c.expected.texts("normal_curvatures_1").at(i)));
  const auto solution = second_form_from_three_tangents(first, t, kappa);
  ASSERT_EQ(bool(solution), c.expected.flag("determined"));
  if (solution)
    EXPECT_TRUE(is_same(*solution, form<NT>(c.expected, "II_reconstructed")));
  else
    EXPECT_EQ(solution.refusal().code(), Refusal_code::DEPENDENT_DIRECTIONS);
  if (c.inputs.has("II2"))
    expect_second_surface(c, kappa);
}

struct Decide_determined
{
  template <class NT>
  auto operator()(const std::array<Coordinates<NT, 2>, 3>& t) const
  {
    return !is_zero_decision(three_tangents_determinant(t));
  }
};

// The second form from the curvatures that it has itself.
template <class NT>
Result<Quadratic_form_2<NT>> reconstruct(const Case& c)
{
  const auto t = tangents<NT>(c);
  const auto first = form<NT>(c.inputs, "I");
  const auto kappa = curvatures(first, form<NT>(c.inputs, "II1"), t);
  return second_form_from_three_tangents(first, t, kappa);
}

Result<Quadratic_form_2<Interval>> reconstruct_in_intervals(const Case& c)
{
  const Interval::Protector protector;
  return reconstruct<Interval>(c);
}

void run_three_tangents_numerically(const Case& c, Counts& counts)
{
  const auto enclosed = reconstruct_in_intervals(c);
  counts.interval.run();
  counts.interval.decide(enclosed || !is_no_claim(enclosed.refusal()));
  if (!enclosed)
  {
    EXPECT_TRUE(is_no_claim(enclosed.refusal()) || !c.expected.flag("determined"));
    return counts.approximate.skip(c.id, "the directions are dependent, or nearly");
  }
  ASSERT_TRUE(c.expected.flag("determined"));
  const auto truth = form<Q>(c.expected, "II_reconstructed");
  EXPECT_TRUE(contains(enclosed->l, truth.l) && contains(enclosed->m, truth.m) &&
              contains(enclosed->n, truth.n));
  const auto near = reconstruct<double>(c);
  counts.approximate.run();
  ASSERT_TRUE(near);
  expect_near(near->l, enclosed->l, number_cast<Real>(truth.l), "L", counts.approximate);
  expect_near(near->m, enclosed->m, number_cast<Real>(truth.m), "M", counts.approximate);
  expect_near(near->n, enclosed->n, number_cast<Real>(truth.n), "N", counts.approximate);
}

struct Three_tangents
{
  static constexpr const char* name = "three_tangents";

  template <class NT>
  static void run(const Case& c) { run_three_tangents<NT>(c); }
  static void run_filtered(const Case& c)
  {
    EXPECT_EQ(Filtered<Decide_determined>()(tangents<Q>(c)), c.expected.flag("determined"));
  }
  static void run_numerically(const Case& c, Counts& counts)
  {
    run_three_tangents_numerically(c, counts);
  }
};

TEST(Oracles_three_tangents, all_number_types) { run_kind<Three_tangents>(4); }

// --- Asymptotic directions -----------------------------------------------------------------------

const char* name_of(Asymptotic_type type)
{
  static const char* const names[] = {"real_distinct", "real_double", "complex", "all"};
  return names[static_cast<int>(type)];
}

// A complex direction (re + i im, y), as in the cases.
struct Direction
{
  Real re, im, y;
};

template <class NT>
std::vector<Direction> directions(const Asymptotic_directions<NT>& a)
{
  const Real x = number_cast<Real>(a.x), y = number_cast<Real>(a.y);
  const Real d = number_cast<Real>(a.discriminant);
  if (a.type == Asymptotic_type::ALL)
    return {};
  if (a.type == Asymptotic_type::REAL_DOUBLE)
    return {{x, 0, y}};
  if (a.type == Asymptotic_type::COMPLEX)
    return {{x, CGAL::sqrt(-d), y}, {x, -CGAL::sqrt(-d), y}};
  if (a.x_is_single)
    return {{1, 0, 0}, {x, 0, y}};
  return {{x + CGAL::sqrt(d), 0, y}, {x - CGAL::sqrt(d), 0, y}};
}

template <class NT>
void expect_directions(const Asymptotic_directions<NT>& a, const Texts& expected)
{
  const std::vector<Direction> found = directions(a);
  if (a.type == Asymptotic_type::ALL)
  {
    EXPECT_EQ(expected, Texts{"null"});
    return;
  }
  ASSERT_EQ(3 * found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    // Members in alphabetical order: a, a_im, b. Directions are equal up to a factor.
    const Real re = number<Real>(expected[3 * i]), im = number<Real>(expected[3 * i + 1]),
               y = number<Real>(expected[3 * i + 2]);
    EXPECT_EQ(re * found[i].y, found[i].re * y);
    EXPECT_EQ(im * found[i].y, found[i].im * y);
    EXPECT_FALSE(CGAL::is_zero(found[i].y) && CGAL::is_zero(found[i].re));
  }
}

template <class NT>
void expect_corollary(const Case& c, const Quadratic_form_2<NT>& a)
{
  const auto b = form<NT>(c.inputs, "II2");
  const auto t = point<NT, 2>(c.inputs.texts("curve_tangent"));
  const bool agree = a(t) == b(t);
  EXPECT_EQ(agree, c.expected.flag("forms_agree_on_curve_tangent"));
  EXPECT_EQ(bool(have_common_asymptotic_direction(a, b)),
            c.expected.flag("shares_asymptotic_direction_over_C"));
  const bool transversal = have_transversal_asymptotic_direction(a, b, t);
  EXPECT_EQ(transversal, c.expected.flag("shared_direction_transversal_to_curve"));
  EXPECT_EQ(agree && transversal, c.expected.flag("corollary_applies"));
  EXPECT_EQ(is_same(a, b), c.expected.flag("second_forms_equal"));
}

template <class NT>
void run_asymptotic(const Case& c)
{
  const Fundamental_forms<NT> forms{form<NT>(c.inputs, "I"), form<NT>(c.inputs, "II1")};
  const auto a = asymptotic_directions(forms.second);
  EXPECT_EQ(name_of(a.type), c.expected.text("type"));
  EXPECT_EQ(a.discriminant, number<NT>(c.expected.text("discriminant")));
  expect_directions(a, c.expected.texts("directions"));
  if (c.expected.has("asymptotic_directions_isotropic"))
  {
    EXPECT_EQ(bool(are_asymptotic_directions_isotropic(forms)),
              c.expected.flag("asymptotic_directions_isotropic"));
  }
  if (c.inputs.has("II2"))
    expect_corollary(c, forms.second);
}

struct Decide_asymptotic_type
{
  template <class NT>
  Asymptotic_type operator()(const std::vector<NT>& x) const
  {
    return asymptotic_directions(Quadratic_form_2<NT>{x[0], x[1], x[2]}).type;
  }
};

void run_asymptotic_numerically(const Case& c, Counts& counts)
{
  counts.interval.run();
  Interval discriminant;
  try_to_decide(counts.interval, [&] {
    const Interval::Protector protector;
    const auto second = form<Interval>(c.inputs, "II1");
    discriminant = -second.determinant();
    EXPECT_EQ(name_of(asymptotic_directions(second).type), c.expected.text("type"));
  });
  EXPECT_TRUE(contains(discriminant, number<Q>(c.expected.text("discriminant"))));
  if (!CGAL::certainly(discriminant == 0) && CGAL::possibly(discriminant == 0))
    return counts.approximate.skip(c.id,
                                   "ill conditioned, the interval does not decide the type");
  counts.approximate.run();
  EXPECT_EQ(name_of(asymptotic_directions(form<double>(c.inputs, "II1")).type),
            c.expected.text("type"));
}

struct Asymptotic
{
  static constexpr const char* name = "asymptotic";

  template <class NT>
  static void run(const Case& c) { run_asymptotic<NT>(c); }
  static void run_filtered(const Case& c)
  {
    const auto second = numbers<Q>(c.inputs.texts("II1"));
    EXPECT_EQ(name_of(Filtered<Decide_asymptotic_type>()(second)), c.expected.text("type"));
  }
  static void run_numerically(const Case& c, Counts& counts)
  {
    run_asymptotic_numerically(c, counts);
  }
};

TEST(Oracles_asymptotic, all_number_types) { run_kind<Asymptotic>(9); }

// --- Dupin's indicatrix --------------------------------------------------------------------------

const char* name_of(Dupin_type type)
{
  static const char* const names[] = {"ellipse", "two conjugate hyperbolas", "two parallel lines",
                                      "empty"};
  return names[static_cast<int>(type)];
}

template <class NT>
Fundamental_forms<NT> dupin_forms(const Case& c)
{
  return {form<NT>(c.inputs, "I"), form<NT>(c.inputs, "II")};
}

template <class NT>
void expect_lines(const Dupin_indicatrix<NT>& d, const Fundamental_forms<NT>& forms,
                  const Fields& e)
{
  const auto v = point<NT, 2>(e.texts("line_direction_is_null_curvature_direction"));
  ASSERT_TRUE(d.line_direction);
  EXPECT_TRUE(CGAL::is_zero(internal::cross(*d.line_direction, v)));
  EXPECT_FALSE(CGAL::is_zero(internal::dot(*d.line_direction, *d.line_direction)));
  EXPECT_EQ(squared_half_distance_of_lines(forms), number<NT>(e.text("half_distance_sq")));
}

template <class NT>
void run_dupin(const Case& c)
{
  const auto forms = dupin_forms<NT>(c);
  const auto d = dupin_indicatrix(forms);
  const Fields& e = c.expected;
  EXPECT_EQ(name_of(d.type), e.text("type"));
  EXPECT_EQ(d.is_circle, e.flag("circle"));
  EXPECT_EQ(forms.gaussian_curvature(), number<NT>(e.text("K")));
  EXPECT_EQ(forms.mean_curvature(), number<NT>(e.text("mean_H")));
  const Real h = number_cast<Real>(forms.mean_curvature());
  const Real root = CGAL::sqrt(h * h - number_cast<Real>(forms.gaussian_curvature()));
  EXPECT_EQ(h - root, number<Real>(e.text("kappa_min")));
  EXPECT_EQ(h + root, number<Real>(e.text("kappa_max")));
  const std::string side = e.text("right_hand_side");
  EXPECT_EQ(d.right_hand_side, side == "1" ? 1 : side == "-1" ? -1 : 0);
  EXPECT_EQ(d.line_direction.has_value(), e.has("half_distance_sq"));
  if (e.has("half_distance_sq"))
    expect_lines(d, forms, e);
  if (c.inputs.has("II2"))
  {
    const auto second = form<NT>(c.inputs, "II2");
    const auto other = dupin_indicatrix(Fundamental_forms<NT>{forms.first, second});
    EXPECT_EQ(is_same_point_set(d, other), e.flag("same_indicatrix_point_set"));
    EXPECT_EQ(is_same(forms.second, second), e.flag("same_second_form"));
  }
}

struct Decide_dupin_type
{
  template <class NT>
  Dupin_type operator()(const std::vector<NT>& x, const std::vector<NT>& y) const
  {
    return dupin_indicatrix(Fundamental_forms<NT>{{x[0], x[1], x[2]}, {y[0], y[1], y[2]}}).type;
  }
};

void run_dupin_numerically(const Case& c, Counts& counts)
{
  counts.interval.run();
  Interval k, h;
  try_to_decide(counts.interval, [&] {
    const Interval::Protector protector;
    const auto forms = dupin_forms<Interval>(c);
    k = forms.gaussian_curvature();
    h = forms.mean_curvature();
    EXPECT_EQ(name_of(dupin_indicatrix(forms).type), c.expected.text("type"));
  });
  const Fields& e = c.expected;
  EXPECT_TRUE(contains(k, number<Q>(e.text("K"))));
  EXPECT_TRUE(contains(h, number<Q>(e.text("mean_H"))));
  counts.approximate.run();
  const auto forms = dupin_forms<double>(c);
  EXPECT_EQ(name_of(dupin_indicatrix(forms).type), e.text("type"));
  expect_near(forms.gaussian_curvature(), k, number<Real>(e.text("K")), "K", counts.approximate);
  expect_near(forms.mean_curvature(), h, number<Real>(e.text("mean_H")), "H",
              counts.approximate);
}

struct Dupin
{
  static constexpr const char* name = "dupin";

  template <class NT>
  static void run(const Case& c) { run_dupin<NT>(c); }
  static void run_filtered(const Case& c)
  {
    const Filtered<Decide_dupin_type> decide;
    EXPECT_EQ(name_of(decide(numbers<Q>(c.inputs.texts("I")), numbers<Q>(c.inputs.texts("II")))),
              c.expected.text("type"));
  }
  static void run_numerically(const Case& c, Counts& counts)
  {
    run_dupin_numerically(c, counts);
  }
};

TEST(Oracles_dupin, all_number_types) { run_kind<Dupin>(7); }

} // namespace
