// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Ten thousand rational points of rationally parametrised systems, found again from approximate
// ones: what is decided at their enclosures is what is true at the points.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/decide_at.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Point = std::vector<double>;

// --- Systems from maps ---------------------------------------------------------------------------

// Unknowns that are rational functions of two of them, in any order, each perhaps by way of
// another; and equations that follow from others.
class Map_system
{
public:
  Map_system(Random& random, int n) : m_random(random), m_place(n), m_steps(2)
  {
    std::iota(m_place.begin(), m_place.end(), 0);
    for (int i = n - 1; i > 0; --i)
      std::swap(m_place[i], m_place[random.integer(0, i)]);
  }

  int size() const { return static_cast<int>(m_place.size()); }
  Expression unknown(int i) const { return Expression::variable(m_place[i]); }

  // Defines the next unknown as a quotient, of the unknowns before it.
  void define(const Expression& numerator, const Expression& denominator = Expression(1))
  {
    m_steps.push_back({numerator, denominator});
    m_equations.push_back(unknown(static_cast<int>(m_steps.size()) - 1) * denominator - numerator);
  }

  // Defines what is left at random.
  void define_others()
  {
    while (static_cast<int>(m_steps.size()) < size())
    {
      const int i = static_cast<int>(m_steps.size());
      const Expression a = unknown(m_random.integer(0, i - 1)), u = unknown(0), v = unknown(1);
      const Expression numerator = linear(u, v) * linear(a, v) + linear(a, u);
      if (m_random.integer(0, 2) == 0)
        define(numerator, 2 + (m_random.integer(0, 1) == 0 ? u * u : v * v));
      else
        define(numerator);
    }
  }

  void add_redundant_equations(int number)
  {
    const int m = static_cast<int>(m_equations.size());
    for (int k = 0; k < number; ++k)
    {
      const Expression a = m_equations[m_random.integer(0, m - 1)];
      const Expression b = m_equations[m_random.integer(0, m - 1)];
      m_equations.push_back(k == 1 ? a * b : a * linear(unknown(0), unknown(1)) + b);
    }
  }

  N_space_system system() const
  {
    std::vector<std::string> names;
    for (int i = 0; i < size(); ++i)
      names.push_back("x" + std::to_string(i));
    return N_space_system(names, m_equations);
  }

  std::vector<Q> point(const Q& u, const Q& v) const
  {
    std::vector<Q> p(size());
    p[m_place[0]] = u;
    p[m_place[1]] = v;
    for (int i = 2; i < size(); ++i)
    {
      const Expression_tape tape({m_steps[i].first, m_steps[i].second}, size(),
                                 Expression_tape::Derivatives::NONE);
      const std::vector<Q> values = tape.evaluate(p);
      p[m_place[i]] = values[0] / values[1];
    }
    return p;
  }

  Expression linear(const Expression& a, const Expression& b)
  {
    return m_random.integer(1, 3) * a + m_random.integer(-3, 3) * b + m_random.integer(-2, 2);
  }

  // Puts the first unknowns to be defined into space: parameters and the third coordinate.
  void show(int i, int j, int k)
  {
    int wanted[3] = {i, j, k};
    for (int c = 0; c < 3; ++c)
      std::iter_swap(m_place.begin() + wanted[c], std::find(m_place.begin(), m_place.end(), c));
  }

private:
  Random& m_random;
  std::vector<int> m_place; // the index of an unknown among the variables
  std::vector<std::pair<Expression, Expression>> m_steps;
  std::vector<Expression> m_equations;
};

enum class Family { GENERIC, DEVELOPABLE, UMBILIC, PLANAR };

// 0, or one of 10^-5 ... 10^-16: a surface that is degenerate, or hardly not.
Q small_number(Random& random)
{
  Q x = random.integer(0, 3) == 0 ? Q(0) : Q(random.integer(0, 1) == 0 ? 1 : -1);
  for (int k = random.integer(5, 16); k > 0; --k)
    x /= 10;
  return x;
}

