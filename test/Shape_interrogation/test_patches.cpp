// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Bezier and B-spline patches: against the parametric surface of the same map, against known
// curvatures, from both sides of knots, and in all number types.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace testing_shapes;
using Interval = CGAL::Interval_nt<true>;
using Shape = Local_shape_3<Q>;
using Point = Coordinates<Q, 3>;
using Parameters = Coordinates<Q, 2>;
using Points = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Q>>;
using Bezier = Bezier_surface_3<Q>;
using Nurbs = Nurbs_surface_3<Q>;

Parameters random_parameters(Random& random)
{
  return {random.in_unit_interval(), random.in_unit_interval()};
}

// A graph-like net, so that places are regular nearly always.
Points random_points(Random& random, int rows, int columns)
{
  const auto number = [&] { return random.fraction(-30, 30, 9); };
  Points p(rows, std::vector<Point>(columns));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      p[i][j] = {Q(Q(7 * i) + number() / 20), Q(Q(7 * j) + number() / 20), number()};
  return p;
}

Weights random_weights(Random& random, int rows, int columns)
{
  Weights w(rows, std::vector<Q>(columns));
  for (auto& row : w)
    for (Q& x : row)
      x = random.fraction(1, 12, 5);
  return w;
}

// The map of a Bezier patch, written with binomials and powers for any number type.
struct Bernstein_map
{
  Points points;
  Weights weights;

  template <class T>
  static std::vector<T> basis(int n, const T& t)
  {
    std::vector<T> b;
    int binomial = 1;
    for (int i = 0; i <= n; ++i)
    {
      T x = T(binomial);
      for (int k = 0; k < n; ++k)
        x = k < i ? T(x * t) : T(x * (T(1) - t));
      b.push_back(x);
      binomial = binomial * (n - i) / (i + 1);
    }
    return b;
  }

  template <class T>
  std::array<T, 3> operator()(const T& u, const T& v) const
  {
    const auto bu = basis(static_cast<int>(points.size()) - 1, u);
    const auto bv = basis(static_cast<int>(points[0].size()) - 1, v);
    std::array<T, 3> a{T(0), T(0), T(0)};
    T w(0);
    for (std::size_t i = 0; i < bu.size(); ++i)
      for (std::size_t j = 0; j < bv.size(); ++j)
      {
        T b = bu[i] * bv[j];
        if (!weights.empty())
          b = b * T(weights[i][j]);
        w += b;
        for (int d = 0; d < 3; ++d)
          a[d] += b * T(points[i][j][d]);
      }
    if (!weights.empty())
      for (T& x : a)
        x = x / w;
    return a;
  }
};

constexpr std::array<std::array<int, 2>, 9> bidegrees{
  {{1, 1}, {1, 2}, {2, 1}, {2, 2}, {3, 3}, {2, 3}, {4, 1}, {8, 1}, {2, 9}}};

// Products of the degree 2 form of the circle, (1 - t^2, 2t, 1 + t^2), in the Bernstein basis.
constexpr int circle[3][3] = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};

Bezier quarter_cylinder()
{
  Points p(3, std::vector<Point>(2));
  Weights w(3, std::vector<Q>(2));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
    {
      w[i][j] = circle[i][2];
      p[i][j] = {fraction(circle[i][0], circle[i][2]), fraction(circle[i][1], circle[i][2]),
                 Q(3 * j)};
    }
  return Bezier(p, w);
}

// Radius 2; u = 1 is the pole of the sphere.
std::vector<Coordinates<Q, 4>> sphere_points(int sign)
{
  std::vector<Coordinates<Q, 4>> p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const auto& a = circle[i];
      const auto& b = circle[j];
      p.push_back({Q(2 * sign * a[0] * b[0]), Q(2 * sign * a[0] * b[1]), Q(2 * sign * a[1] * b[2]),
                   Q(sign * a[2] * b[2])});
    }
  return p;
}

Bezier sphere_octant(int sign = 1) { return Bezier::from_homogeneous(2, 2, sphere_points(sign)); }

