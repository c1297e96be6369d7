// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Approximate points of n-space moved onto the solution of a system, and points that are proved.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;
using Names = std::vector<std::string>;
using Point = std::vector<double>;

N_space_system make_system(const Names& variables, const Names& equations)
{
  std::vector<Expression> expressions;
  for (const std::string& text : equations)
    expressions.push_back(parse_expression(text, variables));
  return N_space_system(variables, expressions);
}

// The offset of an ellipsoid at the distance 1/2: foot points with three equations of rank two.
N_space_system offset_of_ellipsoid()
{
  return make_system({"x", "y", "z", "p", "q", "s"},
                     {"p^2/9 + q^2/4 + s^2 - 1", "(y-q)*2*s - (z-s)*q/2",
                      "(z-s)*2*p/9 - (x-p)*2*s", "(x-p)*q/2 - (y-q)*2*p/9",
                      "(x-p)^2 + (y-q)^2 + (z-s)^2 - 1/4"});
}

Point perturbed(Random& random, Point p, double size)
{
  for (double& x : p)
    x += random.real(-size, size);
  return p;
}

double largest_value(const N_space_system& system, const Point& p)
{
  double largest = 0;
  for (double x : system.tape().evaluate(p))
    largest = std::fmax(largest, std::fabs(x));
  return largest;
}

TEST(N_space_corrector, reaches_solutions_of_redundant_equations)
{
  Random random(20261101);
  const N_space_system system = offset_of_ellipsoid();
  N_space_corrector correct(system);
  int reached = 0;
  for (int i = 0; i < 500; ++i)
  {
    const auto p = correct(perturbed(random, {3.5, 0, 0, 3, 0, 0}, i < 250 ? 0.1 : 1));
    if (!p)
    {
      EXPECT_EQ(p.refusal().code(), Refusal_code::NOT_ON_SOLUTION);
      continue;
    }
    ++reached;
    EXPECT_LT(largest_value(system, p->point), 1e-13);
    const auto& basis = correct.tangent_basis();
    ASSERT_EQ(basis.size(), 2u);
    EXPECT_NEAR(internal::dot_product(basis[0], basis[1]), 0, 1e-14);
  }
  EXPECT_GE(reached, 490);
}

TEST(N_space_corrector, keeps_to_conditions)
{
  Random random(20261102);
  const N_space_system system = offset_of_ellipsoid();
  N_space_corrector correct(system);
  for (int i = 0; i < 100; ++i)
  {
    const double y = random.real(-.1, .1), q = random.real(-.1, .1);
    const auto one = correct(perturbed(random, {3.5, 0, 0, 3, 0, 0}, 0.05),
                             {N_space_condition::fixed(6, 1, y)});
    ASSERT_TRUE(one) << one.refusal().evidence();
    EXPECT_NEAR(one->point[1], y, 1e-15);
    EXPECT_LT(largest_value(system, one->point), 1e-13);
    const auto two =
      correct(perturbed(random, {3.5, 0, 0, 3, 0, 0}, 0.05),
              {N_space_condition::fixed(6, 4, q), N_space_condition::fixed(6, 2, y)});
    ASSERT_TRUE(two) << two.refusal().evidence();
    EXPECT_NEAR(two->point[4], q, 1e-15);
    EXPECT_NEAR(two->point[2], y, 1e-15);
  }
}

TEST(N_space_corrector, follows_curves)
{
  // The circle in which a sphere and a plane meet, as three equations of rank two.
  const N_space_system system =
    make_system({"x", "y", "z"}, {"x^2 + y^2 + z^2 - 25", "z - 3", "(z - 3)*(x + 7)"});
  N_space_corrector correct(system, 1);
  const auto p = correct({3, 2, 2});
  ASSERT_TRUE(p) << p.refusal().evidence();
  EXPECT_NEAR(p->point[0] * p->point[0] + p->point[1] * p->point[1], 16, 1e-14);
  EXPECT_NEAR(p->point[2], 3, 1e-15);
  ASSERT_EQ(correct.tangent_basis().size(), 1u);
}