Map_system make_map(Random& random, Family family)
{
  Map_system map(random, random.integer(4, 16));
  const Expression e(small_number(random));
  if (family == Family::DEVELOPABLE)
  {
    map.show(0, 1, 2);
    const Expression u = map.unknown(0), v = map.unknown(1), s = map.linear(u, v);
    map.define(s * s * s - s * s + e * u * v, 2 + s * s);
  }
  else if (family == Family::UMBILIC) // the sphere by stereographic projection
  {
    map.show(2, 3, 4 < map.size() ? 4 : 0);
    const Expression u = map.unknown(0), v = map.unknown(1), d = 1 + u * u + v * v;
    map.define(2 * u + e * v * v, d);
    map.define(2 * v, d);
    if (map.size() > 4)
      map.define(d - 2, d);
  }
  else if (family == Family::PLANAR)
  {
    map.show(0, 1, 2);
    const Expression u = map.unknown(0), v = map.unknown(1);
    map.define(map.linear(u, v) + e * u * u * v);
  }
  map.define_others();
  map.add_redundant_equations(random.integer(0, 3));
  return map;
}

// --- Questions, and what is true -----------------------------------------------------------------

struct Counts
{
  int points = 0, questions = 0, open = 0, in_doubles = 0;
  double seconds = 0;
};

// Compares the decision with the exact one. `size` is the square of what is asked about.
template <class Question>
void expect_right(const N_space_system& system, const N_space_enclosure& e,
                  const Local_shape_3<Q>& exact, const Question& question, const Q& size,
                  const char* what, Counts& counts)
{
  const auto d = decide_at(system, e, question, 424);
  ++counts.questions;
  if (d)
  {
    counts.in_doubles += d->bits == 53;
    EXPECT_EQ(d->answer, question(exact)) << what;
    return;
  }
  ++counts.open;
  EXPECT_EQ(d.refusal().code(), Refusal_code::UNDECIDED) << what;
  EXPECT_LE(number_cast<double>(size), 1e-24) << what << ": " << d.refusal().evidence();
}

void ask_all(const N_space_system& system, const N_space_enclosure& e,
             const Local_shape_3<Q>& exact, Random& random, Counts& counts)
{
  const Q k = gaussian_curvature(exact);
  expect_right(system, e, exact, [](const auto& s) { return sign_of_gaussian_curvature(s); },
               Q(k * k), "sign of K", counts);
  expect_right(system, e, exact, [](const auto& s) { return sign_of_mean_curvature(s); },
               squared_mean_curvature(exact), "sign of H", counts);
  expect_right(system, e, exact, [](const auto& s) { return is_umbilic(s); },
               squared_curvature_gap(exact), "umbilic", counts);
  const Q both = squared_mean_curvature(exact) + squared_curvature_gap(exact);
  expect_right(system, e, exact, [](const auto& s) { return is_planar(s); }, both, "planar",
               counts);
  const auto tangent = internal::cross(exact.normal(), random.nonzero_vector());
  if (tangent == Coordinates<Q, 3>{Q(0), Q(0), Q(0)})
    return;
  const auto in_direction = [&](const auto& s) {
    using NT = typename std::decay_t<decltype(s)>::FT;
    return sign_of_normal_curvature(s, cast_argument<NT>(tangent));
  };
  expect_right(system, e, exact, in_direction, squared_normal_curvature(exact, tangent),
               "sign of a normal curvature", counts);
}

// The pair of coordinates that suits the tangent plane best, at their exact values.
Fixed_coordinates best_fixed(const N_space_shape_3<Q>& shape, const std::vector<Q>& p)
{
  std::vector<Point> basis(2);
  for (int i = 0; i < 2; ++i)
    for (const Q& x : shape.tangent_basis[i])
      basis[i].push_back(number_cast<double>(x));
  const auto indices = internal::free_coordinates(basis);
  return {indices, {p[indices[0]], p[indices[1]]}};
}

