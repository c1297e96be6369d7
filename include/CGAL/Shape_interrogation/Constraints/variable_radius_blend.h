// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VARIABLE_RADIUS_BLEND_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VARIABLE_RADIUS_BLEND_H

// The canal surface of a ball that touches two surfaces, and whose radius a third thing determines.

#include <CGAL/Shape_interrogation/Constraints/internal/add_point_with_normal.h>
#include <CGAL/Shape_interrogation/Constraints/distance.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The feet of c on both surfaces, and q on the sphere around c through them.
inline std::pair<Constraint_point_3, Constraint_point_3>
add_touching_ball(Constraint_system& system, const Constraint_point_3& c, const Entity_3& a,
                  const Entity_3& b)
{
  const Constraint_point_3 pa = add_foot_point(system, c, "p_A", given(a, "A"));
  const Constraint_point_3 pb = add_foot_point(system, c, "p_B", given(b, "B"));
  require_equal_distances(system, c, pa, pb);
  require_equal_distances(system, c, pa, system.projected_point());
  return {pa, pb};
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface that a ball leaves when it touches two surfaces or curves and its
 * centre moves on a reference surface, which so determines the radius.
 *
 * \details `c` is the centre, on the reference surface \f$ R \f$ and equally far from its
 * orthogonal projections `p_A` and `p_B`; `q` is at the same distance \f$ \rho \f$ from `c`, and on
 * the circle in which the ball touches the surface. When the centre moves with the velocity
 * \f$ c' \f$, that circle is \f$ (q - c) \cdot c' + \rho \rho' = 0 \f$. Now
 * \f$ \rho \rho' = (c - p_A) \cdot c' \f$, as the velocity of `p_A` is tangent, hence
 * \f$ (q - p_A) \cdot c' = 0 \f$; and as the same holds with `p_B`,
 * \f$ (p_B - p_A) \cdot c' = 0 \f$. With \f$ c' \f$ tangent to \f$ R \f$ this is
 * \f$ \det(q - p_A, p_B - p_A, \nabla R(c)) = 0 \f$.
 *
 * Variables: `x y z`, `c_x c_y c_z` (`c_s c_t` if the reference is parametric), those of `p_A`,
 * those of `p_B` (`add_foot_point()`). For three implicit surfaces these are 12, with 12 equations
 * of rank 10. What is said of sides and arcs for `rolling_ball()` holds here.
 *
 * Source: the family of Chandru, Dutta and Hoffmann; the closing equation is derived above.
 */
inline Constraint_system variable_radius_blend(const Entity_3& a, const Entity_3& b,
                                               const Surface_entity_3& reference)
{
  Constraint_system system;
  const auto [c, normal] =
    internal::add_point_with_normal(system, "c", internal::given(reference, "R"));
  const auto [pa, pb] = internal::add_touching_ball(system, c, a, b);
  const Constraint_point_3& q = system.projected_point();
  system.add(Constraint(q.name, "on the circle in which the ball around c touches the surface",
                        {internal::determinant(vector_between(pa, q).components,
                                               vector_between(pa, pb).components,
                                               normal.components)}));
  return system;
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states the surface that a ball leaves when it touches two surfaces or curves and a
 * reference curve, which so determines the radius: the blend of the two through that curve.
 *
 * \details `c` is the centre, equally far from its orthogonal projections `p_A`, `p_B` and `p_R`.
 * As for a reference surface, \f$ c' \f$ is orthogonal to \f$ p_B - p_A \f$ and now to
 * \f$ p_R - p_A \f$, so that the circle in which the ball touches the surface is in the plane of
 * the three: \f$ \det(q - p_A, p_B - p_A, p_R - p_A) = 0 \f$.
 *
 * Variables: `x y z`, `c_x c_y c_z`, those of `p_A`, those of `p_B`, `p_R_r`. For two implicit
 * surfaces these are 13, with 13 equations of rank 11. Where the three are on a line the rank
 * drops.
 */
inline Constraint_system variable_radius_blend(const Entity_3& a, const Entity_3& b,
                                               const Curve_entity_3& reference)
{
  Constraint_system system;
  const Constraint_point_3 c = system.add_point("c");
  const auto [pa, pb] = internal::add_touching_ball(system, c, a, b);
  const Constraint_point_3 pr =
    add_foot_point(system, c, "p_R", internal::given(Entity_3(reference), "R"));
  require_equal_distances(system, c, pa, pr);
  require_coplanar(system, system.projected_point(), pa, pb, pr);
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VARIABLE_RADIUS_BLEND_H
