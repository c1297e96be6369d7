// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H

// What all parts of the mesher of patches need to know.

#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>

#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Patch_mesh_settings
{
  double tolerance;        // of the result
  double face_target;      // of a triangle before its corners are rounded
  double max_edge_length;  // infinite if off
  double min_cosine;       // between normals, or tangents of edge curves; below -1 if off
  std::size_t max_vertices;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H
