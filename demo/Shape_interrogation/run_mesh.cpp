// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The task mesh: meshes, writes the file, and reports what the mesher says.

#include "evaluate_numbers.h"
#include "mesh_surfaces.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/IO/write_polylines.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>

#include <algorithm>
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

Report_json polylines_to_json(const std::vector<si::N_space_polyline>& lines)
{
  Report_json json = Report_json::array();
  for (const si::N_space_polyline& line : lines)
  {
    json.push_back({{"closed", line.closed}, {"points", Report_json::array()}});
    for (const std::vector<double>& p : line.points)
      json.back()["points"].push_back(without_signed_zeros(first<3>(p)));
  }
  return json;
}

// The first of them: where one is, there are often many around it.
Report_json stops_to_json(const std::vector<si::N_space_stop>& stops)
{
  const std::size_t most = 10;
  Report_json json{{"number", stops.size()}, {"first", Report_json::array()}};
  for (std::size_t i = 0; i < (std::min)(stops.size(), most); ++i)
    json["first"].push_back({{"point", without_signed_zeros(first<3>(stops[i].point))},
                             {"code", si::to_string(stops[i].code)},
                             {"text", stops[i].evidence}});
  return json;
}

void store(const si::N_space_mesh& mesh, const std::vector<std::string>& surfaces,
           Task_result& result)
{
  store(mesh.report, surfaces, result);
  result.fields.erase("tolerance"); // there is none
  result.fields["max_residual"] = distance(mesh.max_residual, false);
  result.fields["max_turning"] = distance(mesh.max_turning, false);
  result.fields["folds"] = polylines_to_json(mesh.folds);
  result.fields["rims"] = polylines_to_json(mesh.rims);
  result.fields["stops"] = stops_to_json(mesh.stops);
  if (!mesh.folds.empty())
    result.line += ", folded along " + std::to_string(mesh.folds.size()) +
                   (mesh.folds.size() == 1 ? " curve" : " curves");
  if (!mesh.stops.empty())
    result.line += ", could not be followed at " + std::to_string(mesh.stops.size()) + " vertices";
}

void write(const Mesh_task& task, const std::filesystem::path& directory, si::Shape_mesh& mesh,
           Task_result& result)
{
  if (!task.colour.empty())
    colour(task.colour, mesh, result);
  std::string reason;
  si::write_mesh(path_of(directory, task.file), mesh.surface_mesh, reason);
  store_file("file", task.file, reason, result);
}

void run_system_mesh(const Model& model, const Mesh_task& task,
                     const std::filesystem::path& directory, const Show_progress& show,
                     Task_result& result)
{
  result.number_type = "double";
  const si::Result<si::N_space_mesh> made = mesh_system(model, task, show);
  if (!made)
    return refuse(made.refusal(), result);
  si::N_space_mesh mesh = *made;
  store(mesh, task.surfaces, result);
  write(task, directory, mesh, result);
  if (task.folds_file.empty())
    return;
  const auto& system = std::get<System_model>(model.surfaces.at(task.surfaces.front()).data);
  std::string reason;
  si::write_polylines(path_of(directory, task.folds_file), mesh.folds, system.variables, reason);
  store_file("folds_file", task.folds_file, reason, result);
}

} // namespace

std::string path_of(const std::filesystem::path& directory, const std::string& file)
{
  const std::filesystem::path path = directory / file;
  std::error_code ignored; // the writer says what is wrong
  std::filesystem::create_directories(path.parent_path(), ignored);
  return path.string();
}

void store_file(const char* field, const std::string& file, const std::string& reason,
                Task_result& result)
{
  if (reason.empty())
  {
    result.fields[field] = file;
    return;
  }
  result.status = "error";
  result.code = "output";
  result.text = reason;
}

void run_mesh(const Model& model, const Mesh_task& task, const std::filesystem::path& directory,
              Progress_bar& progress, Task_result& result)
{
  const Show_progress show = [&](std::size_t done, std::size_t total) {
    progress.show(done, total);
    return true;
  };
  const Surface_model& first = model.surfaces.at(task.surfaces.front());
  if (std::holds_alternative<System_model>(first.data))
    return run_system_mesh(model, task, directory, show, result);
  const bool is_implicit = std::holds_alternative<Implicit_model>(first.data);
  result.number_type = is_implicit ? "double" : "filtered";
  const si::Result<si::Shape_mesh> made =
    is_implicit ? mesh_implicit(model, task, show) : mesh_patches(model, task, show);
  if (!made)
    return refuse(made.refusal(), result);
  si::Shape_mesh mesh = *made;
  store(mesh.report, task.surfaces, result);
  write(task, directory, mesh, result);
}

} // namespace interrogate
