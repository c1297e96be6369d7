// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// What is decided at points that are known by an enclosure only: in double precision, in more bits,
// and with the identities of constraints.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Constraints/directions.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/prove_by_identities.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Constraints/verify_identities.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_refinement.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/decide_at.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;
using Names = std::vector<std::string>;
using Point = std::vector<double>;

N_space_system make_system(const Names& variables, const Names& equations)
{
  std::vector<Expression> expressions;
  for (const std::string& text : equations)
    expressions.push_back(parse_expression(text, variables));
  return N_space_system(variables, expressions);
}

struct Gaussian_sign
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const
  {
    return sign_of_gaussian_curvature(s);
  }
};
struct Mean_sign
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const
  {
    return sign_of_mean_curvature(s);
  }
};
struct Umbilic
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const { return is_umbilic(s); }
};

// --- The side of the normal ----------------------------------------------------------------------

TEST(Unoriented_shape, answers_what_does_not_depend_on_the_side)
{
  // The normal is (0, 0, 1) or (0, 0, -1) at the origin: its first component says nothing.
  const N_space_surface_3 saddle(make_system({"y", "z", "x"}, {"x - 2*y^2 + z^2"}));
  const Interval tiny(-1e-12, 1e-12);
  Interval::Protector protector;
  const std::vector<Interval> box{tiny, tiny, tiny};
  ASSERT_FALSE(saddle(box));
  EXPECT_EQ(saddle(box).refusal().code(), Refusal_code::UNDECIDED);
  const auto s = saddle.unoriented(box);
  ASSERT_TRUE(s) << s.refusal().evidence();
  EXPECT_FALSE(s->is_oriented());
  EXPECT_TRUE(CGAL::certainly(s->ask(Gaussian_sign()) == CGAL::NEGATIVE));
  EXPECT_TRUE(CGAL::certainly(!s->ask(Umbilic())));
  EXPECT_FALSE(s->ask(Mean_sign()).is_certain());
  const auto square = [](const auto& shape) { return squared_mean_curvature(shape); };
  EXPECT_GT(s->ask(square).inf(), 0.99); // H = -+1
  const auto mean = [](const auto& shape) { return mean_curvature(shape); };
  const Interval h = s->ask(mean);
  EXPECT_TRUE(h.inf() <= -1 && h.sup() >= 1 && h.sup() < 1.001);
  // In the direction of y the curvature is -+4, of one sign on each side; never both.
  const auto in_y = [](const auto& shape) {
    using NT = typename std::decay_t<decltype(shape)>::FT;
    return sign_of_normal_curvature(shape, Coordinates<NT, 3>{NT(1), NT(0), NT(0)});
  };
  EXPECT_TRUE(s->ask(in_y).is_certain() == false && CGAL::is_certain(in_y(s->one_side())));
  EXPECT_TRUE(CGAL::is_certain(in_y(s->opposite().one_side())));
}

TEST(Unoriented_shape, is_oriented_where_the_side_is_decided)
{
  N_space_system system = make_system({"y", "z", "x"}, {"x - 2*y^2 + z^2"});
  const N_space_surface_3 plain(system);
  const auto exact = plain.unoriented(std::vector<Q>{Q(0), Q(0), Q(0)});
  ASSERT_TRUE(exact && exact->is_oriented());
  EXPECT_EQ(exact->ask(Mean_sign()), plain(std::vector<Q>{Q(0), Q(0), Q(0)})->trace_numerator() < 0
                                       ? CGAL::NEGATIVE : CGAL::POSITIVE);
  // A direction orients what the first component cannot.
  system.set_orientation({Q(0), Q(1), Q(-3)});
  Interval::Protector protector;
  const std::vector<Interval> box(3, Interval(-1e-12, 1e-12));
  const auto s = N_space_surface_3(system).unoriented(box);
  ASSERT_TRUE(s && s->is_oriented());
  EXPECT_EQ(s->ask(Mean_sign()), s->one_side().trace_numerator().inf() > 0
                                   ? CGAL::Uncertain<CGAL::Sign>(CGAL::POSITIVE)
                                   : CGAL::Uncertain<CGAL::Sign>(CGAL::NEGATIVE));
}

