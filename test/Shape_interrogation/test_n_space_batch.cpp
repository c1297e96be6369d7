// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Systems at many points at once: the answers and the refusals are those of the evaluator of single
// points, in every lane, whatever happens in the other lanes.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_batch.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Random;
using Shape = Local_shape_3<double>;
using Names = std::vector<std::string>;
using Points = std::vector<std::vector<double>>; // one by one

N_space_system system_of(const Names& variables, const Names& equations)
{
  std::vector<Expression> f;
  for (const std::string& text : equations)
    f.push_back(parse_expression(text, variables));
  return N_space_system(variables, f);
}

Points by_coordinates(const Points& points, int n)
{
  Points x(n);
  for (const auto& p : points)
    for (int i = 0; i < n; ++i)
      x[i].push_back(p[i]);
  return x;
}

// Equal where the compiler does not contract operations, and else to rounding.
void expect_equal(double a, double b, double scale)
{
#if defined(__FMA__) || defined(__aarch64__)
  EXPECT_NEAR(a, b, 1e-12 * scale);
#else
  static_cast<void>(scale);
  EXPECT_EQ(a, b);
#endif
}

void expect_close(double a, double b, double scale) { EXPECT_NEAR(a, b, 1e-12 * scale); }

// An order of elimination of its own gives the normal another length.
void expect_shape(const Shape& a, const Shape& b, bool same_order)
{
  const auto compare = same_order ? expect_equal : expect_close;
  const double length = std::sqrt(a.normal_squared_length());
  const double factor = same_order ? 1 : length / std::sqrt(b.normal_squared_length());
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(a.point()[i], b.point()[i]);
    compare(a.normal()[i], b.normal()[i] * factor, length);
  }
  const double size = std::sqrt(squared_mean_curvature(a)) + 1;
  compare(gaussian_curvature(a), gaussian_curvature(b), size * size);
  compare(mean_curvature(a), mean_curvature(b), size);
}

// Compares with the evaluator, point by point; returns how many points were refused.
std::size_t expect_answers_of_evaluator(const N_space_system& system, const Points& points)
{
  N_space_evaluator<double> evaluate(system);
  N_space_batch evaluate_all(system);
  const auto result = evaluate_all(by_coordinates(points, system.number_of_variables()));
  EXPECT_EQ(result.shapes.size(), points.size());
  auto refusal = result.refusals.begin();
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    SCOPED_TRACE("point " + std::to_string(k) + " of " + std::to_string(points.size()));
    const auto s = evaluate(points[k]);
    const bool is_refused = refusal != result.refusals.end() && refusal->first == k;
    EXPECT_EQ(s.has_value(), !is_refused) << (s ? "" : s.refusal().evidence());
    if (s && !is_refused)
      expect_shape(*s, result.shapes[k], system.elimination_plan() != nullptr);
    else if (!s && is_refused)
    {
      EXPECT_EQ(refusal->second.code(), s.refusal().code());
      EXPECT_EQ(refusal->second.evidence(), s.refusal().evidence());
    }
    if (is_refused)
      ++refusal;
  }
  EXPECT_EQ(refusal, result.refusals.end());
  return result.refusals.size();
}

// (x, y, z) = (u, v, u^2 v) + d (its normal), with redundant equations.
const Names offset_variables{"x", "y", "z", "u", "v", "w", "d"};
const Names offset_equations{"w-u^2*v",   "x-u+2*d*u*v", "y-v+d*u^2",  "z-w-d",
                             "d-1/(3+u)", "(w-u^2*v)^2", "2*(z-w-d)+u*(x-u+2*d*u*v)"};

std::vector<double> offset_point(double u, double v)
{
  const double w = u * u * v, d = 1 / (3 + u);
  return {u - 2 * d * u * v, v - d * u * u, w + d, u, v, w, d};
}

