// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_POLYNOMIAL_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_POLYNOMIAL_H

// Polynomials over a field of fractions as integer polynomials over one denominator: long formulas
// run in the integers, and fractions are reduced once at the end.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <CGAL/Fraction_traits.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Fractions with one denominator in lowest terms. Where that is a power of two, as for numbers that
// were doubles, they are found by shifts.
template <class NT>
class Quotients
{
  using Traits = Fraction_traits<NT>;
  using Integer = typename Traits::Numerator_type;

public:
  explicit Quotients(const Integer& denominator)
    : m_denominator(denominator), m_exponent(mpz_scan1(gmp_of(denominator), 0)),
      m_is_power_of_two(mpz_sizeinbase(gmp_of(denominator), 2) == m_exponent + 1)
  {}

  NT operator()(const Integer& numerator) const
  {
    if constexpr (Has_gmp_fraction<NT>::value)
      if (m_is_power_of_two)
      {
        NT x(numerator);
        mpq_div_2exp(gmp_fraction_of(x), gmp_fraction_of(x), m_exponent);
        return x;
      }
    return typename Traits::Compose()(numerator, m_denominator);
  }

private:
  typename Traits::Denominator_type m_denominator;
  mp_bitcnt_t m_exponent;
  bool m_is_power_of_two;
};

template <class NT, int d>
class Scaled_polynomial
{
  using Traits = Fraction_traits<NT>;

public:
  using Integer = typename Traits::Numerator_type;
  using Polynomial = Bernstein_polynomial<Integer, d>;
  using Degree = typename Polynomial::Degree;

  Scaled_polynomial() : m_denominator(1) {}
  Scaled_polynomial(int constant) : m_numerator(constant), m_denominator(1) {}
  Scaled_polynomial(const NT& constant)
  {
    Integer numerator;
    typename Traits::Denominator_type denominator;
    typename Traits::Decompose()(constant, numerator, denominator);
    m_numerator = Polynomial(numerator);
    m_denominator = denominator;
  }
  Scaled_polynomial(Polynomial numerator, const Integer& denominator)
    : m_numerator(std::move(numerator)), m_denominator(denominator)
  {}

  const Polynomial& numerator() const { return m_numerator; }
  const Integer& denominator() const { return m_denominator; }

  Scaled_polynomial derivative(int axis) const
  {
    return {m_numerator.derivative(axis), m_denominator};
  }

  Bernstein_polynomial<NT, d> polynomial() const
  {
    std::vector<NT> scaled;
    scaled.reserve(m_numerator.scaled_coefficients().size());
    const Quotients<NT> quotient(m_denominator);
    for (const Integer& c : m_numerator.scaled_coefficients())
      scaled.push_back(quotient(c));
    return Bernstein_polynomial<NT, d>::from_scaled_coefficients(m_numerator.degree(),
                                                                 std::move(scaled));
  }

  friend Scaled_polynomial operator+(const Scaled_polynomial& p, const Scaled_polynomial& q)
  {
    return combined(p, q, [](const Polynomial& a, const Polynomial& b) { return a + b; });
  }
  friend Scaled_polynomial operator-(const Scaled_polynomial& p, const Scaled_polynomial& q)
  {
    return combined(p, q, [](const Polynomial& a, const Polynomial& b) { return a - b; });
  }
  friend Scaled_polynomial operator-(Scaled_polynomial p)
  {
    p.m_numerator = -std::move(p.m_numerator);
    return p;
  }
  friend Scaled_polynomial operator*(const Scaled_polynomial& p, const Scaled_polynomial& q)
  {
    const Integer denominator = p.m_denominator * q.m_denominator;
    if (q.m_numerator.scaled_coefficients().size() == 1 &&
        q.m_numerator.scaled_coefficients().front() == 1)
      return {p.m_numerator, denominator};
    return {p.m_numerator * q.m_numerator, denominator};
  }

private:
  template <class Combine>
  static Scaled_polynomial combined(const Scaled_polynomial& p, const Scaled_polynomial& q,
                                    Combine combine)
  {
    if (p.m_denominator == q.m_denominator)
      return {combine(p.m_numerator, q.m_numerator), p.m_denominator};
    const Integer common = typename Traits::Common_factor()(p.m_denominator, q.m_denominator);
    const Integer for_p = q.m_denominator / common, for_q = p.m_denominator / common;
    return {combine(p.m_numerator * Polynomial(for_p), q.m_numerator * Polynomial(for_q)),
            Integer(p.m_denominator * for_p)};
  }

  Polynomial m_numerator;
  Integer m_denominator;
};

// The ring in which formulas over polynomials with coefficients in NT are evaluated.
template <class NT, int d>
using Polynomial_ring = std::conditional_t<is_fraction_of_gmp<NT>(), Scaled_polynomial<NT, d>,
                                           Bernstein_polynomial<NT, d>>;

template <class NT, int d>
Bernstein_polynomial<NT, d> result_polynomial(const Scaled_polynomial<NT, d>& p)
{
  return p.polynomial();
}
template <class NT, int d>
const Bernstein_polynomial<NT, d>& result_polynomial(const Bernstein_polynomial<NT, d>& p)
{
  return p;
}

// Polynomials of one degree with the given coefficients, over one denominator.
template <class NT, std::size_t count, int d>
std::array<Polynomial_ring<NT, d>, count>
polynomials_in_ring(const std::array<int, d>& degree,
                    const std::array<std::vector<NT>, count>& coefficients)
{
  std::array<Polynomial_ring<NT, d>, count> polynomials;
  if constexpr (is_fraction_of_gmp<NT>())
  {
    using Integer = typename Fraction_traits<NT>::Numerator_type;
    std::vector<NT> all;
    for (const std::vector<NT>& c : coefficients)
      all.insert(all.end(), c.begin(), c.end());
    typename Fraction_traits<NT>::Denominator_type denominator;
    const std::vector<Integer> numerators = clear_denominators(all, denominator);
    auto next = numerators.begin();
    for (std::size_t k = 0; k < count; ++k, next += size_of(degree))
      polynomials[k] = {Bernstein_polynomial<Integer, d>::from_coefficients(
                          degree, std::vector<Integer>(next, next + size_of(degree))),
                        denominator};
  }
  else
    for (std::size_t k = 0; k < count; ++k)
      polynomials[k] = Bernstein_polynomial<NT, d>::from_coefficients(degree, coefficients[k]);
  return polynomials;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_POLYNOMIAL_H