void check_point(const N_space_surface_3& surface, const std::vector<Q>& p, Random& random,
                 Counts& counts)
{
  const auto exact = surface.shape(p);
  if (!exact) // of some maps some points are singular
  {
    EXPECT_TRUE(exact.refusal().code() == Refusal_code::PROJECTION_SINGULAR ||
                exact.refusal().code() == Refusal_code::AMBIGUOUS)
      << exact.refusal().evidence();
    return;
  }
  Point start;
  for (const Q& x : p)
    start.push_back(number_cast<double>(x) + random.real(-1e-6, 1e-6));
  const auto begin = std::chrono::steady_clock::now();
  const auto e = enclose_solution(surface.system(), start, best_fixed(*exact, p));
  counts.seconds +=
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_TRUE(e) << e.refusal().evidence();
  ++counts.points;
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_TRUE(Q(e->box[i].inf()) <= p[i] && p[i] <= Q(e->box[i].sup())) << "variable " << i;
  ask_all(surface.system(), *e, exact->shape, random, counts);
}

class Ten_thousand_points : public testing::TestWithParam<int> {};

TEST_P(Ten_thousand_points, are_enclosed_and_decided_right)
{
  Random random(20261210 + GetParam());
  Counts counts;
  while (counts.points < 1000 && !HasFailure())
  {
    const Map_system map = make_map(random, static_cast<Family>(random.integer(0, 3)));
    N_space_system system = map.system();
    system.set_orientation({Q(17), Q(random.integer(-9, 9)) / 5, Q(random.integer(-9, 9)) / 7});
    const N_space_surface_3 surface(system);
    const int last = (std::min)(counts.points + 20, 1000);
    for (int i = 0; i < 25 && counts.points < last; ++i)
      check_point(surface, map.point(random.rational(), random.rational()), random, counts);
  }
  EXPECT_EQ(counts.points, 1000);
  std::cout << "seed " << 20261210 + GetParam() << ": " << counts.points << " points enclosed, "
            << static_cast<long>(counts.points / counts.seconds) << " a second; of "
            << counts.questions << " decisions " << counts.in_doubles << " in doubles, "
            << counts.open << " left open\n";
}

INSTANTIATE_TEST_SUITE_P(Seeds, Ten_thousand_points, testing::Range(0, 10));

// --- Wrong starting points -----------------------------------------------------------------------

TEST(Wrong_starting_points, are_refused_with_a_reason)
{
  Random random(20261220);
  int outside = 0;
  for (int i = 0; i < 500; ++i)
  {
    // The sphere, whose first two coordinates are held outside of it.
    Map_system map(random, random.integer(4, 8));
    const Expression x = Expression::variable(0), y = Expression::variable(1),
                     z = Expression::variable(2), w = Expression::variable(3);
    const N_space_system system({"x", "y", "z", "w"},
                                {x * x + y * y + z * z - 1, w * (2 + x * x) - map.linear(x, z)});
    const Q a = 1 + random.in_unit_interval();
    const Fixed_coordinates fixed{{0, 1}, {a, random.rational()}};
    Point start;
    for (int k = 0; k < 4; ++k)
      start.push_back(random.real(-2, 2));
    const auto e = enclose_solution(system, start, fixed);
    ASSERT_FALSE(e);
    const Refusal_code code = e.refusal().code();
    EXPECT_TRUE(code == Refusal_code::NOT_ON_SOLUTION || code == Refusal_code::RANK_DEFICIENT ||
                code == Refusal_code::UNDECIDED)
      << to_string(code);
    EXPECT_FALSE(e.refusal().evidence().empty());
    ++outside;
  }
  EXPECT_EQ(outside, 500);
}

TEST(Wrong_starting_points, without_numbers_are_refused)
{
  const Expression x = Expression::variable(0), y = Expression::variable(1),
                   z = Expression::variable(2);
  const N_space_system system({"x", "y", "z"}, {x * x + y * y - z});
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point& start : {Point{NAN, 0, 0}, Point{inf, 0, 0}, Point{0, -inf, 1},
                             Point{1e200, 1e200, 0}, Point{0, 0}, Point{0, 0, 0, 0}})
  {
    const auto e = enclose_solution(system, start);
    ASSERT_FALSE(e);
    const Refusal_code code = e.refusal().code();
    EXPECT_TRUE(code == Refusal_code::NOT_ON_SOLUTION || code == Refusal_code::LIMIT_EXCEEDED)
      << to_string(code);
  }
}

} // namespace
