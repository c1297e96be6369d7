// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads the task line.

#include "read_tasks.h"

#include "make_systems.h"
#include "read_numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace interrogate {

namespace {

const std::vector<std::string> kinds = {"intersection", "section"};
const std::vector<std::string> later_kinds = {"curvature_min", "curvature_max", "isophote",
                                              "silhouette", "ridge", "ravine"};

// Why no line is traced on the surface, or nothing if one is.
std::optional<Unsupported_task> refuse_surface(const Surface_model& surface)
{
  if (const Unsupported* unsupported = std::get_if<Unsupported>(&surface.data))
    return no_kind(unsupported->kind);
  const Patch_model* patch = std::get_if<Patch_model>(&surface.data);
  if (patch && number_of_pieces(*patch) > 1)
    return Unsupported_task{"a line on a spline of several knot spans is not available in this"
                            " version: give its Bezier pieces, one at a time"};
  return std::nullopt;
}

std::vector<double> read_own_start(const Json_place& place, const Surface_model& surface)
{
  const bool has_parameters = std::holds_alternative<Parametric_model>(surface.data) ||
                              std::holds_alternative<Patch_model>(surface.data);
  return has_parameters ? read_start(place, "parameters", parameters_of(surface))
                        : read_start(place, "point", variables_of(surface));
}

// A locator on each surface, or one of the system of both.
void read_starts(const Json_place& place, const std::vector<const Surface_model*>& surfaces,
                 Line_task& task)
{
  if (place.kind() == Json::Kind::ARRAY)
  {
    const std::string what = std::to_string(surfaces.size()) +
                             (surfaces.size() == 1 ? " locator" : " locators, one a surface");
    const std::vector<Json_place> starts = place.elements(surfaces.size(), what);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      task.starts.push_back(read_own_start(starts[i], *surfaces[i]));
  }
  else if (surfaces.size() == 1)
    task.starts.push_back(read_own_start(place, *surfaces[0]));
  else
    task.starts.push_back(
      read_start(place, "point", joint_variables(*surfaces[0], *surfaces[1])));
}

// The plane a x + b y + c z + d = 0, with a normal of length 1.
std::vector<double> read_plane(const Json_place& place)
{
  std::vector<double> plane;
  for (const Json_place& number : place.elements(4, "a plane [a,b,c,d]"))
    plane.push_back(read_double(number));
  if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0)
    place.fail("a plane [a,b,c,d] needs a normal [a,b,c] that is not zero");
  const double largest = (std::max)({std::fabs(plane[0]), std::fabs(plane[1]),
                                     std::fabs(plane[2])});
  for (double& x : plane)
    x /= largest;
  const double length = std::hypot(plane[0], plane[1], plane[2]);
  for (double& x : plane)
    x /= length;
  if (!std::isfinite(plane[3]))
    place.fail("the plane is too far away for floating point");
  return plane;
}

// The condition of a section: a plane, or a variable with its value.
void read_section(const Json_place& place, const Surface_model& surface, Line_task& task)
{
  const std::optional<Json_place> fixed = place.find("fixed");
  if (!fixed)
  {
    task.condition = read_plane(place.field("plane"));
    task.value = -task.condition.back();
    task.condition.pop_back();
    return;
  }
  if (place.find("plane"))
    place.fail("there are both \"plane\" and \"fixed\": give one of them");
  const std::vector<std::string> variables = variables_of(surface);
  const auto fields = fixed->fields("an object {variable: number}");
  if (fields.size() != 1)
    fixed->expected("one variable with its value");
  const auto& [name, value] = fields.front();
  const auto at = std::find(variables.begin(), variables.end(), name);
  if (at == variables.end())
    value.fail("there is no variable of this name, the variables are: " + listed(variables));
  task.condition.resize(variables.size());
  task.condition[at - variables.begin()] = 1;
  task.value = read_double(value);
}

void read_size(const Json_place& place, Line_task& task)
{
  task.step = read_length(place.field("step"));
  if (const std::optional<Json_place> box = place.find("box"))
    task.box = read_box(*box);
  if (const std::optional<Json_place> most = place.find("max_points"))
    task.max_points = read_integer(*most, 1, 100000000);
  if (const std::optional<Json_place> file = place.find("file"))
    task.file = read_file_name(*file, {".vtp", ".ply", ".obj"});
}

} // namespace

Task_data read_line(const Json_place& place, const Model& model)
{
  const std::string& kind = place.field("kind").string("the kind of the line, a string");
  if (std::find(later_kinds.begin(), later_kinds.end(), kind) != later_kinds.end())
    return Unsupported_task{"the task \"line\" of the kind \"" + kind +
                            "\" is not available in this version"};
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    place.field("kind").expected("the kind of a line (" + listed(kinds) +
                                 "; not in this version: " + listed(later_kinds) + ")");
  if (place.find("curve"))
    return Unsupported_task{"lines of planar curves are not available in this version"};
  std::vector<std::string> fields{"kind", "surface", "surfaces", "start", "step", "box",
                                  "max_points", "file"};
  if (kind == "section")
    fields.insert(fields.end(), {"plane", "fixed"});
  allow_task_fields(place, fields);
  const std::vector<Json_place> names = read_surface_names(place);
  const std::size_t most = kind == "section" ? 1 : 2;
  if (names.size() > most)
    place.field("surfaces").expected(most == 1 ? "one surface for a section"
                                               : "one surface or two for an intersection");
  const std::optional<Json_place> type = place.find("number_type");
  if (type && type->string("") != "double")
    return Unsupported_task{"a line in the number type \"" + type->string("") +
                            "\" is not available in this version: it is made in \"double\""};
  Line_task task;
  std::vector<const Surface_model*> surfaces;
  for (const Json_place& name : names)
  {
    surfaces.push_back(&read_name(name, model.surfaces, "surface"));
    if (const auto refused = refuse_surface(*surfaces.back()))
      return *refused;
    task.surfaces.push_back(name.string(""));
  }
  if (kind == "section")
    read_section(place, *surfaces[0], task);
  read_starts(place.field("start"), surfaces, task);
  read_size(place, task);
  return task;
}

} // namespace interrogate
