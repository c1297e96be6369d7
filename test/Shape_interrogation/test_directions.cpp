// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Questions about tangent directions, on random exact data: the second form from three curvatures
// in three ways, asymptotic directions, projectors, and what is refused.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/asymptotic_directions.h>
#include <CGAL/Shape_interrogation/Analysis/Dupin_indicatrix.h>
#include <CGAL/Shape_interrogation/Analysis/hessian_by_cases.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/three_tangents.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Real = CORE::Expr;
using Point = Coordinates<Q, 3>;
using Shape = Local_shape_3<Q>;

const Point origin{Q(0), Q(0), Q(0)};

// Unit normals with every pattern of zeros: a row of a rational rotation, or of one about an axis.
std::vector<Point> unit_normals(Random& random)
{
  std::vector<Point> normals;
  for (int i = 0; i < 10; ++i)
    normals.push_back(testing_shapes::random_rotation(random)[i % 3]);
  const Q c = Q(3) / 5, s = Q(-4) / 5, zero(0), one(1);
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& [a, b] : {std::make_pair(c, s), std::make_pair(s, c),
                               std::make_pair(one, zero), std::make_pair(Q(-1), zero)})
    {
      Point h = origin;
      h[(axis + 1) % 3] = a;
      h[(axis + 2) % 3] = b;
      normals.push_back(h);
    }
  return normals;
}

// --- The shape operator from three curvatures ----------------------------------------------------

TEST(Three_curvatures, cases_and_general_solution_agree)
{
  Random random(1);
  std::array<int, 7> patterns{};
  for (const Point& h : unit_normals(random))
  {
    const Normal_pattern pattern = normal_pattern(h);
    ++patterns[static_cast<int>(pattern)];
    const std::array<Q, 3> kappa{random.rational(), random.rational(), random.rational()};
    const auto directions = case_directions(h, pattern);
    const auto s = shape_from_normal_curvatures(origin, h, directions, kappa);
    ASSERT_TRUE(s) << s.refusal().evidence();
    const auto b = s->shape_matrix(), m = hessian_by_cases(h, pattern, kappa);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(normal_curvature(*s, directions[i]), kappa[i]);
      for (int j = i; j < 3; ++j)
        EXPECT_EQ(b(i, j), m(i, j)) << to_string(pattern);
    }
  }
  for (const int n : patterns)
    EXPECT_GT(n, 0) << "every pattern occurs";
}

TEST(Three_curvatures, any_directions_of_any_surface)
{
  Random random(2);
  int solved = 0;
  for (int i = 0; i < 30; ++i)
  {
    // A normal of rational length, so that curvatures are rational.
    Point n = testing_shapes::random_rotation(random)[0];
    const Q length = CGAL::abs(random.nonzero_rational());
    for (Q& x : n)
      x = x * length;
    const Shape s = Shape::from_form(origin, n, random.matrix());
    std::array<Point, 3> d;
    std::array<Q, 3> kappa;
    for (int k = 0; k < 3; ++k)
    {
      d[k] = internal::cross(n, random.nonzero_vector());
      if (CGAL::is_zero(internal::dot(d[k], d[k])))
        d[k] = internal::cross(n, Point{Q(1), Q(2), Q(5)});
      kappa[k] = normal_curvature(s, d[k]);
    }
    const auto t = shape_from_normal_curvatures(origin, n, d, kappa);
    if (!t)
      continue;
    ++solved;
    const auto a = s.shape_matrix(), b = t->shape_matrix();
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l)
        EXPECT_EQ(a(k, l), b(k, l));
  }
  EXPECT_GT(solved, 25);
}

template <class T>
void expect_code(const Result<T>& result, Refusal_code code)
{
  ASSERT_FALSE(result);
  EXPECT_EQ(to_string(result.refusal().code()), std::string(to_string(code)));
  EXPECT_FALSE(result.refusal().evidence().empty());
}

