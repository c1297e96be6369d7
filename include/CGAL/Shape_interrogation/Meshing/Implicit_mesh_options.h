// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_IMPLICIT_MESH_OPTIONS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_IMPLICIT_MESH_OPTIONS_H

// How fine a mesh of an implicit surface must be.

#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how fine a mesh of an implicit surface must be.
 */
struct Implicit_mesh_options
{
  //! largest length of an edge; 0 stands for a twentieth of the largest side of the box
  double edge_length = 0;
  //! distance of the mesh from the surface that is aimed at; 0 stands for a thousandth of the
  //! largest side of the box
  double tolerance = 0;
  //! smallest angle of a triangle in degrees that is aimed at, at most 30
  double min_angle = 25;
  //! the surface is looked for on a grid with so many cells along each side of the box
  int seed_cells = 24;
  //! largest number of vertices that the refinement may need
  std::size_t max_vertices = 200000;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_IMPLICIT_MESH_OPTIONS_H
