// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes Bezier and NURBS surfaces together, as exact Bezier patches.

#include "mesh_surfaces.h"
#include "surface_shapes.h"

#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>

namespace interrogate {

namespace {

using Patch = si::Bezier_surface_3<Rational>;

std::vector<Patch> patches_of(const Surface_model& surface)
{
  const Patch_model& model = std::get<Patch_model>(surface.data);
  std::vector<Patch> patches;
  if (model.knots[0].empty())
    patches.push_back(make_bezier<Rational>(model));
  else
    for (const auto& piece : make_nurbs<Rational>(model).bezier_patches())
      patches.push_back(piece.patch);
  if (surface.flip)
    for (Patch& patch : patches)
      patch = patch.transposed();
  return patches;
}

} // namespace

si::Result<si::Shape_mesh> mesh_patches(const Model& model, const Mesh_task& task,
                                        std::vector<std::string>& patch_surfaces,
                                        const Show_progress& progress)
{
  std::vector<Patch> patches;
  for (const std::string& name : task.surfaces)
    for (Patch& patch : patches_of(model.surfaces.at(name)))
    {
      patches.push_back(std::move(patch));
      patch_surfaces.push_back(name);
    }
  si::Patch_mesh_options options;
  options.max_edge_length = evaluate<double>(task.edge_length);
  if (task.tolerance)
    options.tolerance = evaluate<double>(*task.tolerance);
  return si::mesh_patches(patches, options, progress);
}

} // namespace interrogate
