// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Plane curves: implicit, parametric, Bezier and B-spline, against known curvatures, against each
// other, from both sides of knots, and in several number types.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Curves/Implicit_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Nurbs_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Parametric_curve_2.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Exact_ring.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace {

using namespace testing_shapes;
using Interval = CGAL::Interval_nt<true>;
using Shape = Local_shape_2<Q>;
using Point = Coordinates<Q, 2>;
using Points = std::vector<Point>;
using Bezier = Bezier_curve_2<Q>;
using Nurbs = Nurbs_curve_2<Q>;

Points random_points(Random& random, int n)
{
  Points p;
  for (int i = 0; i < n; ++i)
    p.push_back({random.fraction(-30, 30, 9), random.fraction(-30, 30, 9)});
  return p;
}

std::vector<Q> random_weights(Random& random, int n)
{
  std::vector<Q> w;
  for (int i = 0; i < n; ++i)
    w.push_back(random.fraction(1, 12, 5));
  return w;
}

// kappa^2 = b^2 / q = (q b)^2 / q^3.
Q squared_curvature(const Shape& s)
{
  const Q b = s.shape_number();
  Q k = b * b / s.normal_squared_length();
  return k;
}

CGAL::Sign sign_of_curvature(const Shape& s) { return CGAL::sign(s.numerator()); }

struct Ellipse
{
  template <class T>
  T operator()(const T& x, const T& y) const { return x * x / 4 + y * y - 1; }
};

struct Node
{
  template <class T>
  T operator()(const T& x, const T& y) const { return y * y - x * x * (x + 1); }
};

struct Circle
{
  template <class T>
  std::array<T, 2> operator()(const T& t) const
  {
    const T w = 1 + t * t;
    return {T((1 - t * t) / w), T(2 * t / w)};
  }
};

struct Cubic
{
  template <class T>
  std::array<T, 2> operator()(const T& t) const { return {T(3 * t - t * t * t), T(1 + t * t)}; }
};

struct Cusp
{
  template <class T>
  std::array<T, 2> operator()(const T& t) const { return {T(t * t), T(t * t * t)}; }
};

struct Hyperbola
{
  template <class T>
  std::array<T, 2> operator()(const T& t) const { return {T(t), T(1 / t)}; }
};

struct Catenary
{
  template <class T>
  std::array<T, 2> operator()(const T& t) const { return {T(t), T(exp(t) + exp(-t))}; }
};

// The Bernstein form written with binomials and powers, for any number type.
struct Bernstein_map
{
  Points points;
  std::vector<Q> weights;

  template <class T>
  std::array<T, 2> operator()(const T& t) const
  {
    const int n = static_cast<int>(points.size()) - 1;
    T x(0), y(0), w(0);
    int binomial = 1;
    for (int i = 0; i <= n; ++i)
    {
      T b = T(binomial);
      for (int k = 0; k < n; ++k)
        b = k < i ? T(b * t) : T(b * (T(1) - t));
      if (!weights.empty())
        b = b * T(weights[i]);
      w += b;
      x += b * T(points[i][0]);
      y += b * T(points[i][1]);
      binomial = binomial * (n - i) / (i + 1);
    }
    return weights.empty() ? std::array<T, 2>{x, y} : std::array<T, 2>{T(x / w), T(y / w)};
  }
};

// The quarter circle (1 - t^2, 2t) / (1 + t^2).
Bezier quarter_circle()
{
  return Bezier(Points{{Q(1), Q(0)}, {Q(1), Q(1)}, {Q(0), Q(1)}}, {Q(1), Q(1), Q(2)});
}

TEST(Implicit_curve, has_the_curvature_of_an_ellipse)
{
  const Implicit_curve_2<Ellipse> ellipse;
  const Point p{fraction(6, 5), fraction(4, 5)};
  const auto s = ellipse(p);
  ASSERT_TRUE(s);
  EXPECT_EQ(s->normal(), (Point{fraction(3, 5), fraction(8, 5)}));
  EXPECT_EQ(s->normal_squared_length(), fraction(73, 25));
  EXPECT_EQ(s->numerator(), 2); // minus the bordered determinant
  EXPECT_EQ(s->shape_number(), fraction(50, 73));
  EXPECT_EQ(squared_curvature(*s), fraction(62500, 389017));
  // The Hessian of the normalform times sqrt(q) = sqrt(73) / 5.
  EXPECT_EQ(s->shape_matrix()[0], Q(fraction(16000, 389017) * 73 / 5));
  EXPECT_EQ(s->shape_matrix()[1], Q(fraction(-6000, 389017) * 73 / 5));
  EXPECT_EQ(s->shape_matrix()[2], Q(fraction(2250, 389017) * 73 / 5));
}