TEST(Three_curvatures, refusals)
{
  const Point n{Q(0), Q(0), Q(1)}, x{Q(1), Q(0), Q(0)}, y{Q(0), Q(1), Q(0)}, d{Q(1), Q(1), Q(0)};
  const std::array<Q, 3> kappa{Q(1), Q(2), Q(3)};
  const auto solve = [&](const Point& normal, const std::array<Point, 3>& directions) {
    return shape_from_normal_curvatures(origin, normal, directions, kappa);
  };
  EXPECT_TRUE(solve(n, {x, y, d}));
  expect_code(solve(n, {x, y, Point{Q(-3), Q(0), Q(0)}}), Refusal_code::DEPENDENT_DIRECTIONS);
  expect_code(solve(n, {x, origin, y}), Refusal_code::DEPENDENT_DIRECTIONS);
  expect_code(solve(n, {x, y, Point{Q(1), Q(1), Q(Q(1) / 1000000000)}}),
              Refusal_code::NOT_TANGENT);
  expect_code(solve(origin, {x, y, d}), Refusal_code::SINGULAR_POINT);
  const Point skew{Q(1), Q(1), Q(0)}; // of length sqrt(2), which is not rational
  expect_code(solve(skew, {n, Point{Q(1), Q(-1), Q(0)}, Point{Q(1), Q(-1), Q(1)}}),
              Refusal_code::NOT_ALGEBRAIC);
}

TEST(Directions, refusals)
{
  const Point n{Q(0), Q(0), Q(2)};
  const Shape s = Shape::from_form(origin, n, Symmetric_matrix_3<Q>(1, 0, 0, 2, 0, 0));
  EXPECT_FALSE(refuse_direction(s, Point{Q(1), Q(2), Q(0)}));
  EXPECT_EQ(refuse_direction(s, Point{Q(1), Q(2), Q(1)})->code(), Refusal_code::NOT_TANGENT);
  EXPECT_EQ(refuse_direction(s, origin)->code(), Refusal_code::DEPENDENT_DIRECTIONS);
  const Shape sphere = Shape::from_form(origin, n, Symmetric_matrix_3<Q>(3, 0, 0, 3, 0, 0));
  expect_code(projector_on_max_direction(sphere), Refusal_code::AMBIGUOUS);
  expect_code(principal_directions(sphere.cast<double>()), Refusal_code::AMBIGUOUS);
}

// Directions that are not tangent stand for their projections: what the form does to the normal,
// which is no property of the surface, does not matter.
TEST(Directions, not_tangent)
{
  Random random(3);
  for (int i = 0; i < 40; ++i)
  {
    const Point n = random.nonzero_vector(), w = random.vector(), v = random.nonzero_vector();
    const Symmetric_matrix_3<Q> t = random.matrix();
    Symmetric_matrix_3<Q> other = t;
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l)
        other(k, l) = t(k, l) + n[k] * w[l] + w[k] * n[l];
    const Q scale = Q(random.integer(1, 9)) / 7;
    const Shape a = Shape::from_form(origin, n, t, scale),
                b = Shape::from_form(origin, n, other, scale);
    const Q form = internal::dot(v, internal::multiply(a.shape_matrix(), v));
    EXPECT_EQ(sign_of_normal_curvature(a, v), CGAL::sign(form));
    EXPECT_EQ(sign_of_normal_curvature(b, v), CGAL::sign(form));
    EXPECT_EQ(sign_of_normal_curvature(a, n), CGAL::ZERO) << "no direction in the surface";
    const Q c = internal::dot(n, v), q = internal::dot(n, n);
    const Q length = internal::dot(v, v) - c * c / q;
    if (CGAL::is_zero(length))
      continue;
    EXPECT_EQ(squared_normal_curvature(a, v), Q(form * form / (length * length * q)));
    EXPECT_EQ(squared_normal_curvature(b, v), squared_normal_curvature(a, v));
    EXPECT_NEAR(normal_curvature(b.cast<double>(), cast_argument<double>(v)),
                number_cast<double>(Q(form / length)) / std::sqrt(number_cast<double>(q)), 1e-9);
    const CGAL::Interval_nt<false>::Protector protector;
    const auto sign = sign_of_normal_curvature(b.cast<CGAL::Interval_nt<false>>(),
                                               cast_argument<CGAL::Interval_nt<false>>(v));
    EXPECT_TRUE(CGAL::possibly(sign == CGAL::sign(form)));
    EXPECT_TRUE(CGAL::is_certain(sign) || CGAL::is_zero(form)) << "decides";
  }
}

