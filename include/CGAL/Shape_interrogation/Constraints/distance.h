// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DISTANCE_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DISTANCE_H

// Vocabulary: distances of points, squared, so that no root occurs.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Constraints/internal/square_of_expression.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>

#include <initializer_list>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The squared length of the vector between two points, which is multiplied by their weights.
inline Expression squared_length(const Constraint_point_3& p, const Constraint_point_3& q)
{
  const Coordinates<Expression, 3> v = vector_between(p, q).components;
  return square(v[0]) + square(v[1]) + square(v[2]);
}

// The squared distance of a point at infinity vanishes with its weight.
inline void check_weights(std::initializer_list<const Constraint_point_3*> points)
{
  for (const Constraint_point_3* p : points)
    if (p->weight.is_constant() && CGAL::is_zero(p->weight.constant()))
      throw Shape_error("the point " + p->name + " has the weight 0: expected a point that is not"
                        " at infinity");
}

inline std::string name_of_distance(const Constraint_point_3& p, const Constraint_point_3& q)
{
  return "the distance of " + p.name + " and " + q.name;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief requires that two points have the distance `d`, a number or an expression:
 * \f$ |p - q|^2 = d^2 \f$, one equation.
 *
 * The sign of `d` has no influence. Square roots that are factors of `d` are squared exactly, so
 * that the distance `sqrt(2)` is rational in the equations.
 *
 * \exception Shape_error if a number in `d` is not real, such as `sqrt(-2)`, or the weight of a
 * point is zero
 */
inline void require_distance(Constraint_system& system, const Constraint_point_3& p,
                             const Constraint_point_3& q, const Expression& d)
{
  internal::check_weights({&p, &q});
  internal::check_real(d, internal::name_of_distance(p, q));
  const Expression d2 = internal::square_of_expression(d), w2 = square(p.weight * q.weight);
  system.add(Constraint(internal::name_of_distance(p, q), to_string(d, system.variables()),
                        {internal::squared_length(p, q) - d2 * w2}));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that `p` is as far from `a` as from `b`: one equation.
/// \exception Shape_error if the weight of a point is zero
inline void require_equal_distances(Constraint_system& system, const Constraint_point_3& p,
                                    const Constraint_point_3& a, const Constraint_point_3& b)
{
  internal::check_weights({&p, &a, &b});
  const Expression to_a = internal::squared_length(p, a), to_b = internal::squared_length(p, b);
  system.add(Constraint(p.name, "as far from " + a.name + " as from " + b.name,
                        {to_a * square(b.weight) - to_b * square(a.weight)}));
}

/// \ingroup PkgShapeInterrogationConstraints
/// \brief requires that the distance of `a` and `b` is that of `c` and `d`: one equation.
/// \exception Shape_error if the weight of a point is zero
inline void require_equal_distances(Constraint_system& system, const Constraint_point_3& a,
                                    const Constraint_point_3& b, const Constraint_point_3& c,
                                    const Constraint_point_3& d)
{
  internal::check_weights({&a, &b, &c, &d});
  const Expression first = internal::squared_length(a, b) * square(c.weight * d.weight);
  const Expression second = internal::squared_length(c, d) * square(a.weight * b.weight);
  system.add(Constraint(internal::name_of_distance(a, b), internal::name_of_distance(c, d),
                        {first - second}));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_DISTANCE_H