TEST(Implicit_curve, refuses_what_is_no_regular_point)
{
  expect_refusal(Refusal_code::SINGULAR_POINT, Implicit_curve_2<Node>()(Point{Q(0), Q(0)}));
  const Implicit_curve_2<Ellipse> ellipse;
  const Point off{Q(1), Q(1)};
  expect_refusal(Refusal_code::NOT_ON_SURFACE, ellipse(off));
  EXPECT_TRUE(ellipse.level_set_shape(off));
  expect_refusal(Refusal_code::SINGULAR_POINT, ellipse.level_set_shape(Point{Q(0), Q(0)}));
}

TEST(Parametric_curve, has_the_curvature_of_the_unit_circle)
{
  const Parametric_curve_2<Circle> circle;
  const auto s = circle(fraction(1, 3));
  ASSERT_TRUE(s);
  EXPECT_EQ(s->point(), (Point{fraction(4, 5), fraction(3, 5)}));
  EXPECT_EQ(s->normal(), (Point{fraction(-36, 25), fraction(-27, 25)}));
  EXPECT_EQ(squared_curvature(*s), 1);
  EXPECT_EQ(sign_of_curvature(*s), CGAL::NEGATIVE); // the normal points inwards
  EXPECT_EQ(s->shape_number(), fraction(-9, 5));
  EXPECT_EQ(sign_of_curvature(s->opposite()), CGAL::POSITIVE);
}

TEST(Parametric_curve, has_the_curvature_of_a_cubic)
{
  const auto s = Parametric_curve_2<Cubic>()(fraction(1, 2));
  ASSERT_TRUE(s);
  EXPECT_EQ(s->point(), (Point{fraction(11, 8), fraction(5, 4)}));
  EXPECT_EQ(s->normal(), (Point{Q(-1), fraction(9, 4)}));
  EXPECT_EQ(s->normal_squared_length(), fraction(97, 16));
  EXPECT_EQ(squared_curvature(*s), fraction(230400, 912673));
  EXPECT_EQ(sign_of_curvature(*s), CGAL::NEGATIVE);

  // The same curve in Bernstein form.
  const Bezier bezier(
    Points{{Q(0), Q(1)}, {Q(1), Q(1)}, {Q(2), fraction(4, 3)}, {Q(2), Q(2)}});
  expect_same_answer(s, bezier(fraction(1, 2)));
}

TEST(Parametric_curve, refuses_what_is_no_regular_point)
{
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, Parametric_curve_2<Cusp>()(Q(0)));
  EXPECT_TRUE(Parametric_curve_2<Cusp>()(fraction(1, 1000000)));
  expect_refusal(Refusal_code::POLE, Parametric_curve_2<Hyperbola>()(Q(0)));
  expect_refusal(Refusal_code::NOT_ALGEBRAIC, Parametric_curve_2<Catenary>()(Q(1)));
  const auto s = Parametric_curve_2<Catenary>()(0.0);
  ASSERT_TRUE(s);
  EXPECT_DOUBLE_EQ(s->shape_number(), -2); // y = 2 cosh t, normal upwards: kappa = -2
}

// An implicit and a parametric curve with opposite normals agree but for the orientation.
TEST(Parametric_curve, agrees_with_the_implicit_curve)
{
  struct Unit_circle
  {
    auto operator()(const Jet<Q, 2, 2>& x, const Jet<Q, 2, 2>& y) const
    {
      return x * x + y * y - 1;
    }
  };
  Random random(20260201);
  for (int k = 0; k < 5; ++k)
  {
    const auto s = Parametric_curve_2<Circle>()(random.fraction(-30, 30, 9));
    ASSERT_TRUE(s);
    const auto t = Implicit_curve_2<Unit_circle>()(s->point());
    ASSERT_TRUE(t);
    expect_same_shape(s->opposite(), *t);
  }
}

