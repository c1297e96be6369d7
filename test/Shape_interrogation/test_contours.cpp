// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Zero sets on the unit square: known curves, degenerate places, and what must not depend on how
// the polynomial is written.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Bernstein/homogeneous_parameters.h>
#include <CGAL/Shape_interrogation/Bernstein/isolate_roots.h>
#include <CGAL/Shape_interrogation/Contours/contour.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using FT = CGAL::Exact_rational;
using Integer = CGAL::Exact_integer;
using P = Bernstein_polynomial_2<FT>;

const P u = P::coordinate(0), v = P::coordinate(1);

P constant(const FT& c) { return P(c); }
P x(const FT& a = FT(1, 2)) { return u - constant(a); }
P y(const FT& a = FT(1, 2)) { return v - constant(a); }

FT power_of_ten(int n)
{
  FT p(1);
  for (int i = 0; i < -n; ++i)
    p /= 10;
  return p;
}

// What must be equal where the curves are.
struct Topology
{
  int closed = 0, open = 0, isolated = 0, unresolved = 0, edges = 0;
  bool operator==(const Topology& t) const
  {
    return closed == t.closed && open == t.open && isolated == t.isolated &&
           unresolved == t.unresolved && edges == t.edges;
  }
};
std::ostream& operator<<(std::ostream& out, const Topology& t)
{
  return out << t.closed << " closed, " << t.open << " open, " << t.isolated << " isolated, "
             << t.unresolved << " unresolved, " << t.edges << " edges";
}

Topology topology(const Contour_2& c)
{
  Topology t;
  for (const auto& curve : c.curves)
    ++(curve.is_closed ? t.closed : t.open);
  t.isolated = static_cast<int>(c.isolated_points.size());
  t.unresolved = static_cast<int>(c.unresolved.size());
  t.edges = static_cast<int>(c.edges.size());
  return t;
}

Contour_2 contour_of(const P& p, const Contour_options& options = {})
{
  return *contour(p, options);
}

// All points are on the curve, and neighbours are near.
void check_points(const P& p, const Contour_2& c, double step)
{
  const auto f = p.cast<double>(), fu = p.derivative(0).cast<double>(),
             fv = p.derivative(1).cast<double>();
  for (const auto& curve : c.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      const auto& q = curve.points[i];
      const double slope = std::hypot(fu(q), fv(q));
      if (slope > 1e-3)
      {
        EXPECT_LT(std::fabs(f(q)) / slope, 1e-10) << q[0] << " " << q[1];
      }
      if (i == 0)
        continue;
      EXPECT_LT(std::hypot(q[0] - curve.points[i - 1][0], q[1] - curve.points[i - 1][1]),
                1.0000001 * step);
    }
}

TEST(Contours, Known_curves)
{
  const auto expect = [](const P& p, const Topology& t) {
    const Contour_2 c = contour_of(p);
    EXPECT_EQ(topology(c), t);
    EXPECT_EQ(c.has_certified_topology(), t.unresolved == 0);
    check_points(p, c, 0.01);
  };
  const P r = x() * x() + y() * y();
  expect(u - v, {0, 1});
  expect(x(), {0, 1});
  expect(u + v - constant(3), {});
  expect(r - constant(FT(1, 16)), {1, 0});
  expect((r - constant(FT(1, 16))) * (r - constant(FT(1, 9))), {2, 0});
  expect(x() * x() - y() * y() - constant(FT(1, 100)), {0, 2});
  expect(r - constant(FT(1, 3)), {0, 4});
}

TEST(Contours, A_double_curve_is_found_once)
{
  const P circle = x() * x() + y() * y() - constant(FT(1, 16));
  const Contour_2 c = contour_of(circle * circle);
  EXPECT_EQ(topology(c), (Topology{1, 0}));
  EXPECT_GT(c.positive_area, 0);
  EXPECT_EQ(c.negative_area, 0);
  EXPECT_EQ(topology(contour_of(circle * circle * circle * (u - v))), (Topology{0, 5, 0, 2}));
}

TEST(Contours, Nearly_touching_branches_are_resolved)
{
  const FT gap = power_of_ten(-12);
  const FT s(gap * gap / 4);
  EXPECT_EQ(topology(contour_of(x() * x() - y() * y() - constant(s))), (Topology{0, 2}));
  EXPECT_EQ(topology(contour_of(x() * x() - y() * y() + constant(s))), (Topology{0, 2}));
  const P a = x(FT(1, 3)), b = y(FT(2, 7));
  EXPECT_EQ(topology(contour_of(a * a - b * b * constant(5) - constant(s))), (Topology{0, 2}));
  EXPECT_EQ(topology(contour_of(y() * y() - constant(s))), (Topology{0, 2}));
  // The two ways of joining differ: which one it is, not only how many.
  const Contour_2 c = contour_of(x() * x() - y() * y() - constant(s));
  for (const auto& curve : c.curves)
  {
    const double side = curve.points.front()[0] - 0.5;
    for (const auto& p : curve.points)
      EXPECT_GT((p[0] - 0.5) * side, 0);
  }
  // A circle of that size, and one that is imaginary.
  EXPECT_EQ(topology(contour_of(x() * x() + y() * y() - constant(s))), (Topology{1, 0}));
  EXPECT_EQ(topology(contour_of(x() * x() + y() * y() + constant(s))), (Topology{}));
}