TEST(Bezier_surface, agrees_with_the_parametric_surface_of_the_same_map)
{
  Random random(20260101);
  for (const auto& degree : bidegrees)
    for (bool rational : {false, true})
    {
      const Points p = random_points(random, degree[0] + 1, degree[1] + 1);
      const Weights w = rational ? random_weights(random, degree[0] + 1, degree[1] + 1) : Weights();
      const Bezier patch(p, w);
      const Parametric_surface_3<Bernstein_map> map(Bernstein_map{p, w});
      EXPECT_EQ(rational, patch.is_rational());
      for (int k = 0; k < 4; ++k)
      {
        const Parameters uv = random_parameters(random);
        expect_same_answer(map(uv), patch(uv));
        const auto d = patch.derivatives(uv);
        ASSERT_TRUE(d);
        const auto e = map.derivatives(uv);
        EXPECT_EQ(e.s, d->s);
        EXPECT_EQ(e.u, d->u);
        EXPECT_EQ(e.v, d->v);
        EXPECT_EQ(e.uu, d->uu);
        EXPECT_EQ(e.uv, d->uv);
        EXPECT_EQ(e.vv, d->vv);
        EXPECT_EQ(e.s, *patch.point(uv));
      }
    }
}

TEST(Bezier_surface, reproduces_known_values)
{
  const Points p{{{Q(0), Q(0), Q(0)}, {Q(0), Q(1), fraction(1, 2)}, {Q(0), Q(2), Q(0)}},
                 {{Q(1), Q(0), fraction(1, 3)}, {fraction(5, 4), Q(1), Q(2)},
                  {Q(1), Q(2), fraction(-1, 2)}},
                 {{Q(2), Q(0), Q(0)}, {Q(2), fraction(3, 4), Q(1)},
                  {fraction(9, 4), Q(2), fraction(1, 5)}}};
  const auto s = Bezier(p)({fraction(1, 3), fraction(1, 4)});
  ASSERT_TRUE(s);
  EXPECT_EQ(s->normal(), (Point{fraction(-3641, 2880), fraction(-229, 128), fraction(3539, 864)}));
  EXPECT_EQ(gaussian_curvature(*s), Q("15635987709907046400/41509586034833942281"));
  EXPECT_EQ(sign_of_gaussian_curvature(*s), CGAL::POSITIVE);
  EXPECT_EQ(sign_of_mean_curvature(*s), CGAL::POSITIVE);

  // A quadratic cone that is not made of lines in either parameter.
  const Points cone{{{Q(1), Q(1), Q(1)}, {Q(1), fraction(3, 2), Q(2)}, {Q(1), Q(2), Q(4)}},
                    {{Q(2), fraction(3, 2), Q(1)}, {Q(2), fraction(9, 4), Q(2)},
                     {Q(2), Q(3), Q(4)}},
                    {{Q(4), Q(2), Q(1)}, {Q(4), Q(3), Q(2)}, {Q(4), Q(4), Q(4)}}};
  Random random(20260102);
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(sign_of_gaussian_curvature(*Bezier(cone)(random_parameters(random))), CGAL::ZERO);
}

TEST(Bezier_surface, has_constant_curvature_on_circular_patches)
{
  Random random(20260103);
  const Bezier cylinder = quarter_cylinder();
  for (int k = 0; k < 10; ++k)
  {
    const Parameters uv = random_parameters(random);
    const auto c = cylinder(uv);
    ASSERT_TRUE(c);
    EXPECT_EQ(gaussian_curvature(*c), 0);
    EXPECT_EQ(squared_mean_curvature(*c), fraction(1, 4));
    EXPECT_EQ(c->point()[0] * c->point()[0] + c->point()[1] * c->point()[1], 1);
    for (int sign : {1, -1})
    {
      const auto s = sphere_octant(sign)(uv);
      ASSERT_TRUE(s);
      EXPECT_EQ(gaussian_curvature(*s), fraction(1, 4));
      EXPECT_EQ(squared_mean_curvature(*s), fraction(1, 4));
      EXPECT_EQ(umbilic_discriminant(*s), 0);
      // u climbs to the pole, v goes round counterclockwise: S_u x S_v points inwards.
      EXPECT_LT(internal::dot(s->normal(), s->point()), 0);
      EXPECT_EQ(sign_of_mean_curvature(*s), CGAL::NEGATIVE);
    }
  }
}

TEST(Bezier_surface, does_not_depend_on_the_sign_of_the_weights)
{
  Random random(20260104);
  for (const auto& degree : bidegrees)
  {
    const Points p = random_points(random, degree[0] + 1, degree[1] + 1);
    const Weights w = random_weights(random, degree[0] + 1, degree[1] + 1);
    Weights negative = w;
    for (auto& row : negative)
      for (Q& x : row)
        x = -x;
    const Parameters uv = random_parameters(random);
    expect_same_answer(Bezier(p, w)(uv), Bezier(p, negative)(uv));
  }
}

