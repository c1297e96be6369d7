// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_GMP_ACCESS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_GMP_ACCESS_H

// The GMP integer inside CGAL::Exact_integer, whatever class that is: sums of products and packed
// multiplication work on it without temporaries.

#include <gmp.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// GMP's own class and Boost.Multiprecision. (CGAL::Gmpz shares its numbers between copies, so that
// they must not be written to: it takes the general way.)
struct Any_integer {};
struct Gmp_class : Any_integer {};

template <class Integer>
auto gmp(Integer& z, Gmp_class) -> decltype(z.get_mpz_t())
{
  return z.get_mpz_t();
}
template <class Integer>
auto gmp(Integer& z, Any_integer) -> decltype(static_cast<mpz_ptr>(z.backend().data()))
{
  return z.backend().data();
}
template <class Integer>
auto gmp(const Integer& z, Any_integer) -> decltype(static_cast<mpz_srcptr>(z.backend().data()))
{
  return z.backend().data();
}

template <class Integer, class = void>
struct Has_gmp : std::false_type {};
template <class Integer>
struct Has_gmp<Integer, std::void_t<decltype(gmp(std::declval<Integer&>(), Gmp_class()))>>
  : std::true_type
{};

template <class Integer>
auto gmp(const Integer& z, Any_integer) -> decltype(mpz_srcptr(z.mpz()))
{
  return z.mpz();
}

template <class Integer>
mpz_srcptr gmp_of(const Integer& z)
{
  return gmp(z, Gmp_class());
}
template <class Integer>
mpz_ptr gmp_of(Integer& z)
{
  return gmp(z, Gmp_class());
}

// The same for fractions.
template <class Fraction>
auto gmp_fraction(Fraction& x, Gmp_class) -> decltype(x.get_mpq_t())
{
  return x.get_mpq_t();
}
template <class Fraction>
auto gmp_fraction(Fraction& x, Any_integer) -> decltype(static_cast<mpq_ptr>(x.backend().data()))
{
  return x.backend().data();
}

template <class Fraction, class = void>
struct Has_gmp_fraction : std::false_type {};
template <class Fraction>
struct Has_gmp_fraction<Fraction,
                        std::void_t<decltype(gmp_fraction(std::declval<Fraction&>(), Gmp_class()))>>
  : std::true_type
{};

template <class Fraction>
mpq_ptr gmp_fraction_of(Fraction& x)
{
  return gmp_fraction(x, Gmp_class());
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_GMP_ACCESS_H
