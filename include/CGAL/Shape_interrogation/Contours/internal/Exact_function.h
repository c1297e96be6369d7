// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EXACT_FUNCTION_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EXACT_FUNCTION_H

// The polynomial whose zero set is asked for, exactly: its signs at points, and its parts on cells
// rounded once. All coordinates are doubles in the unit interval.

#include <CGAL/Shape_interrogation/Bernstein/homogeneous_parameters.h>
#include <CGAL/Shape_interrogation/Contours/internal/Cell_polynomial.h>

#include <CGAL/Exact_integer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Integer_polynomial_1 = Bernstein_polynomial_1<Exact_integer>;
using Integer_polynomial_2 = Bernstein_polynomial_2<Exact_integer>;

// A cell: the rectangle between two corners.
struct Cell_box
{
  std::array<double, 2> low{0, 0}, high{1, 1};

  double width(int axis) const { return high[axis] - low[axis]; }
  double area() const { return width(0) * width(1); }
};

// Doubles over a common power of two.
struct Dyadic_numbers
{
  explicit Dyadic_numbers(std::initializer_list<double> numbers)
  {
    int bits = 0;
    for (double x : numbers)
      bits = (std::max)(bits, -last_bit(x));
    denominator <<= bits;
    for (double x : numbers)
    {
      const int last = last_bit(x);
      numerators.emplace_back(static_cast<long>(std::ldexp(x, -last)));
      numerators.back() <<= bits + last;
    }
  }

  // The exponent of the last bit of a double that is not greater than 1.
  static int last_bit(double x)
  {
    int exponent;
    long mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
    if (mantissa == 0)
      return 0;
    for (exponent -= 53; mantissa % 2 == 0; mantissa /= 2)
      ++exponent;
    return (std::min)(exponent, 0);
  }

  std::vector<Exact_integer> numerators;
  Exact_integer denominator = 1;
};

class Exact_function
{
public:
  explicit Exact_function(Integer_polynomial_2 f) : m_f(std::move(f)) {}

  const Integer_polynomial_2& polynomial() const { return m_f; }

  CGAL::Sign sign_at(double u, double v) const
  {
    const Dyadic_numbers x{u, v};
    const std::array<Exact_integer, 2> at{x.numerators[0], x.numerators[1]};
    const std::array<Exact_integer, 2> rest{Exact_integer(x.denominator - at[0]),
                                            Exact_integer(x.denominator - at[1])};
    return CGAL::sign(Shape_interrogation::value_homogeneous<Exact_integer>(m_f, at, rest));
  }

  // The polynomial, up to a positive factor, on the line where the variable `axis` has the value
  // `x`, between two values of the other one.
  Integer_polynomial_1 on_segment(int axis, double x, double from, double to) const
  {
    const Dyadic_numbers at{x}, ends{from, to};
    const Exact_integer rest = at.denominator - at.numerators[0];
    return restricted_homogeneous(fixed_homogeneous(m_f, axis, at.numerators[0], rest), 0,
                                  ends.numerators[0], ends.numerators[1], ends.denominator);
  }

  // The polynomial on a cell, up to a positive factor.
  Cell_polynomial on(const Cell_box& box) const
  {
    Integer_polynomial_2 part = m_f;
    for (int axis = 0; axis < 2; ++axis)
      if (box.width(axis) != 1)
      {
        const Dyadic_numbers x{box.low[axis], box.high[axis]};
        part =
          restricted_homogeneous(part, axis, x.numerators[0], x.numerators[1], x.denominator);
      }
    return rounded(part);
  }

private:
  static Cell_polynomial rounded(const Integer_polynomial_2& part)
  {
    const auto& c = part.scaled_coefficients();
    const std::vector<double> scales = scaling<double>(part.degree());
    std::vector<double> b(c.size());
    std::vector<signed long> exponents(c.size());
    signed long greatest = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
    {
      b[i] = mpz_get_d_2exp(&exponents[i], gmp_of(c[i])) / scales[i];
      if (b[i] != 0)
        greatest = (std::max)(greatest, exponents[i] + std::ilogb(b[i]));
    }
    double greatest_value = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
    {
      b[i] = std::ldexp(b[i], static_cast<int>((std::max)(exponents[i] - greatest, -2000L)));
      greatest_value = (std::max)(greatest_value, std::fabs(b[i]));
    }
    // The number is cut off, quotient and product are rounded, and sums in scales beyond 2^53.
    const int roundings = 8 + part.degree()[0] + part.degree()[1];
    return Cell_polynomial(part.degree(), std::move(b),
                           roundings * rounding_unit * greatest_value);
  }

  Integer_polynomial_2 m_f;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EXACT_FUNCTION_H
