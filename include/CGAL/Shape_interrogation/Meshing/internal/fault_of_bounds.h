// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FAULT_OF_BOUNDS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FAULT_OF_BOUNDS_H

// What is wrong with bounds of the variables of a system.

#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// What is wrong with a list of bounds, or nothing.
inline std::string fault_of(const std::vector<N_space_bound>& bounds, const N_space_system& system)
{
  if (bounds.size() > 32)
    return "there are more than 32 bounds";
  for (const N_space_bound& b : bounds)
  {
    if (b.variable < 0 || b.variable >= system.number_of_variables())
      return "there is no variable with the number " + std::to_string(b.variable);
    if (b.lower >= b.upper)
      return "the bounds of " + system.variables()[b.variable] + " are empty";
  }
  return "";
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FAULT_OF_BOUNDS_H
