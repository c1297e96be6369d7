// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Property surfaces: against values that are computed at points from the waist and the derivatives,
// against the degrees of the product formulas, and on surfaces of constant curvature.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/patch_of_expressions.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using Point = Coordinates<Q, 3>;
using Parameters = Coordinates<Q, 2>;
using Inputs = Property_inputs<Q>;

std::vector<Property> all_properties()
{
  std::vector<Property> all;
  for (int i = 0; i <= static_cast<int>(Property::CURVATURE_V); ++i)
    all.push_back(static_cast<Property>(i));
  return all;
}

Bezier_surface_3<Q> random_patch(Random& random, int m, int n, bool is_rational)
{
  std::vector<Coordinates<Q, 4>> points;
  std::vector<Point> polynomial_points;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
    {
      const Point p{random.rational(), random.rational(), random.rational()};
      points.push_back({p[0], p[1], p[2], random.rational()}); // weights of both signs, or zero
      polynomial_points.push_back(p);
    }
  return is_rational ? Bezier_surface_3<Q>::from_homogeneous(m, n, points)
                     : Bezier_surface_3<Q>(m, n, polynomial_points);
}

Inputs random_inputs(Random& random)
{
  Inputs in;
  in.up = random.nonzero_vector();
  in.view = random.nonzero_vector();
  in.light = random.nonzero_vector();
  in.level = random.rational();
  return in;
}

Q square(const Q& x)
{
  Q y = x * x;
  return y;
}

int sign_of(const Q& x) { return static_cast<int>(CGAL::sign(x)); }

// The value, and the sign of what it is the square of, the long way round: from the waist where it
// knows them, else from the definition.
struct Expected
{
  Q value;
  int sign;
};

Expected itself(const Q& x) { return {x, sign_of(x)}; }

// The square of x / sqrt(q).
Expected squared_over(const Q& x, const Q& q)
{
  Q value = square(x) / q;
  return {value, sign_of(x)};
}

Expected normal_curvature(const Local_shape_3<Q>& s, const Point& t)
{
  const Q form = internal::dot(t, internal::multiply(s.shape_matrix(), t)); // v.Bv
  const Q length = internal::dot(t, t) * internal::dot(t, t) * s.normal_squared_length();
  return squared_over(form, length);
}

Expected expected(const Surface_derivatives_3<Q>& d, const Local_shape_3<Q>& s, Property property,
                  const Inputs& in)
{
  using internal::dot;
  const Point n = internal::cross(d.u, d.v);
  const Q q = dot(n, n), e = dot(d.u, d.u), g = dot(d.v, d.v);
  const Q normal_twist = dot(n, d.uv), det = dot(n, d.uu) * dot(n, d.vv) - square(normal_twist);
  switch (property)
  {
  case Property::NORMAL_Z: return itself(n[2]);
  case Property::NORMAL_Z_SQUARED: return squared_over(n[2], q);
  case Property::SLOPE: {
    const Q cosine = square(dot(n, in.up)) / (q * dot(in.up, in.up));
    return {Q(1 / cosine - 1), sign_of(dot(n, in.up))};
  }
  case Property::SPEED: return itself(e + g);
  case Property::SPEED_SUPREMUM: break;
  case Property::TWIST_SQUARED: return itself(dot(d.uv, d.uv));
  case Property::NORMAL_TWIST: return itself(normal_twist);
  case Property::TANGENTIAL_TWIST_SQUARED: {
    Point t;
    for (int i = 0; i < 3; ++i)
      t[i] = d.uv[i] - normal_twist / q * n[i];
    return itself(dot(t, t));
  }
  case Property::SECOND_FORM_DETERMINANT: return itself(det);
  case Property::GAUSSIAN: return itself(gaussian_curvature(s));
  case Property::MEAN_SQUARED:
    return {squared_mean_curvature(s), static_cast<int>(sign_of_mean_curvature(s))};
  case Property::CURVATURE_BOUND:
    return itself(4 * squared_mean_curvature(s) - 2 * gaussian_curvature(s));
  case Property::UMBILIC: return itself(squared_curvature_gap(s));
  case Property::SILHOUETTE:
    if (in.eye)
      return itself(dot(n, d.s) - dot(n, *in.eye));
    return itself(dot(n, in.view));
  case Property::ISOPHOTE: {
    const Q cosine = square(dot(n, in.light)) / (q * dot(in.light, in.light));
    return {Q(cosine - square(in.level)), sign_of(dot(n, in.light))};
  }
  case Property::ASYMPTOTIC_DISCRIMINANT: return itself(-det);
  case Property::CURVATURE_U: return normal_curvature(s, d.u);
  case Property::CURVATURE_V: return normal_curvature(s, d.v);
  }
  return {Q(0), 0};
}

