// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_FUNDAMENTAL_FORMS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_FUNDAMENTAL_FORMS_H

// The two fundamental forms in a basis of the tangent plane, for questions about directions
// (Pegna and Wolter, section 2), in Hartmann's sign: the normal curvature is II / I.

#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief is a quadratic form \f$ l x^2 + 2 m x y + n y^2 \f$ on the tangent plane.
 * \tparam NT a ring number type
 */
template <class NT>
struct Quadratic_form_2
{
  NT l; //!< the coefficient of \f$ x^2 \f$
  NT m; //!< half the coefficient of \f$ x y \f$
  NT n; //!< the coefficient of \f$ y^2 \f$

  //! returns the value in a direction.
  NT operator()(const Coordinates<NT, 2>& t) const { return (*this)(t, t); }

  //! returns the value of the polar form.
  NT operator()(const Coordinates<NT, 2>& s, const Coordinates<NT, 2>& t) const
  {
    NT value = l * s[0] * t[0] + m * (s[0] * t[1] + s[1] * t[0]) + n * s[1] * t[1];
    return value;
  }

  //! returns \f$ l n - m^2 \f$.
  NT determinant() const
  {
    NT d = l * n - m * m;
    return d;
  }

  //! tells whether all coefficients vanish.
  typename Number_type_traits<NT>::Boolean is_zero() const
  {
    return is_zero_decision(l) & is_zero_decision(m) & is_zero_decision(n);
  }

  //! returns the difference of two forms.
  friend Quadratic_form_2 operator-(const Quadratic_form_2& a, const Quadratic_form_2& b)
  {
    return {NT(a.l - b.l), NT(a.m - b.m), NT(a.n - b.n)};
  }
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief holds the first and second fundamental form in a common basis of the tangent plane.
 *
 * The normal curvature in the direction \f$ t \f$ is \f$ II(t) / I(t) \f$ times a positive constant
 * common to all directions (1 where the forms were given for the unit normal).
 */
template <class NT>
struct Fundamental_forms
{
  Quadratic_form_2<NT> first;  //!< the first fundamental form, positive definite
  Quadratic_form_2<NT> second; //!< the second fundamental form

  //! returns \f$ II(t) / I(t) \f$. Needs a field. \pre `t` is not zero
  NT normal_curvature(const Coordinates<NT, 2>& t) const
  {
    NT k = second(t) / first(t);
    return k;
  }
  //! returns \f$ \det II / \det I \f$. Needs a field.
  NT gaussian_curvature() const
  {
    NT k = second.determinant() / first.determinant();
    return k;
  }
  //! returns \f$ (E n - 2 F m + G l) / (2 \det I) \f$. Needs a field.
  NT mean_curvature() const
  {
    NT h = mean_numerator() / (NT(2) * first.determinant());
    return h;
  }
  //! returns \f$ E n - 2 F m + G l \f$, a positive multiple of the mean curvature.
  NT mean_numerator() const
  {
    const NT fm = first.m * second.m;
    NT h = first.l * second.n - fm - fm + first.n * second.l;
    return h;
  }
  //! tells whether the forms are proportional, that is the point is umbilic. The three minors
  //! vanish linearly.
  typename Number_type_traits<NT>::Boolean is_umbilic() const
  {
    return is_zero_decision(NT(first.l * second.m - first.m * second.l)) &
           is_zero_decision(NT(first.l * second.n - first.n * second.l)) &
           is_zero_decision(NT(first.m * second.n - first.n * second.m));
  }
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the forms of `s` in the basis `u`, `v` of the tangent plane; the second one is
 * multiplied by \f$ w \sqrt q \f$, which is positive, so that no root is needed.
 * \pre `u` and `v` are tangent and linearly independent
 */
template <class NT>
Fundamental_forms<NT> fundamental_forms(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& u,
                                        const Coordinates<NT, 3>& v)
{
  return {{internal::dot(u, u), internal::dot(u, v), internal::dot(v, v)},
          {second_form(s, u, u), second_form(s, u, v), second_form(s, v, v)}};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_FUNDAMENTAL_FORMS_H
