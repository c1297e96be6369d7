// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROJECTION_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROJECTION_H

// Vocabulary: a point is the orthogonal projection of another onto a surface or a curve
// (Chuang and Hoffmann, section 2), and foot points as unknowns of their own.

#include <CGAL/Shape_interrogation/Constraints/incidence.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

inline Parametric_entity_3::Parameters add_parameters(Constraint_system& system,
                                                      const std::string& prefix,
                                                      const Parametric_entity_3&)
{
  const Expression s = system.add_scalar(prefix + "s");
  return {s, system.add_scalar(prefix + "t")};
}

inline Expression add_parameters(Constraint_system& system, const std::string& prefix,
                                 const Curve_entity_3&)
{
  return system.add_scalar(prefix + "r");
}

template <std::size_t N>
void require_orthogonality(Constraint_system& system, const Constraint_point_3& q,
                           const Constraint_point_3& p, const std::string& onto,
                           const std::array<Coordinates<Expression, 3>, N>& tangents)
{
  const Coordinates<Expression, 3> u = vector_between(p, q).components;
  std::vector<Expression> equations;
  for (const Coordinates<Expression, 3>& t : tangents)
    equations.push_back(dot(u, t));
  system.add(Constraint(p.name, "the projection of " + q.name + " onto " + onto, equations));
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `p`, a point of the implicit surface, is an orthogonal projection of `q`
 * onto it.
 *
 * \f$ (q - p) \times \nabla f(p) = 0 \f$: three equations of rank 2. Which two of them suffice
 * depends on the place, hence the third. They fulfil
 * \f$ \nabla f \cdot ((q - p) \times \nabla f) \equiv 0 \f$, so that at a regular point of the
 * surface each equation whose component of the gradient is not zero follows from the other two.
 *
 * That `p` is on the surface is a constraint of its own: `require_on()`.
 */
inline void require_projection(Constraint_system& system, const Constraint_point_3& q,
                               const Constraint_point_3& p, const Implicit_entity_3& surface)
{
  const Coordinates<Expression, 3> n = surface.gradient(p);
  const Coordinates<Expression, 3> e = internal::cross(vector_between(p, q).components, n);
  system.add(Constraint(p.name, "the projection of " + q.name + " onto " + surface.name(),
                        {e.begin(), e.end()}, 2, {{n.begin(), n.end()}}));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p`, the point of the parametric surface with the parameters `st`, is an
/// orthogonal projection of `q` onto it: \f$ (q - p) \cdot S_s = (q - p) \cdot S_t = 0 \f$.
inline void require_projection(Constraint_system& system, const Constraint_point_3& q,
                               const Constraint_point_3& p, const Parametric_entity_3& surface,
                               const Parametric_entity_3::Parameters& st)
{
  internal::require_orthogonality(system, q, p, surface.name(), surface.tangents(st));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p`, the point of the space curve with the parameter `r`, is an orthogonal
/// projection of `q` onto it: \f$ (q - p) \cdot c' = 0 \f$.
inline void require_projection(Constraint_system& system, const Constraint_point_3& q,
                               const Constraint_point_3& p, const Curve_entity_3& curve,
                               const Expression& r)
{
  internal::require_orthogonality<1>(system, q, p, curve.name(), {curve.tangent(r)});
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `p` is on an entity and is an orthogonal projection of `q` onto it: what
 * `require_on()` and `require_projection()` say together.
 *
 * Unknown parameters of `p` are added as variables: `p_s` and `p_t` on a parametric surface, `p_r`
 * on a curve, if the name of the point is `p`. The projection onto a point is that point.
 */
inline void require_foot_point(Constraint_system& system, const Constraint_point_3& q,
                               const Constraint_point_3& p, const Entity_3& entity)
{
  const auto require = [&](const auto& e) {
    using Kind = std::decay_t<decltype(e)>;
    if constexpr (std::is_same_v<Kind, Implicit_entity_3>)
    {
      require_on(system, p, e);
      require_projection(system, q, p, e);
    }
    else if constexpr (std::is_same_v<Kind, Constraint_point_3>)
      system.add(Constraint(p.name, "the point " + e.name, internal::equal_points(p, e)));
    else
    {
      const auto parameters = internal::add_parameters(system, p.name + "_", e);
      require_on(system, p, e, parameters);
      require_projection(system, q, p, e, parameters);
    }
  };
  std::visit(require, entity);
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief adds the orthogonal projection of `q` onto an entity with its constraints, in as few
 * variables as possible, and returns it.
 *
 * | entity | variables, if the name is `p` | constraints |
 * | ------ | ----------------------------- | ----------- |
 * | implicit surface | `p_x`, `p_y`, `p_z` | on the surface, projection |
 * | parametric surface | `p_s`, `p_t`, of which the point is a function | projection |
 * | curve | `p_r`, of which the point is a function | projection |
 * | point | none; it is returned itself | none |
 */
inline Constraint_point_3 add_foot_point(Constraint_system& system, const Constraint_point_3& q,
                                         const std::string& name, const Entity_3& entity)
{
  const auto add = [&](const auto& e) -> Constraint_point_3 {
    using Kind = std::decay_t<decltype(e)>;
    if constexpr (std::is_same_v<Kind, Implicit_entity_3>)
    {
      const Constraint_point_3 p = system.add_point(name);
      require_foot_point(system, q, p, e);
      return p;
    }
    else if constexpr (std::is_same_v<Kind, Constraint_point_3>)
      return e;
    else
    {
      const auto parameters = internal::add_parameters(system, name + "_", e);
      const Constraint_point_3 p = e.point(name, parameters);
      require_projection(system, q, p, e, parameters);
      return p;
    }
  };
  return std::visit(add, entity);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROJECTION_H
