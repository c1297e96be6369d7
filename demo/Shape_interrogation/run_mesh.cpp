// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The task mesh: meshes, writes the file, and reports what the mesher says.

#include "mesh_surfaces.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>

#include <array>
#include <cstddef>
#include <system_error>

namespace interrogate {

namespace {

Report_json distance(double value, bool certified)
{
  return {{"approx", value}, {"certified", certified}};
}

template <std::size_t d>
std::array<double, d> without_signed_zeros(std::array<double, d> numbers)
{
  for (double& x : numbers)
    x += 0.0;
  return numbers;
}

Report_json place_to_json(const si::Refused_place& place,
                          const std::vector<std::string>& surfaces)
{
  Report_json json;
  json["vertex"] = place.vertex;
  json["point"] = without_signed_zeros(place.point);
  if (place.patch >= 0)
  {
    json["surface"] = surfaces[place.patch];
    json["parameters"] = without_signed_zeros(place.parameters);
  }
  json["code"] = si::to_string(place.code);
  json["text"] = place.evidence;
  return json;
}

void store(const si::Mesh_report& report, const std::vector<std::string>& surfaces,
           Task_result& result)
{
  Report_json& json = result.fields;
  json["vertices"] = report.vertices;
  json["faces"] = report.faces;
  json["manifold"] = report.manifold;
  json["boundary_edges"] = report.boundary_edges;
  json["components"] = report.components;
  json["euler_characteristic"] = report.euler_characteristic;
  json["tolerance"] = report.tolerance;
  json["max_vertex_distance"] =
    distance(report.max_vertex_distance, report.vertex_distance_certified);
  json["max_face_distance"] = distance(report.max_face_distance, report.face_distance_certified);
  json["unmeasured_samples"] = report.unmeasured_samples;
  json["refused_places"] = Report_json::array();
  for (const si::Refused_place& place : report.refused_places)
    json["refused_places"].push_back(place_to_json(place, surfaces));
  result.line = std::to_string(report.vertices) + " vertices, " + std::to_string(report.faces) +
                " triangles, at most " + Report_json(report.max_face_distance).dump() +
                (report.face_distance_certified ? " (certified)" : " (at samples)") +
                " from the surface";
  if (!report.refused_places.empty())
    result.line += ", " + std::to_string(report.refused_places.size()) +
                   " vertices without curvature";
}

void colour(const std::string& property, si::Shape_mesh& mesh, Task_result& result)
{
  const double range = si::color_by_property(mesh.surface_mesh, "v:" + property);
  result.fields["colour"] = {{"property", property}, {"range", {{"approx", range}}}};
}

void write(const si::Shape_mesh& mesh, const std::filesystem::path& directory,
           const std::string& file, Task_result& result)
{
  const std::filesystem::path path = directory / file;
  std::error_code ignored; // the writer says what is wrong
  std::filesystem::create_directories(path.parent_path(), ignored);
  std::string reason;
  if (si::write_mesh(path.string(), mesh.surface_mesh, reason))
    result.fields["file"] = file;
  else
  {
    result.status = "error";
    result.code = "output";
    result.text = reason;
  }
}

} // namespace

void run_mesh(const Model& model, const Mesh_task& task, const std::filesystem::path& directory,
              Progress_bar& progress, Task_result& result)
{
  const Show_progress show = [&](std::size_t done, std::size_t total) {
    progress.show(done, total);
    return true;
  };
  const Surface_model& first = model.surfaces.at(task.surfaces.front());
  const bool is_implicit = std::holds_alternative<Implicit_model>(first.data);
  result.number_type = is_implicit ? "double" : "filtered";
  const si::Result<si::Shape_mesh> made =
    is_implicit ? mesh_implicit(model, task, show) : mesh_patches(model, task, show);
  if (!made)
  {
    result.status = "refused";
    result.code = si::to_string(made.refusal().code());
    result.text = made.refusal().evidence();
    return;
  }
  si::Shape_mesh mesh = *made;
  store(mesh.report, task.surfaces, result);
  if (!task.colour.empty())
    colour(task.colour, mesh, result);
  write(mesh, directory, task.file, result);
}

} // namespace interrogate
