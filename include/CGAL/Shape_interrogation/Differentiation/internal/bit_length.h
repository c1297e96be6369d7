// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_BIT_LENGTH_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_BIT_LENGTH_H

// The size in bits of an exact rational, whichever library is behind it.

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <gmp.h>

#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <int N> struct Priority : Priority<N - 1> {};
template <> struct Priority<0> {};

// GMP's own class, CGAL's wrapper of it, and Boost.Multiprecision.
template <class Integer>
auto integer_bits(const Integer& z, Priority<2>) -> decltype(mpz_sizeinbase(z.get_mpz_t(), 2))
{
  return mpz_sizeinbase(z.get_mpz_t(), 2);
}
template <class Integer>
auto integer_bits(const Integer& z, Priority<1>) -> decltype(mpz_sizeinbase(z.mpz(), 2))
{
  return mpz_sizeinbase(z.mpz(), 2);
}
template <class Integer>
std::size_t integer_bits(const Integer& z, Priority<0>)
{
  return CGAL::is_zero(z) ? 1 : msb(Integer(CGAL::abs(z))) + 1;
}

// Bits of the longer one of numerator and denominator.
template <class Rational>
std::size_t bit_length(const Rational& x)
{
  using Traits = Fraction_traits<Rational>;
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(x, numerator, denominator);
  const std::size_t n = integer_bits(numerator, Priority<2>());
  const std::size_t d = integer_bits(denominator, Priority<2>());
  return n < d ? d : n;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_BIT_LENGTH_H
