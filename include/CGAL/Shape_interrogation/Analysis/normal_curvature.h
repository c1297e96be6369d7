// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_NORMAL_CURVATURE_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_NORMAL_CURVATURE_H

// The normal curvature in a tangent direction, kappa(v) = v' B v / (sqrt(q) v.v): its sign and its
// square without roots, its value with one. Euler's formula from the principal curvatures.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <array>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns \f$ u^T T v \f$ for the form of the data: \f$ w \f$ times \f$ u^T B v \f$ for
 * tangent vectors, without division. Needs a ring only.
 */
template <class NT>
NT second_form(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& u,
               const Coordinates<NT, 3>& v)
{
  return internal::dot(u, internal::multiply(s.form(), v));
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns a refusal if `v` is not a tangent direction at `s`: certainly not orthogonal to
 * the normal (`NOT_TANGENT`; floating point makes no such claim), or zero (`DEPENDENT_DIRECTIONS`).
 */
template <class NT>
std::optional<Refusal> refuse_direction(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& v)
{
  if (auto refusal = internal::refuse_nonzero(NT(internal::dot(s.normal(), v)),
                                              Refusal_code::NOT_TANGENT,
                                              "the product of direction and normal"))
    return refusal;
  return internal::refuse_zero(NT(internal::dot(v, v)), Refusal_code::DEPENDENT_DIRECTIONS,
                               "the direction");
}

namespace internal {

// A positive multiple of P v, the part of v in the tangent plane: v' T v of a vector that is only
// nearly tangent, as one in double is, would depend on more than the surface.
template <class NT>
Coordinates<NT, 3> tangent_part(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& v)
{
  const Coordinates<NT, 3>& n = s.normal();
  const NT c = dot(n, v);
  if (CGAL::certainly(is_zero_decision(c)))
    return v;
  const NT& q = s.normal_squared_length();
  if constexpr (std::is_floating_point_v<NT>) // does not overflow
    return {v[0] - c / q * n[0], v[1] - c / q * n[1], v[2] - c / q * n[2]};
  else
    return {NT(q * v[0] - c * n[0]), NT(q * v[1] - c * n[1]), NT(q * v[2] - c * n[2])};
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the sign of the normal curvature in the tangent direction `v`. Needs a ring only.
 *
 * A direction that is not tangent stands for its orthogonal projection on the tangent plane, so
 * that the sign depends on the surface only; it is zero for a multiple of the normal.
 * \pre `v` is not zero
 */
template <class NT>
typename Number_type_traits<NT>::Sign
sign_of_normal_curvature(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& v)
{
  const Coordinates<NT, 3> t = internal::tangent_part(s, v);
  return sign_decision(second_form(s, t, t));
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the square of the normal curvature in the tangent direction `v`, or in that of the
 * projection of `v` on the tangent plane. Needs a field.
 * \pre `v` is not orthogonal to the tangent plane, and not zero
 */
template <class NT>
NT squared_normal_curvature(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& v)
{
  const Coordinates<NT, 3> t = internal::tangent_part(s, v);
  const NT form = second_form(s, t, t);
  const NT length = s.form_denominator() * internal::dot(t, t);
  NT k = form * form / (s.normal_squared_length() * length * length);
  return k;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the normal curvature in the tangent direction `v`, or in that of the projection of
 * `v` on the tangent plane, in the sign of `Local_shape_3`. Needs a square root.
 * \pre `v` is not orthogonal to the tangent plane, and not zero
 */
template <class NT>
NT normal_curvature(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& v)
{
  const Coordinates<NT, 3> t = internal::tangent_part(s, v);
  const NT root = Elementary_functions<NT>::sqrt(s.normal_squared_length());
  NT k = second_form(s, t, t) / (s.form_denominator() * root * internal::dot(t, t));
  return k;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns Euler's \f$ \kappa_{min} \cos^2 \theta + \kappa_{max} \sin^2 \theta \f$ for the
 * direction at the angle \f$ \theta \f$ from the one of the smaller principal curvature, given by
 * any positive multiple of \f$ (\cos \theta, \sin \theta) \f$. Needs a field.
 * \pre the direction is not zero
 */
template <class NT>
NT normal_curvature_by_euler(const std::array<NT, 2>& principal_curvatures, const NT& cosine,
                             const NT& sine)
{
  const NT c = cosine * cosine, s = sine * sine;
  NT k = (principal_curvatures[0] * c + principal_curvatures[1] * s) / (c + s);
  return k;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_NORMAL_CURVATURE_H
