// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Spline functions: extraction and recomposition, the ring laws, derivatives and knots, against
// evaluation on both sides of knots.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Splines/Spline_function.h>
#include <CGAL/Shape_interrogation/Splines/spline_algebra.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using namespace testing_shapes;
using Spline = Spline_function_1<Q>;
using Spline_2 = Spline_function_2<Q>;

std::vector<Q> random_coefficients(Random& random, int count)
{
  std::vector<Q> c;
  for (int i = 0; i < count; ++i)
    c.push_back(random.rational());
  return c;
}

Spline random_spline(Random& random, const Knot_vector<Q>& knots)
{
  return Spline({knots}, random_coefficients(random, knots.number_of_control_points()));
}

// Knots over [0, 1]: clamped and not, of several degrees and multiplicities, with a jump.
const std::vector<Knot_vector<Q>> unit_knots{
  Knot_vector<Q>(2, rationals({0, 0, 0, 3, 6, 6, 6}, 6)),
  Knot_vector<Q>(3, rationals({-3, -2, -2, 0, 2, 3, 3, 6, 7, 8, 9}, 6)),
  Knot_vector<Q>(1, rationals({0, 0, 2, 2, 3, 6, 6}, 6)),
  Knot_vector<Q>(3, rationals({0, 0, 0, 0, 3, 3, 3, 6, 6, 6, 6}, 6))};

// Some parameters in the domain, with its knots.
std::vector<Q> parameters_of(Random& random, const Spline& f)
{
  const auto ends = f.knots(0).domain();
  std::vector<Q> t;
  for (int k = 0; k < 3; ++k)
    t.push_back(ends[0] + (ends[1] - ends[0]) * random.in_unit_interval());
  for (const auto& b : f.knots(0).breakpoints())
    t.push_back(b.value);
  return t;
}

Q value(const Spline& f, const Q& t, Side side) { return *f({t}, {side}); }

constexpr std::array<Side, 2> sides{Side::LEFT, Side::RIGHT};

TEST(Spline_function, is_that_of_its_pieces)
{
  Random random(20260431);
  for (const auto& knots : knot_vectors)
  {
    const Spline f = random_spline(random, knots);
    const auto pieces = f.pieces();
    ASSERT_EQ(knots.spans().size(), pieces.size());
    for (const auto& piece : pieces)
      for (const Q& x : {Q(0), fraction(2, 7), Q(1)})
      {
        const Q t = piece.low[0] + x * (piece.high[0] - piece.low[0]);
        EXPECT_EQ(piece.polynomial({x}), value(f, t, x == 1 ? Side::LEFT : Side::RIGHT));
      }
    // Back again: the same coefficients, of functions that do not vanish on the domain.
    std::vector<Bernstein_polynomial_1<Q>> polynomials;
    for (const auto& piece : pieces)
      polynomials.push_back(piece.polynomial);
    const Spline back = Spline::from_pieces({knots}, polynomials);
    const auto [start, end] = knots.domain();
    for (int i = 0; i < knots.number_of_control_points(); ++i)
      if (knots.knots()[i] < end && start < knots.knots()[i + knots.degree() + 1])
      {
        EXPECT_EQ(f.coefficients()[i], back.coefficients()[i]);
      }
  }
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, random_spline(random, unit_knots[0])({Q(2)}));
}

TEST(Spline_function, has_sums_and_products_with_the_right_knots)
{
  Random random(20260432);
  for (const auto& a : unit_knots)
    for (const auto& b : unit_knots)
    {
      const Spline f = random_spline(random, a), g = random_spline(random, b);
      const Spline sum = f + g, difference = f - g, product = f * g;
      EXPECT_EQ(std::max(a.degree(), b.degree()), sum.degree(0));
      EXPECT_EQ(a.degree() + b.degree(), product.degree(0));
      for (const Q& t : parameters_of(random, product))
        for (Side side : sides)
        {
          const Q x = value(f, t, side), y = value(g, t, side);
          EXPECT_EQ(Q(x + y), value(sum, t, side));
          EXPECT_EQ(Q(x - y), value(difference, t, side));
          EXPECT_EQ(Q(x * y), value(product, t, side));
        }
      const auto breaks_of_product = product.knots(0).breakpoints();
      for (std::size_t i = 1; i + 1 < breaks_of_product.size(); ++i)
      {
        // The continuity is that of the less smooth function.
        int continuity = 100;
        for (const auto* knots : {&a, &b})
          for (const auto& point : knots->breakpoints())
            if (point.value == breaks_of_product[i].value)
              continuity = std::min(continuity, knots->degree() - point.multiplicity);
        EXPECT_EQ(continuity, product.degree(0) - breaks_of_product[i].multiplicity);
      }
      EXPECT_EQ((g * f).coefficients(), product.coefficients());
      EXPECT_EQ((product + f * f).coefficients(), (f * (g + f)).coefficients());
    }
}

TEST(Spline_function, has_the_derivative_of_its_pieces)
{
  Random random(20260433);
  std::vector<Knot_vector<Q>> all = knot_vectors;
  all.insert(all.end(), unit_knots.begin(), unit_knots.end());
  for (const auto& knots : all)
  {
    const Spline f = random_spline(random, knots), derivative = f.derivative(0);
    EXPECT_EQ(std::max(1, knots.degree() - 1), derivative.degree(0));
    for (const auto& piece : f.pieces())
      for (const Q& x : {Q(0), fraction(3, 5), Q(1)})
      {
        const Q length = piece.high[0] - piece.low[0], t = piece.low[0] + x * length;
        EXPECT_EQ(Q(piece.polynomial.derivative(0)({x}) / length),
                  value(derivative, t, x == 1 ? Side::LEFT : Side::RIGHT));
      }
  }
  for (const auto& a : {unit_knots[0], unit_knots[3]})
  {
    const Spline f = random_spline(random, a), g = random_spline(random, unit_knots[1]);
    const Spline product = (f * g).derivative(0);
    const Spline rule = f.derivative(0) * g + f * g.derivative(0);
    for (const Q& t : parameters_of(random, product))
      for (Side side : sides)
        EXPECT_EQ(value(rule, t, side), value(product, t, side));
  }
}

