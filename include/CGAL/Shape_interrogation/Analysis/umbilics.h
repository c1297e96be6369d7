// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_UMBILICS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_UMBILICS_H

// Umbilic, planar and parabolic points. An umbilic is decided by the discriminant where that
// suffices, else by six entries that vanish linearly: 2 c w q^2 B - a w (q I - N N^T).

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief is the type of a surface point.
 */
enum class Point_type
{
  ELLIPTIC,   //!< both principal curvatures have the same sign
  HYPERBOLIC, //!< they have opposite signs
  PARABOLIC,  //!< exactly one is zero
  PLANAR      //!< both are zero
};

namespace internal {

// All entries zero? An enclosure says no as soon as one entry is certainly not zero.
template <class NT>
typename Number_type_traits<NT>::Boolean is_zero_matrix(const Symmetric_matrix_3<NT>& m)
{
  using Boolean = typename Number_type_traits<NT>::Boolean;
  Boolean zero = true;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      zero = zero & is_zero_decision(m(i, j));
  return zero;
}

template <class NT>
Symmetric_matrix_3<NT> umbilic_deviation(const Local_shape_3<NT>& s)
{
  Symmetric_matrix_3<NT> u = s.scaled_shape_matrix();
  const NT two_c = s.scale() + s.scale();
  const NT aw = s.trace_numerator() * s.form_denominator();
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
    {
      const NT nn = s.normal()[i] * s.normal()[j];
      const NT p = i == j ? NT(s.normal_squared_length() - nn) : NT(-nn);
      u(i, j) = two_c * u(i, j) - aw * p;
    }
  return u;
}

// Out of line and by value: the data of a generic point then never need to be in memory.
template <class NT>
[[gnu::noinline, gnu::cold]] typename Number_type_traits<NT>::Boolean
is_umbilic_by_deviation(Local_shape_3<NT> s)
{
  return is_zero_matrix(umbilic_deviation(s));
}

template <class NT>
[[gnu::noinline, gnu::cold]] typename Number_type_traits<NT>::Boolean
is_planar_by_matrix(Local_shape_3<NT> s)
{
  return is_zero_matrix(s.scaled_shape_matrix());
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether the point is umbilic, that is all normal curvatures are equal (planar points
 * are umbilic). Needs a ring only.
 *
 * Exact types decide by `umbilic_discriminant()`. Enclosures can only refute; near an umbilic they
 * use six entries that vanish linearly instead of quadratically.
 */
template <class NT>
typename Number_type_traits<NT>::Boolean is_umbilic(const Local_shape_3<NT>& s)
{
  using Boolean = typename Number_type_traits<NT>::Boolean;
  const Boolean zero = is_zero_decision(umbilic_discriminant(s));
  if constexpr (!Number_type_traits<NT>::is_enclosure)
    return zero;
  else
  {
    if (!CGAL::possibly(zero))
      return zero;
    return internal::is_umbilic_by_deviation(s);
  }
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether all normal curvatures vanish, \f$ B = 0 \f$. Needs a ring only.
 */
template <class NT>
typename Number_type_traits<NT>::Boolean is_planar(const Local_shape_3<NT>& s)
{
  using Boolean = typename Number_type_traits<NT>::Boolean;
  const Boolean flat = is_zero_decision(s.trace_numerator()) &
                       is_zero_decision(s.minors_numerator());
  if constexpr (!Number_type_traits<NT>::is_enclosure)
    return flat;
  else
  {
    if (!CGAL::possibly(flat))
      return flat;
    return internal::is_planar_by_matrix(s);
  }
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief tells whether exactly one principal curvature vanishes. Needs a ring only.
 */
template <class NT>
typename Number_type_traits<NT>::Boolean is_parabolic(const Local_shape_3<NT>& s)
{
  return is_zero_decision(s.minors_numerator()) & !is_zero_decision(s.trace_numerator());
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the type of the point. Needs a ring only.
 * \exception Uncertain_conversion_exception if an enclosure does not decide
 */
template <class NT>
Point_type point_type(const Local_shape_3<NT>& s)
{
  const CGAL::Sign k = sign_of_gaussian_curvature(s);
  if (k != ZERO)
    return k == POSITIVE ? Point_type::ELLIPTIC : Point_type::HYPERBOLIC;
  const CGAL::Sign h = sign_of_mean_curvature(s);
  return h == ZERO ? Point_type::PLANAR : Point_type::PARABOLIC;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_UMBILICS_H
