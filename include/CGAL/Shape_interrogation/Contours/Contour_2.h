// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_2_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_2_H

// What is known of the zero set of a polynomial on the unit square.

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief holds what a contour should look like and how much may be spent on it.
 */
struct Contour_options
{
  //! the greatest distance between neighbouring points of a curve in the unit square
  double step = 0.01;
  //! the number of cells that are cut at most; what is open then is unresolved
  std::size_t max_cells = 100000;
};

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief is a connected curve of the zero set.
 *
 * The polygon is isotopic to the curve in the union of the cells that the curve passes, and the
 * polygons of different curves do not meet. Its points are on the curve up to rounding (about
 * 1e-12, where the polynomial is well conditioned).
 */
struct Contour_curve_2
{
  std::vector<std::array<double, 2>> points; //!< the points; the first is not repeated at the end
  bool is_closed = false;                    //!< whether the last point is joined to the first
  //! for both ends the index of the unresolved place in which it lies, or -1 on the boundary
  std::array<int, 2> unresolved{-1, -1};
};

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief is a place in which the zero set is not known: a singular point, or where several parts
 * are too close for the effort allowed.
 */
struct Unresolved_box_2
{
  std::array<double, 2> low;  //!< the lower corner of the box
  std::array<double, 2> high; //!< the upper corner
  int branches = 0;           //!< the number of curves that end there
};

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief is an edge of the unit square on which the polynomial vanishes identically.
 */
struct Contour_edge_2
{
  int axis;         //!< the variable that is fixed on the edge
  int end;          //!< its value, 0 or 1
  int multiplicity; //!< the multiplicity with which the polynomial vanishes there
};

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief is the zero set of a polynomial on the unit square.
 *
 * Where nothing is unresolved, the numbers of curves, of closed ones, of their ends on the boundary
 * and of isolated points are proved. (Isolated points are found on the boundary only, where the
 * curve touches the square from outside; those inside are singular, hence unresolved.)
 */
struct Contour_2
{
  bool is_everything = false;                         //!< whether the polynomial is 0
  std::vector<Contour_edge_2> edges;                  //!< edges on which it vanishes
  std::vector<Contour_curve_2> curves;                //!< the curves
  std::vector<std::array<double, 2>> isolated_points; //!< isolated points on the boundary
  std::vector<Unresolved_box_2> unresolved;           //!< the rest
  double positive_area = 0; //!< a lower bound of the area where the polynomial is positive
  double negative_area = 0; //!< a lower bound of the area where it is negative

  //! tells whether the topology is proved: nothing is unresolved.
  bool has_certified_topology() const { return unresolved.empty(); }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_2_H