TEST(N_space_corrector, refuses)
{
  const auto code = [](const N_space_system& system, const Point& start) {
    N_space_corrector correct(system);
    const auto p = correct(start);
    return p ? "answered" : to_string(p.refusal().code());
  };
  const Names xyz{"x", "y", "z"};
  EXPECT_STREQ(code(make_system(xyz, {"x^2 + y^2 + z^2 + 1"}), {1, 2, 3}), "not_on_solution");
  EXPECT_STREQ(code(make_system(xyz, {"z", "z - 1"}), {1, 2, 3}), "not_on_solution");
  EXPECT_STREQ(code(make_system(xyz, {"x^2 + y^2 + z^2 - 1"}), {0, 0, 0}), "rank_deficient");
  EXPECT_STREQ(code(make_system(xyz, {"z"}), {0, 0}), "not_on_solution");
  EXPECT_STREQ(code(make_system({"x", "y", "z", "w"}, {"z"}), {0, 0, 0, 0}), "underdetermined");
  EXPECT_STREQ(code(make_system(xyz, {"z^9 - x"}), {0, 0, 1e200}), "limit_exceeded");
}

// Equations that do not depend on a coordinate do not tell that it is no number.
TEST(N_space_evaluator, refuses_coordinates_that_are_not_finite)
{
  const N_space_system parabola = make_system({"x", "y", "z"}, {"z - y^2"});
  const N_space_system wave = make_system({"x", "y", "z"}, {"z - exp(x)"});
  for (double x : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (const N_space_system* system : {&parabola, &wave})
    {
      const Point p{x, 0, 0};
      for (const auto& refusal : {N_space_evaluator<double>(*system)(p).refusal(),
                                  N_space_corrector(*system)(p).refusal(),
                                  enclose_solution(*system, p).refusal()})
      {
        EXPECT_EQ(refusal.code(), Refusal_code::LIMIT_EXCEEDED);
        EXPECT_NE(refusal.evidence().find("coordinate x"), std::string::npos);
      }
    }
  EXPECT_TRUE(N_space_evaluator<double>(parabola)({1, 0, 0}));
}

// A step that leads out of the domain of a function is damped.
TEST(N_space_corrector, stays_where_the_equations_have_values)
{
  const auto corrected = [](const std::string& equation, const Point& start, double z) {
    const N_space_system system = make_system({"x", "y", "z"}, {equation});
    return N_space_corrector(system)(start, {N_space_condition::fixed(3, 2, z),
                                             N_space_condition::fixed(3, 1, 0)});
  };
  const auto logarithm = corrected("log(x) - z", {1, 0, 0}, -3);
  ASSERT_TRUE(logarithm) << logarithm.refusal().evidence();
  EXPECT_NEAR(logarithm->point[0], std::exp(-3), 1e-12);
  const auto root = corrected("sqrt(x) - z", {1, 0, 1}, 0.1);
  ASSERT_TRUE(root) << root.refusal().evidence();
  EXPECT_NEAR(root->point[0], 0.01, 1e-12);
  const auto pole = corrected("1/x - z", {1, 0, 1}, 2); // the first step leads to x = 0
  ASSERT_TRUE(pole) << pole.refusal().evidence();
  EXPECT_NEAR(pole->point[0], 0.5, 1e-12);
  EXPECT_FALSE(corrected("log(x) - z", {0, 0, 0}, 0)) << "no value at the start";
}

TEST(N_space_corrector, tells_which_condition_is_missed)
{
  const N_space_system plane = make_system({"x", "y", "z"}, {"x - z"});
  const auto p = N_space_corrector(plane)(
    {1, 0, 1}, {N_space_condition::fixed(3, 1, 1), N_space_condition::fixed(3, 1, 0)});
  ASSERT_FALSE(p);
  EXPECT_NE(p.refusal().evidence().find("condition"), std::string::npos) << p.refusal().evidence();
}

// --- The order of elimination --------------------------------------------------------------------

// Replays the pivots on the full matrix: none may have a larger (r - 1)(c - 1) than another entry.
void expect_smallest_fill(const Sparse_pattern& pattern, int columns, const std::vector<Q>& values)
{
  const internal::Elimination_plan plan = internal::plan_elimination(pattern, columns, values);
  const int rows = static_cast<int>(pattern.number_of_rows());
  std::vector<std::vector<Q>> a(rows, std::vector<Q>(columns, Q(0)));
  std::vector<std::vector<bool>> is_entry(rows, std::vector<bool>(columns, false));
  for (int i = 0; i < rows; ++i)
    for (std::size_t e = pattern.row_starts[i]; e < pattern.row_starts[i + 1]; ++e)
    {
      a[i][pattern.columns[e]] = values[e];
      is_entry[i][pattern.columns[e]] = true;
    }
  std::vector<bool> active(rows, true);
  const auto cost = [&](int i, int j) {
    int in_column = 0;
    for (int k = 0; k < rows; ++k)
      in_column += active[k] && is_entry[k][j];
    return (std::count(is_entry[i].begin(), is_entry[i].end(), true) - 1) * (in_column - 1);
  };
  const auto best_cost = [&] {
    long best = -1;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; active[i] && j < columns; ++j)
        if (a[i][j] != 0 && (best < 0 || cost(i, j) < best))
          best = cost(i, j);
    return best;
  };
  for (const auto& pivot : plan.pivots)
  {
    ASSERT_TRUE(active[pivot.row] && a[pivot.row][pivot.column] != 0);
    ASSERT_EQ(cost(pivot.row, pivot.column), best_cost());
    active[pivot.row] = false;
    for (int i = 0; i < rows; ++i)
    {
      if (!active[i] || !is_entry[i][pivot.column])
        continue;
      const Q factor = a[i][pivot.column] / a[pivot.row][pivot.column];
      for (int j = 0; j < columns; ++j)
        if (is_entry[pivot.row][j])
        {
          a[i][j] -= factor * a[pivot.row][j];
          is_entry[i][j] = j != pivot.column;
        }
    }
  }
  EXPECT_EQ(best_cost(), -1) << "nothing is left";
}

