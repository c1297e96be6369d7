// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_ASYMPTOTIC_DIRECTIONS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_ASYMPTOTIC_DIRECTIONS_H

// Asymptotic directions, II(z) = 0, over the complex numbers, and common ones of two surfaces
// (Pegna and Wolter, 2.6 and the complex corollary, with the hypothesis that makes it true).

#include <CGAL/Shape_interrogation/Analysis/three_tangents.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief describes the zeros of a quadratic form on the tangent plane.
 */
enum class Asymptotic_type
{
  REAL_DISTINCT, //!< two real directions (hyperbolic point)
  REAL_DOUBLE,   //!< one double direction (parabolic point)
  COMPLEX,       //!< two conjugate complex directions (elliptic point)
  ALL            //!< every direction (planar point)
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief holds the asymptotic directions \f$ (x \pm \sqrt d, y) \f$, or, where `x_is_single` is
 * set,
 * \f$ (1, 0) \f$ and \f$ (x, y) \f$. Free of roots, so exact.
 */
template <class NT>
struct Asymptotic_directions
{
  Asymptotic_type type;     //!< how many there are; for `ALL` the other fields mean nothing
  NT x;                     //!< the first component, up to the root
  NT y;                     //!< the second component
  NT discriminant;          //!< \f$ d = m^2 - l n \f$; negative for complex directions
  bool x_is_single = false; //!< set if \f$ l = 0 \f$: \f$ (1, 0) \f$ is one of the directions
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the asymptotic directions of a second fundamental form. Needs a ring only.
 * \exception Uncertain_conversion_exception if an enclosure does not decide
 */
template <class NT>
Asymptotic_directions<NT> asymptotic_directions(const Quadratic_form_2<NT>& second)
{
  Asymptotic_directions<NT> a;
  a.discriminant = -second.determinant();
  const CGAL::Sign sign = sign_decision(a.discriminant);
  const bool l_vanishes = is_zero_decision(second.l);
  a.x_is_single = l_vanishes;
  if (l_vanishes)
  {
    // y (2 m x + n y): the second direction is (-n, 2 m), which is (1, 0) again if m = 0.
    a.x = sign == ZERO ? NT(1) : NT(-second.n);
    a.y = second.m + second.m;
  }
  else
  {
    a.x = -second.m;
    a.y = second.l;
  }
  if (sign == ZERO)
    a.type = bool(second.is_zero()) ? Asymptotic_type::ALL : Asymptotic_type::REAL_DOUBLE;
  else
    a.type = sign == POSITIVE ? Asymptotic_type::REAL_DISTINCT : Asymptotic_type::COMPLEX;
  return a;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether the asymptotic directions are isotropic, \f$ I(z, z) = 0 \f$: exactly at
 * umbilics that are not planar. The quotient "normal curvature" is 0/0 in such a direction.
 */
template <class NT>
typename Number_type_traits<NT>::Boolean
are_asymptotic_directions_isotropic(const Fundamental_forms<NT>& forms)
{
  return forms.is_umbilic() & !forms.second.is_zero();
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether two forms have a common asymptotic direction over the complex numbers: their
 * resultant vanishes. Needs a ring only.
 */
template <class NT>
typename Number_type_traits<NT>::Boolean
have_common_asymptotic_direction(const Quadratic_form_2<NT>& a, const Quadratic_form_2<NT>& b)
{
  const NT ln = a.l * b.n - b.l * a.n;
  const NT lm = a.l * b.m - b.l * a.m, mn = a.m * b.n - b.m * a.n;
  return is_zero_decision(NT(ln * ln - NT(4) * lm * mn));
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether two forms that agree on the tangent `t` of a curve have a common asymptotic
 * direction, real or complex, that is not parallel to `t`. Needs a ring only.
 *
 * If the forms also agree as polar forms, `a(t, s) = b(t, s)` for all `s`, as along a common curve
 * of two surfaces that are tangent along it, they are then equal: the complex corollary.
 * A common asymptotic direction that is parallel to `t` proves nothing: two cylinders touching
 * along a generatrix share theirs (the criterion as printed in 2.6 is not sufficient).
 * \pre `a(t) = b(t)`, and `t` is not zero
 * \exception Uncertain_conversion_exception if an enclosure does not decide
 */
template <class NT>
bool have_transversal_asymptotic_direction(const Quadratic_form_2<NT>& a,
                                           const Quadratic_form_2<NT>& b,
                                           const Coordinates<NT, 2>& t)
{
  const Quadratic_form_2<NT> difference = b - a;
  if (bool(difference.is_zero()))
  {
    // Any zero of the common form that is not t: none only if the form is a multiple of (x x t)^2.
    if (bool(a.is_zero()))
      return true;
    return !bool(is_zero_decision(a.determinant())) || !bool(is_zero_decision(a(t)));
  }
  // difference = (x x t)(alpha x + beta y): the other zero is z = (beta, -alpha).
  const NT two_m = difference.m + difference.m;
  Coordinates<NT, 2> z;
  if (bool(is_zero_decision(t[1])))
    z = {NT(-difference.n), two_m};
  else
    z = {NT(two_m * t[1] + difference.l * t[0]), NT(-(difference.l * t[1]))};
  return !bool(is_zero_decision(internal::cross(z, t))) && bool(is_zero_decision(a(z)));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_ASYMPTOTIC_DIRECTIONS_H
