// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_POINT_3_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_POINT_3_H

// Points and vectors whose coordinates are expressions in the variables of a system. Points on
// rational curves and surfaces keep their common denominator, so that equations do not divide.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is a point of a construction: \f$ (X, Y, Z) / W \f$, with a name for sentences.
 *
 * The point is unknown if its coordinates are variables, given if they are numbers, and depends on
 * unknowns if they are other expressions.
 */
struct Constraint_point_3
{
  std::string name;                       //!< the name, such as "p0"
  Coordinates<Expression, 3> coordinates; //!< \f$ X, Y, Z \f$
  Expression weight = Expression(1);      //!< \f$ W \f$

  //! returns the coordinates, divided by the weight.
  Coordinates<Expression, 3> cartesian() const
  {
    return {coordinates[0] / weight, coordinates[1] / weight, coordinates[2] / weight};
  }
};

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is a vector of a construction, with a name for sentences such as "the normal of A at p".
 */
struct Constraint_vector_3
{
  std::string name;                      //!< the name
  Coordinates<Expression, 3> components; //!< the components
};

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief returns the vector from `p` to `q`, multiplied by the weights of both.
 *
 * No division occurs. The weights are 1 unless the points are on rational curves or surfaces.
 */
inline Constraint_vector_3 vector_between(const Constraint_point_3& p, const Constraint_point_3& q)
{
  Constraint_vector_3 v{"the vector from " + p.name + " to " + q.name, {}};
  for (int i = 0; i < 3; ++i)
    v.components[i] = p.weight * q.coordinates[i] - q.weight * p.coordinates[i];
  return v;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_POINT_3_H
