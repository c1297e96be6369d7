// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_BERNSTEIN_QUOTIENT_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_BERNSTEIN_QUOTIENT_H

// Quotients of Bernstein polynomials as a number type: an expression that is evaluated over them is
// a rational function on the unit square.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <CGAL/Exact_rational.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Bernstein_quotient
{
public:
  using Polynomial = Bernstein_polynomial_2<CGAL::Exact_rational>;

  Bernstein_quotient() : m_denominator(1) {}
  Bernstein_quotient(int x) : m_numerator(x), m_denominator(1) {}
  explicit Bernstein_quotient(double x) : Bernstein_quotient(CGAL::Exact_rational(x)) {}
  explicit Bernstein_quotient(const CGAL::Exact_rational& x) : m_numerator(x), m_denominator(1) {}
  explicit Bernstein_quotient(Polynomial p) : m_numerator(std::move(p)), m_denominator(1) {}

  const Polynomial& numerator() const { return m_numerator; }
  const Polynomial& denominator() const { return m_denominator; }

  friend Bernstein_quotient operator-(Bernstein_quotient a)
  {
    a.m_numerator = -std::move(a.m_numerator);
    return a;
  }
  friend Bernstein_quotient operator+(const Bernstein_quotient& a, const Bernstein_quotient& b)
  {
    if (are_equal(a.m_denominator, b.m_denominator))
      return {a.m_numerator + b.m_numerator, a.m_denominator};
    return {product(a.m_numerator, b.m_denominator) + product(b.m_numerator, a.m_denominator),
            product(a.m_denominator, b.m_denominator)};
  }
  friend Bernstein_quotient operator-(const Bernstein_quotient& a, const Bernstein_quotient& b)
  {
    return a + -b;
  }
  friend Bernstein_quotient operator*(const Bernstein_quotient& a, const Bernstein_quotient& b)
  {
    return {product(a.m_numerator, b.m_numerator), product(a.m_denominator, b.m_denominator)};
  }
  friend Bernstein_quotient operator/(const Bernstein_quotient& a, const Bernstein_quotient& b)
  {
    if (b.m_numerator.is_zero())
      throw Division_by_zero_error("division by a function that is zero everywhere");
    return {product(a.m_numerator, b.m_denominator), product(a.m_denominator, b.m_numerator)};
  }
  Bernstein_quotient& operator+=(const Bernstein_quotient& b) { return *this = *this + b; }

  static bool are_equal(const Polynomial& p, const Polynomial& q)
  {
    return p.degree() == q.degree() && p.scaled_coefficients() == q.scaled_coefficients();
  }

  // With the degrees in bounds: an expression of a few signs can have any.
  static Polynomial product(const Polynomial& p, const Polynomial& q)
  {
    constexpr int highest_degree = 200;
    for (int k = 0; k < 2; ++k)
      if (p.degree()[k] + q.degree()[k] > highest_degree)
        throw Limit_error("the rational functions have degrees above 200");
    return p * q;
  }

private:
  Bernstein_quotient(Polynomial numerator, Polynomial denominator)
    : m_numerator(std::move(numerator)), m_denominator(std::move(denominator))
  {}

  Polynomial m_numerator, m_denominator;
};

} // namespace internal

#ifndef DOXYGEN_RUNNING

template <>
struct Number_type_traits<internal::Bernstein_quotient>
{
  using Boolean = bool;
  static constexpr bool is_exact = true;
  static constexpr bool is_light = false;
  static constexpr bool is_enclosure = false;
  static bool is_zero(const internal::Bernstein_quotient& x) { return x.numerator().is_zero(); }
};

template <>
struct Elementary_functions<internal::Bernstein_quotient>
  : internal::No_functions<internal::Bernstein_quotient>
{};

#endif

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_BERNSTEIN_QUOTIENT_H
