// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_REFUSED_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_REFUSED_H

// How the parts of a mesher stop it.

#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Thrown through a mesher, and turned into its answer at its gate.
struct Mesh_refused
{
  Refusal refusal;
};

[[noreturn]] inline void refuse_mesh(Refusal_code code, std::string evidence)
{
  throw Mesh_refused{Refusal(code, std::move(evidence))};
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_REFUSED_H
