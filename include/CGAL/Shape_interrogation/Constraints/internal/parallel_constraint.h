// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_PARALLEL_CONSTRAINT_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_PARALLEL_CONSTRAINT_H

// u x v = 0: three equations of rank 2, with the two identities u.(u x v) = v.(u x v) = 0.

#include <CGAL/Shape_interrogation/Constraints/Constraint.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <string>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline Constraint parallel_constraint(const std::string& subject, const std::string& predicate,
                                      const Coordinates<Expression, 3>& u,
                                      const Coordinates<Expression, 3>& v)
{
  const Coordinates<Expression, 3> e = cross(u, v);
  return Constraint(subject, predicate, {e.begin(), e.end()}, 2,
                    {{u.begin(), u.end()}, {v.begin(), v.end()}});
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_PARALLEL_CONSTRAINT_H