TEST(Answer_union, is_what_both_answers_imply)
{
  using Sign = CGAL::Uncertain<CGAL::Sign>;
  using Union = Answer_union<Result<Sign>>;
  const Result<Sign> plus(CGAL::POSITIVE), zero(CGAL::ZERO);
  const Result<Sign> singular(Refusal(Refusal_code::SINGULAR_POINT, "one"));
  const Result<Sign> pole(Refusal(Refusal_code::POLE, "two"));
  EXPECT_TRUE(CGAL::certainly(*Union::of(plus, plus) == CGAL::POSITIVE));
  EXPECT_EQ(Union::of(plus, zero)->inf(), CGAL::ZERO);
  EXPECT_EQ(Union::of(plus, zero)->sup(), CGAL::POSITIVE);
  EXPECT_EQ(Union::of(pole, pole).refusal().code(), Refusal_code::POLE);
  EXPECT_EQ(Union::of(pole, singular).refusal().code(), Refusal_code::UNDECIDED);
  EXPECT_EQ(Union::of(plus, singular).refusal().code(), Refusal_code::UNDECIDED);
}

// --- The test itself -----------------------------------------------------------------------------

TEST(Krawczyk_operator, proves_no_box_without_the_point)
{
  // The middle is beside the point, and no better one is looked for.
  const N_space_system system =
    make_system({"x", "y", "z", "w"}, {"x^2 + y^2 + z^2 - 1", "w - z^3"});
  const Q third = Q(1) / 3;
  const std::vector<Q> point{Q(2 * third), third, Q(2 * third), Q(8 * third * third * third)};
  int proved = 0;
  for (double off : {1e-2, 1e-3, 1e-4, -1e-5, 1e-6, 1e-9, 1e-15, 0.})
  {
    const Point near{2. / 3, 1. / 3, 2. / 3 + off, 8. / 27 + off};
    internal::Krawczyk_operator krawczyk(system, {0, 1});
    ASSERT_FALSE(krawczyk.linearise(near));
    Interval::Protector protector;
    std::vector<Interval> box;
    if (krawczyk.enclose(near, {number_cast<Interval>(point[0]), number_cast<Interval>(point[1])},
                         box))
      continue;
    ++proved;
    for (int i = 0; i < 4; ++i)
      EXPECT_TRUE(Q(box[i].inf()) <= point[i] && point[i] <= Q(box[i].sup())) << off << ' ' << i;
  }
  EXPECT_GE(proved, 4);
}

// --- More bits -----------------------------------------------------------------------------------

// The saddle z = x^3 - x y^2 + y z as a system with an unknown beside space, and a point of it.
struct Rational_example
{
  N_space_system system = make_system({"x", "y", "z", "w"}, {"z*(1 - y) - x^3 + x*y^2", "w - x*z"});
  std::vector<Q> point{Q(2) / 3, Q(1) / 7, Q(0), Q(0)};
  Fixed_coordinates fixed{{0, 1}, {Q(2) / 3, Q(1) / 7}};

  Rational_example()
  {
    const Q x = point[0], y = point[1];
    point[2] = (x * x * x - x * y * y) / (1 - y);
    point[3] = x * point[2];
  }

  Point start() const
  {
    Point p;
    for (const Q& x : point)
      p.push_back(number_cast<double>(x) + 1e-6);
    return p;
  }
};

Q power_of_half(int n)
{
  Q x(1);
  for (int i = 0; i < n; ++i)
    x /= 2;
  return x;
}

TEST(N_space_refinement, contains_the_point_in_as_many_bits_as_asked_for)
{
  const Rational_example example;
  const auto e = enclose_solution(example.system, example.start(), example.fixed);
  ASSERT_TRUE(e) << e.refusal().evidence();
  N_space_refinement refine(example.system, *e);
  for (int bits : {20, 53, 106, 300, 1200})
  {
    const auto box = refine(bits), alone = refine_enclosure(example.system, *e, bits);
    ASSERT_TRUE(box && alone) << (box ? alone : box).refusal().evidence();
    const Wide_precision precision(2000);
    for (const auto* b : {&*box, &*alone})
      for (int i = 0; i < 4; ++i)
      {
        const Wide_interval exact(example.point[i]);
        EXPECT_FALSE(((*b)[i] - exact).sign().is_certain()) << bits << " bits";
        const Wide_interval room = Wide_interval(power_of_half(bits)) - (*b)[i].width();
        EXPECT_TRUE(CGAL::certainly(room.sign() == CGAL::POSITIVE)) << bits << " bits";
      }
  }
  EXPECT_EQ(Wide_precision::bits(), 106); // restored
}

