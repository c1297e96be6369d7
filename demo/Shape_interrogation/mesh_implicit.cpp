// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes an implicit surface through CGAL's mesher. The slowest file to compile.

#include "mesh_surfaces.h"
#include "evaluate_numbers.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_implicit_surface.h>

namespace interrogate {

si::Result<si::Shape_mesh> mesh_implicit(const Model& model, const Mesh_task& task,
                                         const Show_progress& progress)
{
  const Surface_model& surface = model.surfaces.at(task.surfaces.front());
  const Implicit_model& implicit = std::get<Implicit_model>(surface.data);
  si::Expression_function<3> f(surface.flip ? -implicit.f : implicit.f);
  f.set_variable_names(implicit.variables);
  std::array<std::array<double, 2>, 3> box;
  for (int i = 0; i < 3; ++i)
    box[i] = evaluate<double>((*task.box)[i]);
  si::Implicit_mesh_options options;
  options.edge_length = evaluate<double>(task.edge_length);
  if (task.tolerance)
    options.tolerance = evaluate<double>(*task.tolerance);
  if (task.max_vertices)
    options.max_vertices = *task.max_vertices;
  return si::mesh_implicit_surface(
    si::Implicit_surface_3<si::Expression_function<3>>(f),
    CGAL::Bbox_3(box[0][0], box[1][0], box[2][0], box[0][1], box[1][1], box[2][1]), options,
    progress);
}

} // namespace interrogate
