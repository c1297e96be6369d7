// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Curves in n-space: intersections, sections, and the reasons why they end.

#include "n_space_meshes.h"

#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Meshing/trace_n_space_curve.h>
#include <CGAL/Shape_interrogation/Surfaces/intersection_system.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using End = N_space_curve_end;

Result<N_space_curve> curve_of(const N_space_system& system, const Point& start, double step,
                               const std::vector<N_space_bound>& bounds = {},
                               const std::optional<N_space_condition>& section = std::nullopt)
{
  N_space_curve_options options;
  options.step = step;
  options.bounds = bounds;
  return trace_n_space_curve(system, start, options, section);
}

double distance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double length(const N_space_curve& curve)
{
  double sum = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    sum += distance(curve.points[i], curve.points[i + 1]);
  return curve.closed ? sum + distance(curve.points.back(), curve.points.front()) : sum;
}

// Every step is as long as asked for at most, and none is much shorter than its neighbours allow.
void expect_steps(const N_space_curve& curve, double step)
{
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    EXPECT_LE(distance(curve.points[i], curve.points[i + 1]), 1.05 * step);
  const double last = distance(curve.points.back(), curve.points.front());
  EXPECT_TRUE(!curve.closed || last <= 1.6 * step) << last;
  EXPECT_LE(curve.max_residual, 1e-12);
}

void expect_box_contains(const N_space_curve_end_data& end, const Point& p)
{
  ASSERT_EQ(end.box.size(), p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    EXPECT_LE(end.box[i][0], p[i]);
    EXPECT_GE(end.box[i][1], p[i]);
    EXPECT_LE(end.box[i][1] - end.box[i][0], 1e-3);
  }
}

N_space_system sphere_of_radius_2()
{
  return make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 + z^2 - 4"});
}

} // namespace

TEST(N_space_curves, Circle_is_closed_whatever_the_equations)
{
  const double pi = std::acos(-1.);
  const N_space_system circle = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 - 1", "z"});
  const N_space_system redundant = make_n_space_system(
    {"x", "y", "z"}, {"z", "(x^2 + y^2 - 1)^2 + z^2", "x*z", "3*(x^2 + y^2 - 1) + z"});
  for (const N_space_system& system : {circle, redundant})
  {
    const auto curve = curve_of(system, {1.1, 0, 0.1}, 0.05);
    ASSERT_TRUE(curve) << curve.refusal().evidence();
    EXPECT_TRUE(curve->closed);
    EXPECT_EQ(curve->ends[0].reason, End::CLOSED);
    EXPECT_EQ(curve->ends[1].reason, End::CLOSED);
    expect_steps(*curve, 0.05);
    EXPECT_NEAR(length(*curve), 2 * pi, 0.002);
    ASSERT_EQ(curve->curvatures.size(), curve->points.size());
    for (const auto& k : curve->curvatures)
      EXPECT_NEAR(k.value(), 1, 1e-12);
  }
}

TEST(N_space_curves, Intersection_of_surfaces)
{
  const N_space_system cylinder = make_n_space_system({"x", "y", "z"}, {"(x-1)^2 + y^2 - 1/4"});
  const auto curve =
    curve_of(intersection_system(sphere_of_radius_2(), cylinder), {1, 0.5, 1.6}, 0.1);
  ASSERT_TRUE(curve) << curve.refusal().evidence();
  EXPECT_TRUE(curve->closed);
  expect_steps(*curve, 0.1);

  // An offset of the sphere, whose foot points have variables of the same names as another's.
  const Implicit_entity_3 unit([](auto x, auto y, auto z) { return x * x + y * y + z * z - 1; });
  const Implicit_entity_3 moved([](auto x, auto y, auto z) {
    return (x - 1) * (x - 1) + y * y + z * z - 1;
  });
  const N_space_system both = intersection_system(offset_system(unit, 1).n_space_system(),
                                                  offset_system(moved, 1).n_space_system());
  EXPECT_EQ(both.number_of_variables(), 9);
  const double r = std::sqrt(15.) / 2; // of the circle x = 1/2
  const auto circle =
    curve_of(both, {0.5, r, 0, 0.25, r / 2, 0, 0.75, r / 2, 0}, 0.1);
  ASSERT_TRUE(circle) << circle.refusal().evidence();
  EXPECT_TRUE(circle->closed);
  for (const Point& p : circle->points)
  {
    EXPECT_NEAR(p[0], 0.5, 1e-12);
    EXPECT_NEAR(std::hypot(p[1], p[2]), r, 1e-12);
  }
}