TEST(Bezier_curve, agrees_with_the_parametric_curve_of_the_same_map)
{
  Random random(20260202);
  for (int degree : {1, 2, 3, 5, 7, 8, 10})
    for (bool rational : {false, true})
    {
      const Points p = random_points(random, degree + 1);
      const std::vector<Q> w = rational ? random_weights(random, degree + 1) : std::vector<Q>();
      const Bezier curve(p, w);
      const Parametric_curve_2<Bernstein_map> map(Bernstein_map{p, w});
      for (int k = 0; k < 4; ++k)
      {
        const Q t = random.in_unit_interval();
        expect_same_answer(map(t), curve(t));
        const auto d = curve.derivatives(t);
        ASSERT_TRUE(d);
        EXPECT_EQ(d->c, map.derivatives(t).c);
        EXPECT_EQ(d->t, map.derivatives(t).t);
        EXPECT_EQ(d->tt, map.derivatives(t).tt);
        EXPECT_EQ(d->c, *curve.point(t));
        // Outside, on the extension. (A zero of the weight is one for both.)
        const Q outside = t + 1;
        expect_refusal(Refusal_code::OUTSIDE_DOMAIN, curve(outside));
        expect_refusal(Refusal_code::OUTSIDE_DOMAIN, curve.derivatives(outside));
        expect_refusal(Refusal_code::OUTSIDE_DOMAIN, curve.point(Q(-t)));
        expect_same_answer(map(outside), curve.extended_shape(outside));
      }
    }
}

TEST(Bezier_curve, has_constant_curvature_on_circular_arcs)
{
  Random random(20260203);
  for (int k = 0; k < 10; ++k)
  {
    const Q t = random.in_unit_interval();
    const auto s = quarter_circle()(t);
    ASSERT_TRUE(s);
    EXPECT_EQ(squared_curvature(*s), 1);
    EXPECT_EQ(sign_of_curvature(*s), CGAL::NEGATIVE);
    EXPECT_EQ(internal::dot(s->point(), s->point()), 1);
    expect_same_answer(Parametric_curve_2<Circle>()(t), s);
  }
  // A straight line, however it is parametrised.
  const Bezier line(Points{{Q(0), Q(0)}, {Q(1), Q(2)}, {Q(5), Q(10)}});
  EXPECT_EQ(line(fraction(1, 3))->numerator(), 0);
}

TEST(Bezier_curve, takes_weights_of_any_sign)
{
  Random random(20260204);
  const Points p = random_points(random, 4);
  const std::vector<Q> w = random_weights(random, 4);
  std::vector<Q> negative;
  for (const Q& x : w)
    negative.push_back(-x);
  const Q t = random.in_unit_interval();
  expect_same_answer(Bezier(p, w)(t), Bezier(p, negative)(t));

  const Points q{{Q(0), Q(0)}, {Q(1), Q(0)}, {Q(1), Q(1)}};
  const Bezier with_pole(q, {Q(1), Q(0), Q(-1)}); // W = 1 - 2t
  expect_refusal(Refusal_code::POLE, with_pole(fraction(1, 2)));
  expect_refusal(Refusal_code::POLE, with_pole.point(fraction(1, 2)));
  expect_refusal(Refusal_code::POLE, with_pole.derivatives(fraction(1, 2)));
  const Parametric_curve_2<Bernstein_map> map(Bernstein_map{q, {Q(1), Q(0), Q(-1)}});
  for (int k : {1, 3})
    expect_same_answer(map(fraction(k, 4)), with_pole(fraction(k, 4)));
}

TEST(Bezier_curve, refuses_cusps)
{
  const Bezier cusp(Points{{Q(0), Q(0)}, {Q(0), Q(0)}, {Q(1), Q(0)}, {Q(1), Q(1)}});
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, cusp(Q(0)));
  EXPECT_TRUE(cusp(fraction(1, 1000000)));
  expect_refusal(Refusal_code::UNDECIDED, cusp.cast<Interval>()(Interval(0, 0.1)));
  EXPECT_FALSE(cusp.cast<double>()(std::numeric_limits<double>::quiet_NaN()));
}

