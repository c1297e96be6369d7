// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_COLLAPSED_EDGE_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_COLLAPSED_EDGE_H

// Edges of a Bezier patch that are a single point, decided by the control points without division.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Surfaces/Patch_edge.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The homogeneous control points of an edge.
template <class Patch>
auto edge_points(const Patch& patch, Patch_edge edge)
{
  std::vector<typename Patch::Homogeneous_point> points;
  const int m = patch.degree_u(), n = patch.degree_v();
  if (edge == Patch_edge::U0 || edge == Patch_edge::U1)
    for (int j = 0; j <= n; ++j)
      points.push_back(patch.homogeneous_control_point(edge == Patch_edge::U0 ? 0 : m, j));
  else
    for (int i = 0; i <= m; ++i)
      points.push_back(patch.homogeneous_control_point(i, edge == Patch_edge::V0 ? 0 : n));
  return points;
}

template <class NT>
bool is_certainly_zero(const NT& x)
{
  return CGAL::certainly(is_zero_decision(x));
}

// Whether the vectors a and b are proportional in (x, w), (y, w), (z, w).
template <class NT>
bool is_same_point(const Coordinates<NT, 4>& a, const Coordinates<NT, 4>& b)
{
  for (int d = 0; d < 3; ++d)
    if (!is_certainly_zero(NT(a[d] * b[3] - b[d] * a[3])))
      return false;
  return true;
}

// All control points agree with one whose weight is not zero (where there is none, the edge is a
// pole); one of weight 0 must then be zero as a whole.
template <class NT>
bool is_collapsed(const std::vector<Coordinates<NT, 4>>& points)
{
  const auto first = std::find_if(points.begin(), points.end(), [](const auto& p) {
    return CGAL::certainly(!is_zero_decision(p[3]));
  });
  return first != points.end() &&
         std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return is_same_point(p, *first); });
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_COLLAPSED_EDGE_H
