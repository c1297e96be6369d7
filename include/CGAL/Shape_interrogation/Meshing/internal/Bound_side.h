// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUND_SIDE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUND_SIDE_H

// One side of the range of a variable, in floating point.

#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Bound_side
{
  int variable;
  double value;
  int sign; // 1: the variable is at least the value; -1: at most

  // Not negative on the side that is meant.
  double distance(const std::vector<double>& p) const { return sign * (p[variable] - value); }

  N_space_condition condition(std::size_t n) const
  {
    return N_space_condition::fixed(static_cast<int>(n), variable, value);
  }
};

// Of several bounds to the same side the tightest one counts.
inline void add_side(std::vector<Bound_side>& sides, const Bound_side& side)
{
  for (Bound_side& s : sides)
    if (s.variable == side.variable && s.sign == side.sign)
    {
      s.value = side.sign * (std::max)(side.sign * s.value, side.sign * side.value);
      return;
    }
  sides.push_back(side);
}

inline std::vector<Bound_side> sides_of(const std::vector<N_space_bound>& bounds)
{
  std::vector<Bound_side> sides;
  for (const N_space_bound& b : bounds)
  {
    add_side(sides, {b.variable, number_cast<double>(b.lower), 1});
    add_side(sides, {b.variable, number_cast<double>(b.upper), -1});
  }
  return sides;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUND_SIDE_H
