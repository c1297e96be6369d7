// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_RULED_BY_PROJECTION_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_RULED_BY_PROJECTION_H

// The ruled surface over the two projections of a curve (Chuang and Hoffmann, section 2).

#include <CGAL/Shape_interrogation/Constraints/projection.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface of the lines that join the projections of the points of a curve onto
 * two surfaces.
 *
 * \details `p0` is the point of the directrix with the parameter `r`, `p1` its orthogonal
 * projection onto `a`, `p2` that onto `b`, and \f$ q = \lambda p_1 + (1 - \lambda) p_2 \f$.
 *
 * Variables: `x y z`, `p0_x p0_y p0_z`, `p1_x p1_y p1_z`, `p2_x p2_y p2_z`, `r`, then `p1_s p1_t`
 * if `a` is parametric, `p2_s p2_t` if `b` is, and `lambda`. For an implicit `a` and a parametric
 * `b` these are the 16 variables and 15 equations of the paper. Curves take the place of surfaces
 * with one parameter, `p1_r` or `p2_r`, points with none.
 *
 * A system is redundant by one equation for each implicit surface. `r` and `lambda` are not
 * bounded; the segment between the two curves is \f$ 0 \le \lambda \le 1 \f$.
 *
 * \param directrix the curve
 * \param a,b the surfaces, implicit or parametric in any mix
 * \return a system with two degrees of freedom
 */
inline Constraint_system ruled_by_projection(const Curve_entity_3& directrix, const Entity_3& a,
                                             const Entity_3& b)
{
  Constraint_system system;
  Curve_entity_3 curve = directrix;
  if (curve.name().empty())
    curve.set_name("the directrix");
  const Constraint_point_3 p0 = system.add_point("p0");
  const Constraint_point_3 p1 = system.add_point("p1");
  const Constraint_point_3 p2 = system.add_point("p2");
  const Expression r = system.add_scalar("r");
  require_on(system, p0, curve, r);
  require_foot_point(system, p0, p1, internal::given(a, "A"));
  require_foot_point(system, p0, p2, internal::given(b, "B"));
  const Expression lambda = system.add_scalar("lambda");
  require_dividing(system, system.projected_point(), p1, p2, lambda);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_RULED_BY_PROJECTION_H
