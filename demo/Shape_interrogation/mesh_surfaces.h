// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_MESH_SURFACES_H
#define INTERROGATE_MESH_SURFACES_H

// The meshers of the library for the surfaces of a model. Each is slow to compile and has a file of
// its own.

#include "Model.h"

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>

#include <cstddef>
#include <functional>

namespace interrogate {

namespace si = CGAL::Shape_interrogation;

using Show_progress = std::function<bool(std::size_t done, std::size_t total)>;

// All patches in one mesh. Patch numbers are positions in the task's list of surfaces, parameters
// those of the surface.
si::Result<si::Shape_mesh> mesh_patches(const Model& model, const Mesh_task& task,
                                        const Show_progress& progress);

// The part of an implicit surface in the box of the task.
si::Result<si::Shape_mesh> mesh_implicit(const Model& model, const Mesh_task& task,
                                         const Show_progress& progress);

// The projection of a system, with its auxiliary variables as properties of the vertices.
si::Result<si::N_space_mesh> mesh_system(const Model& model, const Mesh_task& task,
                                         const Show_progress& progress);

} // namespace interrogate

#endif // INTERROGATE_MESH_SURFACES_H
