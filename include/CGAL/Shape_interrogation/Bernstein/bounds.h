// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_BOUNDS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_BOUNDS_H

// The greatest and the least value of a quotient of polynomials on the unit cube, in certified
// intervals with their places: branch and bound with Bernstein coefficients.

#include <CGAL/Shape_interrogation/Bernstein/internal/Extreme_search.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief returns a certified interval of the supremum of \f$ p / q \f$ on the unit cube, and where
 * a value in it is taken.
 *
 * Powers of \f$ u \f$ and \f$ 1 - u \f$ that numerator and denominator have in common are divided
 * out, so that the quotient is extended to edges where both vanish. Where the supremum is taken at
 * a corner of a box that the search meets, the interval is a single number, exactly.
 *
 * \tparam NT an exact field number type
 * \pre `q` is not identically zero, and not negative anywhere on the cube (not checked; where it
 * vanishes and `p` does not, the quotient is not bounded)
 *
 * Degenerate cases: inside the cube, at common zeros of numerator and denominator, no bound is
 * found, and the result says so.
 * Complexity: at most `limits.boxes` boxes with \f$ O(n^{d+1}) \f$ additions each.
 */
template <class NT, int d>
Certified_extreme<NT, d> supremum(const Bernstein_polynomial<NT, d>& p,
                                  const Bernstein_polynomial<NT, d>& q = 1,
                                  const Bound_limits& limits = {})
{
  return internal::Extreme_search<NT, d>(p, q, limits).run();
}

//! \ingroup PkgShapeInterrogationBernstein
//! \brief returns a certified interval of the infimum of \f$ p / q \f$, see `supremum()`.
template <class NT, int d>
Certified_extreme<NT, d> infimum(const Bernstein_polynomial<NT, d>& p,
                                 const Bernstein_polynomial<NT, d>& q = 1,
                                 const Bound_limits& limits = {})
{
  return supremum(-p, q, limits).negative();
}

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief holds the range of a function: certified intervals of its infimum and supremum.
 */
template <class NT, int d>
struct Certified_range
{
  Certified_extreme<NT, d> infimum;  //!< the least value
  Certified_extreme<NT, d> supremum; //!< the greatest value
};

//! \ingroup PkgShapeInterrogationBernstein
//! \brief returns the range of \f$ p / q \f$ on the unit cube, see `supremum()`.
template <class NT, int d>
Certified_range<NT, d> bounds(const Bernstein_polynomial<NT, d>& p,
                              const Bernstein_polynomial<NT, d>& q = 1,
                              const Bound_limits& limits = {})
{
  return {infimum(p, q, limits), supremum(p, q, limits)};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_BOUNDS_H
