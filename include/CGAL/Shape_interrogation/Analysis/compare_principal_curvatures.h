// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_COMPARE_PRINCIPAL_CURVATURES_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_COMPARE_PRINCIPAL_CURVATURES_H

// Exact comparison of principal curvatures, which are nested roots, by signs of a + b sqrt(e) +
// c sqrt(f): kappa = (a +- sqrt(D)) / (2 c q sqrt(q)).

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/internal/sign_of_roots.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief names one of the two principal curvatures.
 */
enum class Principal
{
  MIN, //!< the smaller by signed value
  MAX  //!< the larger by signed value
};

namespace internal {

// kappa = (a + b sqrt(d)) / (l sqrt(q)) with b = +-1 and l positive.
template <class NT>
struct Principal_curvature_numerator
{
  NT a, b, d, l, q;

  Principal_curvature_numerator(const Local_shape_3<NT>& s, Principal which)
    : a(s.trace_numerator()), b(which == Principal::MIN ? -1 : 1), d(umbilic_discriminant(s)),
      l(s.scale() * s.normal_squared_length()), q(s.normal_squared_length())
  {
    l = l + l;
  }
};

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief compares a principal curvature with a number, exactly.
 * \tparam NT an exact ring number type
 */
template <class NT>
Comparison_result compare_principal_curvature(const Local_shape_3<NT>& s, Principal which,
                                              const typename Local_shape_3<NT>::FT& bound)
{
  static_assert(Number_type_traits<NT>::is_exact,
                "principal curvatures are compared in exact number types only");
  const internal::Principal_curvature_numerator<NT> k(s, which);
  const NT c = -(bound * k.l);
  return internal::sign_with_roots(k.a, k.b, k.d, c, k.q);
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief compares principal curvatures at two points, exactly; each for the normal of its data.
 * \tparam NT an exact ring number type
 */
template <class NT>
Comparison_result compare_principal_curvatures(const Local_shape_3<NT>& s, Principal which_s,
                                               const Local_shape_3<NT>& t, Principal which_t)
{
  static_assert(Number_type_traits<NT>::is_exact,
                "principal curvatures are compared in exact number types only");
  const internal::Principal_curvature_numerator<NT> x(s, which_s), y(t, which_t);
  const CGAL::Sign sign_x = internal::sign_with_root(x.a, x.b, x.d);
  const CGAL::Sign sign_y = internal::sign_with_root(y.a, y.b, y.d);
  if (sign_x != sign_y)
    return CGAL::compare(static_cast<int>(sign_x), static_cast<int>(sign_y));
  if (sign_x == ZERO)
    return EQUAL;
  // Same sign: compare (a + b sqrt(d))^2 ly^2 qy with (..)^2 lx^2 qx; (a + b sqrt(d))^2 =
  // a^2 + d + 2 a b sqrt(d).
  const NT wx = y.l * y.l * y.q, wy = x.l * x.l * x.q;
  const NT constant = (x.a * x.a + x.d) * wx - (y.a * y.a + y.d) * wy;
  const NT root_x = NT(2) * x.a * x.b * wx;
  const NT root_y = NT(-2) * y.a * y.b * wy;
  const CGAL::Sign squares =
    internal::sign_with_roots(constant, root_x, x.d, root_y, y.d);
  return sign_x == POSITIVE ? squares : CGAL::opposite(squares);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_COMPARE_PRINCIPAL_CURVATURES_H
