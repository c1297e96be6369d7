// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Approximate points of n-space moved onto the solution of a system.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_corrector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Random;
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

} // namespace
