// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INCIDENCE_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INCIDENCE_H

// Vocabulary: a point lies on a surface, on a curve, on a line, or divides a segment.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Constraints/Entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/internal/parallel_constraint.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// Notes what the name of a surface or curve stands for; throws if it stands for another one.
template <class Entity>
void add_name(Constraint_system& system, const Entity& entity)
{
  if constexpr (std::is_same_v<Entity, Implicit_entity_3>)
    system.names().add_entity(entity.name(), {entity.function()});
  else
    system.names().add_entity(entity.name(), entity.functions());
}

// p = x as three equations, without division.
inline std::vector<Expression> equal_points(const Constraint_point_3& p,
                                            const Constraint_point_3& x)
{
  const Coordinates<Expression, 3> difference = vector_between(x, p).components;
  return {difference.begin(), difference.end()};
}

} // namespace internal
#endif

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p` is on an implicit surface: one equation.
inline void require_on(Constraint_system& system, const Constraint_point_3& p,
                       const Implicit_entity_3& surface)
{
  internal::add_name(system, surface);
  system.add(Constraint(p.name, "on " + surface.name(), {surface.value(p)}));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p` is the point of a parametric surface with the parameters `st`: three
/// equations.
inline void require_on(Constraint_system& system, const Constraint_point_3& p,
                       const Parametric_entity_3& surface,
                       const Parametric_entity_3::Parameters& st)
{
  internal::add_name(system, surface);
  const auto& names = system.variables();
  system.add(Constraint(p.name,
                        "the point of " + surface.name() + " at (" + to_string(st[0], names) +
                          ", " + to_string(st[1], names) + ")",
                        internal::equal_points(p, surface.point("", st))));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p` is the point of a space curve with the parameter `r`: three equations.
inline void require_on(Constraint_system& system, const Constraint_point_3& p,
                       const Curve_entity_3& curve, const Expression& r)
{
  internal::add_name(system, curve);
  system.add(Constraint(p.name,
                        "the point of " + curve.name() + " at " +
                          to_string(r, system.variables()),
                        internal::equal_points(p, curve.point("", r))));
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `p` is on the line of `a` and `b`.
 *
 * \f$ (p - a) \times (b - a) = 0 \f$: three equations of rank 2, with their two identities. Where
 * `a` and `b` coincide the constraint is void.
 */
inline void require_on_line(Constraint_system& system, const Constraint_point_3& p,
                            const Constraint_point_3& a, const Constraint_point_3& b)
{
  system.add(internal::parallel_constraint(
    p.name, "on the line of " + a.name + " and " + b.name, vector_between(a, p).components,
    vector_between(a, b).components));
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `p` divides the segment of `a` and `b`:
 * \f$ p = \lambda a + (1 - \lambda) b \f$, three equations.
 *
 * The segment is \f$ 0 \le \lambda \le 1 \f$; the equations allow its whole line.
 */
inline void require_dividing(Constraint_system& system, const Constraint_point_3& p,
                             const Constraint_point_3& a, const Constraint_point_3& b,
                             const Expression& lambda)
{
  Constraint_point_3 x{"", {}, a.weight * b.weight};
  for (int i = 0; i < 3; ++i)
    x.coordinates[i] = lambda * (b.weight * a.coordinates[i]) +
                       (1 - lambda) * (a.weight * b.coordinates[i]);
  const std::string share = to_string(lambda, system.variables());
  system.add(Constraint(p.name,
                        "the sum of " + share + " times " + a.name + " and 1 - " + share +
                          " times " + b.name,
                        internal::equal_points(p, x)));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INCIDENCE_H
