// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ADD_POINT_WITH_NORMAL_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ADD_POINT_WITH_NORMAL_H

// An unknown point of a surface of either kind, with the normal there.

#include <CGAL/Shape_interrogation/Constraints/directions.h>
#include <CGAL/Shape_interrogation/Constraints/projection.h>

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

using Point_with_normal = std::pair<Constraint_point_3, Constraint_vector_3>;

// The variables are those of add_foot_point().
inline Point_with_normal add_point_with_normal(Constraint_system& system, const std::string& name,
                                               const Surface_entity_3& surface)
{
  const auto add = [&](const auto& s) -> Point_with_normal {
    if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Implicit_entity_3>)
    {
      const Constraint_point_3 p = system.add_point(name);
      require_on(system, p, s);
      return {p, normal_at(s, p)};
    }
    else
    {
      const auto parameters = add_parameters(system, name, s);
      const Constraint_point_3 p = s.point(name, parameters);
      return {p, normal_at(s, p, parameters)};
    }
  };
  return std::visit(add, surface);
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_ADD_POINT_WITH_NORMAL_H
