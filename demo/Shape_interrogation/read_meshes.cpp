// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads a mesh task, and the fields that lines have, too.

#include "read_tasks.h"

#include "read_numbers.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace interrogate {

std::string read_file_name(const Json_place& place, const std::vector<std::string>& extensions)
{
  std::string known;
  for (std::size_t i = 0; i < extensions.size(); ++i)
    known += (i == 0 ? "" : i + 1 < extensions.size() ? ", " : " or ") + extensions[i];
  const std::string& name = place.string("the name of a file (" + known + ")");
  const std::filesystem::path path(name);
  if (std::find(extensions.begin(), extensions.end(), path.extension().string()) ==
      extensions.end())
    place.expected("the name of a file that ends in " + known);
  const bool leaves = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.is_absolute() || leaves || name.find('\0') != std::string::npos)
    place.expected("a file name relative to the directory of the report, without \"..\"");
  return name;
}

std::vector<Json_place> read_surface_names(const Json_place& place)
{
  const std::optional<Json_place> list = place.find("surfaces");
  if (!list)
    return {place.field("surface")};
  if (place.find("surface"))
    place.fail("there are both \"surface\" and \"surfaces\": give one of them");
  const std::vector<Json_place> names = list->elements("an array of names of surfaces");
  if (names.empty())
    list->expected("the name of one surface or more");
  return names;
}

std::array<Range, 3> read_box(const Json_place& place)
{
  const std::vector<Json_place> ranges = place.elements(3, "[[x0,x1],[y0,y1],[z0,z1]]");
  for (const Json_place& range : ranges)
    for (const Json_place& end : range.elements(2, "a range [lo,hi]"))
      read_double(end);
  return {read_range(ranges[0]), read_range(ranges[1]), read_range(ranges[2])};
}

std::vector<double> read_start(const Json_place& place, const std::string& field,
                               const std::vector<std::string>& names)
{
  place.allow_only({field});
  const Json_place numbers = place.field(field);
  std::vector<double> point;
  if (numbers.kind() == Json::Kind::OBJECT)
  {
    numbers.allow_only(names);
    for (const std::string& name : names)
      point.push_back(read_double(numbers.field(name)));
    return point;
  }
  const std::string what =
    "an array of " + std::to_string(names.size()) + " numbers (" + listed(names) + ")";
  for (const Json_place& number : numbers.elements(names.size(), what))
    point.push_back(read_double(number));
  return point;
}

namespace {

// Why this version does not mesh the surface, or nothing if it does.
std::optional<Unsupported_task> refuse_mesh(const Surface_model& surface, bool is_alone,
                                            bool has_box)
{
  if (const Unsupported* unsupported = std::get_if<Unsupported>(&surface.data))
    return no_kind(unsupported->kind);
  if (std::holds_alternative<System_model>(surface.data))
  {
    if (!is_alone)
      return Unsupported_task{"a system is meshed alone: \"surfaces\" are patches"};
    return std::nullopt;
  }
  if (std::holds_alternative<Parametric_model>(surface.data))
    return Unsupported_task{"the meshing of the kind \"parametric\" is not available in this"
                            " version: give the surface as \"bezier\", \"nurbs\" or \"implicit\""};
  const bool is_implicit = std::holds_alternative<Implicit_model>(surface.data);
  if (is_implicit && !has_box)
    return Unsupported_task{"the meshing of an implicit surface without \"box\" is not available in"
                            " this version"};
  if (!is_implicit && has_box)
    return Unsupported_task{"\"box\" for the meshing of patches is not available in this version"};
  if (!is_alone && is_implicit)
    return Unsupported_task{"an implicit surface is meshed alone: \"surfaces\" are patches"};
  return std::nullopt;
}

// The vertex property that colours are given for.
std::string read_colour(const Json_place& place, const std::string& file)
{
  const std::vector<std::string> known = {"gaussian_curvature", "mean_curvature", "kmin", "kmax"};
  const std::string& name = place.string("the name of a curvature (" + listed(known) + ")");
  if (std::find(known.begin(), known.end(), name) == known.end())
    place.expected("the name of a curvature (" + listed(known) + ")");
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".ply" && extension != ".vtp")
    place.fail("a file " + extension + " has no colours: give a name that ends in .ply or .vtp");
  return name;
}