TEST(Bezier_surface, refuses_poles_and_is_right_on_both_sides_of_them)
{
  Random random(20260105);
  const Points p = random_points(random, 2, 3);
  const Weights w{{Q(1), Q(1), Q(1)}, {Q(-1), Q(-1), Q(-1)}}; // W = 1 - 2u
  const Bezier patch(p, w);
  const Parametric_surface_3<Bernstein_map> map(Bernstein_map{p, w});
  for (int i : {1, 3})
  {
    const Parameters uv{fraction(i, 4), fraction(1, 3)};
    ASSERT_TRUE(patch(uv));
    expect_same_answer(map(uv), patch(uv));
  }
  const Parameters pole{fraction(1, 2), fraction(1, 3)};
  expect_refusal(Refusal_code::POLE, patch(pole));
  expect_refusal(Refusal_code::POLE, patch.shape_at_origin(pole));
  expect_refusal(Refusal_code::POLE, patch.derivatives(pole));
  expect_refusal(Refusal_code::POLE, patch.point(pole));
  EXPECT_EQ(patch(pole).refusal().evidence(), "the weight is zero");
  expect_refusal(Refusal_code::UNDECIDED,
                 patch.cast<Interval>()({Interval(0.25, 0.75), Interval(0.25)}));
}

TEST(Bezier_surface, refuses_what_is_outside_unless_asked_for_the_extension)
{
  Random random(20260106);
  const Points p = random_points(random, 3, 3);
  const Bezier patch(p);
  const Parametric_surface_3<Bernstein_map> map(Bernstein_map{p, {}});
  const std::array<Parameters, 4> outside{{{fraction(-1, 100), Q(0)}, {fraction(101, 100), Q(0)},
                                           {Q(1), fraction(-1, 100)}, {Q(1), Q(2)}}};
  for (const Parameters& uv : outside)
  {
    expect_refusal(Refusal_code::OUTSIDE_DOMAIN, patch(uv));
    expect_refusal(Refusal_code::OUTSIDE_DOMAIN, patch.derivatives(uv));
    expect_refusal(Refusal_code::OUTSIDE_DOMAIN, patch.point(uv));
    expect_same_answer(map(uv), patch.extended_shape(uv));
    EXPECT_EQ(map.derivatives(uv).s, patch.extended_derivatives(uv)->s);
  }
  for (int i : {0, 1})
    for (int j : {0, 1})
      EXPECT_EQ(p[2 * i][2 * j], *patch.point({Q(i), Q(j)}));
  EXPECT_EQ(patch.domain()[1][1], 1);
  expect_refusal(Refusal_code::UNDECIDED,
                 patch.cast<Interval>()({Interval(-1e-9, 1e-9), Interval(0.5)}));
}

TEST(Bezier_surface, reports_collapsed_edges_exactly)
{
  EXPECT_EQ(sphere_octant().collapsed_edges(), std::vector<Patch_edge>{Patch_edge::U1});
  EXPECT_EQ(sphere_octant().transposed().collapsed_edges(),
            std::vector<Patch_edge>{Patch_edge::V1});
  EXPECT_TRUE(quarter_cylinder().collapsed_edges().empty());
  EXPECT_STREQ("v0", to_string(Patch_edge::V0));

  Random random(20260107);
  Points p = random_points(random, 4, 4);
  for (int i = 0; i < 4; ++i)
    p[i][0] = p[0][0];
  EXPECT_EQ(Bezier(p).collapsed_edges(), std::vector<Patch_edge>{Patch_edge::V0});
  EXPECT_EQ(Bezier(p, random_weights(random, 4, 4)).collapsed_edges(),
            std::vector<Patch_edge>{Patch_edge::V0});
  EXPECT_EQ(Bezier(p).cast<double>().collapsed_edges(), std::vector<Patch_edge>{Patch_edge::V0});
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, Bezier(p)({fraction(1, 3), Q(0)}));
  EXPECT_TRUE(Bezier(p)({fraction(1, 3), fraction(1, 1000000)}));

  Points twin = p;
  twin[2][0][1] += Q(1) / (Q(1L << 40) * Q(1L << 40));
  EXPECT_TRUE(Bezier(twin).collapsed_edges().empty());
  EXPECT_TRUE(Bezier(twin)({fraction(1, 3), Q(0)}));

  // A control point of weight 0 belongs to a collapsed edge only if it is zero as a whole.
  auto homogeneous = sphere_points(1);
  for (int d = 0; d < 4; ++d)
    homogeneous[7][d] = 0;
  EXPECT_EQ(Bezier::from_homogeneous(2, 2, homogeneous).collapsed_edges(),
            std::vector<Patch_edge>{Patch_edge::U1});
  homogeneous[7][0] = 1;
  EXPECT_TRUE(Bezier::from_homogeneous(2, 2, homogeneous).collapsed_edges().empty());
}

