// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Bernstein polynomials: the ring laws and all operations against evaluation, products of all kinds
// of integers, and enclosures.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Bernstein/homogeneous_parameters.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/Scaled_polynomial.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>

#include <CGAL/Exact_integer.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using namespace testing_shapes;
using Z = CGAL::Exact_integer;
using Polynomial = Bernstein_polynomial_2<Q>;
using Degree = std::array<int, 2>;
using Point = std::array<Q, 2>;

Polynomial random_polynomial(Random& random, const Degree& degree)
{
  std::vector<Q> b;
  for (std::size_t i = 0; i < internal::size_of(degree); ++i)
    b.push_back(random.rational());
  return Polynomial::from_coefficients(degree, b);
}

Point random_point(Random& random) { return {random.rational(), random.rational()}; }

bool are_equal(const Polynomial& p, const Polynomial& q) { return (p - q).is_zero(); }

// The definition.
Q value_of(const Polynomial& p, const Point& x)
{
  Q sum(0);
  const auto power = [](const Q& t, int n) {
    Q y(1);
    for (int i = 0; i < n; ++i)
      y = y * t;
    return y;
  };
  const auto [m, n] = p.degree();
  const auto bu = internal::binomials_in<Q>(m), bv = internal::binomials_in<Q>(n);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      sum += p.coefficient({i, j}) * bu[i] * power(x[0], i) * power(1 - x[0], m - i) * bv[j] *
             power(x[1], j) * power(1 - x[1], n - j);
  return sum;
}

constexpr std::array<Degree, 5> degrees{{{0, 0}, {1, 0}, {2, 3}, {0, 4}, {5, 5}}};

TEST(Bernstein_polynomial, is_a_ring)
{
  Random random(20260411);
  for (const Degree& a : degrees)
    for (const Degree& b : degrees)
    {
      const Polynomial p = random_polynomial(random, a), q = random_polynomial(random, b);
      const Polynomial r = random_polynomial(random, {1, 2});
      EXPECT_TRUE(are_equal(p + q, q + p));
      EXPECT_TRUE(are_equal(p * q, q * p));
      EXPECT_TRUE(are_equal((p + q) + r, p + (q + r)));
      EXPECT_TRUE(are_equal((p * q) * r, p * (q * r)));
      EXPECT_TRUE(are_equal(p * (q + r), p * q + p * r));
      EXPECT_TRUE(are_equal(p - q, p + -q));
      EXPECT_TRUE(are_equal(p * 1, p));
      EXPECT_TRUE((p - p).is_zero());
      const Degree product{a[0] + b[0], a[1] + b[1]};
      EXPECT_EQ(product, (p * q).degree());
      Polynomial s = p;
      s += q;
      s -= r;
      s *= q;
      EXPECT_TRUE(are_equal(s, (p + q - r) * q));
    }
}

TEST(Bernstein_polynomial, operations_commute_with_evaluation)
{
  Random random(20260412);
  for (const Degree& a : degrees)
    for (const Degree& b : degrees)
    {
      const Polynomial p = random_polynomial(random, a), q = random_polynomial(random, b);
      const Point x = random_point(random);
      const Q px = value_of(p, x), qx = value_of(q, x);
      EXPECT_EQ(px, p(x));
      EXPECT_EQ(Q(px * qx), (p * q)(x));
      EXPECT_EQ(Q(px + qx), (p + q)(x));
      EXPECT_EQ(Q(px - qx), (p - q)(x));
      EXPECT_EQ(px, p.elevated({a[0] + 2, a[1] + 1})(x));
      for (int axis : {0, 1})
      {
        EXPECT_TRUE(are_equal((p * q).derivative(axis),
                              p.derivative(axis) * q + p * q.derivative(axis)));
        const Q low = random.rational(), high = random.rational();
        Point y = x;
        y[axis] = low * (1 - x[axis]) + high * x[axis];
        EXPECT_EQ(p(y), p.restricted(axis, low, high)(x));
        EXPECT_EQ(p(x), p.fixed(axis, x[axis])({x[1 - axis]}));
      }
    }
  const Polynomial u = Polynomial::coordinate(0), v = Polynomial::coordinate(1);
  const Polynomial cubic = u * u * u - 2 * u * v + 5;
  EXPECT_TRUE(are_equal(cubic.derivative(0), 3 * u * u - 2 * v));
  EXPECT_TRUE(are_equal(cubic.derivative(1), -2 * u));
}

