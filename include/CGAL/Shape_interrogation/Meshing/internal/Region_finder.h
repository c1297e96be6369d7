// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_FINDER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_FINDER_H

// The regions of triangles: those that are connected without crossing a constraint have one, and it
// is asked for at the centre of the largest circle inside of one of them.

#include <CGAL/Shape_interrogation/Meshing/internal/Domain_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Numbers the sets of triangles that are joined by edges with `joins(t, k)`.
template <class Joins>
std::vector<int> joined_triangles(const std::vector<Domain_triangle>& triangles, Joins joins)
{
  std::vector<int> set(triangles.size(), -1), waiting;
  int count = 0;
  for (std::size_t first = 0; first < triangles.size(); ++first)
  {
    if (set[first] >= 0)
      continue;
    set[first] = count;
    waiting.push_back(static_cast<int>(first));
    while (!waiting.empty())
    {
      const int t = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const int next = triangles[t].neighbours[k];
        if (next >= 0 && set[next] < 0 && joins(t, k))
        {
          set[next] = count;
          waiting.push_back(next);
        }
      }
    }
    ++count;
  }
  return set;
}

// The circle inside of a triangle. Its centre is rounded to 52 binary digits behind the point.
struct Incircle
{
  Incircle(const Domain_point& a, const Domain_point& b, const Domain_point& c)
  {
    const auto length = [](const Domain_point& p, const Domain_point& q) {
      return std::hypot(q[0] - p[0], q[1] - p[1]);
    };
    const double x = length(b, c), y = length(c, a), z = length(a, b), sum = x + y + z;
    radius = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / sum;
    for (int k = 0; k < 2; ++k)
    {
      const double middle = (x * a[k] + y * b[k] + z * c[k]) / sum;
      center[k] = std::ldexp(std::round(std::ldexp(middle, 52)), -52);
    }
  }

  Domain_point center;
  double radius;
};

// `classify(point)` returns a region or `unresolved_region`, then the next circle is tried. None is
// tried in unresolved boxes.
template <class Classify>
std::vector<int> regions_of(const Domain_triangulation& t, const Contour_2& contour,
                            const Domain_options& options, Classify classify)
{
  const std::vector<int> set = joined_triangles(
    t.triangles, [&](int i, int k) { return !t.triangles[i].is_constrained[k]; });
  std::vector<std::pair<double, std::size_t>> circles; // of negative radius
  std::vector<Domain_point> centers;
  for (std::size_t i = 0; i < t.triangles.size(); ++i)
  {
    const auto& c = t.triangles[i].corners;
    const Incircle circle(t.points[c[0]], t.points[c[1]], t.points[c[2]]);
    circles.emplace_back(-circle.radius, i);
    centers.push_back(circle.center);
  }
  std::sort(circles.begin(), circles.end());
  const auto is_unresolved = [&](const Domain_point& p) {
    return std::any_of(contour.unresolved.begin(), contour.unresolved.end(), [&](const auto& b) {
      return !Domain_triangulation::is_point(b, options) && p[0] >= b.low[0] &&
             p[0] <= b.high[0] && p[1] >= b.low[1] && p[1] <= b.high[1];
    });
  };
  std::vector<int> region(t.triangles.size(), unresolved_region); // of each set
  std::vector<int> tries(t.triangles.size(), 0);
  for (const auto& circle : circles)
  {
    const int s = set[circle.second];
    if (region[s] == unresolved_region && tries[s]++ < 16 && !is_unresolved(centers[circle.second]))
      region[s] = classify(centers[circle.second]);
  }
  std::vector<int> regions;
  for (const int s : set)
    regions.push_back(region[s]);
  return regions;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_FINDER_H