// The length of the normal is no obstacle in double, as long as its square is one.
TEST(Directions, in_double_for_normals_of_any_length)
{
  for (const double length : {1e-150, 1e-3, 1e150})
  {
    const auto s = Local_shape_3<double>::from_form(
      {0, 0, 0}, {length, 0, 0}, Symmetric_matrix_3<double>(0, 0, 0, length, 0, 2 * length));
    EXPECT_EQ(sign_of_normal_curvature(s, {1e-3, 1, 0}), CGAL::POSITIVE) << length;
    EXPECT_NEAR(normal_curvature(s, {1e-3, 1, 0}), 1, 1e-12) << length;
    EXPECT_NEAR(normal_curvature(s, {-1, 0, 1}), 2, 1e-12) << length;
  }
}

// --- The projector -------------------------------------------------------------------------------

TEST(Projector, projects_on_the_larger_curvature)
{
  Random random(3);
  for (int i = 0; i < 20; ++i)
  {
    // Principal curvatures k, l in a rotated frame: the discriminant is a square.
    const auto r = testing_shapes::random_rotation(random);
    const Q k = random.rational(), l = k + CGAL::abs(random.nonzero_rational());
    Symmetric_matrix_3<Q> b;
    for (int a = 0; a < 3; ++a)
      for (int c = a; c < 3; ++c)
        b(a, c) = k * r[0][a] * r[0][c] + l * r[1][a] * r[1][c];
    const Shape s(origin, r[2], b);
    EXPECT_EQ(principal_curvatures(s), (std::array<Q, 2>{k, l}));
    const auto p = projector_on_max_direction(s);
    ASSERT_TRUE(p) << p.refusal().evidence();
    for (int a = 0; a < 3; ++a)
      for (int c = a; c < 3; ++c)
        EXPECT_EQ((*p)(a, c), Q(r[1][a] * r[1][c]));
    // The reversed normal exchanges the two.
    const auto q = projector_on_max_direction(s.opposite());
    for (int a = 0; a < 3; ++a)
      EXPECT_EQ((*q)(a, a), Q(r[0][a] * r[0][a]));
  }
}

// --- Forms in the tangent plane ------------------------------------------------------------------

Quadratic_form_2<Q> random_form(Random& random, int size = 4)
{
  return {random.rational(size), random.rational(size), random.rational(size)};
}

Quadratic_form_2<Q> random_metric(Random& random)
{
  const Q a = random.nonzero_rational(), b = random.rational(), c = random.nonzero_rational();
  return {Q(a * a), Q(a * b), Q(b * b + c * c)};
}

TEST(Forms, three_tangents_for_any_metric)
{
  Random random(4);
  for (int i = 0; i < 30; ++i)
  {
    const Fundamental_forms<Q> forms{random_metric(random), random_form(random)};
    std::array<Coordinates<Q, 2>, 3> t;
    std::array<Q, 3> kappa;
    for (int k = 0; k < 3; ++k)
    {
      t[k] = {random.nonzero_rational(), random.rational()};
      kappa[k] = forms.normal_curvature(t[k]);
    }
    const auto solution = second_form_from_three_tangents(forms.first, t, kappa);
    ASSERT_EQ(bool(solution), !CGAL::is_zero(three_tangents_determinant(t)));
    if (solution)
    {
      EXPECT_TRUE((*solution - forms.second).is_zero());
    }
  }
}

