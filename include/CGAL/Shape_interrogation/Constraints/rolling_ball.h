// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ROLLING_BALL_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ROLLING_BALL_H

// The canal surface of a ball of constant radius that touches two surfaces.

#include <CGAL/Shape_interrogation/Constraints/directions.h>
#include <CGAL/Shape_interrogation/Constraints/distance.h>
#include <CGAL/Shape_interrogation/Constraints/projection.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface that a ball of constant radius leaves when it rolls along two surfaces
 * or curves and touches both.
 *
 * \details `c` is the centre, `p_A` and `p_B` are its orthogonal projections at the distance of the
 * radius, and `q` is on the circle in which the ball touches the surface: at the distance of the
 * radius from `c`, in the plane through `c` normal to the way of the centre. That way is orthogonal
 * to \f$ c - p_A \f$ and to \f$ c - p_B \f$, so that the plane is the one of `c`, `p_A` and `p_B`:
 * \f$ \det(q - c, p_A - c, p_B - c) = 0 \f$.
 *
 * Variables: `x y z`, `c_x c_y c_z`, those of `p_A`, those of `p_B` (`add_foot_point()`). For two
 * implicit surfaces these are 12, with 12 equations of rank 10.
 *
 * The equations describe the whole circles, of which a blend uses the arc from `p_A` to `p_B`, and
 * balls on either side of the surfaces. Degenerate cases: where `c`, `p_A` and `p_B` are on a line
 * the plane is not defined, and the rank drops.
 *
 * \param a,b the surfaces or curves
 * \param radius a number or an expression
 * \exception Shape_error if the radius is the number zero or not real, such as `sqrt(-2)`; if `a`
 * or `b` is a point that is not given by numbers, or both have one name
 */
inline Constraint_system rolling_ball(const Entity_3& a, const Entity_3& b,
                                      const Expression& radius)
{
  internal::check_distance(radius, "the radius of the ball");
  Constraint_system system;
  const Constraint_point_3& q = system.projected_point();
  const Constraint_point_3 c = system.add_point("c");
  const Constraint_point_3 pa = add_foot_point(system, c, "p_A", internal::given(a, "A"));
  const Constraint_point_3 pb = add_foot_point(system, c, "p_B", internal::given(b, "B"));
  require_distance(system, c, pa, radius);
  require_distance(system, c, pb, radius);
  require_distance(system, q, c, radius);
  require_coplanar(system, q, c, pa, pb);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_ROLLING_BALL_H
