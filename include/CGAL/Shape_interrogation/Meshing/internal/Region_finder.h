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
// is asked for at the centre of one of them, far from constraints.

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

// The number of edges from each vertex to the next constraint inside of the square.
inline std::vector<int> distances_from_constraints(const Domain_triangulation& t)
{
  std::vector<int> distance(t.points.size(), 0), waiting;
  std::vector<bool> is_known(t.points.size(), false);
  std::vector<std::vector<int>> beside(t.points.size());
  for (const Domain_triangle& triangle : t.triangles)
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangle.corners[(k + 1) % 3], b = triangle.corners[(k + 2) % 3];
      beside[a].push_back(b);
      beside[b].push_back(a);
      for (const int corner : {a, b})
        if (triangle.is_constrained[k] && triangle.neighbours[k] >= 0 && !is_known[corner])
        {
          is_known[corner] = true;
          waiting.push_back(corner);
        }
    }
  for (std::size_t i = 0; i < waiting.size(); ++i)
    for (const int next : beside[waiting[i]])
      if (!is_known[next])
      {
        is_known[next] = true;
        distance[next] = distance[waiting[i]] + 1;
        waiting.push_back(next);
      }
  return distance;
}

// The triangles in the order in which they are asked: the sum of the distances of the corners, then
// the circle inside, the greatest first.
inline std::vector<std::size_t> order_of_asking(const Domain_triangulation& t,
                                                std::vector<Domain_point>& centers)
{
  const std::vector<int> distance = distances_from_constraints(t);
  std::vector<std::pair<std::pair<int, double>, std::size_t>> keys; // negative
  for (std::size_t i = 0; i < t.triangles.size(); ++i)
  {
    const auto& c = t.triangles[i].corners;
    const Incircle circle(t.points[c[0]], t.points[c[1]], t.points[c[2]]);
    keys.push_back({{-distance[c[0]] - distance[c[1]] - distance[c[2]], -circle.radius}, i});
    centers.push_back(circle.center);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  for (const auto& key : keys)
    order.push_back(key.second);
  return order;
}

// `classify(point)` returns a region or `unresolved_region`, then the next triangle is tried. None
// is tried in unresolved boxes.
template <class Classify>
std::vector<int> regions_of(const Domain_triangulation& t, const Contour_2& contour,
                            const Domain_options& options, Classify classify)
{
  const std::vector<int> set = joined_triangles(
    t.triangles, [&](int i, int k) { return !t.triangles[i].is_constrained[k]; });
  std::vector<Domain_point> centers;
  const std::vector<std::size_t> order = order_of_asking(t, centers);
  const auto is_unresolved = [&](const Domain_point& p) {
    return std::any_of(contour.unresolved.begin(), contour.unresolved.end(), [&](const auto& b) {
      return !Domain_triangulation::is_point(b, options) && p[0] >= b.low[0] &&
             p[0] <= b.high[0] && p[1] >= b.low[1] && p[1] <= b.high[1];
    });
  };
  std::vector<int> region(t.triangles.size(), unresolved_region); // of each set
  std::vector<int> tries(t.triangles.size(), 0);
  for (const std::size_t i : order)
  {
    const int s = set[i];
    if (region[s] == unresolved_region && tries[s]++ < 16 && !is_unresolved(centers[i]))
      region[s] = classify(centers[i]);
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
