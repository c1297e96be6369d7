// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads surfaces that are stated as constructions: one call of the library each.

#include "read_members.h"
#include "read_numbers.h"
#include "read_shapes.h"

#include <CGAL/Shape_interrogation/Constraints/equal_distance.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/parametric_graph.h>
#include <CGAL/Shape_interrogation/Constraints/rolling_ball.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Constraints/trimming_surface.h>
#include <CGAL/Shape_interrogation/Constraints/variable_radius_blend.h>

#include <map>
#include <utility>

namespace interrogate {

namespace {

// The system, and the members together with what the names of their parameters begin with.
struct Construction
{
  si::Constraint_system system;
  std::vector<std::pair<std::string, Member>> members;
};

void allow_only(const Json_place& place, std::vector<std::string> fields)
{
  fields.insert(fields.begin(), {"kind", "of"});
  fields.insert(fields.end(), {"bounds", "orient", "flip"});
  place.allow_only(fields);
}

si::Surface_entity_3 surface_of(const Member& member)
{
  if (const auto* implicit = std::get_if<si::Implicit_entity_3>(&member.entity))
    return *implicit;
  return std::get<si::Parametric_entity_3>(member.entity);
}

Construction read_ruled(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {"directrix"});
  const std::vector<Member> of = read_of(place, shapes, 2, 2, ENTITY);
  const Member directrix = read_member(place.field("directrix"), shapes, CURVE);
  const auto& curve = std::get<si::Curve_entity_3>(directrix.entity);
  return {si::ruled_by_projection(curve, of[0].entity, of[1].entity),
          {{"", directrix}, {"p1_", of[0]}, {"p2_", of[1]}}};
}

Construction read_offset(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {"distance"});
  const std::vector<Member> of = read_of(place, shapes, 1, 1, ENTITY);
  const Number distance = read_nonzero(place.field("distance"));
  return {si::offset_system(of[0].entity, distance), {{"p_", of[0]}}};
}

Construction read_equal_distance(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {});
  const std::vector<Member> of = read_of(place, shapes, 2, 3, ENTITY);
  if (of.size() == 2)
    return {si::equal_distance(of[0].entity, of[1].entity), {{"p_A_", of[0]}, {"p_B_", of[1]}}};
  return {si::equal_distance(of[0].entity, of[1].entity, of[2].entity),
          {{"p_A_", of[0]}, {"p_B_", of[1]}, {"p_C_", of[2]}}};
}

Construction read_rolling_ball(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {"radius"});
  const std::vector<Member> of = read_of(place, shapes, 2, 2, ENTITY);
  const Number radius = read_positive(place.field("radius"));
  return {si::rolling_ball(of[0].entity, of[1].entity, radius),
          {{"p_A_", of[0]}, {"p_B_", of[1]}}};
}

Construction read_variable_radius(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {"reference"});
  const std::vector<Member> of = read_of(place, shapes, 2, 2, ENTITY);
  const Member reference = read_member(place.field("reference"), shapes, SURFACE | CURVE);
  if (const auto* curve = std::get_if<si::Curve_entity_3>(&reference.entity))
    return {si::variable_radius_blend(of[0].entity, of[1].entity, *curve),
            {{"p_A_", of[0]}, {"p_B_", of[1]}, {"p_R_", reference}}};
  return {si::variable_radius_blend(of[0].entity, of[1].entity, surface_of(reference)),
          {{"p_A_", of[0]}, {"p_B_", of[1]}, {"c_", reference}}};
}

Construction read_trimming(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {});
  const std::vector<Member> of = read_of(place, shapes, 2, 2, SURFACE);
  return {si::trimming_surface(surface_of(of[0]), surface_of(of[1])),
          {{"p_", of[0]}, {"t_", of[1]}}};
}

Construction read_graph(const Json_place& place, const Named_shapes& shapes)
{
  allow_only(place, {});
  const std::vector<Member> of = read_of(place, shapes, 1, 1, PARAMETRIC);
  const auto& surface = std::get<si::Parametric_entity_3>(of[0].entity);
  return {si::parametric_graph(surface), {{"", of[0]}}};
}

using Read_construction = Construction (*)(const Json_place&, const Named_shapes&);

const std::map<std::string, Read_construction> readers = {
  {"ruled_by_projection", read_ruled},      {"offset_system", read_offset},
  {"equal_distance", read_equal_distance},  {"rolling_ball", read_rolling_ball},
  {"variable_radius_blend", read_variable_radius}, {"trimming_surface", read_trimming},
  {"parametric_graph", read_graph}};

// The domain of a parameter as the bound of its variable.
si::N_space_bound bound_of(const Json_place& place, int variable, const std::string& name,
                           const Range& domain)
{
  if (!domain[0].is_constant() || !domain[1].is_constant())
    place.fail("the domain of the parameter " + name + " has a root, and bounds are rational: give"
               " \"bounds\" for " + name);
  return {variable, domain[0].constant(), domain[1].constant()};
}

// The bounds that are given, and the domains of the members for variables without.
std::vector<si::N_space_bound> bounds_of(const Json_place& place, const Construction& c)
{
  std::map<int, si::N_space_bound> bounds;
  if (const std::optional<Json_place> given = place.find("bounds"))
    for (const si::N_space_bound& bound : read_bounds(*given, c.system.variables()))
      bounds.emplace(bound.variable, bound);
  for (const auto& [prefix, member] : c.members)
    for (std::size_t i = 0; i < member.domain.size(); ++i)
    {
      const std::string name = prefix + (member.domain.size() == 1 ? "r" : i == 0 ? "s" : "t");
      const int variable = c.system.find_variable(name);
      if (bounds.count(variable) == 0)
        bounds.emplace(variable, bound_of(place, variable, name, member.domain[i]));
    }
  std::vector<si::N_space_bound> result;
  for (const auto& entry : bounds)
    result.push_back(entry.second);
  return result;
}

System_model read_data(const Json_place& place, const Named_shapes& shapes)
{
  try
  {
    const Construction c = readers.at(place.field("kind").string(""))(place, shapes);
    return {c.system.variables(), c.system.equations(), bounds_of(place, c), c.system};
  }
  catch (const si::Shape_error& error)
  {
    place.fail(error.what());
  }
}

} // namespace

bool is_construction(const Json_place& place)
{
  const std::optional<Json_place> kind = place.find("kind");
  return kind && kind->kind() == Json::Kind::STRING && readers.count(kind->string("")) == 1;
}

Surface_model read_construction(const Json_place& place, const std::string& name,
                                const Model& model, const Json_place& surfaces)
{
  Surface_model surface;
  surface.kind = place.field("kind").string("");
  try
  {
    surface.data = read_data(place, Named_shapes{model, surfaces, name});
  }
  catch (const Unsupported& unsupported)
  {
    surface.data = unsupported;
    return surface;
  }
  read_orientation(place, surface);
  if (const std::optional<Json_place> flip = place.find("flip"))
    surface.flip = flip->boolean();
  return surface;
}

} // namespace interrogate
