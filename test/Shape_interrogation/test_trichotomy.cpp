// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The division of patches into convex, concave and saddle parts, against closed forms and against
// the second-order data at points.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Property_surfaces/trichotomy_of_patch.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using FT = CGAL::Exact_rational;
using Patch = Bezier_surface_3<FT>;
using P = Bernstein_polynomial_2<FT>;

const P u = P::coordinate(0), v = P::coordinate(1);

// The graph z = f(u, v) over the unit square.
Patch graph(const P& f)
{
  const std::array<int, 2> degree{(std::max)(1, f.degree()[0]), (std::max)(1, f.degree()[1])};
  const P z = f.elevated(degree);
  std::vector<Coordinates<FT, 3>> points;
  for (int i = 0; i <= degree[0]; ++i)
    for (int j = 0; j <= degree[1]; ++j)
      points.push_back({FT(i) / FT(degree[0]), FT(j) / FT(degree[1]), z.coefficient({i, j})});
  return Patch(degree[0], degree[1], points);
}

void expect_area(const Trichotomy& t, Region region, double area)
{
  EXPECT_LE(CGAL::to_double(t.area(region).lower), area) << to_string(region);
  EXPECT_GE(CGAL::to_double(t.area(region).upper), area) << to_string(region);
  EXPECT_LE(CGAL::to_double(FT(t.area(region).upper - t.area(region).lower)), 1e-3);
}

TEST(Trichotomy, One_kind_everywhere)
{
  // A bowl seen from above: the normal points up and turns inward.
  const auto bowl = trichotomy_of_patch(graph(u * u + v * v));
  EXPECT_EQ(bowl->area(Region::CONCAVE).lower, 1);
  EXPECT_EQ(bowl->area(Region::CONVEX).upper, 0);
  EXPECT_EQ(bowl->regularity.verdict, Verdict::YES);
  EXPECT_TRUE(bowl->boundary.curves.empty());
  const auto dome = trichotomy_of_patch(graph(-(u * u) - v * v));
  EXPECT_EQ(dome->area(Region::CONVEX).lower, 1);
  const auto turned = trichotomy_of_patch(graph(-(u * u) - v * v).transposed());
  EXPECT_EQ(turned->area(Region::CONCAVE).lower, 1);
  const auto saddle = trichotomy_of_patch(graph(u * u - v * v));
  EXPECT_EQ(saddle->area(Region::SADDLE).lower, 1);
  EXPECT_EQ(saddle->area(Region::SADDLE).upper, 1);
}

TEST(Trichotomy, Boundaries_of_known_shape)
{
  // det Hess = 36 (u - 1/2) (v - 1/3): four rectangles.
  const P a = u - P(FT(1, 2)), b = v - P(FT(1, 3));
  const auto cubic = trichotomy_of_patch(graph(a * a * a + b * b * b));
  expect_area(*cubic, Region::SADDLE, 1. / 2 * 2 / 3 + 1. / 2 / 3);
  expect_area(*cubic, Region::CONCAVE, 1. / 2 * 2 / 3);
  expect_area(*cubic, Region::CONVEX, 1. / 2 / 3);
  EXPECT_EQ(cubic->boundary.unresolved.size(), 1u); // the lines cross
  EXPECT_EQ(cubic->boundary.unresolved.front().branches, 4);
  EXPECT_FALSE(cubic->is_developable);
}

TEST(Trichotomy, Developable_patches)
{
  const auto plane = trichotomy_of_patch(graph(u * P(3) - v));
  EXPECT_TRUE(plane->is_developable);
  EXPECT_TRUE(plane->boundary.is_everything);
  EXPECT_EQ(plane->area(Region::FLAT).lower, 1);
  EXPECT_EQ(plane->area(Region::CONVEX).upper, 0);

  const P a = u - P(FT(1, 4));
  const auto wave = trichotomy_of_patch(graph(a * a * a));
  EXPECT_TRUE(wave->is_developable);
  expect_area(*wave, Region::CONVEX, 0.25);
  expect_area(*wave, Region::CONCAVE, 0.75);
  EXPECT_EQ(wave->area(Region::SADDLE).upper, 0);

  // One coefficient moved by 1e-9: no longer, and that is proved.
  P f = (a * a * a).elevated({3, 1});
  const FT tiny = FT(1) / FT(1000000000);
  const auto twin = trichotomy_of_patch(graph(f + P(tiny) * u * u * v));
  EXPECT_FALSE(twin->is_developable);
  EXPECT_GT(twin->area(Region::SADDLE).lower, FT(99, 100));
}