TEST(Bezier_surface, refuses_irregular_places_of_the_sphere_at_its_pole_only)
{
  const Bezier sphere = sphere_octant();
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION, sphere({Q(1), fraction(1, 2)}));
  expect_refusal(Refusal_code::IRREGULAR_PARAMETRISATION,
                 sphere.shape_at_origin({Q(1), fraction(1, 2)}));
  EXPECT_EQ(*sphere.point({Q(1), fraction(1, 2)}), (Point{Q(0), Q(0), Q(2)}));
  EXPECT_EQ(gaussian_curvature(*sphere({Q(Q(1) - fraction(1, 1000000000)), fraction(1, 2)})),
            fraction(1, 4));
}

TEST(Bezier_surface, transposed_has_the_opposite_normal)
{
  Random random(20260108);
  for (const auto& degree : bidegrees)
  {
    const Points p = random_points(random, degree[0] + 1, degree[1] + 1);
    const Weights w = random_weights(random, degree[0] + 1, degree[1] + 1);
    for (const Bezier& patch : {Bezier(p), Bezier(p, w)})
    {
      const Parameters uv = random_parameters(random);
      const Bezier other = patch.transposed();
      EXPECT_EQ(other.degree_u(), patch.degree_v());
      EXPECT_EQ(other.control_point(0, 1), patch.control_point(1, 0));
      EXPECT_EQ(other.weight(1, 0), patch.weight(0, 1));
      const auto s = patch(uv), t = other({uv[1], uv[0]});
      ASSERT_TRUE(s);
      ASSERT_TRUE(t);
      expect_same_shape(s->opposite(), *t);
    }
  }
}

TEST(Bezier_surface, is_the_same_at_the_origin)
{
  Random random(20260109);
  const Points p = random_points(random, 3, 4);
  for (const Bezier& patch : {Bezier(p), Bezier(p, random_weights(random, 3, 4))})
  {
    const Parameters uv = random_parameters(random);
    const auto s = patch.shape_at_origin(uv);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->point(), (Point{Q(0), Q(0), Q(0)}));
    expect_same_answer(patch(uv), s->at(*patch.point(uv)));
  }
}

TEST(Bezier_surface, casts_what_was_given)
{
  Random random(20260110);
  const Bezier patch(random_points(random, 4, 3), random_weights(random, 4, 3));
  const auto d = patch.cast<double>();
  const auto back = d.cast<Q>().cast<double>();
  const auto enclosed = patch.cast<Interval>();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_EQ(d.control_point(i, j), back.control_point(i, j));
      EXPECT_EQ(d.weight(i, j), back.weight(i, j));
      // The product of weight and point is made anew, from numbers that were not rounded before.
      EXPECT_EQ(d.cast<Q>().homogeneous_control_point(i, j)[0],
                Q(Q(d.weight(i, j)) * Q(d.control_point(i, j)[0])));
      EXPECT_TRUE(enclosed.weight(i, j).do_overlap(
        Interval(CGAL::to_interval(patch.weight(i, j)))));
    }
  const auto sphere = sphere_octant().cast<Quadratic_field>();
  EXPECT_EQ(sphere.homogeneous_control_point(1, 1)[2], Quadratic_field(2));
  EXPECT_EQ(sphere.control_point(2, 2)[2], Quadratic_field(2));
}

TEST(Bezier_surface, is_exact_with_a_square_root)
{
  // u = sqrt(2) - 1 is halfway to the pole.
  using F = Quadratic_field;
  const auto s = sphere_octant().cast<F>()({F(Q(-1), Q(1), Q(2)), F(fraction(1, 3))});
  ASSERT_TRUE(s);
  EXPECT_EQ(s->point()[2], F(Q(0), Q(1), Q(2)));
  EXPECT_EQ(gaussian_curvature(*s), F(fraction(1, 4)));
  EXPECT_EQ(sign_decision(umbilic_discriminant(*s)), CGAL::ZERO);
}

