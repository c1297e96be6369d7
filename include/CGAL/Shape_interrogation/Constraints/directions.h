// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DIRECTIONS_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DIRECTIONS_H

// Vocabulary: normals of surfaces, and vectors that are parallel or orthogonal.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Constraints/Entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/internal/parallel_constraint.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/// \ingroup PkgShapeInterrogationConstraints
/// \brief returns the normal of an implicit surface at a point: the gradient, not normalised.
inline Constraint_vector_3 normal_at(const Implicit_entity_3& surface, const Constraint_point_3& p)
{
  return {"the normal of " + surface.name() + " at " + p.name, surface.gradient(p)};
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief returns the normal of a parametric surface at its point `p` with the parameters `st`:
/// \f$ S_s \times S_t \f$, not normalised, times \f$ W^4 \f$ for rational ones.
inline Constraint_vector_3 normal_at(const Parametric_entity_3& surface,
                                     const Constraint_point_3& p,
                                     const Parametric_entity_3::Parameters& st)
{
  const auto tangents = surface.tangents(st);
  return {"the normal of " + surface.name() + " at " + p.name,
          internal::cross(tangents[0], tangents[1])};
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that two vectors are parallel, or one of them is zero.
 *
 * \f$ a \times b = 0 \f$: three equations of rank 2, with their two identities.
 */
inline void require_parallel(Constraint_system& system, const Constraint_vector_3& a,
                             const Constraint_vector_3& b)
{
  system.add(internal::parallel_constraint(a.name, "parallel to " + b.name, a.components,
                                           b.components));
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `a` is `factor` times `b`: three equations.
 *
 * With an unknown factor the vectors are parallel, and `b` is zero only where `a` is.
 */
inline void require_multiple(Constraint_system& system, const Constraint_vector_3& a,
                             const Constraint_vector_3& b, const Expression& factor)
{
  std::vector<Expression> equations;
  for (int i = 0; i < 3; ++i)
    equations.push_back(a.components[i] - factor * b.components[i]);
  system.add(Constraint(a.name, to_string(factor, system.variables()) + " times " + b.name,
                        std::move(equations)));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that two vectors are orthogonal: one equation.
inline void require_orthogonal(Constraint_system& system, const Constraint_vector_3& a,
                               const Constraint_vector_3& b)
{
  system.add(
    Constraint(a.name, "orthogonal to " + b.name, {internal::dot(a.components, b.components)}));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p` is in the plane of three points: one equation. Where these are on a
/// line it is void.
inline void require_coplanar(Constraint_system& system, const Constraint_point_3& p,
                             const Constraint_point_3& a, const Constraint_point_3& b,
                             const Constraint_point_3& c)
{
  system.add(Constraint(p.name, "in the plane of " + a.name + ", " + b.name + " and " + c.name,
                        {internal::determinant(vector_between(a, p).components,
                                               vector_between(a, b).components,
                                               vector_between(a, c).components)}));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DIRECTIONS_H