// Numbers of few bits must not leave the box over which the derivatives were enclosed.
TEST(N_space_refinement, keeps_to_the_box_in_few_bits)
{
  const Rational_example example;
  auto e = enclose_solution(example.system, example.start(), example.fixed);
  ASSERT_TRUE(e) << e.refusal().evidence();
  N_space_refinement refine(example.system, *e);
  for (int bits : {2, 5, 11, 200, 2})
  {
    const auto box = refine(bits);
    ASSERT_TRUE(box) << box.refusal().evidence();
    for (std::size_t i = 0; i < box->size(); ++i)
    {
      const auto ends = (*box)[i].ends();
      EXPECT_TRUE(e->box[i].inf() <= ends.first && ends.second <= e->box[i].sup()) << bits;
    }
  }
}

TEST(N_space_refinement, refuses_a_box_without_the_point)
{
  const Rational_example example;
  auto e = enclose_solution(example.system, example.start(), example.fixed);
  ASSERT_TRUE(e) << e.refusal().evidence();
  N_space_enclosure other = *e;
  other.box[2] = other.box[2] + Interval(1e-3);
  const auto box = refine_enclosure(example.system, other, 100);
  ASSERT_FALSE(box);
  EXPECT_EQ(box.refusal().code(), Refusal_code::NOT_ON_SOLUTION);
}

TEST(Decide_at, takes_as_many_bits_as_it_needs)
{
  // A cylinder, bent by c: K is a positive multiple of -20/9 c - c^2 at the point.
  const auto decide = [](const char* c, int max_bits) {
    const N_space_system system = make_system(
      {"x", "y", "z", "w"}, {"w - x*y", std::string("z - (x + y/3)^3 - w*") + c});
    const Fixed_coordinates fixed{{0, 1}, {Q(1) / 3, Q(2) / 3}};
    const auto e = enclose_solution(system, {0.333333, 0.666667, 0.2, 0.2}, fixed);
    EXPECT_TRUE(e);
    return decide_at(system, *e, Gaussian_sign(), max_bits);
  };
  struct Twin { const char* c; CGAL::Sign sign; int bits; };
  for (const Twin& twin : {Twin{"10^-3", CGAL::NEGATIVE, 53}, Twin{"10^-25", CGAL::NEGATIVE, 106},
                           Twin{"(-10^-25)", CGAL::POSITIVE, 106},
                           Twin{"(-10^-50)", CGAL::POSITIVE, 212}})
  {
    const auto d = decide(twin.c, 848);
    ASSERT_TRUE(d) << twin.c << ": " << d.refusal().evidence();
    EXPECT_EQ(d->answer, twin.sign) << twin.c;
    EXPECT_EQ(d->bits, twin.bits) << twin.c;
  }
  for (const auto& d : {decide("0", 848), decide("10^-25", 53), decide("10^-50", 106)})
  {
    ASSERT_FALSE(d);
    EXPECT_EQ(d.refusal().code(), Refusal_code::UNDECIDED);
  }
}

TEST(Decide_at, keeps_certain_refusals)
{
  const Rational_example example;
  const auto e = enclose_solution(example.system, example.start(), example.fixed);
  ASSERT_TRUE(e) << e.refusal().evidence();
  const auto refuse = [](const auto& s) -> Result<decltype(sign_of_gaussian_curvature(s))> {
    return Refusal(Refusal_code::NOT_TANGENT, "as asked");
  };
  const auto d = decide_at(example.system, *e, refuse);
  ASSERT_FALSE(d);
  EXPECT_EQ(d.refusal().code(), Refusal_code::NOT_TANGENT);
  // Too many independent equations, all of which vanish at the point.
  const N_space_system curve =
    make_system({"x", "y", "z", "w"}, {"z", "w", "x - y"});
  const auto line = enclose_solution(make_system({"x", "y", "z", "w"}, {"z", "w"}), {1, 1, 0, 0});
  ASSERT_TRUE(line);
  const auto no_surface = decide_at(curve, *line, Gaussian_sign());
  ASSERT_FALSE(no_surface);
  EXPECT_EQ(no_surface.refusal().code(), Refusal_code::NOT_TWO_DIMENSIONAL);
}