// The enclosure contains the exact data, is narrow, and double is close to them.
template <class Surface>
void expect_enclosures(const Surface& surface, const Parameters& uv)
{
  const Coordinates<Interval, 2> enclosed{number_cast<Interval>(uv[0]),
                                          number_cast<Interval>(uv[1])};
  const Coordinates<double, 2> rounded{number_cast<double>(uv[0]), number_cast<double>(uv[1])};
  const auto exact = surface(uv);
  const auto interval = surface.template cast<Interval>()(enclosed);
  const auto approximate = surface.template cast<double>()(rounded);
  ASSERT_TRUE(exact);
  ASSERT_TRUE(interval) << interval.refusal().evidence();
  ASSERT_TRUE(approximate);
  const auto b = exact->shape_matrix();
  const auto c = interval->shape_matrix();
  for (int i = 0; i < 3; ++i)
  {
    expect_contains(interval->point()[i], exact->point()[i]);
    expect_contains(interval->normal()[i], exact->normal()[i]);
    for (int j = 0; j < 3; ++j)
      expect_contains(c(i, j), b(i, j));
  }
  const Interval k = gaussian_curvature(*interval);
  const double expected = number_cast<double>(gaussian_curvature(*exact));
  expect_contains(k, gaussian_curvature(*exact));
  EXPECT_LT(k.sup() - k.inf(), 1e-9 * (1 + std::abs(expected)));
  EXPECT_NEAR(gaussian_curvature(*approximate), expected, 1e-11 * (1 + std::abs(expected)));
}

TEST(Bezier_surface, is_enclosed_by_intervals)
{
  Random random(20260111);
  for (const auto& degree : bidegrees)
  {
    const Points p = random_points(random, degree[0] + 1, degree[1] + 1);
    expect_enclosures(Bezier(p), random_parameters(random));
    expect_enclosures(Bezier(p, random_weights(random, degree[0] + 1, degree[1] + 1)),
                      random_parameters(random));
  }
}

struct Sign_of_umbilic_discriminant
{
  template <class Surface, class NT>
  Result<typename Number_type_traits<NT>::Sign> operator()(const Surface& surface,
                                                           const Coordinates<NT, 2>& uv) const
  {
    const auto s = surface.shape_at_origin(uv);
    if (!s)
      return s.refusal();
    return sign_decision(umbilic_discriminant(*s));
  }
};

// All points of the sphere are umbilics: only exact numbers can tell, and those of a ring do,
// although the patch is rational.
template <class Sphere>
void expect_umbilics_in_a_ring(const Sphere& sphere)
{
  Filter_statistics statistics;
  const Filtered<Sign_of_umbilic_discriminant> filtered(Sign_of_umbilic_discriminant(),
                                                        &statistics);
  const Coordinates<double, 2> uv{0.1, 0.7};
  EXPECT_EQ(*filtered(sphere, uv), CGAL::ZERO);
  EXPECT_EQ(statistics.fallbacks(), 1u);
#ifdef CGAL_HAS_MPZF
  EXPECT_EQ(statistics.exact, 0u);
#endif
  EXPECT_EQ(*filtered(quarter_cylinder().cast<double>(), uv), CGAL::POSITIVE);
  EXPECT_EQ(statistics.fallbacks(), 1u);
}

TEST(Bezier_surface, is_decided_in_a_ring)
{
  expect_umbilics_in_a_ring(sphere_octant().cast<double>());
}

#ifdef CGAL_HAS_MPZF
TEST(Bezier_surface, needs_no_division_operator)
{
  const Points plane{{{Q(0), Q(0), Q(0)}, {Q(0), Q(1), Q(1)}},
                     {{Q(1), Q(0), Q(1)}, {Q(1), Q(1), Q(2)}}};
  const auto s = Bezier(plane).cast<double>().cast<CGAL::Mpzf>()({0.25, 0.5});
  ASSERT_TRUE(s);
  EXPECT_EQ(sign_of_mean_curvature(*s), CGAL::ZERO);
}
#endif

TEST(Bezier_surface, does_not_answer_with_numbers_that_are_none)
{
  Random random(20260112);
  auto patch = Bezier(random_points(random, 4, 4)).cast<double>();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(patch({nan, 0.5}));
  EXPECT_FALSE(patch.extended_shape({1e200, 0.5}));
}

#ifndef CGAL_NO_PRECONDITIONS
TEST(Bezier_surface, has_preconditions)
{
  const std::vector<Point> four(4, Point{Q(0), Q(0), Q(0)});
  EXPECT_THROW(Bezier(0, 3, four), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(1, 2, four), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(1, 1, four, {Q(1)}), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(Points{four, {four[0]}}), CGAL::Precondition_exception);
  EXPECT_THROW(Bezier(Points{}), CGAL::Precondition_exception);
}
#endif