// (x - (E + G) / 2)^2 is a quarter of the radicand, so an enclosure of x is checked by its square.
void check_supremum(const Surface_derivatives_3<Q>& d, const CGAL::Interval_nt<true>& x)
{
  using internal::dot;
  const Q e = dot(d.u, d.u), f = dot(d.u, d.v), g = dot(d.v, d.v);
  const auto excess = [&](const Q& y) {
    return Q(square(2 * y - e - g) - square(e - g) - 4 * f * f);
  };
  EXPECT_GE(Q(2 * Q(x.sup())), Q(e + g));
  EXPECT_GE(excess(Q(x.sup())), 0);
  EXPECT_TRUE(Q(2 * Q(x.inf())) <= Q(e + g) || excess(Q(x.inf())) <= 0);
  EXPECT_LE(x.sup() - x.inf(), 1e-12 * x.sup());
}

// What the two sides of a property say at a point where the surface is regular.
void check_at(const Property_surface<Q>& surface, const Bernstein_polynomial_2<Q>& sign,
              const Parameters& on_square, const Surface_derivatives_3<Q>& d,
              const Local_shape_3<Q>& s, const Inputs& in)
{
  const Property property = surface.property();
  if (property == Property::SPEED_SUPREMUM)
  {
    check_supremum(d, *surface.enclosure(on_square));
    expect_refusal(Refusal_code::NOT_ALGEBRAIC, surface.value(on_square));
    return;
  }
  const Expected e = expected(d, s, property, in);
  const Result<Q> value = surface.value(on_square), pointwise = property_value(d, property, in);
  ASSERT_TRUE(value) << value.refusal().evidence();
  EXPECT_EQ(e.value, *value);
  ASSERT_TRUE(pointwise);
  EXPECT_EQ(e.value, *pointwise);
  EXPECT_EQ(e.sign, sign_of(sign(on_square)));
  expect_contains(*surface.enclosure(on_square), e.value);
}

class Properties : public testing::TestWithParam<Property> {};

TEST_P(Properties, of_random_patches_are_those_at_points)
{
  Random random(20260401);
  constexpr std::array<std::array<int, 2>, 6> degrees{
    {{1, 1}, {1, 2}, {3, 1}, {2, 2}, {2, 3}, {3, 3}}};
  int checked = 0;
  for (const auto& degree : degrees)
    for (bool is_rational : {false, true})
    {
      const auto patch = random_patch(random, degree[0], degree[1], is_rational);
      Inputs in = random_inputs(random);
      if (random.integer(0, 1))
        in.eye = random.vector();
      Property_surface_maker<Q> maker(patch);
      const auto surface = maker(GetParam(), in);
      const auto sign = maker.sign(GetParam(), in);
      for (int k = 0; k < 2; ++k)
      {
        const Parameters uv{random.in_unit_interval(), random.in_unit_interval()};
        const auto s = patch(uv);
        if (!s)
          continue;
        check_at(surface, sign, uv, *patch.derivatives(uv), *s, in);
        ++checked;
      }
    }
  EXPECT_GT(checked, 20);
}

