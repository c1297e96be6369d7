// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_H

// A curve in n-space that was followed, and the limits of its steps.

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Path_point
{
  std::vector<double> point, tangent; // the tangent has unit length and points forward
};

enum class Path_end { CLOSED, BOUND, SINGULAR, LIMIT };

struct Path
{
  std::vector<Path_point> points; // without the start
  Path_end end = Path_end::LIMIT;
  int side = -1;          // the index of the bound where it ends
  std::string evidence;   // why it ends at a singular point
  double last_step = 0;   // the singular point is about so near to the end
};

struct Path_limits
{
  double cos_turning = 0.9;  // of the tangents at the ends of a step
  double least_size = 1e-8; // of a step, as a part of the unit
  std::size_t max_points = 100000;
  bool stops_at_branches = false; // also where the curve could be followed straight on
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_H
