// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_REDUCED_SQUARE_ROOT_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_REDUCED_SQUARE_ROOT_H

// sqrt(x) = r sqrt(c) with a rational r and an integer c without small square factors, so that
// roots such as sqrt(8), sqrt(2) and sqrt(1/2) meet in one field and print alike.

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is the product of a rational number and the square root of a positive integer.
 */
struct Reduced_square_root
{
  CGAL::Exact_rational factor{0};   //!< the rational factor, not negative
  CGAL::Exact_rational radicand{1}; //!< the integer under the root
  bool square_free = true; //!< whether the radicand is proved to have no square factor
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief returns the square root of a rational number as a rational multiple of the root of an
 * integer. \pre `x` is not negative
 *
 * Square factors of primes up to 2000 and a remaining perfect square are pulled out. What is left
 * is proved square-free if it is below the cube of that limit; a larger one may still hide the
 * square of a large prime, which is reported and harmless.
 */
inline Reduced_square_root reduced_square_root(const CGAL::Exact_rational& x)
{
  using Rational = CGAL::Exact_rational;
  using Traits = Fraction_traits<Rational>;
  using Integer = Traits::Numerator_type;
  CGAL_precondition_msg(!CGAL::is_negative(x), "the square root of a negative number is not real");

  Reduced_square_root result;
  if (CGAL::is_zero(x))
    return result;
  Integer numerator, denominator;
  Traits::Decompose()(x, numerator, denominator);
  const Algebraic_structure_traits<Integer>::Sqrt isqrt;
  const Algebraic_structure_traits<Integer>::Div div;
  const Algebraic_structure_traits<Integer>::Mod mod;

  Integer n = numerator * denominator, root = 1, rest = 1;
  const int limit = 2000;
  for (int p = 2; p <= limit && n != Integer(1); ++p)
    for (int count = 0; mod(n, Integer(p)) == Integer(0); ++count)
    {
      n = div(n, Integer(p));
      // Every second factor completes a square.
      if (count % 2 == 0)
        rest = rest * Integer(p);
      else
      {
        rest = div(rest, Integer(p));
        root = root * Integer(p);
      }
    }
  const Integer square = isqrt(n);
  if (Integer(square * square) == n)
  {
    root = root * square;
    n = 1;
  }
  // A square factor p^2 of the rest has p > limit, and the cofactor is not 1.
  const Integer cube = Integer(limit) * Integer(limit) * Integer(limit);
  result.square_free = n < cube;
  const Integer radicand = n * rest;
  result.factor = Traits::Compose()(root, denominator);
  result.radicand = Traits::Compose()(radicand, Integer(1));
  return result;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_REDUCED_SQUARE_ROOT_H