TEST_P(Properties, of_splines_are_those_at_points_on_both_sides_of_knots)
{
  Random random(20260402);
  const Property property = GetParam();
  const auto& u = knot_vectors[1];
  const auto& v = knot_vectors[4]; // degree 1 with a break
  std::vector<std::vector<Point>> p(u.number_of_control_points());
  std::vector<std::vector<Q>> w(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int j = 0; j < v.number_of_control_points(); ++j)
    {
      p[i].push_back({Q(2 * Q(int(i)) + random.rational() / 9), Q(3 * Q(j) + random.rational() / 9),
                      random.rational()});
      w[i].push_back(random.fraction(1, 9, 5));
    }
  const Inputs in = random_inputs(random);
  for (bool is_rational : {false, true})
  {
    const Nurbs_surface_3<Q> surface(u, v, p, is_rational ? w : std::vector<std::vector<Q>>());
    const auto pieces = property_surface(surface, property, in);
    const auto patches = surface.bezier_patches();
    ASSERT_EQ(pieces.size(), patches.size());
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (Side side : {Side::LEFT, Side::RIGHT}) // the start of the piece and its end
      {
        const bool is_end = side == Side::LEFT;
        const Parameters uv{pieces[k].u[is_end ? 1 : 0], pieces[k].v[is_end ? 1 : 0]};
        const auto s = surface(uv, side, side);
        if (!s)
          continue;
        EXPECT_EQ(uv, pieces[k].on_surface(pieces[k].on_square(uv)));
        const auto sign = Property_surface_maker<Q>(patches[k]).sign(property, in);
        check_at(pieces[k].surface, sign, pieces[k].on_square(uv),
                 *surface.derivatives(uv, side, side), *s, in);
        if (property != Property::SPEED_SUPREMUM)
        {
          EXPECT_EQ(*pieces[k].value(uv), *pieces[k].surface.value(pieces[k].on_square(uv)));
        }
      }
  }
}

TEST_P(Properties, in_intervals_enclose_the_exact_ones)
{
  using Interval = CGAL::Interval_nt<true>;
  Random random(20260403);
  const auto patch = random_patch(random, 2, 2, true);
  const Property property = GetParam();
  const auto exact = property_surface(patch, property);
  const auto enclosed = property_surface(patch.cast<Interval>(), property);
  const auto& a = exact.numerator().scaled_coefficients();
  const auto& b = enclosed.numerator().scaled_coefficients();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    expect_contains(b[i], a[i]);
  const Q u = fraction(1, 3), v = fraction(2, 7);
  const auto number = [](const Q& x) { return number_cast<Interval>(x); };
  expect_contains(enclosed.denominator()({number(u), number(v)}), exact.denominator()({u, v}));
}

INSTANTIATE_TEST_SUITE_P(, Properties, testing::ValuesIn(all_properties()),
                         [](const auto& info) { return std::string(to_string(info.param)); });

TEST(Property, has_its_name)
{
  for (Property p : all_properties())
    EXPECT_EQ(p, property_of_name(to_string(p)));
  EXPECT_FALSE(property_of_name("beauty"));
  EXPECT_STREQ("speed_supremum", to_string(Property::SPEED_SUPREMUM));
}

