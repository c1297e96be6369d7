// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ENTITY_3_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ENTITY_3_H

// What constructions are made of: given points, curves and surfaces, in any mix.

#include <CGAL/Shape_interrogation/Constraints/Curve_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/Implicit_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/Parametric_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/internal/constant_parts.h>

#include <string>
#include <type_traits>
#include <variant>

namespace CGAL {
namespace Shape_interrogation {

//! \ingroup PkgShapeInterrogationConstraints
//! \brief is a surface of either kind.
using Surface_entity_3 = std::variant<Implicit_entity_3, Parametric_entity_3>;

//! \ingroup PkgShapeInterrogationConstraints
//! \brief is a surface, a curve in space, or a given point.
using Entity_3 =
  std::variant<Implicit_entity_3, Parametric_entity_3, Curve_entity_3, Constraint_point_3>;

#ifndef DOXYGEN_RUNNING
namespace internal {

// A construction has unknowns of its own, which are not what variables of a given point mean.
inline void check_given(const Constraint_point_3& p)
{
  const std::string what = "the given point " + p.name;
  for (const Expression& x : {p.coordinates[0], p.coordinates[1], p.coordinates[2], p.weight})
  {
    if (has_variables(x))
      throw Shape_error(what + " has a coordinate with variables: expected numbers");
    check_real(x, "a coordinate of " + what);
  }
  if (p.weight.is_constant() && CGAL::is_zero(p.weight.constant()))
    throw Shape_error(what + " has the weight 0: expected a point that is not at infinity");
}

// A member of a construction, which gets the given name if it has none.
template <class Entity>
Entity given(Entity entity, const std::string& name)
{
  std::visit(
    [&](auto& e) {
      if constexpr (std::is_same_v<std::decay_t<decltype(e)>, Constraint_point_3>)
      {
        if (e.name.empty())
          e.name = name;
        check_given(e);
      }
      else if (e.name().empty())
        e.set_name(name);
    },
    entity);
  return entity;
}

} // namespace internal
#endif

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ENTITY_3_H