Nurbs random_surface(Random& random, const Knot_vector<Q>& u, const Knot_vector<Q>& v,
                     bool rational)
{
  const int rows = u.number_of_control_points(), columns = v.number_of_control_points();
  const Points p = random_points(random, rows, columns);
  return Nurbs(u, v, p, rational ? random_weights(random, rows, columns) : Weights());
}

TEST(Nurbs_surface, agrees_with_its_bezier_patches)
{
  Random random(20260113);
  for (std::size_t k = 0; k < knot_vectors.size(); ++k)
    for (bool rational : {false, true})
    {
      const auto& u = knot_vectors[k];
      const auto& v = knot_vectors[(k + 1) % 5];
      const Nurbs surface = random_surface(random, u, v, rational);
      const auto pieces = surface.bezier_patches();
      EXPECT_EQ(pieces.size(), u.spans().size() * v.spans().size());
      EXPECT_EQ(pieces.front().u[0], surface.domain()[0][0]);
      EXPECT_EQ(pieces.back().v[1], surface.domain()[1][1]);
      for (const auto& piece : pieces)
      {
        const Q s = random.in_unit_interval(), t = random.in_unit_interval();
        const Parameters uv{Q(piece.u[0] + s * (piece.u[1] - piece.u[0])),
                            Q(piece.v[0] + t * (piece.v[1] - piece.v[0]))};
        expect_same_answer(piece.patch({s, t}), surface(uv));
        EXPECT_EQ(*piece.patch.point({s, t}), *surface.point(uv));
      }
    }
}

// Each corner of each patch is a place on knots, seen from its inside.
TEST(Nurbs_surface, agrees_with_its_bezier_patches_at_knots_from_each_side)
{
  Random random(20260114);
  for (std::size_t k = 0; k < 5; ++k)
  {
    const Nurbs surface = random_surface(random, knot_vectors[k], knot_vectors[(k + 2) % 5], k % 2);
    for (const auto& piece : surface.bezier_patches())
      for (int i : {0, 1})
        for (int j : {0, 1})
        {
          const Side side_u = i == 0 ? Side::RIGHT : Side::LEFT;
          const Side side_v = j == 0 ? Side::RIGHT : Side::LEFT;
          expect_same_answer(piece.patch({Q(i), Q(j)}),
                             surface({piece.u[i], piece.v[j]}, side_u, side_v));
        }
  }
}

TEST(Nurbs_surface, has_as_many_one_sided_shapes_as_its_continuity_asks)
{
  Random random(20260115);
  const Knot_vector<Q> cubic(3, rationals({0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}));
  const Knot_vector<Q> quadratic(2, rationals({0, 0, 0, 1, 2, 2, 2}));
  const Nurbs surface = random_surface(random, cubic, quadratic, true);
  const auto count = [&](const Q& u, const Q& v) {
    return surface.one_sided_shapes({u, v})->size();
  };
  const Q half = fraction(1, 2);
  EXPECT_EQ(count(half, half), 1u);
  EXPECT_EQ(count(Q(1), half), 1u); // two continuous derivatives
  EXPECT_EQ(count(Q(2), half), 2u);
  EXPECT_EQ(count(half, Q(1)), 2u);
  EXPECT_EQ(count(Q(1), Q(1)), 2u);
  EXPECT_EQ(count(Q(2), Q(1)), 4u);
  EXPECT_EQ(count(Q(0), Q(0)), 1u);
  EXPECT_EQ(count(Q(3), Q(2)), 1u);
  EXPECT_EQ(surface.one_sided_shapes({Q(3), Q(2)})->front().side_u, Side::LEFT);
  EXPECT_EQ(surface.one_sided_shapes({Q(0), Q(1)})->front().side_v, Side::LEFT);

  const auto sides = *surface.one_sided_shapes({Q(2), Q(1)});
  ASSERT_EQ(sides.size(), 4u);
  for (const auto& side : sides)
  {
    expect_same_answer(side.shape, surface({Q(2), Q(1)}, side.side_u, side.side_v));
    EXPECT_EQ(side.shape->point(), sides[0].shape->point());
    expect_same_direction(side.shape->normal(), sides[0].shape->normal()); // the surface is G1
  }
  EXPECT_NE(gaussian_curvature(*sides[0].shape), gaussian_curvature(*sides[1].shape));
  EXPECT_NE(gaussian_curvature(*sides[0].shape), gaussian_curvature(*sides[2].shape));
  expect_same_answer(surface({Q(2), Q(1)}), sides[3].shape); // from the right
  // Where two derivatives are continuous, both sides are one.
  expect_same_answer(surface({Q(1), half}, Side::LEFT), surface({Q(1), half}, Side::RIGHT));
}

