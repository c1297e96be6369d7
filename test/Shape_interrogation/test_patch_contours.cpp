// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours of properties and plane sections of patches, against closed forms.

#include <CGAL/Shape_interrogation/Property_surfaces/patch_contours.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using FT = CGAL::Exact_rational;
using Patch = Bezier_surface_3<FT>;

// z = u^2 + v^2 over [-1, 1]^2, as a polynomial patch on the unit square.
Patch paraboloid()
{
  std::vector<Coordinates<FT, 3>> points;
  const FT squares[] = {1, -1, 1};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      points.push_back({FT(i - 1), FT(j - 1), FT(squares[i] + squares[j])});
  return Patch(2, 2, points);
}

Surface_piece_3<FT> piece(const Patch& patch)
{
  return {patch, {FT(0), FT(1)}, {FT(0), FT(1)}};
}

TEST(Patch_contours, Plane_sections_of_a_paraboloid)
{
  const auto circle = plane_section(paraboloid(), {FT(0), FT(0), FT(1), FT(-1, 4)});
  ASSERT_TRUE(circle);
  ASSERT_EQ(circle->curves.size(), 1u);
  EXPECT_TRUE(circle->curves.front().is_closed);
  for (const auto& x : lifted(circle->curves.front().points, paraboloid().cast<double>()))
  {
    EXPECT_NEAR(x[0] * x[0] + x[1] * x[1], 0.25, 1e-12);
    EXPECT_NEAR(x[2], 0.25, 1e-12);
  }
  EXPECT_TRUE(plane_section(paraboloid(), {FT(0), FT(0), FT(1), FT(1, 4)})->curves.empty());
  EXPECT_EQ(plane_section(paraboloid(), {FT(1), FT(2), FT(0), FT(0)})->curves.size(), 1u);
}

// The slope's tangent is 2 r, the cosine with the axis 1 / sqrt(1 + 4 r^2).
TEST(Patch_contours, Slopes_and_isophotes_are_circles)
{
  const auto slope = property_contour(piece(paraboloid()), Property::SLOPE, FT(1));
  ASSERT_TRUE(slope);
  ASSERT_EQ(slope->curves.size(), 1u);
  Property_inputs<FT> inputs;
  inputs.light = {FT(0), FT(0), FT(2)};
  inputs.level = FT(4, 5); // tan = 3/4
  const auto isophote = property_contour(piece(paraboloid()), Property::ISOPHOTE, FT(0), inputs);
  ASSERT_TRUE(isophote);
  ASSERT_EQ(isophote->curves.size(), 1u);
  const auto radius = [](const std::array<double, 2>& p) {
    return std::hypot(2 * p[0] - 1, 2 * p[1] - 1);
  };
  for (const auto& p : slope->curves.front().points)
    EXPECT_NEAR(radius(p), 0.5, 1e-12);
  for (const auto& p : isophote->curves.front().points)
    EXPECT_NEAR(radius(p), 0.375, 1e-12);
  // Lit from below there is none: the zero set of the squares is the same one.
  inputs.level = FT(-4, 5);
  EXPECT_TRUE(
    property_contour(piece(paraboloid()), Property::ISOPHOTE, FT(0), inputs)->curves.empty());
}

// The light comes from the other side: neither everything nor an edge counts.
TEST(Patch_contours, Isophotes_where_the_cosine_is_one)
{
  Property_inputs<FT> inputs;
  inputs.light = {FT(0), FT(0), FT(1)};
  const Patch plane(1, 1,
                    std::vector<Coordinates<FT, 3>>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}});
  const Patch wall(2, 1,
                   std::vector<Coordinates<FT, 3>>{
                     {0, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 2, 0}, {2, 0, -1}, {2, 2, -1}});
  for (int level : {1, -1})
  {
    inputs.level = FT(level);
    const auto all = property_contour(piece(plane), Property::ISOPHOTE, FT(0), inputs);
    EXPECT_EQ(all->is_everything, level == 1);
    const auto edge = property_contour(piece(wall), Property::ISOPHOTE, FT(0), inputs);
    EXPECT_EQ(edge->edges.size(), level == 1 ? 1u : 0u);
  }
}

TEST(Patch_contours, Silhouettes)
{
  Property_inputs<FT> inputs;
  inputs.view = {FT(1), FT(0), FT(0)};
  const auto line = property_contour(piece(paraboloid()), Property::SILHOUETTE, FT(0), inputs);
  ASSERT_TRUE(line);
  ASSERT_EQ(line->curves.size(), 1u);
  for (const auto& p : line->curves.front().points)
    EXPECT_NEAR(p[0], 0.5, 1e-12);
  // From the eye (0, 0, -1/9) the polar plane is z = 1/9.
  inputs.eye = Coordinates<FT, 3>{FT(0), FT(0), FT(-1, 9)};
  const auto circle = property_contour(piece(paraboloid()), Property::SILHOUETTE, FT(0), inputs);
  ASSERT_TRUE(circle);
  ASSERT_EQ(circle->curves.size(), 1u);
  EXPECT_TRUE(circle->curves.front().is_closed);
  for (const auto& p : circle->curves.front().points)
    EXPECT_NEAR(std::hypot(2 * p[0] - 1, 2 * p[1] - 1), 1. / 3, 1e-12);
}

TEST(Patch_contours, Refusals)
{
  const auto root = property_contour(piece(paraboloid()), Property::SPEED_SUPREMUM, FT(1));
  ASSERT_FALSE(root);
  EXPECT_EQ(root.refusal().code(), Refusal_code::NOT_ALGEBRAIC);
  const Patch segment(1, 1,
                      std::vector<Coordinates<FT, 3>>{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, {2, 2, 2}});
  const auto none = property_contour(piece(segment), Property::GAUSSIAN, FT(1));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.refusal().code(), Refusal_code::IRREGULAR_PARAMETRISATION);
  const auto cancelled = property_contour(piece(paraboloid()), Property::SLOPE, FT(1), {}, {},
                                          [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.refusal().code(), Refusal_code::CANCELLED);
}

} // namespace
