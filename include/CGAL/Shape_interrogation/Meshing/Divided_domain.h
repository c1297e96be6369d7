// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_DIVIDED_DOMAIN_H
#define CGAL_SHAPE_INTERROGATION_MESHING_DIVIDED_DOMAIN_H

// The unit square of a patch's parameters, triangulated and divided into regions.

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

//! \ingroup PkgShapeInterrogationMeshing
//! \brief is the region of triangles whose region is not known.
constexpr int unresolved_region = -1;

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a closed polygon on the boundary of a part of a region, which lies to the left of it.
 *
 * The outer loop of a part is anticlockwise, loops around its holes are clockwise. Where a part
 * touches itself in a point, its loops pass there more than once, and never cross.
 */
struct Region_loop
{
  int region = unresolved_region;             //!< the region
  int part = 0;                               //!< the connected part of a region, from 0
  std::vector<std::array<double, 2>> points;  //!< the points; the first is not repeated at the end
  double signed_area = 0;                     //!< what it encloses; of a hole negative
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is the unit square in triangles, each of which belongs to a region.
 *
 * The parts of regions are connected through edges of triangles, and numbered in the order of
 * their first triangles.
 */
struct Divided_domain
{
  std::vector<std::array<double, 2>> points;  //!< the vertices
  std::vector<std::array<int, 3>> triangles;  //!< their corners, anticlockwise
  std::vector<int> regions;                   //!< the region of each triangle
  std::vector<int> parts;                     //!< the part of a region that each is in
  //! the edges on contour curves, and those on edges of the square where the polynomial vanishes
  std::vector<std::array<int, 2>> contour_edges;
  std::vector<Region_loop> loops;             //!< the boundaries of the parts, ordered by part

  //! returns the area of a triangle.
  double triangle_area(std::size_t t) const
  {
    const auto &a = points[triangles[t][0]], &b = points[triangles[t][1]],
               &c = points[triangles[t][2]];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }

  //! returns the area of the triangles of a region.
  double area(int region) const
  {
    double sum = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (regions[t] == region)
        sum += triangle_area(t);
    return sum;
  }
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how a domain is to be triangulated.
 */
struct Domain_options
{
  //! the distance of neighbouring vertices in the unit square, about; at most 1
  double edge_length = 0.03;
  //! unresolved boxes up to this width are contracted to a vertex
  double point_width = 1e-6;
  //! the largest number of vertices
  std::size_t max_vertices = 5000000;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_DIVIDED_DOMAIN_H