TEST(Nurbs_surface, with_bezier_knots_is_the_bezier_patch)
{
  Random random(20260116);
  const Points p = random_points(random, 4, 3);
  const Weights w = random_weights(random, 4, 3);
  const Knot_vector<Q> u(3, rationals({0, 0, 0, 0, 1, 1, 1, 1}));
  const Knot_vector<Q> v(2, rationals({0, 0, 0, 1, 1, 1}));
  const Nurbs surface(u, v, p, w);
  const Bezier patch(p, w);
  for (const Parameters& uv :
       {random_parameters(random), Parameters{Q(0), Q(1)}, Parameters{Q(1), Q(0)}})
    expect_same_answer(patch(uv), surface(uv));
  const Bezier piece = surface.bezier_patches().at(0).patch;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_EQ(piece.control_point(i, j), p[i][j]);
      EXPECT_EQ(piece.weight(i, j), w[i][j]);
      EXPECT_EQ(surface.control_point(i, j), p[i][j]);
      EXPECT_EQ(surface.weight(i, j), w[i][j]);
    }
}

TEST(Nurbs_surface, refuses_what_is_outside_and_what_is_undecided)
{
  Random random(20260117);
  const Nurbs surface = random_surface(random, knot_vectors[0], knot_vectors[1], false);
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, surface({fraction(-1, 1000), Q(1)}));
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, surface({Q(0), Q(3)}));
  EXPECT_NE(surface({Q(0), Q(3)}).refusal().evidence().find("v = 3"), std::string::npos);
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, surface.one_sided_shapes({Q(1), Q(1)}));

  // The knot 5/3 is no double: from its enclosure no side is certain.
  const auto enclosed = surface.cast<Interval>();
  const Coordinates<Interval, 2> at_knot{Interval(0.25), number_cast<Interval>(fraction(5, 3))};
  expect_refusal(Refusal_code::UNDECIDED, enclosed(at_knot));
  expect_refusal(Refusal_code::UNDECIDED, enclosed.one_sided_shapes(at_knot));
  EXPECT_TRUE(enclosed({Interval(0.25), Interval(1.5)}));
}

TEST(Nurbs_surface, is_enclosed_by_intervals)
{
  Random random(20260118);
  for (std::size_t k = 0; k < knot_vectors.size(); ++k)
  {
    const Nurbs surface = random_surface(random, knot_vectors[k], knot_vectors[(k + 1) % 5], k % 2);
    const auto ends = surface.domain();
    const Q s = random.in_unit_interval(), t = random.in_unit_interval();
    expect_enclosures(surface, {Q(ends[0][0] + s * (ends[0][1] - ends[0][0])),
                                Q(ends[1][0] + t * (ends[1][1] - ends[1][0]))});
  }
}

TEST(Nurbs_surface, casts_keep_the_structure_of_the_knots)
{
  // Two different knots that are one as doubles stay two.
  const Q tiny = Q(1) / (Q(1L << 40) * Q(1L << 40));
  const Knot_vector<Q> knots(2, {Q(0), Q(0), Q(0), Q(1), Q(Q(1) + tiny), Q(2), Q(2), Q(2)});
  EXPECT_EQ(knots.spans().size(), 3u);
  EXPECT_EQ(knots.cast<double>().spans(), knots.spans());
  EXPECT_EQ(knots.cast<Interval>().spans(), knots.spans());
  EXPECT_EQ(knots.cast<double>().breakpoints()[1].multiplicity, 1);
  Random random(20260119);
  const auto surface = random_surface(random, knots, knots, false).cast<double>();
  for (double u : {0.0, 0.5, 1.0, 1.5, 2.0})
    for (double v : {0.0, 0.5, 1.0, 1.5, 2.0})
      EXPECT_TRUE(surface({u, v}));
  // Thirds that are equal stay equal as enclosures.
  const Knot_vector<Q> thirds(2, rationals({0, 0, 0, 1, 1, 3, 3, 3}, 3));
  EXPECT_EQ(thirds.cast<Interval>().breakpoints()[1].multiplicity, 2);
}

