// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_CURVATURES_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_CURVATURES_H

// Gaussian, mean and principal curvatures from the waist: signs and squares without roots.
// K = b / (c q)^2, H = a / (2 c q sqrt(q)), with a, b, c, q as in Local_shape_3.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the Gaussian curvature, which is rational in the data. Needs a field.
 */
template <class NT>
NT gaussian_curvature(const Local_shape_3<NT>& s)
{
  const NT cq = s.scale() * s.normal_squared_length();
  NT k = s.minors_numerator() / (cq * cq);
  return k;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the sign of the Gaussian curvature: positive at elliptic, zero at parabolic and
 * planar, negative at hyperbolic points. Needs a ring only.
 */
template <class NT>
typename Number_type_traits<NT>::Sign sign_of_gaussian_curvature(const Local_shape_3<NT>& s)
{
  return sign_decision(s.minors_numerator());
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the sign of the mean curvature for the normal of `s`. Needs a ring only.
 */
template <class NT>
typename Number_type_traits<NT>::Sign sign_of_mean_curvature(const Local_shape_3<NT>& s)
{
  return sign_decision(s.trace_numerator());
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the square of the mean curvature, which is rational in the data. Needs a field.
 */
template <class NT>
NT squared_mean_curvature(const Local_shape_3<NT>& s)
{
  const NT& a = s.trace_numerator();
  const NT& q = s.normal_squared_length();
  const NT cq = s.scale() * q;
  NT h = a * a / (NT(4) * cq * cq * q);
  return h;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the mean curvature \f$ (\kappa_{min} + \kappa_{max}) / 2 \f$ for the normal of `s`.
 * Needs a square root.
 */
template <class NT>
NT mean_curvature(const Local_shape_3<NT>& s)
{
  const NT& q = s.normal_squared_length();
  const NT root = Elementary_functions<NT>::sqrt(q);
  NT h = s.trace_numerator() / (NT(2) * s.scale() * q * root);
  return h;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns \f$ a^2 - 4 q b \f$, a positive multiple of
 * \f$ (\kappa_{max} - \kappa_{min})^2 \f$: zero exactly at umbilics. Needs a ring only.
 *
 * It vanishes to second order, so an enclosure of it decides late; `is_umbilic()` also uses a form
 * that vanishes linearly.
 */
template <class NT>
NT umbilic_discriminant(const Local_shape_3<NT>& s)
{
  const NT& a = s.trace_numerator();
  NT d = a * a - NT(4) * s.normal_squared_length() * s.minors_numerator();
  return d;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns \f$ (\kappa_{max} - \kappa_{min})^2 \f$, which is rational in the data.
 * Needs a field.
 */
template <class NT>
NT squared_curvature_gap(const Local_shape_3<NT>& s)
{
  const NT& q = s.normal_squared_length();
  const NT cq = s.scale() * q;
  NT g = umbilic_discriminant(s) / (cq * cq * q);
  return g;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the principal curvatures for the normal of `s`, by signed value: min, then max.
 * Needs square roots.
 *
 * The one of larger magnitude is computed first and the other as a quotient, so that no digits
 * cancel in floating point.
 */
template <class NT>
std::array<NT, 2> principal_curvatures(const Local_shape_3<NT>& s)
{
  NT d = umbilic_discriminant(s);
  // The discriminant is a square in truth: rounding must not make it negative.
  if (CGAL::certainly(sign_decision(d) == CGAL::NEGATIVE))
    d = NT(0);
  else if constexpr (Number_type_traits<NT>::is_enclosure)
    d = internal::nonnegative_part(d);
  const NT& q = s.normal_squared_length();
  const NT root_d = Elementary_functions<NT>::sqrt(d);
  const NT length = NT(2) * s.scale() * q * Elementary_functions<NT>::sqrt(q);
  const NT& a = s.trace_numerator();
  const auto sign = sign_of_mean_curvature(s);
  if (CGAL::certainly(sign == CGAL::POSITIVE))
  {
    const NT high = a + root_d;
    return {NT(NT(4) * q * s.minors_numerator() / (high * length)), NT(high / length)};
  }
  if (CGAL::certainly(sign == CGAL::NEGATIVE))
  {
    const NT low = a - root_d;
    return {NT(low / length), NT(NT(4) * q * s.minors_numerator() / (low * length))};
  }
  return {NT((a - root_d) / length), NT((a + root_d) / length)};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_CURVATURES_H
