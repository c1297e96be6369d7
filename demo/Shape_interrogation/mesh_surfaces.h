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

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>

#include <cstddef>
#include <functional>

namespace interrogate {

namespace si = CGAL::Shape_interrogation;

using Show_progress = std::function<bool(std::size_t done, std::size_t total)>;

// All patches in one mesh. `patch_surfaces` receives the name of the surface of each patch.
si::Result<si::Shape_mesh> mesh_patches(const Model& model, const Mesh_task& task,
                                        std::vector<std::string>& patch_surfaces,
                                        const Show_progress& progress);

} // namespace interrogate

#endif // INTERROGATE_MESH_SURFACES_H
