// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Certified bounds of polynomials and properties, and theorems about whole patches: bounds that are
// attained, twins 2^-60 beside them, collapsed edges, and what stays undecided.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using Polynomial = Bernstein_polynomial_2<Q>;
using Point = Coordinates<Q, 3>;
using Parameters = std::array<Q, 2>;

const Polynomial u = Polynomial::coordinate(0), v = Polynomial::coordinate(1);
const Q tiny("1/1152921504606846976"); // 2^-60

Verdict decide(const Polynomial& p) { return decide_nonnegative<Q, 2>({p}).verdict; }

void expect_no(const Polynomial& p)
{
  const auto sign = decide_nonnegative<Q, 2>({p});
  ASSERT_EQ(Verdict::NO, sign.verdict);
  EXPECT_EQ(CGAL::NEGATIVE, CGAL::sign(p(*sign.witness)));
}

TEST(Decide_nonnegative, proves_and_refutes)
{
  EXPECT_EQ(Verdict::YES, decide(u * u - u + fraction(1, 2)));
  EXPECT_EQ(Verdict::YES, decide(2 - u - v));                    // zero at a corner
  EXPECT_EQ(Verdict::YES, decide(Polynomial(2) - u * u - v * v)); // zero at a corner
  EXPECT_EQ(Verdict::YES, decide(u * u * (1 - v) * (v + 1)));    // zero along two edges
  EXPECT_EQ(Verdict::YES, decide(Polynomial(0)));
  EXPECT_EQ(Verdict::YES, decide((u - fraction(1, 2)) * (u - fraction(1, 2))));
  expect_no(u * u - u + fraction(1, 4) - tiny * v);
  expect_no(2 - u - v - tiny);
  expect_no(-u * v * (1 - u) * (1 - v)); // zero on all edges
  expect_no(u * u * u * (u - tiny));     // negative beside an edge only
  // Touched at a point that halving does not reach.
  const Polynomial third = u - fraction(1, 3);
  EXPECT_EQ(Verdict::UNDECIDED, decide(third * third));
  EXPECT_EQ(Verdict::YES, decide(third * third + fraction(1, 1000000)));
  expect_no(third * third - fraction(1, 1000000));
}

TEST(Decide_nonnegative, needs_one_of_several_at_each_point)
{
  const auto both = [&](const Polynomial& p, const Polynomial& q) {
    return decide_nonnegative<Q, 2>({p, q}).verdict;
  };
  const Polynomial half = u - fraction(1, 2);
  EXPECT_EQ(Verdict::YES, both(half, -half));
  EXPECT_EQ(Verdict::YES, both(half + fraction(1, 9), -half));
  const auto no = decide_nonnegative<Q, 2>({half - tiny, -half - tiny});
  ASSERT_EQ(Verdict::NO, no.verdict);
  EXPECT_EQ(fraction(1, 2), (*no.witness)[0]);
}

TEST(Decide_nonnegative, has_three_answers)
{
  EXPECT_STREQ("yes", to_string(Verdict::YES));
  EXPECT_STREQ("no", to_string(Verdict::NO));
  EXPECT_STREQ("undecided", to_string(Verdict::UNDECIDED));
  using F = Quadratic_field;
  const F root(Q(0), Q(1), Q(2));
  const auto x = Bernstein_polynomial_1<F>::coordinate(0);
  EXPECT_EQ(Verdict::YES, (decide_nonnegative<F, 1>({root - x - F(fraction(2, 5))}).verdict));
  EXPECT_EQ(Verdict::NO, (decide_nonnegative<F, 1>({root - x - F(fraction(1, 2))}).verdict));
}

// Enclosures against values at many points, and against their own places.
TEST(Bounds, contain_the_values)
{
  Random random(20260421);
  for (int k = 0; k < 12; ++k)
  {
    std::vector<Q> a, b;
    for (int i = 0; i < 12; ++i)
    {
      a.push_back(random.rational());
      b.push_back(random.fraction(1, 9, 5));
    }
    const Polynomial p = Polynomial::from_coefficients({2, 3}, a);
    const Polynomial q = k % 2 ? Polynomial::from_coefficients({3, 2}, b) : Polynomial(3);
    const auto range = bounds(p, q);
    ASSERT_TRUE(range.infimum.is_bounded && range.supremum.is_bounded);
    ASSERT_TRUE(range.infimum.is_attained && range.supremum.is_attained);
    for (int i = 0; i < 50; ++i)
    {
      const Parameters x{random.in_unit_interval(), random.in_unit_interval()};
      const Q value = p(x) / q(x);
      EXPECT_LE(range.infimum.lower, value);
      EXPECT_GE(range.supremum.upper, value);
    }
    const auto value_at = [&](const Parameters& x) { return Q(p(x) / q(x)); };
    EXPECT_EQ(range.supremum.lower, value_at(range.supremum.at));
    EXPECT_EQ(range.infimum.upper, value_at(range.infimum.at));
    EXPECT_LT(CGAL::to_double(Q(range.supremum.upper - range.supremum.lower)), 1e-7);
    EXPECT_LT(CGAL::to_double(Q(range.infimum.upper - range.infimum.lower)), 1e-7);
  }
}