// Viviani's curve is one branch twice: it ends at the double point from both sides.
TEST(N_space_curves, Branches_that_cross_end_a_curve)
{
  const N_space_system cylinder = make_n_space_system({"x", "y", "z"}, {"(x-1)^2 + y^2 - 1"});
  const N_space_system viviani = intersection_system(sphere_of_radius_2(), cylinder);
  for (const Point& start : {Point{0, 0, 2}, Point{1, 1, 1.4}, Point{1.9, 0.4, 0.45}})
  {
    const auto curve = curve_of(viviani, start, 0.05);
    ASSERT_TRUE(curve) << curve.refusal().evidence();
    EXPECT_FALSE(curve->closed);
    EXPECT_NEAR(length(*curve), 7.6404, 0.002);
    for (const N_space_curve_end_data& end : curve->ends)
    {
      EXPECT_EQ(end.reason, End::SINGULAR);
      expect_box_contains(end, {2, 0, 0});
    }
  }
  const auto node = curve_of(
    make_n_space_system({"x", "y", "z"}, {"y^2 - x^2*(x+1)", "z"}), {1, 1.4, 0}, 0.1,
    {{0, -2, 2}});
  ASSERT_TRUE(node);
  EXPECT_EQ(node->ends[0].reason, End::BOUND);
  EXPECT_EQ(node->ends[0].evidence, "x is 2");
  EXPECT_EQ(node->points.front()[0], 2);
  EXPECT_EQ(node->ends[1].reason, End::SINGULAR);
  expect_box_contains(node->ends[1], {0, 0, 0});
}

TEST(N_space_curves, Cusp_ends_a_curve)
{
  const auto cusp = curve_of(make_n_space_system({"x", "y", "z"}, {"y^2 - x^3", "z"}), {1, 1, 0},
                             0.1, {{0, -1, 2}});
  ASSERT_TRUE(cusp) << cusp.refusal().evidence();
  EXPECT_EQ(cusp->ends[1].reason, End::SINGULAR);
  expect_box_contains(cusp->ends[1], {0, 0, 0});
  const Point& p = cusp->points[0]; // y = x^(3/2)
  EXPECT_NEAR(cusp->curvatures[0].value(),
              0.75 / std::sqrt(p[0]) / std::pow(1 + 2.25 * p[0], 1.5), 1e-12);
}

// The units of an equation, or of space, make no difference.
TEST(N_space_curves, Branches_in_other_units)
{
  for (const char* unit : {"1", "1000000", "1/1000000"})
  {
    const std::string u = unit;
    const auto node = curve_of(
      make_n_space_system({"x", "y", "z"}, {u + "*(y^2 - x^2*(x+1))", "z/" + u}), {1, 1.4, 0}, 0.1,
      {{0, -2, 2}});
    ASSERT_TRUE(node) << node.refusal().evidence();
    EXPECT_EQ(node->ends[1].reason, End::SINGULAR) << unit;
  }
}

// Two branches that come near to each other, and a loop that passes near its start.
TEST(N_space_curves, Near_branches_are_not_confused)
{
  const auto hyperbola = curve_of(
    make_n_space_system({"x", "y", "z"}, {"y^2 - x^2 - 1/10000", "z"}), {-1, 1, 0}, 0.1,
    {{0, -2, 2}});
  ASSERT_TRUE(hyperbola);
  for (const Point& p : hyperbola->points)
    EXPECT_GT(p[1], 0);
  // A curve on a torus around the unit circle with a small tube that closes after two turns.
  const auto loop = curve_of(
    make_n_space_system({"x", "y", "z", "c", "s"},
                        {"c^2 + s^2 - 1", "x - (1 + c/100)*(2*c^2 - 1)",
                         "y - (1 + c/100)*2*c*s", "z - s/100"}), {1.01, 0, 0, 1, 0}, 0.1);
  ASSERT_TRUE(loop);
  EXPECT_TRUE(loop->closed);
  EXPECT_NEAR(length(*loop), 4 * std::acos(-1.), 0.05);
}