TEST(Plan_elimination, keeps_the_fill_small)
{
  Random random(20261123);
  for (int k = 0; k < 200; ++k)
  {
    const int rows = random.integer(1, 14), columns = random.integer(3, 14);
    const int percent = random.integer(5, 80);
    Sparse_pattern pattern;
    std::vector<Q> values;
    for (int i = 0; i < rows; ++i)
    {
      for (int j = 0; j < columns; ++j)
        if (random.integer(0, 99) < percent)
        {
          pattern.columns.push_back(j);
          values.push_back(Q(random.integer(-2, 2)));
        }
      pattern.row_starts.push_back(pattern.columns.size());
    }
    SCOPED_TRACE(k);
    expect_smallest_fill(pattern, columns, values);
  }
}

// One column is in all rows; the work must not grow with the square of their number.
TEST(Plan_elimination, takes_chains_of_any_length)
{
  const int n = 30000;
  Sparse_pattern pattern;
  std::vector<double> values;
  for (int i = 3; i < n; ++i)
  {
    const std::vector<std::pair<int, double>> row =
      i == 3 ? std::vector<std::pair<int, double>>{{0, -1}, {1, -0.75}, {3, 1}}
             : std::vector<std::pair<int, double>>{{1, -0.75}, {i - 1, -1}, {i, 1}};
    for (const auto& [column, value] : row)
    {
      pattern.columns.push_back(column);
      values.push_back(value);
    }
    pattern.row_starts.push_back(pattern.columns.size());
  }
  const internal::Elimination_plan plan = internal::plan_elimination(pattern, n, values);
  EXPECT_EQ(plan.rank(), n - 3);
  EXPECT_LT(plan.updates.size(), 4u * n);
}

// --- Enclosures ----------------------------------------------------------------------------------

// A rational point of the sphere of radius 3 and the one of its offset at the distance 2.
std::vector<Q> offset_point(Random& random)
{
  const Q a = random.rational(), b = random.rational(), d = 1 + a * a + b * b;
  const std::vector<Q> unit{Q(2 * a / d), Q(2 * b / d), Q((d - 2) / d)};
  std::vector<Q> p;
  for (int radius : {5, 3})
    for (const Q& x : unit)
      p.push_back(Q(radius * x));
  return p;
}

N_space_system offset_of_sphere()
{
  return make_system({"x", "y", "z", "p", "q", "s"},
                     {"p^2 + q^2 + s^2 - 9", "(y-q)*s - (z-s)*q", "(z-s)*p - (x-p)*s",
                      "(x-p)*q - (y-q)*p", "(x-p)^2 + (y-q)^2 + (z-s)^2 - 4"});
}

Point doubles(const std::vector<Q>& p)
{
  Point d;
  for (const Q& x : p)
    d.push_back(number_cast<double>(x));
  return d;
}

