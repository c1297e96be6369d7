// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_THREE_TANGENTS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_THREE_TANGENTS_H

// The three tangents theorem (Pegna and Wolter, 2.3): normal curvatures in three pairwise
// independent directions determine the second fundamental form. det = 2 (t1 x t2)(t1 x t3)(t2 x
// t3).

#include <CGAL/Shape_interrogation/Analysis/Fundamental_forms.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <class NT>
NT cross(const Coordinates<NT, 2>& a, const Coordinates<NT, 2>& b)
{
  NT c = a[0] * b[1] - a[1] * b[0];
  return c;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the determinant of the linear system of the three tangents theorem,
 * \f$ 2 (t_1 \times t_2)(t_1 \times t_3)(t_2 \times t_3) \f$: not zero exactly for pairwise
 * independent directions. Needs a ring only.
 */
template <class NT>
NT three_tangents_determinant(const std::array<Coordinates<NT, 2>, 3>& t)
{
  NT d = NT(2) * internal::cross(t[0], t[1]) * internal::cross(t[0], t[2]) *
         internal::cross(t[1], t[2]);
  return d;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the second fundamental form that has the normal curvatures `kappa` in the three
 * directions `t`, for the first fundamental form `first`. Needs a field.
 *
 * Refused are directions of which two are parallel (`DEPENDENT_DIRECTIONS`): the form is then not
 * determined, however many curvatures agree.
 */
template <class NT>
Result<Quadratic_form_2<NT>>
second_form_from_three_tangents(const Quadratic_form_2<NT>& first,
                                const std::array<Coordinates<NT, 2>, 3>& t,
                                const std::array<NT, 3>& kappa)
{
  const NT d12 = internal::cross(t[0], t[1]);
  const NT d13 = internal::cross(t[0], t[2]);
  const NT d23 = internal::cross(t[1], t[2]);
  if (auto refusal = internal::refuse_zero(NT(d12 * d13 * d23),
                                           Refusal_code::DEPENDENT_DIRECTIONS,
                                           "the determinant of the three directions"))
    return *refusal;
  // Lagrange: II = sum c_i (x x t_j)(x x t_k), where (x x t_j)(x x t_k) vanishes on t_j and t_k.
  const auto product = [](const Coordinates<NT, 2>& a, const Coordinates<NT, 2>& b) {
    const NT mixed = a[0] * b[1] + a[1] * b[0];
    return Quadratic_form_2<NT>{NT(a[1] * b[1]), NT(-(mixed / NT(2))), NT(a[0] * b[0])};
  };
  const NT c1 = kappa[0] * first(t[0]) / (d12 * d13);
  const NT c2 = -(kappa[1] * first(t[1]) / (d12 * d23));
  const NT c3 = kappa[2] * first(t[2]) / (d13 * d23);
  const Quadratic_form_2<NT> p1 = product(t[1], t[2]), p2 = product(t[0], t[2]),
                             p3 = product(t[0], t[1]);
  return Quadratic_form_2<NT>{NT(c1 * p1.l + c2 * p2.l + c3 * p3.l),
                              NT(c1 * p1.m + c2 * p2.m + c3 * p3.m),
                              NT(c1 * p1.n + c2 * p2.n + c3 * p3.n)};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_THREE_TANGENTS_H
