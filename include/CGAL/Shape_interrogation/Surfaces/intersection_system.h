// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERSECTION_SYSTEM_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERSECTION_SYSTEM_H

// The curve in which the projections of two surfaces in n-space meet, as one system.

#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief returns the system of both surfaces at the same projected point.
 *
 * \details The variables are those of `a`, followed by those of `b` from the fourth on; one whose
 * name is taken gets underscores in front. The solutions are, in general, a curve: see
 * `trace_n_space_curve()`.
 *
 * Source: Chuang and Hoffmann, "Curvature computations on surfaces in n-space"
 */
inline N_space_system intersection_system(const N_space_system& a, const N_space_system& b)
{
  std::vector<std::string> names = a.variables();
  std::set<std::string> taken(names.begin(), names.end());
  std::vector<Expression> variables_of_a, variables_of_b;
  for (int i = 0; i < a.number_of_variables(); ++i)
    variables_of_a.push_back(Expression::variable(i));
  for (int i = 0; i < b.number_of_variables(); ++i)
  {
    variables_of_b.push_back(
      Expression::variable(i < 3 ? i : static_cast<int>(names.size())));
    if (i < 3)
      continue;
    std::string name = b.variables()[static_cast<std::size_t>(i)];
    while (!taken.insert(name).second)
      name = "_" + name;
    names.push_back(name);
  }
  std::vector<Expression> equations = a.tape().evaluate(variables_of_a);
  const std::vector<Expression> more = b.tape().evaluate(variables_of_b);
  equations.insert(equations.end(), more.begin(), more.end());
  return N_space_system(names, equations);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERSECTION_SYSTEM_H
