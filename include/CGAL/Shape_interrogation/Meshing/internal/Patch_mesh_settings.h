// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H

// What all parts of the mesher of patches need to know, and how they stop it.

#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Thrown through the mesher, and turned into its answer at its gate.
struct Mesh_refused
{
  Refusal refusal;
};

[[noreturn]] inline void refuse_mesh(Refusal_code code, std::string evidence)
{
  throw Mesh_refused{Refusal(code, std::move(evidence))};
}

struct Patch_mesh_settings
{
  double tolerance;        // of the result
  double face_target;      // of a triangle before its corners are rounded
  double max_edge_length;  // infinite if off
  double min_cosine;       // between normals, or tangents of edge curves; -1 if off
  std::size_t max_vertices;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESH_SETTINGS_H