TEST(Contours, Singular_points_are_small_boxes)
{
  const auto expect = [](const P& p, int branches, std::array<double, 2> place) {
    const Contour_2 c = contour_of(p);
    ASSERT_EQ(c.unresolved.size(), 1u);
    const Unresolved_box_2& box = c.unresolved.front();
    EXPECT_EQ(box.branches, branches);
    EXPECT_LE((box.high[0] - box.low[0]) * (box.high[1] - box.low[1]), 1e-6);
    for (int axis = 0; axis < 2; ++axis)
    {
      EXPECT_LE(box.low[axis], place[axis] + 1e-15);
      EXPECT_GE(box.high[axis], place[axis] - 1e-15);
    }
    EXPECT_EQ(int(c.curves.size()), branches == 0 ? 0 : branches);
    for (const auto& curve : c.curves)
      EXPECT_EQ(curve.unresolved[0] + curve.unresolved[1], -1);
  };
  const P a = x(FT(1, 3)), b = y(FT(2, 7));
  expect(x() * x() - y() * y() * constant(2) + x() * x() * x(), 4, {0.5, 0.5});
  expect(a * a - b * b * constant(2) + a * a * a, 4, {1. / 3, 2. / 7});
  expect(x() * x() + y() * y(), 0, {0.5, 0.5});
  expect(a * a + b * b * constant(3) + a * a * a, 0, {1. / 3, 2. / 7});
  expect(a * a - b * b * b, 2, {1. / 3, 2. / 7});
  expect(b * b - a * a * a * a, 4, {1. / 3, 2. / 7});
}

TEST(Contours, Tangent_to_the_boundary)
{
  EXPECT_EQ(topology(contour_of(v - x() * x())), (Topology{0, 1}));
  EXPECT_EQ(topology(contour_of(v + x() * x())), (Topology{0, 0, 1}));
  EXPECT_EQ(topology(contour_of(v - x() * x() * x())), (Topology{0, 1}));
  EXPECT_EQ(topology(contour_of(x() * x() + y() * y() - constant(FT(1, 4)))), (Topology{1, 0}));
  EXPECT_EQ(topology(contour_of(u + v)), (Topology{0, 0, 1}));
  EXPECT_EQ(topology(contour_of(u - v * v)), (Topology{0, 1}));
  EXPECT_EQ(topology(contour_of(u * u + v - u * v * constant(FT(1, 3)))), (Topology{0, 0, 1}));
  EXPECT_EQ(topology(contour_of(constant(2) - u - v)), (Topology{0, 0, 1}));
  // An irrational place, and one at the line at which cells are cut first.
  const P w = u * u - constant(FT(1, 2));
  EXPECT_EQ(topology(contour_of(v - w * w)), (Topology{0, 1}));
  EXPECT_EQ(topology(contour_of(v - x(FT(125, 256)) * x(FT(125, 256)))), (Topology{0, 1}));
}

TEST(Contours, Edges_on_which_the_polynomial_vanishes)
{
  const P circle = x() * x() + y() * y() - constant(FT(1, 16));
  const Contour_2 c = contour_of(u * u * (constant(1) - v) * circle);
  EXPECT_EQ(topology(c), (Topology{1, 0, 0, 0, 2}));
  EXPECT_EQ(c.edges[0].axis, 0);
  EXPECT_EQ(c.edges[0].end, 0);
  EXPECT_EQ(c.edges[0].multiplicity, 2);
  EXPECT_EQ(c.edges[1].axis, 1);
  EXPECT_EQ(c.edges[1].end, 1);
  EXPECT_EQ(c.edges[1].multiplicity, 1);
  EXPECT_TRUE(contour_of(P(0)).is_everything);
  EXPECT_EQ(topology(contour_of(P(1))), (Topology{}));
}

