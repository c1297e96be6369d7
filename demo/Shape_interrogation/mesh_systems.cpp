// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes the projection of a system in n-space.

#include "mesh_surfaces.h"

#include "evaluate_numbers.h"
#include "make_systems.h"

#include <CGAL/Shape_interrogation/Meshing/mesh_n_space_surface.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace interrogate {

namespace {

using Surface_mesh = si::Shape_mesh::Surface_mesh;

// The opposite normal, and with it the opposite signs of curvatures.
void flip(si::Shape_property_maps& maps, Surface_mesh::Vertex_index v)
{
  maps.normal[v] = -maps.normal[v];
  maps.mean_curvature[v] = 0 - maps.mean_curvature[v];
  maps.kmin[v] = 0 - maps.kmin[v];
  maps.kmax[v] = 0 - maps.kmax[v];
  std::swap(maps.kmin[v], maps.kmax[v]);
  std::swap(maps.direction_min[v], maps.direction_max[v]);
}

// Each component gets the side that has mostly a positive product with the orientation, if there
// is one, or the other one for a flipped surface.
void orient(const Surface_model& surface, Surface_mesh& mesh)
{
  using Face = Surface_mesh::Face_index;
  auto component = mesh.add_property_map<Face, std::size_t>("f:component", 0).first;
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  const auto component_of = [&](Surface_mesh::Vertex_index v) {
    if (!mesh.is_isolated(v))
      for (const Face f : mesh.faces_around_target(mesh.halfedge(v)))
        if (mesh.is_valid(f))
          return component[f];
    return n; // of no triangle
  };
  si::Shape_property_maps maps(mesh);
  std::vector<double> product(n + 1, 0.);
  if (surface.orient)
  {
    const auto d = si::cast_argument<double>(*surface.orient);
    for (const auto v : mesh.vertices())
      product[component_of(v)] += maps.normal[v] * si::Shape_mesh::Vector_3(d[0], d[1], d[2]);
  }
  const auto is_turned = [&](std::size_t c) { return (product[c] < 0) != surface.flip; };
  for (const auto v : mesh.vertices())
    if (is_turned(component_of(v)))
      flip(maps, v);
  std::vector<Face> turned;
  for (const Face f : mesh.faces())
    if (is_turned(component[f]))
      turned.push_back(f);
  CGAL::Polygon_mesh_processing::reverse_face_orientations(turned, mesh);
  mesh.remove_property_map(component);
}

// The names that a file has for its own columns.
std::set<std::string> taken_names(const Surface_mesh& mesh)
{
  std::set<std::string> taken{"x", "y", "z", "nx", "ny", "nz", "u", "v", "red", "green", "blue",
                              "color", "parameter", "vertex_indices"};
  for (const std::string& name : mesh.properties<Surface_mesh::Vertex_index>())
  {
    const std::string own = name.substr(name.find(':') + 1);
    taken.insert({own, own + "_x", own + "_y", own + "_z"});
  }
  return taken;
}

// A name that is taken gets underscores in front.
void add_variables(const std::vector<std::string>& variables, Surface_mesh& mesh)
{
  using Vertex = Surface_mesh::Vertex_index;
  std::set<std::string> taken = taken_names(mesh);
  const si::N_space_property_maps maps(mesh);
  for (std::size_t i = 3; i < variables.size(); ++i)
  {
    std::string name = variables[i];
    while (!taken.insert(name).second)
      name = "_" + name;
    auto map = mesh.add_property_map<Vertex, double>("v:" + name, 0.).first;
    for (const Vertex v : mesh.vertices())
      map[v] = maps.n_space_point[v][i];
  }
}

} // namespace

si::Result<si::N_space_mesh> mesh_system(const Model& model, const Mesh_task& task,
                                         const Show_progress& progress)
{
  const Surface_model& surface = model.surfaces.at(task.surfaces.front());
  Bounded_system made = make_system(surface);
  if (task.box)
    add_box(*task.box, made.bounds);
  si::N_space_mesh_options options;
  options.edge_length = evaluate<double>(task.edge_length);
  options.bounds = made.bounds;
  if (task.starts.empty())
    options.search_box = made.bounds;
  if (task.max_vertices)
    options.max_vertices = *task.max_vertices;
  const si::Result<si::N_space_mesh> result =
    si::mesh_n_space_surface(made.system, task.starts, options, progress);
  if (!result)
    return result;
  si::N_space_mesh mesh = *result;
  if (surface.flip || surface.orient)
    orient(surface, mesh.surface_mesh);
  add_variables(made.system.variables(), mesh.surface_mesh);
  return mesh;
}

} // namespace interrogate
