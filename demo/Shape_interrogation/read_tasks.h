// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_READ_TASKS_H
#define INTERROGATE_READ_TASKS_H

// Reads tasks: those of meshes and lines in files of their own, and what all tasks have in common.

#include "Json_place.h"
#include "Model.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace interrogate {

using Task_data = decltype(Task::data);

Task_data read_mesh(const Json_place& place, const Model& model);
Task_data read_line(const Json_place& place, const Model& model);
Task_data read_property(const Json_place& place, const Model& model, const std::string& kind);

// Fails at a field that is none of these and none that all tasks have.
void allow_task_fields(const Json_place& place, std::vector<std::string> fields);

// The sentence about a kind that this version does not offer.
Unsupported_task no_kind(const std::string& kind);

// --- Of meshes and lines, in read_meshes.cpp -----------------------------------------------------

// The field "surface", or those of the field "surfaces".
std::vector<Json_place> read_surface_names(const Json_place& place);
// A file in the directory of the report, whose name ends in one of these.
std::string read_file_name(const Json_place& place, const std::vector<std::string>& extensions);
std::array<Range, 3> read_box(const Json_place& place);
// A locator that need not be on the surface: the field is an array, or an object with the names.
std::vector<double> read_start(const Json_place& place, const std::string& field,
                               const std::vector<std::string>& names);

// --- Names ---------------------------------------------------------------------------------------

template <class Shape>
std::vector<std::string> names_of(const std::map<std::string, Shape>& shapes)
{
  std::vector<std::string> names;
  for (const auto& entry : shapes)
    names.push_back(entry.first);
  return names;
}

// The name of a surface or curve that the model has.
template <class Shape>
const Shape& read_name(const Json_place& place, const std::map<std::string, Shape>& shapes,
                       const char* what)
{
  const auto at = shapes.find(place.string(std::string("the name of a ") + what));
  if (at == shapes.end())
    place.expected(shapes.empty()
                     ? std::string("the name of a ") + what + ", but the model has none"
                     : std::string("the name of a ") + what + " of the model (" +
                         listed(names_of(shapes)) + ")");
  return at->second;
}

} // namespace interrogate

#endif // INTERROGATE_READ_TASKS_H
