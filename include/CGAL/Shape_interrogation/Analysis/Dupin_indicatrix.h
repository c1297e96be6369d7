// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_DUPIN_INDICATRIX_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_DUPIN_INDICATRIX_H

// Dupin's indicatrix k1 x^2 + k2 y^2 = +-1 in the tangent plane, with the signs that Pegna and
// Wolter leave out: without them a surface and its mirror image have the same one.

#include <CGAL/Shape_interrogation/Analysis/Fundamental_forms.h>

#include <optional>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief is the type of a Dupin indicatrix.
 */
enum class Dupin_type
{
  ELLIPSE,              //!< elliptic point; a circle at umbilics
  CONJUGATE_HYPERBOLAS, //!< hyperbolic point: one pair of branches for each sign
  PARALLEL_LINES,       //!< parabolic point: two lines parallel to the null direction
  EMPTY                 //!< planar point
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief is Dupin's indicatrix of a pair of fundamental forms: the set of tangent vectors `t` with
 * \f$ II(t) = \pm 1 \f$.
 */
template <class NT>
struct Dupin_indicatrix
{
  Dupin_type type;           //!< its type
  bool is_circle;            //!< whether it is a circle: the point is umbilic and not planar
  int right_hand_side;       //!< +1 or -1; 0 for both (hyperbolas) and for none (empty)
  Quadratic_form_2<NT> form; //!< the second fundamental form
  //! for parallel lines, their direction: the null direction of the form. (Pegna and Wolter, 2.2,
  //! have the other one.)
  std::optional<Coordinates<NT, 2>> line_direction;

  //! tells whether two indicatrices in the same basis are the same set of points. The forms may
  //! then still be opposite: the set does not know the side to which the surface bends.
  friend bool is_same_point_set(const Dupin_indicatrix& a, const Dupin_indicatrix& b)
  {
    const Quadratic_form_2<NT> opposite{NT(-b.form.l), NT(-b.form.m), NT(-b.form.n)};
    return bool((a.form - b.form).is_zero()) || bool((a.form - opposite).is_zero());
  }
};

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns Dupin's indicatrix. Needs a ring only.
 * \exception Uncertain_conversion_exception if an enclosure does not decide
 */
template <class NT>
Dupin_indicatrix<NT> dupin_indicatrix(const Fundamental_forms<NT>& forms)
{
  const CGAL::Sign k = sign_decision(forms.second.determinant());
  const CGAL::Sign h = sign_decision(forms.mean_numerator());
  Dupin_indicatrix<NT> d{Dupin_type::EMPTY, false, static_cast<int>(h), forms.second, {}};
  if (k == POSITIVE)
  {
    d.type = Dupin_type::ELLIPSE;
    d.is_circle = forms.is_umbilic();
  }
  else if (k == NEGATIVE)
  {
    d.type = Dupin_type::CONJUGATE_HYPERBOLAS;
    d.right_hand_side = 0;
  }
  else if (h != ZERO)
  {
    d.type = Dupin_type::PARALLEL_LINES;
    if (bool(is_zero_decision(forms.second.l)))
      d.line_direction = Coordinates<NT, 2>{NT(1), NT(0)};
    else
      d.line_direction = Coordinates<NT, 2>{NT(-forms.second.m), forms.second.l};
  }
  return d;
}

/*!
 * \ingroup PkgShapeInterrogationAnalysis
 * \brief returns the squared distance of the two lines of the indicatrix from the point, which is
 * \f$ 1 / |\kappa| \f$ for the principal curvature that is not zero. Needs a field.
 * \pre the indicatrix of `forms`, given for the unit normal, is a pair of parallel lines
 */
template <class NT>
NT squared_half_distance_of_lines(const Fundamental_forms<NT>& forms)
{
  const NT h = NT(2) * forms.mean_curvature();
  NT distance = NT(1) / (CGAL::is_negative(h) ? NT(-h) : h);
  return distance;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_DUPIN_INDICATRIX_H