// A quarter of the sphere of radius 1 with both poles: two collapsed edges. Weights with roots of 2
// are avoided by rational points on the circle.
TEST(Trichotomy, Collapsed_edges_and_singular_points)
{
  // A cone with its apex on the edge u = 0.
  std::vector<Coordinates<FT, 3>> points;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j)
      points.push_back({FT(i), FT(i) * FT(j) / 2, FT(i) * FT(j == 1 ? 0 : 1)});
  const auto cone = trichotomy_of_patch(Patch(1, 2, points));
  ASSERT_TRUE(cone);
  EXPECT_TRUE(cone->is_developable);
  EXPECT_EQ(cone->regularity.verdict, Verdict::NO);
  ASSERT_EQ(cone->regularity.edges.size(), 1u);
  EXPECT_EQ(cone->regularity.edges.front().axis, 0);
  EXPECT_EQ(cone->regularity.edges.front().end, 0);
  EXPECT_TRUE(cone->boundary.edges.empty());
  EXPECT_EQ(cone->area(Region::CONVEX).lower + cone->area(Region::CONCAVE).lower, 1);

  // A patch whose partial derivatives are parallel at one corner.
  points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 1},
            {2, 1, 0}, {1, 2, 1}, {2, 2, 0}, {3, 3, 1}};
  const auto corner = trichotomy_of_patch(Patch(2, 2, points));
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->regularity.verdict, Verdict::NO);
  ASSERT_EQ(corner->regularity.points.size(), 1u);
  EXPECT_EQ(corner->regularity.points.front(), (std::array<double, 2>{0, 0}));

  // A line of poles across the patch: (u, v, v^2) / (2 u - 1), with a normal that is never zero.
  std::vector<Coordinates<FT, 4>> homogeneous;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j)
      homogeneous.push_back({FT(1), FT(j, 2), FT(j == 2 ? 1 : 0), FT(2 * i - 1)});
  const auto poles = trichotomy_of_patch(Patch::from_homogeneous(1, 2, homogeneous));
  ASSERT_TRUE(poles);
  EXPECT_EQ(poles->regularity.verdict, Verdict::NO);
  EXPECT_EQ(poles->regularity.poles.curves.size(), 1u);
  EXPECT_TRUE(poles->regularity.points.empty());

  // A curve in place of a surface.
  const auto curve = trichotomy_of_patch(
    Patch(1, 1, std::vector<Coordinates<FT, 3>>{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, {2, 2, 2}}));
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.refusal().code(), Refusal_code::IRREGULAR_PARAMETRISATION);
}

// At random points the kind of the place is that of the curvatures there, and as many points are of
// each kind as the areas allow.
TEST(Trichotomy, Agrees_with_curvatures_at_points)
{
  testing_shapes::Random random(4711);
  for (int trial = 0; trial < 6; ++trial)
  {
    std::vector<Coordinates<FT, 3>> points;
    std::vector<FT> weights;
    const bool is_rational = trial % 2 == 1;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
      {
        points.push_back({FT(i) + random.fraction(-1, 1, 5), FT(j) + random.fraction(-1, 1, 5),
                          random.rational(3)});
        weights.push_back(random.fraction(1, 4, 3));
      }
    const Patch patch(3, 2, points, is_rational ? weights : std::vector<FT>());
    const auto t = trichotomy_of_patch(patch);
    ASSERT_TRUE(t);
    EXPECT_TRUE(t->boundary.has_certified_topology());
    std::array<int, 4> counts{};
    const int size = 16;
    int regular = 0;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
      {
        const auto s = patch({FT(2 * i + 1) / (2 * size), FT(2 * j + 1) / (2 * size)});
        if (!s)
          continue;
        ++regular;
        const CGAL::Sign gauss = CGAL::sign(gaussian_curvature(*s));
        const CGAL::Sign mean = sign_of_mean_curvature(*s);
        ++counts[static_cast<int>(gauss == CGAL::NEGATIVE  ? Region::SADDLE
                                  : mean == CGAL::POSITIVE ? Region::CONVEX
                                                           : Region::CONCAVE)];
      }
    for (Region region : {Region::CONVEX, Region::CONCAVE, Region::SADDLE})
    {
      const double share = double(counts[static_cast<int>(region)]) / regular;
      EXPECT_NEAR(share, CGAL::to_double(t->area(region).lower), 0.06) << to_string(region);
      // A region that is proved empty has no point at all.
      if (t->area(region).upper == 0)
        {
          EXPECT_EQ(counts[static_cast<int>(region)], 0);
        }
    }
  }
}

TEST(Trichotomy, Pieces_limits_and_cancel)
{
  const Patch patch = graph(u * u * u - v * v * u);
  const auto half = trichotomy_of_patch(Surface_piece_3<FT>{patch, {FT(2), FT(5)}, {FT(0), FT(2)}});
  const auto whole = trichotomy_of_patch(patch);
  for (Region region : {Region::CONVEX, Region::CONCAVE, Region::SADDLE, Region::FLAT})
  {
    EXPECT_EQ(half->area(region).lower, 6 * whole->area(region).lower);
    EXPECT_EQ(half->area(region).upper, 6 * whole->area(region).upper);
  }
  Trichotomy_options coarse;
  coarse.max_cells = 3;
  const auto rough = trichotomy_of_patch(patch, coarse);
  EXPECT_LE(rough->area(Region::SADDLE).lower, whole->area(Region::SADDLE).lower);
  EXPECT_GE(rough->area(Region::SADDLE).upper, whole->area(Region::SADDLE).upper);
  const auto cancelled =
    trichotomy_of_patch(patch, {}, [](std::size_t done, std::size_t) { return done < 2; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.refusal().code(), Refusal_code::CANCELLED);
}

} // namespace
