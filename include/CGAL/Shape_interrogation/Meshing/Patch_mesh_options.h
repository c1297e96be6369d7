// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_PATCH_MESH_OPTIONS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_PATCH_MESH_OPTIONS_H

// How fine a mesh of patches must be.

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how fine a mesh of patches must be.
 */
struct Patch_mesh_options
{
  //! largest distance of the mesh from the patches; 0 stands for a thousandth of the largest side
  //! of the box around all control points
  double tolerance = 0;
  //! largest length of an edge; 0 stands for no bound
  double max_edge_length = 0;
  //! largest angle in degrees between the normals at the ends of an edge, on the boundary of a
  //! patch between the tangents of the boundary; it does not divide edges shorter than the
  //! tolerance; 0 stands for no bound
  double max_angle = 20;
  //! largest number of vertices
  std::size_t max_vertices = 5000000;
  //! patches whose normal and orientation are reversed; may be shorter than the list of patches
  std::vector<bool> flipped = {};
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_PATCH_MESH_OPTIONS_H