TEST(Knot_vector, tells_why_it_is_invalid)
{
  const auto why = [](int degree, const std::vector<Q>& knots) {
    return Knot_vector<Q>::why_invalid(degree, knots).value_or("valid");
  };
  EXPECT_EQ(why(2, rationals({0, 0, 0, 1, 1, 1})), "valid");
  EXPECT_EQ(why(2, rationals({0, 0, 0, 1, 1, 1, 2, 2, 2})), "valid");
  EXPECT_EQ(why(0, rationals({0, 1})), "the degree is 0, at least 1 was expected");
  EXPECT_EQ(why(2, rationals({0, 0, 1, 1, 1})),
            "there are 5 knots, at least 6 were expected for degree 2");
  EXPECT_EQ(why(1, rationals({0, 1, 3, 2, 4})), "knot 3 (2) is less than knot 2 (3) before it");
  EXPECT_EQ(why(1, rationals({0, 0, 1, 1, 1, 2, 2})),
            "knot 4 (1) occurs more than degree + 1 = 2 times");
  EXPECT_EQ(why(2, rationals({0, 1, 2, 2, 3, 4})),
            "the domain from knot 2 to knot 3 is a single parameter");
  EXPECT_EQ(Knot_vector<double>::why_invalid(1, {0, 0, std::numeric_limits<double>::infinity(), 1}),
            "knot 2 (inf) is not a finite number");
  const Interval third = Interval(1) / Interval(3);
  EXPECT_NE(Knot_vector<Interval>::why_invalid(1, {Interval(0), third, third, Interval(1)})
              .value_or("valid")
              .find("undecided"),
            std::string::npos);
#ifndef CGAL_NO_PRECONDITIONS
  EXPECT_THROW(Knot_vector<Q>(1, rationals({0, 1, 3, 2, 4})), CGAL::Precondition_exception);
#endif
}

TEST(Nurbs_surface, tells_why_it_is_invalid)
{
  const Knot_vector<Q> u(1, rationals({0, 0, 1, 1})), v(2, rationals({0, 0, 0, 1, 1, 1}));
  Random random(20260120);
  EXPECT_FALSE(Nurbs::why_invalid(u, v, random_points(random, 2, 3)));
  EXPECT_FALSE(Nurbs::why_invalid(u, v, random_points(random, 2, 3), random_weights(random, 2, 3)));
  EXPECT_EQ(Nurbs::why_invalid(u, v, random_points(random, 3, 3)),
            "there are 3 rows of control points, the knots along u need 2");
  EXPECT_EQ(Nurbs::why_invalid(u, v, random_points(random, 2, 2)),
            "row 0 has 2 control points, the knots along v need 3");
  EXPECT_EQ(Nurbs::why_invalid(u, v, random_points(random, 2, 3), random_weights(random, 2, 1)),
            "row 0 has 1 weights, the knots along v need 3");
#ifndef CGAL_NO_PRECONDITIONS
  EXPECT_THROW(Nurbs(u, v, random_points(random, 3, 3)), CGAL::Precondition_exception);
#endif
}

// Weights of both signs: a patch of the surface has a control point of weight 0 then, which only
// the homogeneous form can hold.
TEST(Nurbs_surface, extracts_patches_with_zero_weights)
{
  const Knot_vector<Q> u(2, rationals({0, 0, 0, 1, 2, 2, 2})), v(1, rationals({0, 0, 1, 1}));
  Random random(20260121);
  const Weights w{{Q(1), Q(1)}, {Q(-1), Q(-1)}, {Q(1), Q(1)}, {Q(1), Q(2)}};
  const Nurbs surface(u, v, random_points(random, 4, 2), w);
  const auto pieces = surface.bezier_patches();
  EXPECT_EQ(pieces[0].patch.weight(2, 0), 0);
  for (int k = 1; k < 8; ++k)
  {
    const Q t = fraction(k, 8);
    expect_same_answer(surface({t, fraction(1, 3)}), pieces[0].patch({t, fraction(1, 3)}));
    expect_same_answer(surface({Q(t + 1), fraction(1, 3)}), pieces[1].patch({t, fraction(1, 3)}));
  }
  expect_refusal(Refusal_code::POLE, surface({Q(1), fraction(1, 3)}));
  expect_refusal(Refusal_code::POLE, pieces[1].patch({Q(0), fraction(1, 3)}));
}

// Where the lengths of the knot spans are powers of two, no rational is needed either.
TEST(Nurbs_surface, is_decided_in_a_ring)
{
  const Knot_vector<Q> knots(2, rationals({0, 0, 0, 2, 2, 2}));
  Points p(3, std::vector<Point>(3));
  Weights w(3, std::vector<Q>(3));
  const Bezier sphere = sphere_octant();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      p[i][j] = sphere.control_point(i, j);
      w[i][j] = sphere.weight(i, j);
    }
  expect_umbilics_in_a_ring(Nurbs(knots, knots, p, w).cast<double>());
}

} // namespace