// Cutting at other places, turning and mirroring the square, and raising the degree change nothing.
TEST(Contours, Random_polynomials_in_other_forms)
{
  const unsigned seed = 20261123;
  std::mt19937_64 random(seed);
  const P one(1);
  for (int trial = 0; trial < 60; ++trial)
  {
    const int m = 1 + int(random() % 6), n = 1 + int(random() % 6);
    std::vector<FT> b((m + 1) * (n + 1));
    for (FT& c : b)
      c = FT(long(random() % 2001) - 1000, 100);
    const P p = P::from_coefficients({m, n}, b);
    SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
    const Contour_2 c = contour_of(p);
    EXPECT_TRUE(c.has_certified_topology());
    check_points(p, c, 0.01);
    EXPECT_EQ(topology(contour_of(p.elevated({m + 2, n + 1}))), topology(c));
    EXPECT_EQ(topology(contour_of(p.at<P>({v, u}))), topology(c));
    EXPECT_EQ(topology(contour_of(p.at<P>({one - u, v}))), topology(c));
    EXPECT_EQ(topology(contour_of(-p)), topology(c));
    EXPECT_LE(c.positive_area + c.negative_area, 1);
    // A monotone change of the parameter: another curve, the same topology.
    EXPECT_EQ(topology(contour_of(p.at<P>({u * (one + u) * constant(FT(1, 2)), v}))), topology(c));
  }
}

// Crossings near a singular corner whose order shows in more bits than the cells have.
TEST(Contours, Crossings_are_ordered_near_a_singular_corner)
{
  std::vector<FT> b;
  for (const char* x : {"0", "0",     "0",     "0",    "0",    "1/4", "1/8", "1/24",  "0",
                        "0", "0",     "-1/12", "-5/36", "-1/6", "-1/6", "0",  "1/8",  "-1/24",
                        "0", "0",     "0",     "0",    "-2/3", "0",   "1"})
    b.push_back(FT(x));
  const Contour_2 c = contour_of(P::from_coefficients({4, 4}, b));
  EXPECT_EQ(topology(c), (Topology{0, 2, 0, 1, 1}));
  for (const auto& curve : c.curves)
    for (int end = 0; end < 2; ++end)
    {
      const auto& p = end ? curve.points.back() : curve.points.front();
      const bool is_on_boundary = p[0] == 0 || p[0] == 1 || p[1] == 0 || p[1] == 1;
      EXPECT_EQ(is_on_boundary, curve.unresolved[end] < 0);
    }
}

// Over a common denominator, the integers are the rationals times a power of it.
TEST(Contours, Restriction_in_a_ring)
{
  using Z = Bernstein_polynomial_2<Integer>;
  const Z s = Z::coordinate(0), t = Z::coordinate(1);
  const Z p = s * s * t * Z(3) - t * Z(2) + s;
  const P q = p.cast<FT>();
  const P part = restricted_homogeneous(p, 0, Integer(1), Integer(3), Integer(4)).cast<FT>();
  EXPECT_TRUE((part - q.restricted(0, FT(1, 4), FT(3, 4)) * P(16)).is_zero());
  const auto line = fixed_homogeneous(p, 1, Integer(2), Integer(3)).cast<FT>();
  EXPECT_TRUE((line - q.fixed(1, FT(2, 5)) * Bernstein_polynomial_1<FT>(5)).is_zero());
  const auto value = value_homogeneous<Integer>(p, {1, 2}, {2, 3});
  EXPECT_EQ(FT(value), FT(q({FT(1, 3), FT(2, 5)}) * 9 * 5));
}

TEST(Contours, Stop_and_limits)
{
  const P far = (u - v) * (u - v) - constant(power_of_ten(-10));
  Contour_options options;
  options.max_cells = 500;
  const Contour_2 c = contour_of(far, options);
  EXPECT_FALSE(c.has_certified_topology());
  const auto cancelled =
    contour(far, {}, [](std::size_t done, std::size_t) { return done < 10; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.refusal().code(), Refusal_code::CANCELLED);
}

TEST(Contours, Roots_on_an_interval)
{
  using P1 = Bernstein_polynomial_1<Integer>;
  const P1 t = P1::coordinate(0);
  const auto roots = isolate_roots(t * t * (P1(3) * t - P1(1)) * (P1(2) * t - P1(1)) *
                                   (P1(2) * t - P1(1)) * (t - P1(1)) * (t * t * P1(2) - P1(1)));
  ASSERT_EQ(roots.size(), 5u);
  const double at[] = {0, 1. / 3, 0.5, std::sqrt(0.5), 1};
  const int multiplicities[] = {2, 1, 2, 1, 1};
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_LE(CGAL::to_double(roots[i].lower()), at[i] + 1e-15);
    EXPECT_GE(CGAL::to_double(roots[i].upper()), at[i] - 1e-15);
    EXPECT_EQ(roots[i].multiplicity(), multiplicities[i]);
    Bernstein_root root = roots[i];
    root.refine(FT(1, 1000000000));
    EXPECT_NEAR(CGAL::to_double(root.lower()), at[i], 2e-9);
    EXPECT_EQ(root.is_exact(), root.lower() == root.upper());
  }
}

} // namespace