// --- The appendix: K = 0 by symmetry, and its twin beside the axis -------------------------------

TEST(Decide_at, leaves_the_parabolic_point_of_the_appendix_undecided)
{
  const N_space_system system = make_system(
    {"x", "y", "z", "u0", "v0", "w0", "u1", "v1", "w1", "u2", "v2", "w2", "r", "s", "t", "l"},
    {"2*u0*(1+r^2) - 3*(1-r^2) + (1+r^2)", "v0*(1+r^2) - 3*r", "w0 - 4", "(u1+1)^2 + v1^2 - 1",
     "u2*(1+s^2) - 3*(1-s^2)", "v2 - t", "w2*(1+s^2) - 6*s", "x - (l*u1 + (1-l)*u2)",
     "y - (l*v1 + (1-l)*v2)", "z - (l*w1 + (1-l)*w2)", "2*(w0-w1)*(u1+1)",
     "-2*(u0-u1)*v1 + 2*(v0-v1)*(u1+1)", "2*(w0-w1)*v1", "-12*s*(u0-u2) + 6*(1-s^2)*(w0-w2)",
     "v0 - v2"});
  const double root = std::sqrt(17.);
  const Point start{3 * root / 34, 0, 2 + 6 * root / 17, 1, 0, 4, 0, 0, 4,
                    3 * root / 17, 0, 12 * root / 17, 0, (root - 1) / 4, 0, .5};
  const auto decide = [&](const Q& r) {
    const auto e = enclose_solution(system, start, Fixed_coordinates{{12, 15}, {r, Q(1) / 2}});
    EXPECT_TRUE(e) << e.refusal().evidence();
    EXPECT_EQ(e->others_contain_zero.size(), 1u); // 15 equations, 14 in the proof
    return decide_at(system, *e, Gaussian_sign());
  };
  const auto flat = decide(Q(0));
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.refusal().code(), Refusal_code::UNDECIDED);
  // A ruled surface is hyperbolic where it is not flat.
  for (const auto& [r, bits] : {std::pair<double, int>(1e-2, 53), {1e-9, 106}, {1e-20, 212}})
  {
    const auto beside = decide(Q(r));
    ASSERT_TRUE(beside) << r << ": " << beside.refusal().evidence();
    EXPECT_EQ(beside->answer, CGAL::NEGATIVE);
    EXPECT_LE(beside->bits, bits) << r;
  }
}

// --- Redundant equations that are proved ---------------------------------------------------------

TEST(Prove_by_identities, proves_the_redundant_projections)
{
  const auto f = [](const auto& x, const auto& y, const auto& z) {
    return x * x / 9 + y * y / 4 + z * z - 1;
  };
  const Constraint_system constraints = offset_system(Implicit_entity_3(f, "f"), Q(1) / 2);
  ASSERT_TRUE(CGAL::certainly(verify_identities(constraints)));
  const N_space_system system = constraints.n_space_system();
  Random random(20261202);
  int proved = 0;
  for (int i = 0; i < 100; ++i)
  {
    const double a = random.real(0, 6), b = random.real(-1, 1);
    const Point foot{3 * std::cos(a) * std::cos(b), 2 * std::sin(a) * std::cos(b), std::sin(b)};
    const double g[3] = {foot[0] * 2 / 9, foot[1] / 2, foot[2] * 2};
    const double length = 2 * std::hypot(g[0], g[1], g[2]);
    Point start;
    for (int k = 0; k < 3; ++k)
      start.push_back(foot[k] + g[k] / length);
    start.insert(start.end(), foot.begin(), foot.end());
    const auto e = enclose_solution(system, start);
    ASSERT_TRUE(e) << e.refusal().evidence();
    EXPECT_TRUE(e->others_proved.empty());
    ASSERT_EQ(e->others_contain_zero.size(), 1u);
    const N_space_enclosure p = prove_by_identities(constraints, *e);
    EXPECT_EQ(p.others_proved.size() + p.others_contain_zero.size(), 1u);
    proved += static_cast<int>(p.others_proved.size());
  }
  EXPECT_EQ(proved, 100);
}