TEST(N_space_enclosure, contains_the_rational_point)
{
  Random random(20261103);
  const N_space_system system = offset_of_sphere();
  const N_space_surface_3 surface(system);
  int proved = 0;
  for (int i = 0; i < 300; ++i)
  {
    const std::vector<Q> p = offset_point(random);
    const Fixed_coordinates fixed{{i % 3, (i + 1) % 3}, {p[i % 3], p[(i + 1) % 3]}};
    const auto e = enclose_solution(system, perturbed(random, doubles(p), 1e-6), fixed);
    // Beside the equator of the fixed coordinates they do not determine the others.
    if (CGAL::abs(p[(i + 2) % 3]) < Q(1) / 100)
      continue;
    ASSERT_TRUE(e) << e.refusal().evidence();
    ++proved;
    EXPECT_EQ(e->fixed, fixed.indices);
    EXPECT_EQ(e->equations.size(), 4u);
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_LE(Q(e->box[k].inf()), p[k]);
      EXPECT_GE(Q(e->box[k].sup()), p[k]);
      EXPECT_LT(e->box[k].sup() - e->box[k].inf(), 1e-10);
    }
    Interval::Protector protector;
    const auto shape = surface.unoriented(e->box);
    ASSERT_TRUE(shape) << shape.refusal().evidence();
    const auto sign = [](const auto& s) { return sign_of_gaussian_curvature(s); };
    EXPECT_TRUE(CGAL::certainly(shape->ask(sign) == CGAL::POSITIVE));
    // The first component of the normal orients it.
    EXPECT_EQ(shape->is_oriented(), !CGAL::is_zero(p[0]));
    EXPECT_EQ(surface(e->box).has_value(), shape->is_oriented());
  }
  EXPECT_GT(proved, 250);
}

TEST(N_space_enclosure, is_unique_for_the_coordinates_that_it_chooses)
{
  Random random(20261104);
  const N_space_system system = offset_of_ellipsoid();
  for (int i = 0; i < 100; ++i)
  {
    const auto e = enclose_solution(system, perturbed(random, {3.5, 0, 0, 3, 0, 0}, 0.2));
    ASSERT_TRUE(e) << e.refusal().evidence();
    for (int j = 0; j < 2; ++j)
    {
      EXPECT_EQ(Q(e->box[e->fixed[j]].inf()), e->values[j]);
      EXPECT_EQ(Q(e->box[e->fixed[j]].sup()), e->values[j]);
    }
    for (const Interval& x : e->box)
      EXPECT_LT(x.sup() - x.inf(), 1e-12);
  }
}

// Conditions that cannot be met are no success, and the origin is a point like others.
TEST(N_space_corrector, Contradictory_conditions_and_the_origin)
{
  const N_space_system sphere = make_system({"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"});
  N_space_corrector on_sphere(sphere);
  EXPECT_FALSE(on_sphere({0, 0, 1}, {N_space_condition::fixed(3, 2, 2)}));
  EXPECT_TRUE(on_sphere({0, 0.1, 1}, {N_space_condition::fixed(3, 2, 0.5)}));
  const N_space_system through_origin = make_system(
    {"x", "y", "z"}, {"(x-1/10)^2 + (y-2/7)^2 + (z-3/11)^2 - (1/100 + 4/49 + 9/121)"});
  N_space_corrector corrector(through_origin);
  EXPECT_TRUE(corrector({1e-17, 0, 0}));
  EXPECT_TRUE(corrector({0, 0, 0}));
}

TEST(N_space_enclosure, refuses)
{
  const auto code = [](const N_space_system& system, const Point& start,
                       const std::optional<Fixed_coordinates>& fixed = std::nullopt) {
    const auto e = enclose_solution(system, start, fixed);
    return e ? "answered" : to_string(e.refusal().code());
  };
  const Names xyz{"x", "y", "z"};
  const N_space_system sphere = make_system(xyz, {"x^2 + y^2 + z^2 - 1"});
  // (1, 0, z): at the equator z is a double root, and outside there is none.
  EXPECT_STREQ(code(sphere, {1, 0, 0}, Fixed_coordinates{{0, 1}, {Q(1), Q(0)}}), "rank_deficient");
  EXPECT_STREQ(code(sphere, {1.1, 0, .1}, Fixed_coordinates{{0, 1}, {Q(2), Q(0)}}),
               "not_on_solution");
  EXPECT_STREQ(code(make_system(xyz, {"x^2 + y^2 + z^2 + 1"}), {1, 2, 3}), "not_on_solution");
  // Redundant equations that hold only where x = 0.
  EXPECT_STREQ(code(make_system(xyz, {"z", "z + x^2*10^-9"}), {1, 2, 0}), "not_on_solution");
}

} // namespace
