// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_VOTES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_VOTES_H

// Chooses triangles of a cover so that they form a manifold: those first on which the Delaunay
// triangulations in the charts of all three vertices agree.

#include <CGAL/Shape_interrogation/Meshing/internal/Cover_growth.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Candidate_triangle
{
  std::array<int, 3> corners; // counterclockwise, the least index first
  int votes = 0;
  double radius = 0; // of the circumcircle, in units
};

// Each triangle once, with the number of its vertices that have it in their Delaunay triangulation.
template <class Go_on>
std::vector<Candidate_triangle> candidate_triangles(const N_space_cover& cover, Go_on go_on)
{
  constexpr double largest_radius = 1.15;
  std::vector<Candidate_triangle> all;
  for (int p = 0; p < static_cast<int>(cover.vertices().size()); ++p)
  {
    go_on();
    const Voronoi_cell cell = cell_of(cover, p);
    for (const Voronoi_cell::Corner& c : cell.corners())
    {
      if (c.before < 0 || c.after < 0 || c.before == c.after)
        continue;
      const auto unit = [&](int v) { return cover.vertices()[v].chart.unit(); };
      const double radius =
        std::hypot(c.x, c.y) * 3 * unit(p) / (unit(p) + unit(c.before) + unit(c.after));
      if (radius > largest_radius)
        continue;
      std::array<int, 3> t{p, c.before, c.after};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      all.push_back({t, 1, radius});
    }
  }
  std::sort(all.begin(), all.end(), [](const Candidate_triangle& a, const Candidate_triangle& b) {
    return std::tie(a.corners, a.radius) < std::tie(b.corners, b.radius);
  });
  std::vector<Candidate_triangle> unique;
  for (const Candidate_triangle& t : all)
    if (unique.empty() || unique.back().corners != t.corners)
      unique.push_back(t);
    else
      ++unique.back().votes;
  return unique;
}

class Triangle_assembly
{
public:
  explicit Triangle_assembly(const N_space_cover& cover)
    : m_cover(cover), m_is_stop(cover.vertices().size(), false)
  {
    for (const Cover_stop& s : cover.stops())
      m_is_stop[s.vertex] = true;
  }

  // Adds a triangle if none of its sides is taken in this direction.
  bool add(const std::array<int, 3>& t)
  {
    for (int i = 0; i < 3; ++i)
      if (m_sides.count(key(t[i], t[(i + 1) % 3])))
        return false;
    for (int i = 0; i < 3; ++i)
      m_sides[key(t[i], t[(i + 1) % 3])] = 1;
    m_triangles.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
    return true;
  }

  const std::vector<Soup_triangle>& triangles() const { return m_triangles; }

  // Fills small holes that neither a bound nor a stop explains.
  void fill_holes()
  {
    for (std::vector<int> hole : holes())
      while (hole.size() >= 3 && cut_ear(hole))
        ;
  }

private:
  static std::uint64_t key(int a, int b)
  {
    return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b);
  }

  bool has_side(int a, int b) const { return m_sides.count(key(a, b)) != 0; }

  bool is_on_bound(int a, int b) const
  {
    return (m_cover.vertices()[a].sides & m_cover.vertices()[b].sides) != 0;
  }

  // Closed chains of sides without a neighbour, in the direction that their triangles need.
  std::vector<std::vector<int>> holes() const
  {
    constexpr std::size_t longest = 16;
    std::vector<std::pair<int, int>> open;
    for (const Soup_triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
      {
        const int a = int(t[i]), b = int(t[(i + 1) % 3]);
        if (!has_side(b, a) && !is_on_bound(a, b))
          open.emplace_back(b, a);
      }
    std::unordered_map<int, std::vector<int>> next;
    for (const auto& [a, b] : open)
      next[a].push_back(b);
    std::vector<std::vector<int>> result;
    for (const auto& [a, b] : open)
    {
      std::vector<int> hole{a};
      int v = b;
      while (v != a && hole.size() < longest && next.count(v) && next[v].size() == 1)
      {
        hole.push_back(v);
        v = next[v][0];
      }
      const bool is_stopped =
        std::any_of(hole.begin(), hole.end(), [&](int corner) { return m_is_stop[corner]; });
      if (v == a && !is_stopped && hole.size() >= 3 && *std::min_element(hole.begin(), hole.end()) == a)
        result.push_back(hole);
    }
    return result;
  }

  // Cuts off the corner whose triangle has the shortest new side, if it is counterclockwise.
  bool cut_ear(std::vector<int>& hole)
  {
    const std::size_t n = hole.size();
    std::size_t best = n;
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < n; ++i)
    {
      const int a = hole[(i + n - 1) % n], b = hole[i], c = hole[(i + 1) % n];
      const N_space_chart& chart = m_cover.vertices()[b].chart;
      const Chart_vector pa = place_in(chart, m_cover.vertices()[a].chart.point).at;
      const Chart_vector pc = place_in(chart, m_cover.vertices()[c].chart.point).at;
      const double distance = std::hypot(pa[0] - pc[0], pa[1] - pc[1]);
      // a, b, c counterclockwise: at b turn from c to a.
      if (pc[0] * pa[1] - pc[1] * pa[0] > 0 && distance < shortest)
      {
        shortest = distance;
        best = i;
      }
    }
    if (best == n)
      return false;
    if (!add({hole[(best + n - 1) % n], hole[best], hole[(best + 1) % n]}))
      return false;
    if (n == 3)
      hole.clear();
    else
      hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(best));
    return true;
  }

  const N_space_cover& m_cover;
  std::vector<bool> m_is_stop;
  std::unordered_map<std::uint64_t, char> m_sides;
  std::vector<Soup_triangle> m_triangles;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_VOTES_H
