// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CONDITION_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CONDITION_H

// Linear equations that single points out of a solution: planes of a sweep, fixed coordinates.

#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a linear equation \f$ a \cdot p = b \f$ that a corrected point shall satisfy as well.
 */
struct N_space_condition
{
  std::vector<double> coefficients; //!< \f$ a \f$, one number for each variable
  double value = 0;                 //!< \f$ b \f$

  //! returns the condition that the variable `i` of `n` has the value `x`.
  static N_space_condition fixed(int n, int i, double x)
  {
    N_space_condition c{std::vector<double>(n, 0.), x};
    c.coefficients[i] = 1;
    return c;
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CONDITION_H
