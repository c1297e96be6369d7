// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_HOMOGENEOUS_PARAMETERS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_HOMOGENEOUS_PARAMETERS_H

// Values and parts of polynomials at rational parameters without a division: up to a power of the
// denominator, in the ring of the coefficients.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief returns the value of `p` at the point with the coordinates \f$ x / (x + \bar x) \f$ times
 * \f$ \prod (x + \bar x)^m \f$, a polynomial in both.
 *
 * The coordinates are in a ring `T`, constructible from `NT`: with polynomials in their place this
 * is the composition with a rational curve or map.
 */
template <class T, class NT, int d>
T value_homogeneous(const Bernstein_polynomial<NT, d>& p,
                    const std::array<T, static_cast<std::size_t>(d)>& x,
                    const std::array<T, static_cast<std::size_t>(d)>& complement)
{
  const std::vector<NT>& c = p.scaled_coefficients();
  return internal::value_homogeneous(p.degree(), std::vector<T>(c.begin(), c.end()), x,
                                     complement);
}

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief returns the part of `p` over \f$ [a/w, b/w] \f$ in the variable `axis`, on the unit
 * interval, times \f$ w^m \f$.
 */
template <class NT, int d>
Bernstein_polynomial<NT, d> restricted_homogeneous(const Bernstein_polynomial<NT, d>& p, int axis,
                                                   const NT& a, const NT& b, const NT& w)
{
  return Bernstein_polynomial<NT, d>::from_scaled_coefficients(
    p.degree(), internal::multiplied_lines(
                  p.scaled_coefficients(), internal::axis_layout(p.degree(), axis),
                  internal::restriction_matrix(p.degree()[axis], a, b, w)));
}

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief returns `p` where the variable `axis` has the value \f$ x / (x + \bar x) \f$ times
 * \f$ (x + \bar x)^m \f$, as a polynomial in the other variables. \pre `d` is at least 2
 */
template <class NT, int d>
Bernstein_polynomial<NT, d - 1> fixed_homogeneous(const Bernstein_polynomial<NT, d>& p, int axis,
                                                  const NT& x, const NT& complement)
{
  return Bernstein_polynomial<NT, d - 1>::from_scaled_coefficients(
    internal::without_axis(p.degree(), axis),
    internal::fixed_lines(p.scaled_coefficients(), internal::axis_layout(p.degree(), axis),
                          internal::homogeneous_powers(p.degree()[axis], x, complement)));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_HOMOGENEOUS_PARAMETERS_H