TEST(Property_surface, has_the_degrees_of_the_product_formulas)
{
  Random random(20260404);
  const auto degree_of = [&](const Bezier_surface_3<Q>& patch, Property p) {
    return property_surface(patch, p).numerator().degree();
  };
  using Degree = std::array<int, 2>;
  for (int m : {2, 3})
    for (int n : {2, 4})
    {
      const auto patch = random_patch(random, m, n, false);
      EXPECT_EQ((Degree{2 * m - 1, 2 * n - 1}), degree_of(patch, Property::NORMAL_Z));
      EXPECT_EQ((Degree{2 * m, 2 * n}), degree_of(patch, Property::SPEED));
      EXPECT_EQ((Degree{6 * m - 4, 6 * n - 4}),
                degree_of(patch, Property::SECOND_FORM_DETERMINANT));
      EXPECT_EQ((Degree{10 * m - 6, 10 * n - 6}), degree_of(patch, Property::MEAN_SQUARED));
      const auto rational = random_patch(random, m, n, true);
      EXPECT_EQ((Degree{3 * m - 1, 3 * n - 1}), degree_of(rational, Property::NORMAL_Z));
      EXPECT_EQ((Degree{0, 0}),
                property_surface(patch, Property::NORMAL_Z).denominator().degree());
    }
}

// Patches made of two arcs of a circle with numerators c, s over d: R is the radius of the centres.
template <class NT>
Bezier_surface_3<NT> torus_patch(const std::array<std::array<NT, 3>, 3>& arc, const NT& R,
                                 const NT& r)
{
  const auto& [c, s, d] = arc;
  std::vector<Coordinates<NT, 4>> p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const NT radius = R * d[j] + r * c[j];
      p.push_back({NT(radius * c[i]), NT(radius * s[i]), NT(r * s[j] * d[i]), NT(d[i] * d[j])});
    }
  return Bezier_surface_3<NT>::from_homogeneous(2, 2, p);
}

template <class NT>
void expect_constant(const Property_surface<NT>& p, const NT& value)
{
  EXPECT_FALSE(p.denominator().is_zero());
  EXPECT_TRUE((p.numerator() - p.denominator() * Bernstein_polynomial_2<NT>(value)).is_zero());
}

template <class NT>
void check_constant_curvatures(const std::array<std::array<NT, 3>, 3>& arc)
{
  const NT r = NT(2) / NT(3);
  Property_surface_maker<NT> sphere(torus_patch(arc, NT(0), r));
  const NT k = NT(1) / (r * r);
  expect_constant(sphere(Property::GAUSSIAN), k);
  expect_constant(sphere(Property::MEAN_SQUARED), k);
  expect_constant(sphere(Property::CURVATURE_BOUND), NT(k + k));
  EXPECT_TRUE(sphere(Property::UMBILIC).is_identically_zero());
  expect_constant(sphere(Property::CURVATURE_U), k);
  Property_surface_maker<NT> torus(torus_patch(arc, NT(3), r));
  expect_constant(torus(Property::CURVATURE_V), k);
  EXPECT_FALSE(torus(Property::UMBILIC).is_identically_zero());
  EXPECT_EQ(CGAL::POSITIVE, CGAL::sign(torus.sign(Property::MEAN_SQUARED)({NT(0), NT(0)})));

  std::vector<Coordinates<NT, 4>> p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      p.push_back({NT(r * arc[0][i]), NT(r * arc[1][i]), NT(NT(j) * arc[2][i]), arc[2][i]});
  Property_surface_maker<NT> cylinder(Bezier_surface_3<NT>::from_homogeneous(2, 1, p));
  EXPECT_TRUE(cylinder(Property::GAUSSIAN).is_identically_zero());
  EXPECT_TRUE(cylinder(Property::SECOND_FORM_DETERMINANT).is_identically_zero());
  EXPECT_TRUE(cylinder(Property::CURVATURE_V).is_identically_zero());
  expect_constant(cylinder(Property::MEAN_SQUARED), NT(k / NT(4)));
  expect_constant(cylinder(Property::CURVATURE_BOUND), k);
  EXPECT_TRUE(cylinder(Property::NORMAL_Z).is_identically_zero());
}

TEST(Property_surface, of_spheres_tori_and_cylinders_is_constant)
{
  check_constant_curvatures<Q>({{{1, 1, 0}, {0, 1, 2}, {1, 1, 2}}});
  using F = Quadratic_field;
  const F h(Q(0), fraction(1, 2), Q(2)); // sqrt(2) / 2
  check_constant_curvatures<F>({{{F(1), h, F(0)}, {F(0), h, F(1)}, {F(1), h, F(1)}}});
}

