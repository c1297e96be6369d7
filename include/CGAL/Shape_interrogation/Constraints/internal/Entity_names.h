// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ENTITY_NAMES_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ENTITY_NAMES_H

// What the names in the sentences of a system stand for: one thing each. A point may be called as a
// surface or curve, as sentences tell these apart.

#include <CGAL/Shape_interrogation/Constraints/Constraint_point_3.h>
#include <CGAL/Shape_interrogation/Constraints/internal/constant_parts.h>

#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

class Entity_names
{
public:
  // Notes the name of a surface or curve, with its functions. The empty name stands for nothing.
  void add_entity(const std::string& name, const std::vector<Expression>& functions)
  {
    add(m_entities, name, functions);
  }

  void add_point(const Constraint_point_3& p)
  {
    const Coordinates<Expression, 3>& x = p.coordinates;
    add(m_points, p.name, {x[0], x[1], x[2], p.weight});
  }

  void check_new_point(const std::string& name) const
  {
    if (m_points.count(name) == 1)
      refuse(name);
  }

private:
  using Table = std::map<std::string, std::vector<Expression>>;

  static void add(Table& table, const std::string& name, const std::vector<Expression>& functions)
  {
    if (!name.empty() && !are_same(table.emplace(name, functions).first->second, functions))
      refuse(name);
  }

  [[noreturn]] static void refuse(const std::string& name)
  {
    throw Shape_error("the system already has something else with the name '" + name +
                      "', and its sentences could not tell them apart: expected another name");
  }

  Table m_entities, m_points;
};

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ENTITY_NAMES_H
