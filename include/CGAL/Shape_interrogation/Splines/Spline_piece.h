// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_PIECE_H
#define CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_PIECE_H

// A polynomial piece of a spline function.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSplines
 * \brief holds a polynomial piece of a spline function and the box of parameters that it covers.
 */
template <class NT, int d>
struct Spline_piece
{
  Bernstein_polynomial<NT, d> polynomial; //!< the polynomial, on the unit cube
  std::array<NT, d> low;                  //!< the least parameters
  std::array<NT, d> high;                 //!< the greatest parameters

  //! tells whether the piece covers a box.
  bool contains(const std::array<NT, d>& low_end, const std::array<NT, d>& high_end) const
  {
    for (int k = 0; k < d; ++k)
      if (low_end[k] < low[k] || high[k] < high_end[k])
        return false;
    return true;
  }

  //! returns the polynomial over a part of the box, on the unit cube again.
  Bernstein_polynomial<NT, d> restricted(const std::array<NT, d>& low_end,
                                         const std::array<NT, d>& high_end) const
  {
    Bernstein_polynomial<NT, d> p = polynomial;
    for (int k = 0; k < d; ++k)
    {
      const NT length = high[k] - low[k];
      if (low_end[k] != low[k] || high_end[k] != high[k])
        p = p.restricted(k, NT((low_end[k] - low[k]) / length),
                         NT((high_end[k] - low[k]) / length));
    }
    return p;
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_PIECE_H