TEST(N_space_curves, Curve_in_a_bound_is_followed)
{
  const auto circle = curve_of(make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 - 1", "z"}),
                               {1, 0, 0}, 0.1, {{2, 0, 1}});
  ASSERT_TRUE(circle) << circle.refusal().evidence();
  EXPECT_TRUE(circle->closed);
}

// Where only some rows of a redundant system become dependent nothing ends.
TEST(N_space_curves, Rows_that_become_dependent_do_not_end_a_curve)
{
  const auto curve = curve_of(
    make_n_space_system({"x", "y", "z"}, {"x*y", "y", "z", "z*(x - 1/3)"}), {-1, 0, 0}, 0.1,
    {{0, -1, 1}});
  ASSERT_TRUE(curve) << curve.refusal().evidence();
  EXPECT_EQ(curve->ends[0].reason, End::BOUND);
  EXPECT_EQ(curve->ends[1].reason, End::BOUND);
  EXPECT_NEAR(length(*curve), 2, 1e-12);
}

TEST(N_space_curves, Section_of_a_surface)
{
  const N_space_system k = ruled_surface_of_the_paper();
  // The line of constant lambda through the start.
  const auto line = curve_of(k, start_of_ruled_surface(), 0.1, {{12, -1, 1}},
                             N_space_condition::fixed(16, 15, 0.5));
  ASSERT_TRUE(line) << line.refusal().evidence();
  EXPECT_EQ(line->ends[0].reason, End::BOUND);
  EXPECT_EQ(line->ends[1].reason, End::BOUND);
  for (const Point& p : line->points)
    EXPECT_NEAR(p[15], 0.5, 1e-13);
  const N_space_system torus =
    make_n_space_system({"x", "y", "z"}, {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)"});
  const auto circle = curve_of(torus, {3, 0, 0.1}, 0.1, {}, N_space_condition{{0, 1, 0}, 0});
  ASSERT_TRUE(circle);
  EXPECT_TRUE(circle->closed);
  EXPECT_NEAR(length(*circle), 2 * std::acos(-1.), 0.01);
  for (const auto& curvature : circle->curvatures)
    EXPECT_NEAR(curvature.value(), 1, 1e-12);
}

TEST(N_space_curves, Refusals)
{
  const N_space_system line = make_n_space_system({"x", "y", "z"}, {"y", "z"});
  const N_space_system surface = make_n_space_system({"x", "y", "z"}, {"y"});
  const auto code = [](const Result<N_space_curve>& r) { return r.refusal().code(); };
  EXPECT_EQ(code(curve_of(line, {0, 0, 0}, 0)), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(curve_of(line, {0, 0, 0}, 1, {{7, 0, 1}})), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(curve_of(line, {0, 0, 0}, 1, {{0, 1, 2}})), Refusal_code::OUTSIDE_DOMAIN);
  EXPECT_EQ(code(curve_of(surface, {0, 0, 0}, 1)), Refusal_code::UNDERDETERMINED);
  EXPECT_EQ(code(curve_of(line, {0, 0}, 1)), Refusal_code::NOT_ON_SOLUTION);
  N_space_curve_options options;
  options.step = 0.1;
  options.max_points = 10;
  const auto limited = trace_n_space_curve(line, {0, 0, 0}, options);
  ASSERT_TRUE(limited);
  EXPECT_EQ(limited->ends[0].reason, End::LIMIT);
  EXPECT_EQ(limited->points.size(), 21u);
  EXPECT_EQ(code(curve_of(surface, {0, 0, 0}, 1, {}, N_space_condition{{1, 0}, 0})),
            Refusal_code::LIMIT_EXCEEDED);
  const auto stop = [](std::size_t done, std::size_t) { return done < 5; };
  EXPECT_EQ(code(trace_n_space_curve(line, {0, 0, 0}, options, std::nullopt, stop)),
            Refusal_code::CANCELLED);
}