// (g / w) w - g vanishes where w does not. On w = 0 it tells nothing of g.
TEST(Prove_by_identities, proves_nothing_at_a_pole)
{
  Constraint_system constraints;
  const Expression w = constraints.add_scalar("w");
  const Expression x = Expression::variable(0), y = Expression::variable(1),
                   z = Expression::variable(2);
  const Expression e = w - x * x, g = z - x * y - Expression(Q(1) / (Q(1) << 200));
  constraints.add(Constraint("z", "x y", {z - x * y}));
  constraints.add(Constraint("w", "x^2", {e, g}, 1, {{g / e, Expression(-1)}}));
  const auto box = enclose_solution(constraints.n_space_system(), {1.3, 1.7, 2.2, 1.7});
  ASSERT_TRUE(box) << box.refusal().evidence();
  ASSERT_EQ(box->equations, (std::vector<int>{0, 1}));
  const N_space_enclosure proved = prove_by_identities(constraints, *box);
  EXPECT_TRUE(proved.others_proved.empty());
  EXPECT_EQ(proved.others_contain_zero, std::vector<int>{2}); // where it is not zero
}

// An enclosure must not be certain of a rank that its own factors do not confirm.
TEST(N_space_evaluator, does_not_doubt_the_dimension_of_nearly_dependent_gradients)
{
  const N_space_system system = make_system(
    {"x", "y", "z", "w", "v"}, {"3*x + w + z^2", "3*x + (1 + 2^(-52))*w + z^2", "v - y^2"});
  EXPECT_TRUE(N_space_evaluator<Q>(system)(std::vector<Q>(5, Q(0))));
  Interval::Protector protector;
  const auto s = N_space_evaluator<Interval>(system).unoriented(std::vector<Interval>(5, 0));
  EXPECT_TRUE(s || s.refusal().code() == Refusal_code::UNDECIDED);
}

TEST(Prove_by_identities, proves_nothing_without_a_coefficient)
{
  // p = q = 0 where the vectors are parallel; the identities have the components as coefficients.
  Constraint_system constraints;
  const Expression p = constraints.add_scalar("p"), q = constraints.add_scalar("q");
  const Constraint_vector_3 a{"a", {p, q, Expression(1)}};
  const Constraint_vector_3 b{"b", {Expression(0), Expression(0), Expression(2)}};
  require_parallel(constraints, a, b);
  // Redundant, and not by an identity: nothing is proved of it.
  constraints.add(Constraint("p", "zero", {p * (p + 1)}));
  const N_space_system system = constraints.n_space_system();
  // x, y, z are free here, which is one too many.
  EXPECT_FALSE(enclose_solution(system, {1, 2, 3, 0, 0}));
  constraints.add(Constraint("z", "one", {Expression::variable(2) - 1}));
  const auto e = enclose_solution(constraints.n_space_system(), {1, 2, 1, 0, 0});
  ASSERT_TRUE(e) << e.refusal().evidence();
  ASSERT_EQ(e->equations.size(), 3u);
  const N_space_enclosure proved = prove_by_identities(constraints, *e);
  ASSERT_EQ(proved.others_contain_zero.size() + proved.others_proved.size(), 2u);
  for (int k : proved.others_proved)
    EXPECT_LT(k, 3); // of the parallel vectors
  // The first equation, q * 2 - 0 * 1, is in the proof, or the others do not give it.
  const N_space_enclosure none = prove_by_identities(
    constraints, [&] { auto x = *e; x.others_contain_zero = {0, 1, 2, 3}; return x; }());
  EXPECT_LE(none.others_proved.size(), 1u);
}

} // namespace
