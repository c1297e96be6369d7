// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_PRINCIPAL_DIRECTIONS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_PRINCIPAL_DIRECTIONS_H

// Principal directions from the columns of B - lambda P, which is sqrt(D) times the projector on
// the other direction. (Hartmann's fallback alpha = 0 never arises: umbilics are refused first.)

#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <array>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the orthogonal projector on the direction of the larger principal curvature.
 *
 * It is \f$ (B - \lambda P) / \sqrt D \f$ with \f$ \lambda = (\mathrm{tr} B - \sqrt D) / 2 \f$, and
 * does not depend on the sign choice that a direction vector needs. Exact where \f$ \sqrt D \f$ is
 * in the field. Refused at umbilics (`AMBIGUOUS`).
 * \exception Not_algebraic_error if the root is not in an exact field
 */
template <class NT>
Result<Symmetric_matrix_3<NT>> projector_on_max_direction(const Local_shape_3<NT>& s)
{
  const auto umbilic = is_umbilic(s);
  if (CGAL::certainly(umbilic))
    return Refusal(Refusal_code::AMBIGUOUS, "the point is umbilic: all directions are principal");
  if (CGAL::possibly(umbilic))
    return Refusal(Refusal_code::UNDECIDED, "it is undecided whether the point is umbilic");
  const NT& q = s.normal_squared_length();
  const NT discriminant = internal::nonnegative_part(umbilic_discriminant(s));
  if (CGAL::certainly(is_zero_decision(discriminant))) // below zero by rounding
    return Refusal(Refusal_code::AMBIGUOUS, "the point is umbilic up to rounding");
  const NT root = Elementary_functions<NT>::sqrt(discriminant) / (s.scale() * q); // sqrt(D)
  const NT trace = s.trace_numerator() / (s.scale() * q);
  const NT lambda = (trace - root) / NT(2);
  const Symmetric_matrix_3<NT> b = s.shape_matrix();
  Symmetric_matrix_3<NT> m;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
    {
      const NT nn = s.normal()[i] * s.normal()[j] / q;
      const NT p = i == j ? NT(NT(1) - nn) : NT(-nn);
      m(i, j) = (b(i, j) - lambda * p) / root;
    }
  return m;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the unit principal directions: of the smaller, then of the larger principal
 * curvature.
 *
 * They are orthonormal and right-handed with the normal, in the order (min, max, normal); the pair
 * with both signs reversed would be as good. Needs square roots, so that it is for `double`,
 * enclosures and exact reals; `projector_on_max_direction()` is free of the sign choice.
 * Refused at umbilics (`AMBIGUOUS`).
 */
template <class NT>
Result<std::array<Coordinates<NT, 3>, 2>> principal_directions(const Local_shape_3<NT>& s)
{
  const Result<Symmetric_matrix_3<NT>> projector = projector_on_max_direction(s);
  if (!projector)
    return projector.refusal();
  // The largest diagonal entry belongs to the longest column.
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (CGAL::possibly(sign_decision(NT((*projector)(i, i) - (*projector)(k, k))) ==
                       CGAL::POSITIVE))
      k = i;
  Coordinates<NT, 3> max, unit;
  const NT length = Elementary_functions<NT>::sqrt((*projector)(k, k));
  const NT normal = Elementary_functions<NT>::sqrt(s.normal_squared_length());
  for (int i = 0; i < 3; ++i)
  {
    max[i] = (*projector)(i, k) / length;
    unit[i] = s.normal()[i] / normal;
  }
  return std::array<Coordinates<NT, 3>, 2>{internal::cross(max, unit), max};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_PRINCIPAL_DIRECTIONS_H
