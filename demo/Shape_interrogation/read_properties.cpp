// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads the tasks property, bound, contour and trichotomy.

#include "read_tasks.h"

#include "read_numbers.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace interrogate {

namespace {

using Property = si::Property;

std::string all_properties()
{
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(Property::CURVATURE_V); ++i)
    names.push_back(si::to_string(static_cast<Property>(i)));
  return listed(names);
}

Property read_name_of_property(const Json_place& place)
{
  const auto property = si::property_of_name(place.string("the name of a property"));
  if (!property)
    place.expected("the name of a property (" + all_properties() + ")");
  return *property;
}

Numbers<3> read_direction_3(const Json_place& place)
{
  const Numbers<3> direction = read_point<3>(place, "a direction of 3 numbers");
  bool is_zero = true;
  for (const Number& x : direction)
    is_zero = is_zero && x.is_constant() && CGAL::is_zero(x.constant());
  if (is_zero)
    place.fail("the direction is zero");
  return direction;
}

// What the property needs besides the surface.
void read_inputs(const Json_place& place, Property_task& task)
{
  task.up = task.view = task.light = {Number(0), Number(0), Number(1)};
  task.level = Number(0);
  if (const auto up = place.find("up"))
    task.up = read_direction_3(*up);
  if (task.property == Property::SILHOUETTE)
  {
    const auto eye = place.find("eye");
    if (eye && place.find("view"))
      place.fail("there are both \"view\" and \"eye\": give one of them");
    if (eye)
      task.eye = read_point<3>(*eye, "a point of 3 numbers");
    else
      task.view = read_direction_3(place.field("view"));
  }
  if (task.property == Property::ISOPHOTE)
    task.light = read_direction_3(place.field("light"));
  if (const auto level = place.find("level"))
    task.level = read_number(*level);
}

std::vector<std::string> fields_of(Property property, const std::string& kind)
{
  std::vector<std::string> fields{"surface", "property"};
  if (kind == "property")
    fields.insert(fields.end(), {"at", "file"});
  else if (kind == "bound")
    fields.insert(fields.end(), {"at_most", "at_least"});
  if (property == Property::SLOPE)
    fields.push_back("up");
  if (property == Property::SILHOUETTE)
    fields.insert(fields.end(), {"view", "eye"});
  if (property == Property::ISOPHOTE)
    fields.insert(fields.end(), {"light", "level"});
  return fields;
}

void read_bound(const Json_place& place, Property_task& task)
{
  const auto most = place.find("at_most"), least = place.find("at_least");
  if (most && least)
    place.fail("there are both \"at_most\" and \"at_least\": give one of them");
  task.is_upper = !least;
  task.bound = read_number(least ? *least : place.field("at_most"));
}

bool has_domain(const Surface_model& surface)
{
  const auto* parametric = std::get_if<Parametric_model>(&surface.data);
  return !parametric || parametric->domain;
}

// Why the task is not for the surface, if it is not.
std::optional<Unsupported_task> not_for(const Surface_model& surface, const std::string& kind)
{
  if (const auto* unsupported = std::get_if<Unsupported>(&surface.data))
    return no_kind(unsupported->kind);
  if (!std::holds_alternative<Parametric_model>(surface.data) &&
      !std::holds_alternative<Patch_model>(surface.data))
    return Unsupported_task{"the task \"" + kind + "\" for the kind \"" + surface.kind +
                            "\" is not available: it is for surfaces with parameters"};
  return std::nullopt;
}

void need_domain(const Json_place& name, const Surface_model& surface)
{
  if (!has_domain(surface))
    name.fail("the task is about the whole surface, which needs a \"domain\"");
}

} // namespace

Task_data read_property(const Json_place& place, const Model& model, const std::string& kind)
{
  Property_task task;
  task.property = read_name_of_property(place.field("property"));
  allow_task_fields(place, fields_of(task.property, kind));
  const Json_place name = place.field("surface");
  const Surface_model& surface = read_name(name, model.surfaces, "surface");
  if (auto unsupported = not_for(surface, kind))
    return *unsupported;
  task.surface = name.string("");
  read_inputs(place, task);
  if (kind == "bound")
    read_bound(place, task);
  if (const auto at = place.find("at"))
  {
    at->allow_only({"parameters"});
    task.at = read_numbers(at->field("parameters"), 2, "an array of 2 numbers");
  }
  else
    need_domain(name, surface);
  if (const auto file = place.find("file"))
    task.file = read_file_name(*file, {".json"});
  return task;
}

Task_data read_contour(const Json_place& place, const Model& model)
{
  Contour_task task;
  const auto plane = place.find("plane");
  if (plane)
  {
    allow_task_fields(place, {"surface", "plane"});
    task.plane = read_numbers(*plane, 4, "the 4 coefficients of a plane");
    const auto is_zero = [](const Number& x) {
      return x.is_constant() && CGAL::is_zero(x.constant());
    };
    if (std::all_of(task.plane->begin(), task.plane->begin() + 3, is_zero))
      plane->fail("the normal of the plane is zero");
  }
  else
  {
    task.property.property = read_name_of_property(place.field("property"));
    std::vector<std::string> fields = fields_of(task.property.property, "contour");
    fields.push_back("level");
    allow_task_fields(place, fields);
    read_inputs(place, task.property);
    if (task.property.property != Property::ISOPHOTE) // whose level is the cosine
      task.level = std::exchange(task.property.level, Number(0));
  }
  const Json_place name = place.field("surface");
  const Surface_model& surface = read_name(name, model.surfaces, "surface");
  if (auto unsupported = not_for(surface, "contour"))
    return *unsupported;
  need_domain(name, surface);
  task.property.surface = name.string("");
  return task;
}

Task_data read_trichotomy(const Json_place& place, const Model& model)
{
  allow_task_fields(place, {"surface"});
  const Json_place name = place.field("surface");
  const Surface_model& surface = read_name(name, model.surfaces, "surface");
  if (auto unsupported = not_for(surface, "trichotomy"))
    return *unsupported;
  need_domain(name, surface);
  return Trichotomy_task{name.string("")};
}

} // namespace interrogate