TEST(Bounds, are_exact_at_corners_and_for_constants)
{
  const auto range = bounds(u * u * 3 - v + tiny, 1 + u);
  EXPECT_EQ(range.supremum.lower, range.supremum.upper);
  EXPECT_EQ(Q((3 + tiny) / 2), range.supremum.upper);
  EXPECT_EQ((Parameters{1, 0}), range.supremum.at);
  EXPECT_EQ(Q(tiny - 1), range.infimum.lower);
  const Polynomial q = u * v + 2;
  const auto constant = bounds(q * q * fraction(1, 3), q * q);
  EXPECT_EQ(fraction(1, 3), constant.infimum.lower);
  EXPECT_EQ(fraction(1, 3), constant.supremum.upper);
  // One variable, a greatest value inside at a place that is no dyadic number.
  const auto t = Bernstein_polynomial_1<Q>::coordinate(0);
  const auto inside = supremum(t * (fraction(2, 3) - t));
  EXPECT_LE(inside.lower, fraction(1, 9));
  EXPECT_GE(inside.upper, fraction(1, 9));
  EXPECT_LT(inside.upper - inside.lower, fraction(1, 1000000000));
}

TEST(Bounds, divide_common_factors_of_the_boundary_out)
{
  const auto range = bounds(u * u * (2 + v) * (1 - v), u * u * (1 - v));
  EXPECT_EQ(Q(2), range.infimum.lower);
  EXPECT_EQ(Q(3), range.supremum.upper);
  const auto pole = supremum(Polynomial(1), u, {1e-9, 50});
  EXPECT_FALSE(pole.is_bounded);
  EXPECT_TRUE(pole.is_attained);
  EXPECT_EQ(Q(1), infimum(Polynomial(1), u, {1e-9, 50}).upper);
  // 0/0 inside: no bound, and an end.
  const Polynomial r = (u - fraction(1, 3)) * (u - fraction(1, 3));
  EXPECT_FALSE(supremum(r * v, r, {1e-9, 50}).is_bounded);
}

// z = a u^2 + 2/5 v^2 over the unit square.
Bezier_surface_3<Q> paraboloid(const Q& a)
{
  std::vector<Point> p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      p.push_back({fraction(i, 2), fraction(j, 2),
                   Q((i == 2 ? a : Q(0)) + (j == 2 ? fraction(2, 5) : Q(0)))});
  return Bezier_surface_3<Q>(2, 2, p);
}

TEST(Property_bounds, are_attained_or_missed_by_little)
{
  const auto slope = property_surface(paraboloid(fraction(3, 10)), Property::SLOPE);
  EXPECT_EQ(Verdict::YES, decide_at_most(slope, Q(1))->verdict);
  EXPECT_EQ(Q(1), decide_at_most(slope, Q(1))->extreme.upper);
  const auto twin =
    decide_at_most(property_surface(paraboloid(fraction(3, 10) + tiny), Property::SLOPE), Q(1));
  EXPECT_EQ(Verdict::NO, twin->verdict);
  EXPECT_EQ((Parameters{1, 1}), *twin->at);

  const auto speed = property_surface(paraboloid(fraction(3, 10)), Property::SPEED);
  EXPECT_EQ(Verdict::YES, decide_at_most(speed, Q(3))->verdict);
  EXPECT_EQ(Verdict::NO, decide_at_most(speed, Q(3 - tiny))->verdict);
  EXPECT_EQ(Verdict::YES, decide_at_least(speed, Q(2))->verdict);
  EXPECT_EQ(Verdict::NO, decide_at_least(speed, Q(2 + tiny))->verdict);
}

