// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_EQUAL_DISTANCE_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_EQUAL_DISTANCE_H

// Equal-distance surfaces of two points, curves or surfaces, and equal-distance curves of three.

#include <CGAL/Shape_interrogation/Constraints/distance.h>
#include <CGAL/Shape_interrogation/Constraints/projection.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface of the points that are equally far from two entities.
 *
 * \details `p_A` and `p_B` are orthogonal projections of `q` onto `a` and `b`, and
 * \f$ |q - p_A| = |q - p_B| \f$. The variables are `x y z`, those of `p_A` and those of `p_B`: see
 * `add_foot_point()`. Projections need not be nearest points: the solutions have several sheets,
 * one for each choice of projections.
 *
 * \exception Shape_error if a point is not given by numbers or has the weight zero, or if two
 * different entities have one name
 */
inline Constraint_system equal_distance(const Entity_3& a, const Entity_3& b)
{
  Constraint_system system;
  const Constraint_point_3& q = system.projected_point();
  const Constraint_point_3 pa = add_foot_point(system, q, "p_A", internal::given(a, "A"));
  const Constraint_point_3 pb = add_foot_point(system, q, "p_B", internal::given(b, "B"));
  require_equal_distances(system, q, pa, pb);
  return system;
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the curve of the points that are equally far from three entities.
 *
 * \details As for two, with the variables of `p_C` at the end. The system has one degree of
 * freedom: it is the intersection of two equal-distance surfaces, and no surface.
 *
 * \exception Shape_error as for two
 */
inline Constraint_system equal_distance(const Entity_3& a, const Entity_3& b, const Entity_3& c)
{
  Constraint_system system;
  const Constraint_point_3& q = system.projected_point();
  const Constraint_point_3 pa = add_foot_point(system, q, "p_A", internal::given(a, "A"));
  const Constraint_point_3 pb = add_foot_point(system, q, "p_B", internal::given(b, "B"));
  const Constraint_point_3 pc = add_foot_point(system, q, "p_C", internal::given(c, "C"));
  require_equal_distances(system, q, pa, pb);
  require_equal_distances(system, q, pa, pc);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_EQUAL_DISTANCE_H
