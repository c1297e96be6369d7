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
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

namespace interrogate {

namespace {

using Patch = si::Bezier_surface_3<Rational>;
using Ends = std::array<double, 2>;

// The pieces of all surfaces, and where each comes from.
struct Pieces
{
  std::vector<Patch> patches;
  std::vector<bool> flipped;
  std::vector<int> surface;   // its position in the list
  std::vector<Ends> u, v;     // its parameters there
};

Ends rounded(const std::array<Rational, 2>& ends) { return si::cast_argument<double>(ends); }

void add(const Surface_model& surface, int index, Pieces& pieces)
{
  const Patch_model& model = std::get<Patch_model>(surface.data);
  if (model.knots[0].empty())
  {
    pieces.patches.push_back(make_bezier<Rational>(model));
    pieces.u.push_back({0, 1});
    pieces.v.push_back({0, 1});
  }
  else
    for (const auto& piece : make_nurbs<Rational>(model).bezier_patches())
    {
      pieces.patches.push_back(piece.patch);
      pieces.u.push_back(rounded(piece.u));
      pieces.v.push_back(rounded(piece.v));
    }
  pieces.surface.resize(pieces.patches.size(), index);
  pieces.flipped.resize(pieces.patches.size(), surface.flip);
}

double blend(const Ends& ends, double t) { return ends[0] * (1 - t) + ends[1] * t; }

// From pieces to surfaces: the parameters and the numbers of patches.
void rename_patches(const Pieces& pieces, si::Shape_mesh& mesh)
{
  si::Patch_property_maps where(mesh.surface_mesh);
  for (const auto v : mesh.surface_mesh.vertices())
    if (where.vertex_patch[v] >= 0)
    {
      const int piece = where.vertex_patch[v];
      const auto p = where.parameter[v];
      where.parameter[v] = si::Shape_mesh::Point_2(blend(pieces.u[piece], p.x()),
                                                   blend(pieces.v[piece], p.y()));
      where.vertex_patch[v] = pieces.surface[piece];
    }
  for (const auto f : mesh.surface_mesh.faces())
    where.face_patch[f] = pieces.surface[where.face_patch[f]];
  for (si::Refused_place& place : mesh.report.refused_places)
    if (place.patch >= 0)
    {
      place.parameters = {blend(pieces.u[place.patch], place.parameters[0]),
                          blend(pieces.v[place.patch], place.parameters[1])};
      place.patch = pieces.surface[place.patch];
    }
}

} // namespace

si::Result<si::Shape_mesh> mesh_patches(const Model& model, const Mesh_task& task,
                                        const Show_progress& progress)
{
  Pieces pieces;
  for (std::size_t i = 0; i < task.surfaces.size(); ++i)
    try
    {
      add(model.surfaces.at(task.surfaces[i]), static_cast<int>(i), pieces);
    }
    catch (const si::Not_algebraic_error&)
    {
      return si::Refusal(si::Refusal_code::NOT_ALGEBRAIC,
                         "a control point of " + task.surfaces[i] +
                           " has a root: patches are meshed from rational control points only");
    }
  si::Patch_mesh_options options;
  options.max_edge_length = evaluate<double>(task.edge_length);
  if (task.tolerance)
    options.tolerance = evaluate<double>(*task.tolerance);
  if (task.max_vertices)
    options.max_vertices = *task.max_vertices;
  options.flipped = pieces.flipped;
  const si::Result<si::Shape_mesh> mesh = si::mesh_patches(pieces.patches, options, progress);
  if (!mesh)
    return mesh.refusal();
  si::Shape_mesh renamed = *mesh;
  rename_patches(pieces, renamed);
  return renamed;
}

} // namespace interrogate
