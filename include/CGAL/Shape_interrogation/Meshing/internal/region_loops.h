// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_LOOPS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_LOOPS_H

// The boundaries of the parts of regions as closed polygons with the part on the left.

#include <CGAL/Shape_interrogation/Meshing/internal/Domain_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Region_loops
{
public:
  Region_loops(const Domain_triangulation& t, const std::vector<int>& regions,
               const std::vector<int>& parts)
    : m_t(t), m_regions(regions), m_parts(parts), m_is_used(3 * t.triangles.size(), false)
  {}

  std::vector<Region_loop> operator()()
  {
    std::vector<Region_loop> loops;
    for (int t = 0; t < static_cast<int>(m_t.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k)
        if (is_boundary(t, k) && !m_is_used[3 * t + k])
          loops.push_back(follow(t, k));
    std::stable_sort(loops.begin(), loops.end(), [](const Region_loop& a, const Region_loop& b) {
      return std::make_pair(a.part, -a.signed_area) < std::make_pair(b.part, -b.signed_area);
    });
    return loops;
  }

private:
  bool is_boundary(int t, int k) const
  {
    const int next = m_t.triangles[t].neighbours[k];
    return next < 0 || m_parts[next] != m_parts[t];
  }

  // From the edge k of a triangle, which runs from corner k + 1 to corner k + 2.
  Region_loop follow(int t, int k)
  {
    Region_loop loop;
    loop.region = m_regions[t];
    loop.part = m_parts[t];
    while (!m_is_used[3 * t + k])
    {
      m_is_used[3 * t + k] = true;
      loop.points.push_back(m_t.points[m_t.triangles[t].corners[(k + 1) % 3]]);
      const int pivot = m_t.triangles[t].corners[(k + 2) % 3];
      k = (k + 1) % 3; // the edge that leaves the end
      while (!is_boundary(t, k))
      {
        t = m_t.triangles[t].neighbours[k];
        const auto& corners = m_t.triangles[t].corners;
        k = static_cast<int>(std::find(corners.begin(), corners.end(), pivot) - corners.begin());
        k = (k + 2) % 3;
      }
    }
    loop.signed_area = signed_area(loop.points);
    return loop;
  }

  static double signed_area(const std::vector<Domain_point>& p)
  {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      const Domain_point &a = p[i], &b = p[(i + 1) % p.size()], &o = p.front();
      twice += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    return twice / 2;
  }

  const Domain_triangulation& m_t;
  const std::vector<int>&m_regions, &m_parts;
  std::vector<bool> m_is_used; // of the edge k of triangle t at 3 t + k
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_LOOPS_H