TEST(N_space_batch, has_the_answers_of_the_evaluator)
{
  Random random(1);
  for (bool is_prepared : {false, true})
    for (std::size_t size : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 9u, 103u})
    {
      N_space_system system = system_of(offset_variables, offset_equations);
      if (is_prepared)
      {
        ASSERT_TRUE(system.prepare(offset_point(0.25, 0.5)));
      }
      Points points;
      for (std::size_t k = 0; k < size; ++k)
        points.push_back(offset_point(random.real(-2, 2), random.real(-2, 2)));
      EXPECT_EQ(expect_answers_of_evaluator(system, points), 0u);
    }
}

TEST(N_space_batch, orients_as_the_evaluator_does)
{
  Random random(2);
  N_space_system system = system_of({"x", "y", "z"}, {"x^2+y^2+z^2-1"});
  ASSERT_TRUE(system.prepare(std::vector<double>{0.6, 0, 0.8}));
  Points points;
  for (int k = 0; k < 20; ++k)
  {
    const double a = random.real(0, 6), b = random.real(0, 6);
    points.push_back({std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
  }
  points[6] = {1, 0, 0};
  points[7] = {0, -1, 0};
  EXPECT_EQ(expect_answers_of_evaluator(system, points), 0u);
  system.set_orientation({1, 2, 3});
  EXPECT_EQ(expect_answers_of_evaluator(system, points), 0u);
  system.set_orientation({0, 1, 0}); // orthogonal to the normal at one point
  EXPECT_EQ(expect_answers_of_evaluator(system, points), 1u);
}

// One point that is special in some way at each place between points that are not.
void expect_answers_around(const N_space_system& system, const std::vector<double>& special,
                           const std::vector<std::vector<double>>& others, Refusal_code code)
{
  const auto refused = N_space_evaluator<double>(system)(special);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.refusal().code(), code) << refused.refusal().evidence();
  for (std::size_t place = 0; place < 11; ++place)
  {
    Points points;
    for (std::size_t k = 0; k < 11; ++k)
      points.push_back(k == place ? special : others[k % others.size()]);
    EXPECT_EQ(expect_answers_of_evaluator(system, points), 1u);
  }
  EXPECT_EQ(expect_answers_of_evaluator(system, {special, special, special, special}), 4u);
}

TEST(N_space_batch, refuses_single_lanes)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (bool is_prepared : {false, true})
  {
    const auto made = [&](const Names& variables, const Names& equations,
                          const std::vector<double>& sample) {
      N_space_system system = system_of(variables, equations);
      EXPECT_TRUE(!is_prepared || system.prepare(sample));
      return system;
    };
    const Names xyz{"x", "y", "z"}, xyzu{"x", "y", "z", "u"}, xyzuv{"x", "y", "z", "u", "v"};
    const auto cone = made(xyz, {"x^2+y^2-z^2"}, {3, 4, 5});
    const Points on_cone{{3, 4, 5}, {5, 12, 13}, {-3, 4, -5}};
    expect_answers_around(cone, {0, 0, 0}, on_cone, Refusal_code::RANK_DEFICIENT);
    expect_answers_around(cone, {nan, 1, 1}, on_cone, Refusal_code::LIMIT_EXCEEDED);
    expect_answers_around(cone, {infinity, 1, 1}, on_cone, Refusal_code::LIMIT_EXCEEDED);
    expect_answers_around(cone, {1e200, 1, 1}, on_cone, Refusal_code::LIMIT_EXCEEDED);
    const auto fold = made(xyzuv, {"x-u^2", "y-v", "z-u*v"}, {1, 2, 2, 1, 2});
    expect_answers_around(fold, {0, 0, 0, 0, 0}, {{1, 2, 2, 1, 2}, {4, -1, -2, 2, -1}},
                          Refusal_code::PROJECTION_SINGULAR);
    const auto pole = made(xyzu, {"z-1/u", "u-x*y"}, {1, 2, 0.5, 2});
    expect_answers_around(pole, {0, 2, 5, 0}, {{1, 2, 0.5, 2}, {2, 2, 0.25, 4}},
                          Refusal_code::POLE);
    const auto root = made(xyz, {"z-sqrt(x*y)"}, {2, 2, 2});
    expect_answers_around(root, {-1, 1, 1}, {{2, 2, 2}, {1, 4, 2}}, Refusal_code::OUTSIDE_DOMAIN);
    const auto two = made(xyz, {"z-x^2*y", "z-x^2*y*(1+(x^2+y^2-2)^3)"}, {1, 1, 1});
    expect_answers_around(two, {1, 0, 0}, {{1, 1, 1}, {1, -1, -1}, {-1, 1, 1}},
                          Refusal_code::NOT_TWO_DIMENSIONAL);
    const auto touching = made(xyz, {"z-x*(y-1)", "z-x*(y-1)-x^2*y^2"}, {0, 0, 0});
    expect_answers_around(touching, {0, 2, 0}, {{0, 0, 0}, {0, 0, 0}},
                          Refusal_code::INCONSISTENT_REDUNDANCY);
  }
}

