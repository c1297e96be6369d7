// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_HESSIAN_BY_CASES_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_HESSIAN_BY_CASES_H

// Hartmann's closed formulas for the Hessian of a normalform, sections 4.1.1 and 4.1.2, corrected,
// with the cyclic cases written out and the case chosen by certified signs.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells which components of a normal vanish.
 */
enum class Normal_pattern
{
  GENERIC,         //!< none
  X_ZERO,          //!< only x
  Y_ZERO,          //!< only y
  Z_ZERO,          //!< only z
  X_AND_Y_ZERO,    //!< all but z
  X_AND_Z_ZERO,    //!< all but y
  Y_AND_Z_ZERO     //!< all but x
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the name of a pattern as in reports: `"generic"`, `"hz=0"`, `"hx=hy=0"`, ...
 */
inline const char* to_string(Normal_pattern pattern)
{
  static const char* const names[] = {"generic", "hx=0",    "hy=0",   "hz=0",
                                      "hx=hy=0", "hx=hz=0", "hy=hz=0"};
  return names[static_cast<int>(pattern)];
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns which components of `h` vanish. \pre `h` is not zero
 * \exception Uncertain_conversion_exception if an enclosure does not decide
 */
template <class NT>
Normal_pattern normal_pattern(const Coordinates<NT, 3>& h)
{
  const bool x = is_zero_decision(h[0]), y = is_zero_decision(h[1]), z = is_zero_decision(h[2]);
  if (x && y)
    return Normal_pattern::X_AND_Y_ZERO;
  if (x && z)
    return Normal_pattern::X_AND_Z_ZERO;
  if (y && z)
    return Normal_pattern::Y_AND_Z_ZERO;
  return x ? Normal_pattern::X_ZERO
           : y ? Normal_pattern::Y_ZERO : z ? Normal_pattern::Z_ZERO : Normal_pattern::GENERIC;
}

namespace internal {

// The component that the formulas treat as the vanishing one: 0, 1, 2, or -1 in the generic case.
// Section 4.1.2 divides by no component, so it also serves where two vanish.
inline int vanishing_axis(Normal_pattern pattern)
{
  switch (pattern)
  {
  case Normal_pattern::GENERIC: return -1;
  case Normal_pattern::X_ZERO:
  case Normal_pattern::X_AND_Y_ZERO: return 0;
  case Normal_pattern::Y_ZERO: return 1;
  default: return 2;
  }
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the three tangent directions that `hessian_by_cases()` expects curvatures in.
 *
 * With \f$ h = (h_x, h_y, h_z) \f$ these are, not normalised,
 * \f$ (0, h_z, -h_y), (h_z, 0, -h_x), (h_y, -h_x, 0) \f$ in the generic case, and
 * \f$ (h_y, -h_x, 1), (-h_y, h_x, 1), (0, 0, 1) \f$ for \f$ h_z = 0 \f$; cyclically for the others.
 * \pre `h` is a unit vector with the given pattern
 */
template <class NT>
std::array<Coordinates<NT, 3>, 3> case_directions(const Coordinates<NT, 3>& h,
                                                  Normal_pattern pattern)
{
  const int axis = internal::vanishing_axis(pattern);
  const NT zero(0), one(1);
  if (axis < 0)
    return {Coordinates<NT, 3>{zero, h[2], NT(-h[1])}, Coordinates<NT, 3>{h[2], zero, NT(-h[0])},
            Coordinates<NT, 3>{h[1], NT(-h[0]), zero}};
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::array<Coordinates<NT, 3>, 3> v;
  v[0][axis] = v[1][axis] = v[2][axis] = one;
  v[0][i] = h[j];
  v[0][j] = -h[i];
  v[1][i] = -h[j];
  v[1][j] = h[i];
  v[2][i] = v[2][j] = zero;
  return v;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the Hessian of the normalform from its unit gradient and the normal curvatures in
 * the directions of `case_directions()`. Needs a field.
 *
 * The generic formulas divide by products of components: in floating point they lose all digits
 * near a vanishing component. `shape_from_normal_curvatures()` and the projector form \f$ P H P \f$
 * need no cases; the three agree exactly.
 * \pre `h` is a unit vector with the given pattern
 *
 * Source: Hartmann, 4.1.1 and 4.1.2 (the printed linear systems have a misprint, the solutions are
 * right; the cyclic cases are ours).
 */
template <class NT>
Symmetric_matrix_3<NT> hessian_by_cases(const Coordinates<NT, 3>& h, Normal_pattern pattern,
                                        const std::array<NT, 3>& kappa)
{
  Symmetric_matrix_3<NT> m;
  const int axis = internal::vanishing_axis(pattern);
  if (axis < 0)
  {
    std::array<NT, 3> square, k;
    for (int i = 0; i < 3; ++i)
      square[i] = h[i] * h[i];
    for (int i = 0; i < 3; ++i)
      k[i] = kappa[i] * (square[(i + 1) % 3] + square[(i + 2) % 3]);
    const NT sum = k[0] + k[1] + k[2];
    for (int i = 0; i < 3; ++i)
    {
      m(i, i) = sum - k[i] - sum * square[i];
      // The pair (i, j) and the third index l: (k_i h_i^2 + k_j h_j^2 - k_l h_l^2) / (2 h_i h_j).
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      const NT product = h[i] * h[j];
      m(i, j) = (k[i] * square[i] + k[j] * square[j] - k[l] * square[l]) / (NT(2) * product) -
                sum * product;
    }
    return m;
  }
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const NT a = kappa[0] + kappa[1] - kappa[2];
  const NT half = (kappa[0] - kappa[1]) / NT(2);
  m(axis, axis) = kappa[2];
  m(i, i) = h[j] * h[j] * a;
  m(j, j) = h[i] * h[i] * a;
  m(i, j) = -(h[i] * h[j] * a);
  m(axis, i) = h[j] * half;
  m(axis, j) = -(h[i] * half);
  return m;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_HESSIAN_BY_CASES_H
