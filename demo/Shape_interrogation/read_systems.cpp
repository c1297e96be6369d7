// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads systems that are written down, and what all systems may have: bounds and an orientation.

#include "read_shapes.h"

#include "read_numbers.h"

#include <algorithm>

namespace interrogate {

System_model read_system(const Json_place& place)
{
  place.allow_only({"kind", "variables", "equations", "bounds", "orient", "flip"});
  System_model model;
  const Json_place variables = place.field("variables");
  model.variables = read_names(variables, "an array of names");
  if (model.variables.size() < 3)
    variables.fail("a system needs three variables or more, the first three are those of space");
  const Json_place equations = place.field("equations");
  for (const Json_place& f : equations.elements("an array of functions"))
    model.equations.push_back(read_function(f, model.variables));
  if (const std::optional<Json_place> bounds = place.find("bounds"))
    model.bounds = read_bounds(*bounds, model.variables);
  return model;
}

std::vector<si::N_space_bound> read_bounds(const Json_place& place,
                                           const std::vector<std::string>& variables)
{
  std::vector<si::N_space_bound> bounds;
  for (const auto& [name, range] : place.fields("an object {variable: [lo,hi]}"))
  {
    const auto at = std::find(variables.begin(), variables.end(), name);
    if (at == variables.end())
      range.fail("there is no variable of this name, the variables are: " + listed(variables));
    read_range(range);
    const std::vector<Json_place> ends = range.elements(2, "a range [lo,hi]");
    bounds.push_back({static_cast<int>(at - variables.begin()), read_rational(ends[0]),
                      read_rational(ends[1])});
  }
  std::sort(bounds.begin(), bounds.end(),
            [](const auto& a, const auto& b) { return a.variable < b.variable; });
  return bounds;
}

void read_orientation(const Json_place& place, Surface_model& surface)
{
  const std::optional<Json_place> orient = place.find("orient");
  if (!orient)
    return;
  surface.orient.emplace();
  const std::vector<Json_place> components = orient->elements(3, "a vector of three numbers");
  for (int i = 0; i < 3; ++i)
    (*surface.orient)[i] = read_rational(components[i]);
}

} // namespace interrogate