// Where the pivots of the prepared order vanish another order is found, for that point alone.
TEST(N_space_batch, finds_another_order_where_a_pivot_vanishes)
{
  N_space_system system = system_of({"x", "y", "z", "u"}, {"u^2+x^2-1", "y*u+z-x*u^2"});
  const auto point = [](double x, double u, double y) {
    return std::vector<double>{x, y, x * u * u - y * u, u};
  };
  ASSERT_TRUE(system.prepare(point(0.6, 0.8, 2)));
  Points points;
  for (int k = 0; k < 12; ++k)
    points.push_back(k % 3 == 0 ? point(1, 0, k + 1) : point(std::cos(k), std::sin(k), 2 - k));
  points.push_back(point(0, 1, 3));
  EXPECT_EQ(expect_answers_of_evaluator(system, points), 0u);
}

TEST(N_space_batch, refuses_too_few_equations)
{
  const N_space_system system = system_of({"x", "y", "z", "u"}, {"x+y+z*u"});
  EXPECT_EQ(expect_answers_of_evaluator(system, {{0, 0, 0, 1}, {1, -1, 0, 2}, {1, 1, 2, -1}}), 3u);
}

// The squares of both large components are finite, their sum is not.
TEST(N_space_batch, refuses_what_overflows)
{
  Names variables{"x", "y", "z"}, equations{"z-a54-b54"};
  for (const std::string name : {"a", "b"})
    for (int k = 54; k > 0; --k)
    {
      variables.push_back(name + std::to_string(k));
      equations.push_back(name + std::to_string(k) + "-918*" +
                          (k > 1 ? name + std::to_string(k - 1) : name == "a" ? "x" : "y"));
    }
  N_space_system system = system_of(variables, equations);
  const std::vector<CGAL::Exact_rational> origin(variables.size(), 0);
  ASSERT_TRUE(system.prepare(origin)); // by exact pivots, whatever their size
  const Points points(5, std::vector<double>(variables.size(), 0.));
  EXPECT_EQ(expect_answers_of_evaluator(system, points), points.size());
}

TEST(N_space_batch, refuses_coordinates_that_are_not_finite)
{
  const N_space_system system = system_of({"x", "y", "z"}, {"z-y^2"}); // x is free
  const double nan = std::nan("");
  EXPECT_EQ(expect_answers_of_evaluator(
              system, {{1, 1, 1}, {nan, 0, 0}, {2, 0, 0}, {HUGE_VAL, 0, 0}, {-HUGE_VAL, 1, 1}}),
            3u);
}

TEST(N_space_batch, reuses_its_result)
{
  const N_space_system system = system_of({"x", "y", "z"}, {"z-x*y"});
  N_space_batch evaluate_all(system);
  N_space_batch_result result;
  evaluate_all({{1, 2, 3, 4, 5}, {1, 1, 1, 1, 1}, {1, 2, 3, 4, 5}}, result);
  EXPECT_EQ(result.shapes.size(), 5u);
  evaluate_all({{0, std::nan("")}, {0, 0}, {0, 0}}, result);
  ASSERT_EQ(result.shapes.size(), 2u);
  EXPECT_EQ(gaussian_curvature(result.shapes[0]), -1);
  ASSERT_EQ(result.refusals.size(), 1u);
  EXPECT_EQ(result.refusals[0].first, 1u);
}

} // namespace