TEST(Bernstein_polynomial, is_composed_with_polynomials)
{
  Random random(20260413);
  using Curve = Bernstein_polynomial_1<Q>;
  const Polynomial p = random_polynomial(random, {3, 2});
  const auto t = Curve::coordinate(0);
  const std::array<Curve, 2> line{Curve(random.rational()) + t, t * t * random.rational()};
  const Curve along = p.at(line);
  const Curve homogeneous =
    value_homogeneous<Curve>(p, {t, t * t}, {Curve(2) - t, Curve(3)});
  for (int k = 0; k < 5; ++k)
  {
    const Q x = random.rational();
    EXPECT_EQ(p({line[0]({x}), line[1]({x})}), along({x}));
    const Q square = x * x, ratio = square / (square + 3);
    EXPECT_EQ(Q(p({Q(x / 2), ratio}) * 8 * (square + 3) * (square + 3)), homogeneous({x}));
  }
  EXPECT_EQ((std::array<int, 1>{7}), homogeneous.degree());
}

// Coefficients of all lengths and signs: the two ways to a product give the same.
TEST(Bernstein_polynomial, products_packed_into_one_integer_are_those_by_rows)
{
  Random random(20260414);
  const auto integers = [&](std::size_t count, int bits) {
    std::vector<Z> numbers;
    for (std::size_t i = 0; i < count; ++i)
    {
      Z x(random.integer(-1000, 1000));
      for (int b = random.integer(0, bits); b > 0; b -= 10)
        x = x * Z(1024) + Z(random.integer(-1000, 1000));
      numbers.push_back(random.integer(0, 5) == 0 ? Z(0) : x);
    }
    return numbers;
  };
  for (const Degree& a : {Degree{0, 0}, Degree{3, 2}, Degree{9, 7}})
    for (const Degree& b : {Degree{1, 0}, Degree{4, 4}, Degree{12, 3}})
      for (int bits : {0, 60, 64, 300, 2000})
      {
        const auto x = integers(internal::size_of(a), bits);
        auto y = integers(internal::size_of(b), 500 - bits / 5);
        const Degree degree{a[0] + b[0], a[1] + b[1]};
        const auto slots_x = internal::slots(a, degree), slots_y = internal::slots(b, degree);
        std::vector<Z> rows(internal::size_of(degree), Z(0)), packed = rows, twice = rows;
        internal::multiply_by_rows(x, slots_x, y, slots_y, rows);
        const std::size_t width = internal::slot_bits(internal::longest(x), internal::longest(y),
                                                       std::min(x.size(), y.size()));
        internal::multiply_packed(x, slots_x, y, slots_y, width, packed);
        EXPECT_EQ(rows, packed);
        internal::multiply_packed_twice(x, slots_x, y, slots_y, width, twice);
        EXPECT_EQ(rows, twice);
        // Squares.
        const Degree twice_a{2 * a[0], 2 * a[1]};
        const auto slots = internal::slots(a, twice_a);
        std::vector<Z> square(internal::size_of(twice_a), Z(0)), other = square;
        const std::size_t length = internal::longest(x);
        const std::size_t even = internal::slot_bits(length, length, x.size());
        internal::multiply_by_rows(x, slots, x, slots, square);
        internal::multiply_packed_twice(x, slots, x, slots, even, other);
        EXPECT_EQ(square, other);
      }
}

