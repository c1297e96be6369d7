// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_SHAPE_FROM_NORMAL_CURVATURES_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_SHAPE_FROM_NORMAL_CURVATURES_H

// The shape operator from normal curvatures in any three tangent directions: the general form
// behind Hartmann's case formulas, without cases.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// |n|, which need not be in the field unless it is 1.
template <class NT>
NT length_of_normal(const NT& q)
{
  if (CGAL::certainly(is_zero_decision(NT(q - NT(1)))))
    return NT(1);
  return Elementary_functions<NT>::sqrt(q);
}

template <class NT>
Result<Local_shape_3<NT>> solve_three_tangents(const Coordinates<NT, 3>& point,
                                               const Coordinates<NT, 3>& n,
                                               const std::array<Coordinates<NT, 3>, 3>& d,
                                               const std::array<NT, 3>& kappa)
{
  const NT q = dot(n, n);
  if (auto refusal = refuse_zero(q, Refusal_code::SINGULAR_POINT, "the normal"))
    return *refusal;
  for (int i = 0; i < 3; ++i)
    if (auto refusal = refuse_nonzero(NT(dot(n, d[i])), Refusal_code::NOT_TANGENT,
                                      "the product of normal and direction"))
      return *refusal;
  const NT d12 = determinant(n, d[0], d[1]);
  const NT d13 = determinant(n, d[0], d[2]);
  const NT d32 = determinant(n, d[2], d[1]);
  if (auto refusal = refuse_zero(NT(d12 * d13 * d32), Refusal_code::DEPENDENT_DIRECTIONS,
                                 "the determinant of two of the directions"))
    return *refusal;
  // d3 = (d32 d1 + d13 d2) / d12, so II(d3) gives the mixed entry in the basis d1, d2.
  const NT h11 = kappa[0] * dot(d[0], d[0]), h22 = kappa[1] * dot(d[1], d[1]);
  const NT h33 = kappa[2] * dot(d[2], d[2]);
  const NT h12 =
    (h33 * d12 * d12 - d32 * d32 * h11 - d13 * d13 * h22) / (NT(2) * d32 * d13);
  // The form is the Hessian of the normalform; B = |n| times it. The frame's own normal d1 x d2 has
  // no part in this: only its matrix is used.
  const auto frame = Local_shape_3<NT>::from_frame(point, d[0], d[1], h11, h12, h22);
  Symmetric_matrix_3<NT> b = frame.shape_matrix();
  const NT length = length_of_normal(q);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      b(i, j) = b(i, j) * length;
  return Local_shape_3<NT>(point, n, b);
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the second-order data with the given normal that have the normal curvatures
 * `kappa` (for the unit normal) in three tangent `directions`. Needs a field.
 *
 * The directions need not be normalised. If the normal has not length 1, its length must exist in
 * the field.
 * Refused are a zero normal (`SINGULAR_POINT`), directions that certainly are not tangent
 * (`NOT_TANGENT`), two parallel directions (`DEPENDENT_DIRECTIONS`), and a length that is not in
 * the field (`NOT_ALGEBRAIC`).
 *
 * Source: three tangents theorem (Pegna and Wolter, 2.3); Hartmann, section 4.1.
 * \sa `hessian_by_cases()`
 */
template <class NT>
Result<Local_shape_3<NT>>
shape_from_normal_curvatures(const Coordinates<NT, 3>& point, const Coordinates<NT, 3>& normal,
                             const std::array<Coordinates<NT, 3>, 3>& directions,
                             const std::array<NT, 3>& kappa)
{
  return internal::refuse_errors<Local_shape_3<NT>>(
    [&] { return internal::solve_three_tangents(point, normal, directions, kappa); });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_SHAPE_FROM_NORMAL_CURVATURES_H