TEST(Property_bounds, of_the_speed_need_no_root)
{
  // At (1, 1): E = 1 + 9/25, G = 1 + 16/25, F = 12/25, so that the supremum is 2.
  const auto speed = property_surface(paraboloid(fraction(3, 10)), Property::SPEED_SUPREMUM);
  EXPECT_EQ(Verdict::YES, decide_at_most(speed, Q(2))->verdict);
  EXPECT_EQ(Verdict::NO, decide_at_most(speed, Q(2 - tiny))->verdict);
  EXPECT_EQ(Verdict::YES, decide_at_least(speed, Q(1))->verdict);
  EXPECT_EQ(Verdict::NO, decide_at_least(speed, Q(1 + tiny))->verdict);
  const auto range = bounds(speed);
  EXPECT_LE(range.supremum.lower, Q(2));
  EXPECT_GE(range.supremum.upper, Q(2));
  EXPECT_LT(range.supremum.upper - range.supremum.lower, fraction(1, 100000000));
  EXPECT_LE(range.infimum.lower, Q(1));
  EXPECT_GE(range.infimum.upper, Q(1));
}

TEST(Property_bounds, hold_for_patches_with_collapsed_edges)
{
  // A sphere of radius 2 with a pole at u = 1, and its weights turned round.
  constexpr int circle[3][3] = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  for (int sign : {1, -1})
  {
    std::vector<Coordinates<Q, 4>> p;
    for (const auto& a : circle)
      for (const auto& b : circle)
        p.push_back({Q(2 * sign * a[0] * b[0]), Q(2 * sign * a[0] * b[1]),
                     Q(2 * sign * a[1] * b[2]), Q(sign * a[2] * b[2])});
    Property_surface_maker<Q> maker(Bezier_surface_3<Q>::from_homogeneous(2, 2, p));
    const auto range = bounds(maker(Property::GAUSSIAN));
    EXPECT_EQ(fraction(1, 4), range.infimum.lower);
    EXPECT_EQ(fraction(1, 4), range.supremum.upper);
    EXPECT_EQ(Verdict::YES, decide_at_most(maker(Property::GAUSSIAN), fraction(1, 4))->verdict);
    const auto no = decide_at_most(maker(Property::GAUSSIAN), Q(fraction(1, 4) - tiny));
    ASSERT_EQ(Verdict::NO, no->verdict);
    EXPECT_TRUE(maker(Property::GAUSSIAN).value(*no->at).has_value());
    EXPECT_EQ(Verdict::YES, decide_at_least(maker(Property::UMBILIC), Q(0))->verdict);
    // S_u x S_v points inward: its product with z is not positive, whatever the sign of the weight.
    const auto facing = maker(Property::SILHOUETTE);
    EXPECT_EQ(Verdict::YES, decide_at_most(facing, Q(0))->verdict);
    EXPECT_EQ(Verdict::NO, decide_at_least(facing, Q(0))->verdict);
    // At u = 0 the sphere is vertical.
    EXPECT_EQ(Verdict::NO, decide_at_most(maker(Property::SLOPE), Q(1000000))->verdict);
    EXPECT_FALSE(bounds(maker(Property::SLOPE), {1e-9, 50}).supremum.is_bounded);
  }
}

TEST(Property_bounds, are_refused_where_there_is_no_value)
{
  const Bezier_surface_3<Q> point(1, 1, std::vector<Point>(4, {Q(1), Q(2), Q(3)}));
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION,
                 decide_at_most(property_surface(point, Property::GAUSSIAN), Q(1)));
  EXPECT_EQ(Verdict::YES, decide_at_most(property_surface(point, Property::SPEED), Q(0))->verdict);
}

TEST(Property_bounds, of_splines_are_in_their_parameters)
{
  const Knot_vector<Q> knots_u(2, rationals({0, 0, 0, 2, 6, 6, 6}));
  const Knot_vector<Q> knots_v(1, rationals({-1, -1, 3, 3}));
  std::vector<std::vector<Point>> p;
  for (int i = 0; i < 4; ++i)
    p.push_back({{Q(i), Q(0), Q(i * i)}, {Q(i), Q(4), Q(i * i)}});
  const Nurbs_surface_3<Q> surface(knots_u, knots_v, p);
  const auto speed = property_surface(surface, Property::SPEED);
  const auto range = bounds(speed);
  const auto at = range.supremum.at;
  const auto d = *surface.derivatives(at);
  EXPECT_EQ(range.supremum.upper, Q(internal::dot(d.u, d.u) + internal::dot(d.v, d.v)));
  EXPECT_EQ(Verdict::YES, decide_at_most(speed, range.supremum.upper)->verdict);
  EXPECT_EQ(Verdict::YES, decide_at_least(speed, range.infimum.lower)->verdict);
  const auto no = decide_at_most(speed, Q(range.supremum.upper - tiny));
  ASSERT_EQ(Verdict::NO, no->verdict);
  EXPECT_EQ(at, *no->at);
  EXPECT_EQ(Verdict::NO, decide_at_least(speed, Q(range.infimum.upper + 1))->verdict);
}

} // namespace