TEST(Property_surface, has_no_value_where_the_surface_is_not_regular)
{
  // The edge u = 1 is a point.
  const std::vector<Point> p{{Q(0), Q(0), Q(0)}, {Q(0), Q(1), Q(0)},
                             {Q(1), Q(0), Q(1)}, {Q(1), Q(0), Q(1)}};
  Property_surface_maker<Q> maker(Bezier_surface_3<Q>(1, 1, p));
  const Parameters collapsed{Q(1), fraction(1, 2)};
  const auto gaussian = maker(Property::GAUSSIAN);
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, gaussian.value(collapsed));
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, gaussian.enclosure(collapsed));
  EXPECT_TRUE(gaussian.has_nonnegative_denominator());
  EXPECT_EQ(Q(0), maker.normal_squared()(collapsed));
  const auto speed = maker(Property::SPEED_SUPREMUM);
  ASSERT_TRUE(speed.radicand());
  EXPECT_EQ(fraction(9, 4), *maker(Property::SPEED).value(collapsed));
  // There E G = F^2, and the supremum is E + G.
  EXPECT_EQ(2.25, speed.enclosure(collapsed)->sup());
  EXPECT_EQ(Q(0), *property_surface(Bezier_surface_3<Q>(1, 1, std::vector<Point>(4, p[0])),
                                    Property::SPEED_SUPREMUM).value(collapsed));
}

// Over a rectangle that is not the unit square, with different denominators.
TEST(Patch_of_expressions, is_the_same_surface)
{
  const Expression s = Expression::variable(0), t = Expression::variable(1);
  const std::vector<std::vector<Expression>> surfaces{
    {s * s - t, (s + 1) * t * fraction(2, 7), pow(s - t, 3)},
    {2 * s / (1 + s * s + t * t), 2 * t / (1 + s * s + t * t), 1 - 2 / (1 + s * s + t * t)},
    {s / (t + 5), 1 / (s + 9), t}};
  const Parameters range_s{fraction(-1, 2), Q(3)}, range_t{Q(-2), fraction(1, 3)};
  for (const auto& x : surfaces)
  {
    const auto pieces = patch_of_expressions(x, range_s, range_t);
    ASSERT_TRUE(pieces) << pieces.refusal().evidence();
    ASSERT_EQ(1u, pieces->size());
    const Surface_piece_3<Q>& piece = pieces->front();
    const Parametric_surface_3<Expression_function<2, 3>> surface{Expression_function<2, 3>(x)};
    Property_surface_maker<Q> maker(piece);
    for (Property property : all_properties())
    {
      const Property_surface_piece<Q> p{maker(property), piece.u, piece.v};
      const Parameters at{fraction(3, 5), fraction(-7, 9)};
      if (property == Property::SPEED_SUPREMUM)
        check_supremum(surface.derivatives(at), *property_at(surface.derivatives(at), property)
                                                   .enclosure({Q(0), Q(0)}));
      else
        EXPECT_EQ(*property_value(surface.derivatives(at), property), *p.value(at))
          << to_string(property);
    }
  }
}

TEST(Patch_of_expressions, is_refused_where_there_is_none)
{
  const Expression s = Expression::variable(0), t = Expression::variable(1);
  const Parameters unit{Q(0), Q(1)};
  const auto patch = [&](const Expression& x) {
    return patch_of_expressions({x, s, t}, unit, unit);
  };
  expect_refusal(Refusal_code::NOT_ALGEBRAIC, patch(sin(s)));
  expect_refusal(Refusal_code::LIMIT_EXCEEDED, patch(pow(s, 300)));
  EXPECT_TRUE(patch(1 / s)); // a pole at an edge
  EXPECT_FALSE(patch(s * t)->front().patch.is_rational());
}

} // namespace
