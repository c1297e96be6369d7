// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BORDER_BESIDE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BORDER_BESIDE_H

// Finds the side on a bound that a point comes between.

#include <CGAL/Shape_interrogation/Meshing/internal/N_space_cover.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Two vertices that follow each other on the bound and that the point is between, or (-1, -1).
inline std::pair<int, int> border_beside(const N_space_cover& cover, const N_space_chart& p,
                                         int side)
{
  std::pair<int, int> best(-1, -1);
  double nearest = 0.35; // off the segment, in lengths of it
  for (const auto& [ends, on] : cover.borders())
  {
    const N_space_chart &a = cover.vertices()[ends.first].chart,
                        &b = cover.vertices()[ends.second].chart;
    double square = 0, along = 0, length = 0;
    for (std::size_t k = 0; k < a.point.size(); ++k)
    {
      const double d = p.point[k] - a.point[k], e = b.point[k] - a.point[k];
      square += d * d;
      along += d * e;
      length += e * e;
    }
    const double t = along / length; // of the way
    const double off = std::sqrt((std::max)(square / length - t * t, 0.));
    if (on == side && t > 0.1 && t < 0.9 && off < nearest &&
        angle_between(p, a).cosine > 0.3 && angle_between(p, b).cosine > 0.3)
    {
      best = ends;
      nearest = off;
    }
  }
  return best;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BORDER_BESIDE_H
