// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads the kinds of surfaces and curves; those of the format that this version does not offer are
// taken as they are, so that the tasks that need them can say so.

#include "read_shapes.h"

#include "read_numbers.h"

#include <algorithm>

namespace interrogate {

namespace {

const std::vector<std::string> surface_kinds = {
  "implicit", "parametric", "bezier", "nurbs", "system", "ruled_by_projection", "offset_system",
  "equal_distance", "rolling_ball", "variable_radius_blend", "trimming_surface",
  "parametric_graph"};
const std::vector<std::string> later_surface_kinds = {
  "offset", "bisector", "functional_spline", "product_level", "normalform_expression", "blend"};
const std::vector<std::string> curve_kinds = {"implicit_2", "parametric_2", "bezier_2", "nurbs_2",
                                              "parametric_3", "bezier_3", "nurbs_3"};
const std::vector<std::string> later_curve_kinds = {
  "offset", "bisector", "normalform_expression", "parabolic_functional_spline"};

bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> names_or(const Json_place& place, const std::string& field,
                                  const std::vector<std::string>& usual)
{
  const std::optional<Json_place> names = place.find(field);
  if (!names)
    return usual;
  return read_names(*names, usual.size(),
                    std::to_string(usual.size()) + " names of " + field);
}

Implicit_model read_implicit(const Json_place& place, const std::vector<std::string>& usual)
{
  Implicit_model model;
  model.variables = names_or(place, "variables", usual);
  model.f = read_function(place.field("f"), model.variables);
  return model;
}

Parametric_model read_parametric_surface(const Json_place& place)
{
  Parametric_model model;
  model.parameters = names_or(place, "parameters", {"u", "v"});
  model.x = read_functions(place.field("x"), 3, model.parameters);
  if (const std::optional<Json_place> domain = place.find("domain"))
  {
    model.domain.emplace();
    for (const Json_place& range : domain->elements(2, "[[u0,u1],[v0,v1]]"))
      model.domain->push_back(read_range(range));
  }
  return model;
}

Parametric_model read_parametric_curve(const Json_place& place, int dimension)
{
  place.allow_only({"kind", "x", "parameter", "domain"});
  Parametric_model model;
  const std::optional<Json_place> name = place.find("parameter");
  model.parameters = {name ? read_name(*name, "the name of the parameter") : "t"};
  model.x = read_functions(place.field("x"), dimension, model.parameters);
  if (const std::optional<Json_place> domain = place.find("domain"))
    model.domain.emplace(1, read_range(*domain));
  return model;
}

[[noreturn]] void unknown_kind(const Json_place& place, const char* what,
                               const std::vector<std::string>& now,
                               const std::vector<std::string>& later)
{
  place.expected(std::string("the kind of a ") + what + " (" + listed(now) +
                 "; not in this version: " + listed(later) + ")");
}

} // namespace

Surface_model read_surface(const Json_place& place)
{
  const Json_place kind_place = place.field("kind");
  const std::string& kind = kind_place.string("the kind of the surface, a string");
  Surface_model surface;
  surface.kind = kind;
  if (contains(later_surface_kinds, kind))
    surface.data = Unsupported{kind};
  else if (kind == "implicit")
  {
    place.allow_only({"kind", "f", "variables", "flip"});
    surface.data = read_implicit(place, {"x", "y", "z"});
  }
  else if (kind == "parametric")
  {
    place.allow_only({"kind", "x", "parameters", "domain", "flip"});
    surface.data = read_parametric_surface(place);
  }
  else if (kind == "bezier")
    surface.data = read_bezier_surface(place);
  else if (kind == "nurbs")
    surface.data = read_nurbs_surface(place);
  else if (kind == "system")
  {
    surface.data = read_system(place);
    read_orientation(place, surface);
  }
  else
    unknown_kind(kind_place, "surface", surface_kinds, later_surface_kinds);
  if (!std::holds_alternative<Unsupported>(surface.data))
    if (const std::optional<Json_place> flip = place.find("flip"))
      surface.flip = flip->boolean();
  return surface;
}

bool is_curve_kind(const std::string& kind)
{
  return contains(curve_kinds, kind);
}

Curve_model read_curve(const Json_place& place)
{
  const Json_place kind_place = place.field("kind");
  const std::string& kind = kind_place.string("the kind of the curve, a string");
  if (contains(later_curve_kinds, kind))
    return Unsupported{kind};
  if (kind == "implicit_2")
  {
    place.allow_only({"kind", "f", "variables"});
    return read_implicit(place, {"x", "y"});
  }
  if (kind == "parametric_2")
    return read_parametric_curve(place, 2);
  if (kind == "bezier_2")
    return read_bezier_curve(place);
  if (kind == "nurbs_2")
    return read_nurbs_curve(place);
  if (kind == "parametric_3")
    return Space_curve_model{kind, read_parametric_curve(place, 3)};
  if (kind == "bezier_3" || kind == "nurbs_3")
    return Space_curve_model{kind, read_space_spline(place, kind == "nurbs_3")};
  unknown_kind(kind_place, "curve", curve_kinds, later_curve_kinds);
}

} // namespace interrogate