TEST(Bezier_curve, reversed_has_the_opposite_normal)
{
  Random random(20260205);
  const Points p = random_points(random, 5);
  for (const Bezier& curve : {Bezier(p), Bezier(p, random_weights(random, 5))})
  {
    const Q t = random.in_unit_interval();
    const auto s = curve(t);
    ASSERT_TRUE(s);
    expect_same_answer(s->opposite(), curve.reversed()(Q(1 - t)));
    EXPECT_EQ(curve.reversed().control_point(0), curve.control_point(4));
    EXPECT_EQ(curve.reversed().weight(1), curve.weight(3));
  }
}

TEST(Bezier_curve, casts_what_was_given)
{
  Random random(20260206);
  const Bezier curve(random_points(random, 4), random_weights(random, 4));
  const auto rounded = curve.cast<double>();
  const auto back = rounded.cast<Q>();
  EXPECT_EQ(back.degree(), 3);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(back.cast<double>().control_point(i), rounded.control_point(i));
    EXPECT_EQ(back.homogeneous_control_point(i)[1],
              Q(Q(rounded.weight(i)) * Q(rounded.control_point(i)[1])));
  }
#ifdef CGAL_HAS_MPZF
  const auto ring = Bezier(Points{{Q(0), Q(0)}, {Q(1), Q(2)}, {Q(2), Q(0)}})
                      .cast<internal::Exact_ring>()(0.1);
  ASSERT_TRUE(ring);
  EXPECT_EQ(sign_decision(ring->numerator()), CGAL::POSITIVE);
#endif
}

// The enclosure contains the exact data, is narrow, and double is close to them.
template <class Curve>
void expect_enclosures(const Curve& curve, const Q& t)
{
  const auto exact = curve(t);
  const auto interval = curve.template cast<Interval>()(number_cast<Interval>(t));
  const auto approximate = curve.template cast<double>()(number_cast<double>(t));
  ASSERT_TRUE(exact);
  ASSERT_TRUE(interval) << interval.refusal().evidence();
  ASSERT_TRUE(approximate);
  for (int d = 0; d < 2; ++d)
  {
    expect_contains(interval->point()[d], exact->point()[d]);
    expect_contains(interval->normal()[d], exact->normal()[d]);
  }
  const Interval b = interval->shape_number();
  const double expected = number_cast<double>(exact->shape_number());
  expect_contains(b, exact->shape_number());
  EXPECT_LT(b.sup() - b.inf(), 1e-8 * (1 + std::abs(expected)));
  EXPECT_NEAR(approximate->shape_number(), expected, 1e-9 * (1 + std::abs(expected)));
}

TEST(Bezier_curve, is_enclosed_by_intervals)
{
  Random random(20260207);
  for (int degree : {1, 2, 3, 6, 9})
  {
    const Points p = random_points(random, degree + 1);
    expect_enclosures(Bezier(p), random.in_unit_interval());
    expect_enclosures(Bezier(p, random_weights(random, degree + 1)), random.in_unit_interval());
  }
}

TEST(Nurbs_curve, agrees_with_its_bezier_arcs_inside_and_at_knots_from_each_side)
{
  Random random(20260208);
  for (const auto& knots : knot_vectors)
    for (bool rational : {false, true})
    {
      const int n = knots.number_of_control_points();
      const Nurbs curve(knots, random_points(random, n),
                        rational ? random_weights(random, n) : std::vector<Q>());
      const auto pieces = curve.bezier_arcs();
      EXPECT_EQ(pieces.size(), knots.spans().size());
      EXPECT_EQ(pieces.front().t[0], curve.domain()[0]);
      EXPECT_EQ(pieces.back().t[1], curve.domain()[1]);
      for (const auto& piece : pieces)
      {
        const Q s = random.in_unit_interval();
        const Q t = piece.t[0] + s * (piece.t[1] - piece.t[0]);
        expect_same_answer(piece.arc(s), curve(t));
        expect_same_answer(piece.arc(Q(0)), curve(piece.t[0], Side::RIGHT));
        expect_same_answer(piece.arc(Q(1)), curve(piece.t[1], Side::LEFT));
        expect_enclosures(curve, t);
      }
    }
}