// The denominators are t_{i+p+1} - t_{i+1}: another reading of the paper gives 14 in place of 28.
TEST(Spline_function, has_the_derivative_of_the_corrected_formula)
{
  const Spline f({Knot_vector<Q>(2, rationals({0, 0, 0, 1, 2, 2, 2}, 2))},
                 rationals({1, 3, -2, 5}));
  const Spline derivative = f.derivative(0);
  EXPECT_EQ(rationals({8, -10, 28}), derivative.coefficients());
  EXPECT_EQ(rationals({0, 0, 1, 2, 2}, 2), derivative.knots(0).knots());
}

TEST(Spline_function, keeps_its_values_with_more_knots_and_higher_degree)
{
  Random random(20260434);
  for (const auto& knots : unit_knots)
  {
    const Spline f = random_spline(random, knots);
    const Spline inserted = f.with_knot(0, fraction(2, 5)).with_knot(0, fraction(2, 3));
    const Spline elevated = f.elevated(0, knots.degree() + 2);
    EXPECT_EQ(knots.number_of_control_points() + 2,
              inserted.knots(0).number_of_control_points());
    EXPECT_EQ(knots.degree() + 2, elevated.degree(0));
    for (const Q& t : parameters_of(random, inserted))
      for (Side side : sides)
      {
        EXPECT_EQ(value(f, t, side), value(inserted, t, side));
        EXPECT_EQ(value(f, t, side), value(elevated, t, side));
      }
    EXPECT_EQ(f.pieces_on(inserted.knots()).size(), inserted.pieces().size());
    EXPECT_EQ(f.on_knots({knots}).coefficients(), f.coefficients());
  }
}

TEST(Spline_function, of_one_period_continues_across_its_ends)
{
  const std::vector<Q> knots = rationals({0, 1, 3, 4, 7});
  const Spline f = periodic_spline<Q>(3, knots, rationals({2, -1, 5, 4}));
  EXPECT_EQ((std::array<Q, 2>{Q(0), Q(7)}), f.knots(0).domain());
  EXPECT_EQ(4u, f.pieces().size());
  Spline g = f;
  for (int order = 0; order < 3; ++order, g = g.derivative(0))
    EXPECT_EQ(value(g, Q(0), Side::RIGHT), value(g, Q(7), Side::LEFT));
  EXPECT_NE(value(g, Q(0), Side::RIGHT), value(g, Q(7), Side::LEFT));
  const Spline one = periodic_spline<Q>(2, knots, rationals({1, 1, 1, 1}));
  EXPECT_EQ(Q(1), value(one, fraction(7, 2), Side::RIGHT));
}

TEST(Spline_function, of_two_variables)
{
  Random random(20260435);
  const auto spline = [&](int u, int v) {
    const auto &a = unit_knots[u], &b = unit_knots[v];
    return Spline_2({a, b}, random_coefficients(random, a.number_of_control_points() *
                                                          b.number_of_control_points()));
  };
  const Spline_2 f = spline(0, 1), g = spline(2, 0);
  std::vector<Bernstein_polynomial_2<Q>> polynomials;
  for (const auto& piece : f.pieces())
    polynomials.push_back(piece.polynomial);
  EXPECT_EQ(f.coefficients(), Spline_2::from_pieces(f.knots(), polynomials).coefficients());
  const Spline_2 product = f * g, sum = f + g;
  const Spline_2 mixed = f.derivative(0).derivative(1), other = f.derivative(1).derivative(0);
  const Spline_2 finer = f.with_knot(1, fraction(1, 7), 2).elevated(0, 4);
  EXPECT_EQ(mixed.coefficients(), other.coefficients());
  for (const Q& s : {Q(0), fraction(1, 3), fraction(1, 2), fraction(3, 4), Q(1)})
    for (const Q& t : {Q(0), fraction(1, 3), fraction(1, 2), fraction(9, 10), Q(1)})
      for (Side a : sides)
        for (Side b : sides)
        {
          const std::array<Q, 2> x{s, t};
          const Q p = *f(x, {a, b}), q = *g(x, {a, b});
          EXPECT_EQ(Q(p * q), *product(x, {a, b}));
          EXPECT_EQ(Q(p + q), *sum(x, {a, b}));
          EXPECT_EQ(Q(-q), Q(*(f - g)(x, {a, b}) - p));
          EXPECT_EQ(p, *finer(x, {a, b}));
        }
  const Spline_2 du = f.derivative(0);
  for (const auto& piece : f.pieces())
  {
    const std::array<Q, 2> x{fraction(1, 4), fraction(2, 3)};
    std::array<Q, 2> at;
    for (int k : {0, 1})
      at[k] = piece.low[k] + x[k] * (piece.high[k] - piece.low[k]);
    EXPECT_EQ(Q(piece.polynomial.derivative(0)(x) / (piece.high[0] - piece.low[0])), *du(at));
  }
}

} // namespace