// The value of the form in (a + b r, c) with r^2 = d, as two rational parts.
std::pair<Q, Q> value_with_root(const Quadratic_form_2<Q>& f, const Q& a, const Q& b, const Q& c,
                                const Q& d)
{
  return {Q(f.l * (a * a + b * b * d) + 2 * f.m * a * c + f.n * c * c),
          Q(2 * f.l * a * b + 2 * f.m * b * c)};
}

TEST(Forms, asymptotic_directions_are_zeros)
{
  Random random(5);
  int single = 0;
  for (int i = 0; i < 200; ++i)
  {
    Quadratic_form_2<Q> f = random_form(random, 2);
    if (i % 4 == 0)
      f.l = 0;
    const auto a = asymptotic_directions(f);
    const CGAL::Sign sign = CGAL::sign(a.discriminant);
    EXPECT_EQ(a.type, f.is_zero()               ? Asymptotic_type::ALL
                      : sign == CGAL::ZERO      ? Asymptotic_type::REAL_DOUBLE
                      : sign == CGAL::POSITIVE  ? Asymptotic_type::REAL_DISTINCT
                                                : Asymptotic_type::COMPLEX);
    EXPECT_EQ(a.x_is_single, CGAL::is_zero(f.l));
    if (a.type == Asymptotic_type::ALL)
      continue;
    if (a.x_is_single)
    {
      ++single;
      EXPECT_EQ(f({Q(1), Q(0)}), Q(0));
      EXPECT_EQ(f({a.x, a.y}), Q(0));
      EXPECT_FALSE(CGAL::is_zero(a.x) && CGAL::is_zero(a.y));
      EXPECT_EQ(CGAL::is_zero(a.y), a.type == Asymptotic_type::REAL_DOUBLE);
    }
    else // also for a negative discriminant: the root is then imaginary
      EXPECT_EQ(value_with_root(f, a.x, Q(1), a.y, a.discriminant), std::make_pair(Q(0), Q(0)));
  }
  EXPECT_GT(single, 40);
}

TEST(Forms, common_asymptotic_directions)
{
  Random random(6);
  int agreeing = 0;
  for (int i = 0; i < 60; ++i)
  {
    // (p x + q y)(..) and (p x + q y)(..) share a direction; other factors are their own.
    const Q p = random.nonzero_rational(), q = random.rational();
    const auto with_factor = [&](const Q& r, const Q& s) {
      return Quadratic_form_2<Q>{Q(p * r), Q((p * s + q * r) / 2), Q(q * s)};
    };
    const auto a = with_factor(random.rational(), random.nonzero_rational());
    const auto b = with_factor(random.rational(), random.nonzero_rational());
    EXPECT_TRUE(have_common_asymptotic_direction(a, b));
    // Made to agree on t by a factor, they still share it.
    const Coordinates<Q, 2> t{random.rational(), random.nonzero_rational()};
    const Q at = a(t), bt = b(t);
    if (CGAL::is_zero(at) || CGAL::is_zero(bt))
      continue;
    ++agreeing;
    const Q factor = at / bt;
    const Quadratic_form_2<Q> c{Q(b.l * factor), Q(b.m * factor), Q(b.n * factor)};
    EXPECT_TRUE(have_transversal_asymptotic_direction(a, c, t));
    EXPECT_TRUE(have_transversal_asymptotic_direction(a, a, t));
  }
  EXPECT_GT(agreeing, 30);
}

