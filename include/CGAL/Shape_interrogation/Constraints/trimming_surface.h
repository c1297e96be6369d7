// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_TRIMMING_SURFACE_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_TRIMMING_SURFACE_H

// The surface of the normals of a surface along the curve in which another one cuts it.

#include <CGAL/Shape_interrogation/Constraints/internal/add_point_with_normal.h>

#include <variant>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the ruled surface of the normals of a surface along its intersection with another.
 *
 * \details It bounds the points that have their projection on the part of the surface that is
 * trimmed off. `p` is on both surfaces, and \f$ q = p + \lambda n \f$ for the normal \f$ n \f$ of
 * the surface at `p`: the gradient, or \f$ S_s \times S_t \f$, not normalised.
 *
 * Variables: `x y z`, `p_x p_y p_z` (`p_s p_t` if the surface is parametric), `t_s t_t` if
 * the trimming one is parametric, and `lambda`. For two implicit surfaces these are 7.
 *
 * \param surface the surface that is trimmed
 * \param trimming the surface that cuts it
 */
inline Constraint_system trimming_surface(const Surface_entity_3& surface,
                                          const Surface_entity_3& trimming)
{
  Constraint_system system;
  const auto [p, normal] =
    internal::add_point_with_normal(system, "p", internal::given(surface, "A"));
  const Surface_entity_3 cut = internal::given(trimming, "C");
  if (const auto* implicit = std::get_if<Implicit_entity_3>(&cut))
    require_on(system, p, *implicit);
  else
  {
    const auto& parametric = std::get<Parametric_entity_3>(cut);
    require_on(system, p, parametric, internal::add_parameters(system, "t", parametric));
  }
  const Expression lambda = system.add_scalar("lambda");
  require_multiple(system, vector_between(p, system.projected_point()), normal, lambda);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_TRIMMING_SURFACE_H