// All coefficients are the greatest that fit their slots.
TEST(Bernstein_polynomial, products_of_the_greatest_coefficients_do_not_overflow)
{
  Z power(1);
  for (int i = 0; i < 31; ++i)
    power = power * Z(4);
  for (int sign : {-1, 1})
    for (int more : {0, 1})
    {
      const Z largest = Z(sign) * (power * Z(1 + more) - Z(1)); // of 62 or 63 bits
      const auto p = Bernstein_polynomial_1<Z>::from_scaled_coefficients(
        {63}, std::vector<Z>(64, largest));
      const auto square = p * p;
      for (int i = 0; i <= 126; ++i)
        EXPECT_EQ(Z(largest * largest * Z(i < 64 ? i + 1 : 127 - i)),
                  square.scaled_coefficient({i}));
      EXPECT_EQ(square.scaled_coefficients(), (p * (p + 0)).scaled_coefficients());
    }
}

TEST(Bernstein_polynomial, in_integers_stays_in_them)
{
  using Integral = Bernstein_polynomial_2<Z>;
  const Integral u = Integral::coordinate(0), v = Integral::coordinate(1);
  const Integral p = (u * v + 3) * (u - v * 2);
  EXPECT_EQ(Z(-30), p({Z(1), Z(3)}));
  EXPECT_EQ(Z(5), p.derivative(0)({Z(2), Z(1)}));
  const auto rational = p.cast<Q>();
  EXPECT_EQ(Q(-30), rational({Q(1), Q(3)}));
}

TEST(Bernstein_polynomial, in_the_field_of_a_root_and_in_intervals)
{
  Random random(20260415);
  const Polynomial p = random_polynomial(random, {3, 4}), q = random_polynomial(random, {4, 2});
  using Interval = CGAL::Interval_nt<true>;
  const auto a = p.cast<Interval>(), b = q.cast<Interval>();
  const auto exact = (p * q - p).derivative(1).restricted(0, fraction(1, 3), fraction(2, 3));
  const auto enclosed =
    (a * b - a).derivative(1).restricted(0, Interval(1) / 3, Interval(2) / 3);
  ASSERT_EQ(exact.degree(), enclosed.degree());
  for (std::size_t i = 0; i < exact.scaled_coefficients().size(); ++i)
    expect_contains(enclosed.scaled_coefficients()[i], exact.scaled_coefficients()[i]);

  using F = Quadratic_field;
  const F root(Q(0), Q(1), Q(2));
  const auto u = Bernstein_polynomial_2<F>::coordinate(0);
  const auto difference = (u - root) * (u + root) - (u * u - 2);
  EXPECT_TRUE(difference.is_zero());
}

TEST(Bernstein_polynomial, over_one_denominator_is_the_same)
{
  Random random(20260416);
  const auto coefficients = [&](int count) {
    std::vector<Q> b;
    for (int i = 0; i < count; ++i)
      b.push_back(random.rational());
    return b;
  };
  const Degree degree{2, 3};
  const std::array<std::vector<Q>, 2> b{coefficients(12), coefficients(12)};
  const auto ring = internal::polynomials_in_ring<Q, 2, 2>(degree, b);
  const Polynomial p = Polynomial::from_coefficients(degree, b[0]);
  const Polynomial q = Polynomial::from_coefficients(degree, b[1]);
  const Q c = fraction(5, 7);
  const auto result = (ring[0] * c - ring[1].derivative(0)) * ring[1] + -ring[0] + 3;
  const Polynomial expected = (p * c - q.derivative(0)) * q + -p + 3;
  EXPECT_EQ(expected.scaled_coefficients(), result.polynomial().scaled_coefficients());
  // Doubles have powers of two as denominators.
  const auto dyadic = internal::polynomials_in_ring<Q, 1, 2>({1, 0}, {{{Q(0.375), Q(-6)}}})[0];
  EXPECT_EQ((std::vector<Q>{Q(0.375), Q(-6)}), dyadic.polynomial().scaled_coefficients());
}

} // namespace
