// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads a task and checks it against the surface or curve that it asks about.

#include "read_tasks.h"

#include "Model_error.h"
#include "read_model.h"
#include "read_numbers.h"

#include <algorithm>

namespace interrogate {

namespace {

const std::vector<std::string> task_kinds = {"curvature", "shape_operator", "mesh",
                                             "line", "property", "bound"};
const std::vector<std::string> later_task_kinds = {
  "normalform", "foot_point", "intersection_curvature", "contact", "continuity", "audit",
  "contour", "trichotomy", "umbilics"};

const std::vector<std::string> number_types = {"exact", "interval", "double", "filtered"};

// What a locator must hold: the field, the number of coordinates, and the names of the variables
// where there are more than those of space.
struct Place_form
{
  const char* field;
  std::size_t size;
  const std::vector<std::string>* names = nullptr;
};

Place_form form_of(const Implicit_model& m) { return {"point", m.variables.size()}; }
Place_form form_of(const Parametric_model& m) { return {"parameters", m.parameters.size()}; }
Place_form form_of(const Patch_model&) { return {"parameters", 2}; }
Place_form form_of(const Spline_model&) { return {"parameters", 1}; }
Place_form form_of(const System_model& m)
{
  return {"point", m.variables.size(), &m.variables};
}
Place_form form_of(const Space_curve_model&) { return {"", 0}; }
Place_form form_of(const Unsupported&) { return {"", 0}; }

std::vector<Number> read_locator(const Json_place& place, const Place_form& form)
{
  place.allow_only({form.field, "enclose"});
  const std::string what = "an array of " + std::to_string(form.size) +
                           (form.size == 1 ? " number" : " numbers");
  const Json_place numbers = place.field(form.field);
  if (!form.names)
    return read_numbers(numbers, form.size, what);
  if (numbers.kind() != Json::Kind::OBJECT)
    return read_numbers(numbers, form.size, what + " (" + listed(*form.names) + ")");
  numbers.allow_only(*form.names);
  std::vector<Number> point;
  for (const std::string& name : *form.names)
    point.push_back(read_number(numbers.field(name)));
  return point;
}

// Whether the locator asks for the proved point nearby. Parameters always give a point.
bool asks_for_enclosure(const Json_place& at, const Place_form& form)
{
  const std::optional<Json_place> enclose = at.find("enclose");
  if (!enclose || !enclose->boolean())
    return false;
  if (form.field != std::string("point"))
    enclose->fail("a place with parameters is on the surface or curve: \"enclose\" is for points of"
                  " a system or an implicit surface");
  return true;
}

std::vector<Number> read_direction(const Json_place& place, std::size_t n)
{
  const std::string what = n == 3 ? "a vector of 3 numbers"
                                  : "a vector of 3 or " + std::to_string(n) + " numbers";
  const std::size_t size = place.elements(what).size();
  if (size != 3 && size != n)
    place.expected(what);
  return read_numbers(place, size, what);
}

Task_data read_surface_curvature(const Json_place& place, const Model& model)
{
  allow_task_fields(place, {"surface", "at", "direction"});
  const Json_place name = place.field("surface");
  const Surface_model& surface = read_name(name, model.surfaces, "surface");
  if (const Unsupported* unsupported = std::get_if<Unsupported>(&surface.data))
    return no_kind(unsupported->kind);
  const Json_place at = place.field("at");
  const Place_form form = std::visit([](const auto& m) { return form_of(m); }, surface.data);
  const System_model* system = std::get_if<System_model>(&surface.data);
  Curvature_task task;
  task.surface = name.string("");
  task.at = read_locator(at, form);
  task.enclose = asks_for_enclosure(at, form);
  if (const std::optional<Json_place> direction = place.find("direction"))
    task.direction = read_direction(*direction, system ? system->variables.size() : 3);
  return task;
}

Task_data read_curve_curvature(const Json_place& place, const Model& model)
{
  allow_task_fields(place, {"curve", "at"});
  const Json_place name = place.field("curve");
  const Curve_model& curve = read_name(name, model.curves, "curve");
  if (const Unsupported* unsupported = std::get_if<Unsupported>(&curve))
    return no_kind(unsupported->kind);
  if (const Space_curve_model* in_space = std::get_if<Space_curve_model>(&curve))
    return Unsupported_task{"the curvature of curves in space (" + in_space->kind +
                            ") is not available in this version"};
  const Json_place at = place.field("at");
  const Place_form form = std::visit([](const auto& m) { return form_of(m); }, curve);
  Curvature_task task;
  task.curve = name.string("");
  task.at = read_locator(at, form);
  if (asks_for_enclosure(at, form))
    return Unsupported_task{"\"enclose\" for the kind \"implicit_2\" is not available in this"
                            " version: it is for surfaces"};
  return task;
}

Task_data read_shape_operator(const Json_place& place)
{
  allow_task_fields(place, {"normal", "directions", "curvatures"});
  Shape_operator_task task;
  task.normal = read_point<3>(place.field("normal"), "a vector of 3 numbers");
  const std::vector<Json_place> directions =
    place.field("directions").elements(3, "three tangent vectors");
  for (int i = 0; i < 3; ++i)
    task.directions[i] = read_point<3>(directions[i], "a vector of 3 numbers");
  task.curvatures = read_point<3>(place.field("curvatures"), "three normal curvatures");
  return task;
}

Task_data read_data(const Json_place& place, const std::string& kind, const Model& model)
{
  if (std::find(later_task_kinds.begin(), later_task_kinds.end(), kind) != later_task_kinds.end())
    return Unsupported_task{"the task \"" + kind + "\" is not available in this version"};
  if (kind == "curvature")
    return place.find("curve") ? read_curve_curvature(place, model)
                               : read_surface_curvature(place, model);
  if (kind == "shape_operator")
    return read_shape_operator(place);
  if (kind == "mesh")
    return read_mesh(place, model);
  if (kind == "line")
    return read_line(place, model);
  if (kind == "property" || kind == "bound")
    return read_property(place, model, kind);
  place.field("task").expected("the kind of a task (" + listed(task_kinds) +
                               "; not in this version: " + listed(later_task_kinds) + ")");
}

} // namespace

void allow_task_fields(const Json_place& place, std::vector<std::string> fields)
{
  fields.insert(fields.begin(), {"task", "id", "number_type"});
  place.allow_only(fields);
}

Unsupported_task no_kind(const std::string& kind)
{
  return Unsupported_task{"the kind \"" + kind + "\" is not available in this version"};
}

Task read_task(const Json_place& place, const Model& model)
{
  Task task;
  task.kind = place.field("task").string("the kind of the task, a string");
  if (const std::optional<Json_place> id = place.find("id"))
  {
    task.id = id->string("a text that names the task");
    if (task.id.empty())
      id->fail("the name of the task is empty");
  }
  if (const std::optional<Json_place> type = place.find("number_type"))
  {
    task.number_type = number_type_of(type->string("the name of a number type"));
    if (!task.number_type)
      type->expected("a number type (" + listed(number_types) + ")");
  }
  task.data = read_data(place, task.kind, model);
  return task;
}

std::optional<Number_type> number_type_of(const std::string& name)
{
  const auto at = std::find(number_types.begin(), number_types.end(), name);
  if (at == number_types.end())
    return std::nullopt;
  return static_cast<Number_type>(at - number_types.begin());
}

const char* name_of(Number_type type)
{
  return number_types[static_cast<std::size_t>(type)].c_str();
}

} // namespace interrogate
