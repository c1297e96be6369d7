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
#include <type_traits>

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
 * \brief returns the mean curvature \f$ (\kappa_{min} + \kappa_{max}) / 2 \f$ for the normal of
 * `s`. Needs a square root.
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

namespace internal {

// By size; in floating point rounding may have exchanged two that are nearly equal.
template <class NT>
std::array<NT, 2> in_order(const NT& low, const NT& high)
{
  if constexpr (std::is_floating_point_v<NT>)
    if (low > high)
      return {high, low};
  return {low, high};
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief holds the curvatures at a point, for the normal of the data.
 */
template <class NT>
struct Curvatures
{
  NT gaussian; //!< the Gaussian curvature
  NT mean;     //!< the mean curvature
  NT min;      //!< the smaller principal curvature by signed value
  NT max;      //!< the larger principal curvature by signed value
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns all curvatures in one go. Needs square roots.
 *
 * The principal curvature of larger magnitude is computed first and the other as a quotient, so
 * that no digits cancel in floating point.
 */
template <class NT>
Curvatures<NT> curvatures(const Local_shape_3<NT>& s)
{
  const NT& q = s.normal_squared_length();
  const NT& a = s.trace_numerator();
  const NT& b = s.minors_numerator();
  // The discriminant is a square in truth: rounding must not make it negative.
  const NT root_d =
    Elementary_functions<NT>::sqrt(internal::nonnegative_part(umbilic_discriminant(s)));
  const NT cq = s.scale() * q;
  const NT scale = NT(1) / (NT(2) * cq * Elementary_functions<NT>::sqrt(q));
  Curvatures<NT> k;
  k.gaussian = b / (cq * cq);
  k.mean = a * scale;
  const auto sign = sign_of_mean_curvature(s);
  const bool positive = CGAL::certainly(sign == CGAL::POSITIVE);
  const bool negative = CGAL::certainly(sign == CGAL::NEGATIVE);
  if (!positive && !negative)
  {
    k.min = (a - root_d) * scale;
    k.max = (a + root_d) * scale;
    return k;
  }
  const NT larger = positive ? NT(a + root_d) : NT(a - root_d);
  const NT smaller = NT(4) * q * b / larger;
  const std::array<NT, 2> ordered = positive
    ? internal::in_order<NT>(smaller * scale, larger * scale)
    : internal::in_order<NT>(larger * scale, smaller * scale);
  k.min = ordered[0];
  k.max = ordered[1];
  return k;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the principal curvatures for the normal of `s`, by signed value: min, then max.
 * Needs square roots.
 */
template <class NT>
std::array<NT, 2> principal_curvatures(const Local_shape_3<NT>& s)
{
  const Curvatures<NT> k = curvatures(s);
  return {k.min, k.max};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_CURVATURES_H
