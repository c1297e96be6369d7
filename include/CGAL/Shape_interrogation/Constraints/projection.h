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

// How the names of the variables of a foot point end.
inline std::vector<std::string> endings(const Implicit_entity_3&) { return {"_x", "_y", "_z"}; }
inline std::vector<std::string> endings(const Parametric_entity_3&) { return {"_s", "_t"}; }
inline std::vector<std::string> endings(const Curve_entity_3&) { return {"_r"}; }

// Notes the name of the entity. Throws if the variables of a foot point cannot be added, and
// changes nothing then.
template <class Entity>
void check_foot_point(Constraint_system& system, const std::string& point, const Entity& entity)
{
  for (const std::string& ending : endings(entity))
    check_new_variable(point + ending, system.variables());
  add_name(system, entity);
}

inline Parametric_entity_3::Parameters
add_parameters(Constraint_system& system, const std::string& point, const Parametric_entity_3& e)
{
  check_foot_point(system, point, e);
  const Expression s = system.add_scalar(point + "_s");
  return {s, system.add_scalar(point + "_t")};
}

inline Expression add_parameters(Constraint_system& system, const std::string& point,
                                 const Curve_entity_3& e)
{
  check_foot_point(system, point, e);
  return system.add_scalar(point + "_r");
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
  internal::add_name(system, surface);
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
  internal::add_name(system, surface);
  internal::require_orthogonality(system, q, p, surface.name(), surface.tangents(st));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p`, the point of the space curve with the parameter `r`, is an orthogonal
/// projection of `q` onto it: \f$ (q - p) \cdot c' = 0 \f$.
inline void require_projection(Constraint_system& system, const Constraint_point_3& q,
                               const Constraint_point_3& p, const Curve_entity_3& curve,
                               const Expression& r)
{
  internal::add_name(system, curve);
  internal::require_orthogonality<1>(system, q, p, curve.name(), {curve.tangent(r)});
}

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that `p` is on an entity and is an orthogonal projection of `q` onto it: what
 * `require_on()` and `require_projection()` say together.
 *
 * Unknown parameters of `p` are added as variables: `p_s` and `p_t` on a parametric surface, `p_r`
 * on a curve, if the name of the point is `p`. The projection onto a point is that point, which is
 * given by numbers or is a point of the same system.
 *
 * \exception Shape_error if a name is taken; nothing is added then
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
    {
      system.names().add_point(e);
      system.add(Constraint(p.name, "the point " + e.name, internal::equal_points(p, e)));
    }
    else
    {
      const auto parameters = internal::add_parameters(system, p.name, e);
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
 *
 * A point is given by numbers or is a point of the same system.
 *
 * \exception Shape_error if a name is taken; nothing is added then
 */
inline Constraint_point_3 add_foot_point(Constraint_system& system, const Constraint_point_3& q,
                                         const std::string& name, const Entity_3& entity)
{
  const auto add = [&](const auto& e) -> Constraint_point_3 {
    using Kind = std::decay_t<decltype(e)>;
    if constexpr (!std::is_same_v<Kind, Constraint_point_3>)
      system.names().check_new_point(name);
    if constexpr (std::is_same_v<Kind, Implicit_entity_3>)
    {
      internal::check_foot_point(system, name, e);
      const Constraint_point_3 p = system.add_point(name);
      require_foot_point(system, q, p, e);
      return p;
    }
    else if constexpr (std::is_same_v<Kind, Constraint_point_3>)
    {
      system.names().add_point(e);
      return e;
    }
    else
    {
      const auto parameters = internal::add_parameters(system, name, e);
      const Constraint_point_3 p = e.point(name, parameters);
      system.names().add_point(p);
      require_projection(system, q, p, e, parameters);
      return p;
    }
  };
  return std::visit(add, entity);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROJECTION_H