// Forms that agree in all pairs with t differ by a multiple of (x x t)^2: they share a transversal
// direction only if they are equal (the complex corollary).
TEST(Forms, complex_corollary)
{
  Random random(61);
  for (int i = 0; i < 60; ++i)
  {
    const Coordinates<Q, 2> t{random.rational(), random.nonzero_rational()};
    const Q k = i % 3 ? random.rational() : Q(0);
    const auto a = random_form(random);
    const Quadratic_form_2<Q> b{Q(a.l + k * t[1] * t[1]), Q(a.m - k * t[0] * t[1]),
                                Q(a.n + k * t[0] * t[0])};
    const Coordinates<Q, 2> s{random.rational(), random.rational()};
    EXPECT_EQ(a(t, s), b(t, s));
    const bool only_at_t = CGAL::is_zero(a.determinant()) && CGAL::is_zero(a(t));
    EXPECT_EQ(have_transversal_asymptotic_direction(a, b, t),
              CGAL::is_zero(k) && (a.is_zero() || !only_at_t));
  }
}

// (x x t)^2 has its double direction at t, which proves nothing, even where the forms are equal.
TEST(Forms, double_direction_along_the_curve)
{
  const Coordinates<Q, 2> t{Q(2), Q(3)};
  const Quadratic_form_2<Q> f{Q(9), Q(-6), Q(4)}, g{Q(18), Q(-12), Q(8)}, zero{Q(0), Q(0), Q(0)};
  EXPECT_EQ(f(t), Q(0));
  EXPECT_FALSE(have_transversal_asymptotic_direction(f, g, t));
  EXPECT_FALSE(have_transversal_asymptotic_direction(f, f, t));
  EXPECT_TRUE(have_transversal_asymptotic_direction(zero, zero, t));
}

TEST(Forms, dupin_line_direction_is_the_null_direction)
{
  Random random(7);
  for (int i = 0; i < 30; ++i)
  {
    const Q p = random.rational(), q = random.nonzero_rational(), sign = i % 2 ? 1 : -1;
    const Fundamental_forms<Q> forms{random_metric(random),
                                     {Q(sign * p * p), Q(sign * p * q), Q(sign * q * q)}};
    const auto d = dupin_indicatrix(forms);
    EXPECT_EQ(d.type, Dupin_type::PARALLEL_LINES);
    EXPECT_EQ(d.right_hand_side, i % 2 ? 1 : -1);
    ASSERT_TRUE(d.line_direction);
    EXPECT_EQ(forms.second(*d.line_direction), Q(0));
    EXPECT_FALSE(CGAL::is_zero(forms.first(*d.line_direction)));
    EXPECT_TRUE(is_same_point_set(d, d));
    // 1 / |kappa| for the only principal curvature, which is 2 H.
    EXPECT_EQ(Q(squared_half_distance_of_lines(forms) * CGAL::abs(Q(2 * forms.mean_curvature()))),
              Q(1));
  }
}

TEST(Forms, of_a_shape_in_a_tangent_basis)
{
  Random random(8);
  for (int i = 0; i < 20; ++i)
  {
    const Shape s = Shape::from_form(origin, random.nonzero_vector(), random.matrix());
    const Point u = internal::cross(s.normal(), Point{Q(1), Q(0), Q(0)});
    const Point v = internal::cross(s.normal(), Point{Q(0), Q(1), Q(0)});
    const auto forms = fundamental_forms(s, u, v);
    // II is scaled by w sqrt(q).
    const Q q = s.normal_squared_length();
    EXPECT_EQ(forms.gaussian_curvature(), Q(gaussian_curvature(s) * q));
    EXPECT_EQ(forms.is_umbilic(), is_umbilic(s));
    const Coordinates<Q, 2> t{random.nonzero_rational(), random.rational()};
    Point w;
    for (int k = 0; k < 3; ++k)
      w[k] = t[0] * u[k] + t[1] * v[k];
    const Q kappa = forms.normal_curvature(t);
    EXPECT_EQ(Q(kappa * kappa), Q(squared_normal_curvature(s, w) * q));
  }
}

} // namespace