// Order 3 with one knot inside: the derivative has the control points 8, -10, 28.
TEST(Nurbs_curve, has_the_derivative_of_the_corrected_formula)
{
  const Knot_vector<Q> knots(2, rationals({0, 0, 0, 1, 2, 2, 2}, 2));
  const Nurbs curve(knots, Points{{Q(1), Q(0)}, {Q(3), Q(1)}, {Q(-2), Q(3)}, {Q(5), Q(4)}});
  EXPECT_EQ(curve.derivatives(Q(0))->t[0], 8);
  EXPECT_EQ(curve.derivatives(fraction(1, 2))->t[0], -10);
  EXPECT_EQ(curve.derivatives(Q(1))->t[0], 28);
  EXPECT_EQ(curve.derivatives(fraction(1, 4))->t[0], -1);
  EXPECT_EQ(curve.derivatives(fraction(1, 2), Side::LEFT)->tt[0], -36);
  EXPECT_EQ(curve.derivatives(fraction(1, 2), Side::RIGHT)->tt[0], 76);
}

TEST(Nurbs_curve, has_two_shapes_where_it_is_not_smooth_enough)
{
  const Knot_vector<Q> knots(2, rationals({0, 0, 0, 1, 2, 2, 3, 3, 3}));
  Random random(20260209);
  const Nurbs curve(knots, random_points(random, 6), random_weights(random, 6));
  for (int t : {1, 2})
  {
    const auto sides = curve.one_sided_shapes(Q(t));
    ASSERT_TRUE(sides);
    ASSERT_EQ(sides->size(), 2u);
    EXPECT_EQ((*sides)[0].side, Side::LEFT);
    EXPECT_EQ((*sides)[1].side, Side::RIGHT);
    const Shape left = *(*sides)[0].shape, right = *(*sides)[1].shape;
    EXPECT_EQ(left.point(), right.point());
    expect_same_answer(curve(Q(t)), right);
    EXPECT_NE(squared_curvature(left), squared_curvature(right));
    const Q turn = left.normal()[0] * right.normal()[1] - left.normal()[1] * right.normal()[0];
    EXPECT_EQ(turn == 0, t == 1); // a corner at the double knot
  }
  for (const Q& t : {Q(0), fraction(1, 2), Q(3)})
    EXPECT_EQ(curve.one_sided_shapes(t)->size(), 1u);
  EXPECT_EQ(curve.one_sided_shapes(Q(3))->front().side, Side::LEFT);
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, curve.one_sided_shapes(Q(4)));
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, curve(Q(-1)));

  // A cubic with simple knots has two continuous derivatives: one answer everywhere.
  const Nurbs smooth(Knot_vector<Q>(3, rationals({0, 0, 0, 0, 1, 2, 2, 2, 2})),
                     random_points(random, 5));
  EXPECT_EQ(smooth.one_sided_shapes(Q(1))->size(), 1u);
  expect_same_answer(smooth(Q(1), Side::LEFT), smooth(Q(1), Side::RIGHT));
}

// A full circle as four rational arcs is one circle at its knots too.
TEST(Nurbs_curve, is_a_circle_from_both_sides_of_its_knots)
{
  const Knot_vector<Q> knots(2, rationals({0, 0, 0, 1, 1, 2, 2, 2}));
  const Points p{{Q(1), Q(0)}, {Q(1), Q(1)}, {Q(0), Q(1)}, {Q(-1), Q(1)}, {Q(-1), Q(0)}};
  const Nurbs circle(knots, p, rationals({1, 1, 2, 2, 4}));
  for (int k = 0; k <= 8; ++k)
    for (const auto& side : circle.one_sided_shapes(fraction(k, 4)).value())
      EXPECT_EQ(squared_curvature(side.shape.value()), 1) << k;
}

TEST(Nurbs_curve, tells_why_it_is_invalid)
{
  const Knot_vector<Q> knots(1, rationals({0, 0, 1, 1}));
  Random random(20260210);
  EXPECT_FALSE(Nurbs::why_invalid(knots, random_points(random, 2)));
  EXPECT_EQ(Nurbs::why_invalid(knots, random_points(random, 3)),
            "there are 3 control points, the knots need 2");
  EXPECT_EQ(Nurbs::why_invalid(knots, random_points(random, 2), random_weights(random, 1)),
            "there are 1 weights, the knots need 2");
#ifndef CGAL_NO_PRECONDITIONS
  EXPECT_THROW(Nurbs(knots, random_points(random, 3)), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(random_points(random, 1)), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(random_points(random, 2), random_weights(random, 1)),
               CGAL::Precondition_exception);
#endif
}

} // namespace
