// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_OFFSET_SYSTEM_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_OFFSET_SYSTEM_H

// Offsets as systems: the points at a given distance from their projection.

#include <CGAL/Shape_interrogation/Constraints/distance.h>
#include <CGAL/Shape_interrogation/Constraints/projection.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface of the points at a distance from a surface, a curve or a point,
 * measured along a normal.
 *
 * \details `p` is an orthogonal projection of `q` onto `base`, and \f$ |q - p| = d \f$. The
 * variables are `x y z` and those of `p`: `p_x p_y p_z` for an implicit surface, `p_s p_t` for a
 * parametric one, `p_r` for a curve, which has a tube for its offset.
 *
 * The offsets on both sides of a surface fulfil the same equations; a point belongs to one of them.
 * Where the distance is a principal radius of curvature of the base on that side, the surface in
 * n-space goes on smoothly and its projection is singular.
 *
 * \param base the surface, curve or point
 * \param distance a number or an expression such as `sqrt(2)`
 * \exception Shape_error if the distance is the number zero or not real, such as `sqrt(-2)`; if the
 * base is a point that is not given by numbers
 */
inline Constraint_system offset_system(const Entity_3& base, const Expression& distance)
{
  internal::check_distance(distance, "the distance of the offset");
  Constraint_system system;
  const Constraint_point_3 p = add_foot_point(system, system.projected_point(), "p",
                                              internal::given(base, "the base"));
  require_distance(system, system.projected_point(), p, distance);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_OFFSET_SYSTEM_H
