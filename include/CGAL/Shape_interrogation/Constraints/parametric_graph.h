// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_GRAPH_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_GRAPH_H

// A parametric surface or patch as a system in 5-space (Chuang and Hoffmann, section 4).

#include <CGAL/Shape_interrogation/Constraints/incidence.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief states a parametric surface as a system: \f$ q = S(s, t) \f$.
 *
 * The variables are `x y z`, `s`, `t`, and the three equations are independent where the
 * parametrisation is regular.
 */
inline Constraint_system parametric_graph(const Parametric_entity_3& surface)
{
  Constraint_system system;
  Parametric_entity_3 s = surface;
  if (s.name().empty())
    s.set_name("S");
  const Expression first = system.add_scalar("s");
  require_on(system, system.projected_point(), s, {first, system.add_scalar("t")});
  return system;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_GRAPH_H