// Each mesher has one way to calculate, which a task may name.
std::optional<Unsupported_task> refuse_number_type(const Json_place& place,
                                                   const Surface_model& surface)
{
  const bool is_implicit = std::holds_alternative<Implicit_model>(surface.data);
  const bool is_system = std::holds_alternative<System_model>(surface.data);
  const std::string own = is_implicit || is_system ? "double" : "filtered";
  const std::optional<Json_place> type = place.find("number_type");
  if (!type || type->string("") == own)
    return std::nullopt;
  return Unsupported_task{std::string("the mesh of ") +
                          (is_system ? "a system" : is_implicit ? "an implicit surface"
                                                                : "patches") +
                          " in the number type \"" + type->string("") +
                          "\" is not available in this version: it is made in \"" + own + "\""};
}

// One locator, or several.
std::vector<std::vector<double>> read_starts(const Json_place& place, const System_model& system)
{
  if (place.kind() != Json::Kind::ARRAY)
    return {read_start(place, "point", system.variables)};
  std::vector<std::vector<double>> starts;
  for (const Json_place& start : place.elements("a locator or an array of locators"))
    starts.push_back(read_start(start, "point", system.variables));
  if (starts.empty())
    place.expected("one locator or more");
  return starts;
}

// Whether the three variables of space have bounds, in which start points can be looked for.
bool is_bounded_in_space(const System_model& system)
{
  int bounded = 0;
  for (const si::N_space_bound& bound : system.bounds)
    bounded += bound.variable < 3;
  return bounded == 3;
}

// What only some of the meshers take.
std::optional<Unsupported_task> read_rest(const Json_place& place, const Surface_model& surface,
                                          Mesh_task& task)
{
  const std::optional<Json_place> start = place.find("start");
  const System_model* system = std::get_if<System_model>(&surface.data);
  if (!system)
  {
    if (start)
      return Unsupported_task{"\"start\" for the mesh of a surface that is no system is not"
                              " available in this version"};
    if (place.find("folds_file"))
      place.field("folds_file").fail("only the mesh of a system has folds");
    return std::nullopt;
  }
  if (place.find("tolerance"))
    return Unsupported_task{"\"tolerance\" for the mesh of a system is not available in this"
                            " version: its edges are as short as \"edge_length\" says"};
  if (start)
    task.starts = read_starts(*start, *system);
  else if (!task.box && !is_bounded_in_space(*system))
    place.fail("a system is meshed from \"start\", or in a \"box\" where start points are looked"
               " for");
  if (const std::optional<Json_place> folds = place.find("folds_file"))
    task.folds_file = read_file_name(*folds, {".vtp", ".ply", ".obj"});
  return std::nullopt;
}

} // namespace

Task_data read_mesh(const Json_place& place, const Model& model)
{
  allow_task_fields(place, {"surface", "surfaces", "curve", "file", "edge_length", "tolerance",
                            "box", "start", "max_vertices", "colour", "folds_file"});
  if (place.find("curve"))
    return Unsupported_task{"the meshing of curves is not available in this version"};
  Mesh_task task;
  task.file = read_file_name(place.field("file"), {".ply", ".off", ".vtp", ".obj"});
  task.edge_length = read_length(place.field("edge_length"));
  if (const std::optional<Json_place> tolerance = place.find("tolerance"))
    task.tolerance = read_length(*tolerance);
  if (const std::optional<Json_place> box = place.find("box"))
    task.box = read_box(*box);
  if (const std::optional<Json_place> most = place.find("max_vertices"))
    task.max_vertices = read_integer(*most, 3, 100000000);
  if (const std::optional<Json_place> colour = place.find("colour"))
    task.colour = read_colour(*colour, task.file);
  const std::vector<Json_place> names = read_surface_names(place);
  for (const Json_place& name : names)
  {
    const Surface_model& surface = read_name(name, model.surfaces, "surface");
    if (const auto refused = refuse_mesh(surface, names.size() == 1, task.box.has_value()))
      return *refused;
    if (const auto refused = refuse_number_type(place, surface))
      return *refused;
    if (const auto refused = read_rest(place, surface, task))
      return *refused;
    task.surfaces.push_back(name.string(""));
  }
  return task;
}

} // namespace interrogate
