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
#include <unordered_set>
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

// A cover leaves no empty circle much larger than 1. Along bounds, vertices can lie nearly on a
// line, and triangles are flat.
inline bool is_too_large(const N_space_cover& cover, const std::array<int, 3>& t, double radius)
{
  const auto& vertices = cover.vertices();
  for (int v : t)
    if (vertices[v].sides == 0)
      return radius > 1.15;
  for (int i = 0; i < 3; ++i)
    if (length(place_in(vertices[t[i]].chart, vertices[t[(i + 1) % 3]].chart.point).at) > 1.8)
      return true;
  return false;
}

// Each triangle once, with the number of its vertices that have it in their Delaunay triangulation.
template <class Go_on>
std::vector<Candidate_triangle> candidate_triangles(const N_space_cover& cover, Go_on go_on)
{
  std::vector<Candidate_triangle> all;
  for (int p = 0; p < static_cast<int>(cover.vertices().size()); ++p)
  {
    go_on();
    const Voronoi_cell cell = cell_of(cover, p, 1000);
    for (const Voronoi_cell::Corner& c : cell.corners())
    {
      if (c.before < 0 || c.after < 0 || c.before == c.after)
        continue;
      // A surface that cannot be oriented is cut where its charts disagree.
      const N_space_chart& chart = cover.vertices()[p].chart;
      if (angle_between(chart, cover.vertices()[c.before].chart).is_reversed ||
          angle_between(chart, cover.vertices()[c.after].chart).is_reversed)
        continue;
      const auto unit = [&](int v) { return cover.vertices()[v].chart.unit(); };
      const double radius =
        std::hypot(c.x, c.y) * 3 * unit(p) / (unit(p) + unit(c.before) + unit(c.after));
      if (is_too_large(cover, {p, c.before, c.after}, radius))
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
  bool add(const std::array<int, 3>& t, bool is_agreed = false)
  {
    for (int i = 0; i < 3; ++i)
      if (has_side(t[i], t[(i + 1) % 3]))
        return false;
    for (int i = 0; i < 3; ++i)
      m_sides.insert(key(t[i], t[(i + 1) % 3]));
    m_triangles.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
    m_is_agreed.push_back(is_agreed);
    return true;
  }

  const std::vector<Soup_triangle>& triangles() const { return m_triangles; }

  // Fills small holes that neither a bound nor a stop explains. Around those that cannot be filled,
  // triangles that not all charts agreed on are taken away first, then all.
  void fill_holes()
  {
    for (int round = 0; round < 4; ++round)
    {
      std::vector<bool> is_open(m_cover.vertices().size(), false);
      bool any = false;
      for (std::vector<int> hole : holes())
      {
        while (hole.size() >= 3 && cut_ear(hole))
          ;
        for (int v : hole)
          any = is_open[v] = true;
      }
      if (!any || round == 3)
        return;
      take_away(is_open, round == 0);
    }
  }

private:
  static std::uint64_t key(int a, int b)
  {
    return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b);
  }

  bool has_side(int a, int b) const { return m_sides.count(key(a, b)) != 0; }

  void take_away(const std::vector<bool>& is_open, bool keeps_agreed)
  {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      const Soup_triangle& corners = m_triangles[t];
      const bool is_beside = is_open[corners[0]] || is_open[corners[1]] || is_open[corners[2]];
      if (is_beside && !(keeps_agreed && m_is_agreed[t]))
        for (int i = 0; i < 3; ++i)
          m_sides.erase(key(int(corners[i]), int(corners[(i + 1) % 3])));
      else
      {
        m_triangles[kept] = corners;
        m_is_agreed[kept++] = m_is_agreed[t];
      }
    }
    m_triangles.resize(kept);
    m_is_agreed.resize(kept);
  }

  // A border without a triangle, in the direction that its triangle needs.
  std::pair<int, int> with_inside_left(const std::pair<int, int>& border, int side) const
  {
    const auto& [a, b] = border;
    const Bound_side& bound = m_cover.sides()[side];
    const N_space_chart& chart = m_cover.vertices()[a].chart;
    const Chart_vector along = place_in(chart, m_cover.vertices()[b].chart.point).at;
    const Chart_vector g = gradient_of_variable(chart, bound.variable);
    const double left = bound.sign * (along[0] * g[1] - along[1] * g[0]);
    return left > 0 ? border : std::make_pair(b, a);
  }

  // Chains of sides without a neighbour, in the direction that their triangles need, with those on
  // bounds that have no triangle at all. They are closed, or can be by a side on a bound where that
  // was not traced.
  std::vector<std::vector<int>> holes() const
  {
    constexpr std::size_t longest = 16;
    std::vector<std::pair<int, int>> open;
    for (const Soup_triangle& t : m_triangles)
      for (int i = 0; i < 3; ++i)
      {
        const int a = int(t[i]), b = int(t[(i + 1) % 3]);
        if (!has_side(b, a) && !m_cover.is_border(a, b))
          open.emplace_back(b, a);
      }
    for (const auto& [border, side] : m_cover.borders())
      if (!has_side(border.first, border.second) && !has_side(border.second, border.first))
        open.push_back(with_inside_left(border, side));
    std::unordered_map<int, std::vector<int>> next;
    std::unordered_set<int> ended; // by a side
    for (const auto& [a, b] : open)
    {
      next[a].push_back(b);
      ended.insert(b);
    }
    std::vector<std::vector<int>> result;
    for (const auto& [a, b] : open)
    {
      std::vector<int> hole{a};
      int before = a, v = b;
      while (v != a && hole.size() < longest && next.count(v))
      {
        hole.push_back(v);
        const int after = next_corner(before, v, next[v]);
        before = v;
        v = after;
      }
      const bool is_stopped =
        std::any_of(hole.begin(), hole.end(), [&](int corner) { return m_is_stop[corner]; });
      const bool is_closed = v == a && *std::min_element(hole.begin(), hole.end()) == a;
      if (v != a && hole.size() < longest)
        hole.push_back(v);
      const bool lacks_bound = v != a && !ended.count(a) && m_cover.is_border(v, a) &&
                               !has_side(v, a) && !has_side(a, v);
      if ((is_closed || lacks_bound) && !is_stopped && hole.size() >= 3)
        result.push_back(hole);
    }
    return result;
  }

  // Where holes touch each other: the end of the side that bounds the same hole, which is to the
  // left of its sides.
  int next_corner(int before, int v, const std::vector<int>& ends) const
  {
    if (ends.size() == 1)
      return ends[0];
    const N_space_chart& chart = m_cover.vertices()[v].chart;
    const auto direction = [&](int u) {
      const Chart_vector at = place_in(chart, m_cover.vertices()[u].chart.point).at;
      return std::atan2(at[1], at[0]);
    };
    const double full = 2 * std::acos(-1.), incoming = direction(before);
    const auto opening = [&](int u) {
      const double angle = std::fmod(incoming - direction(u) + 2 * full, full);
      return angle > 0 ? angle : full;
    };
    return *std::min_element(ends.begin(), ends.end(),
                             [&](int a, int b) { return opening(a) < opening(b); });
  }

  // Cuts off the corner whose triangle has the shortest new side among those that can be.
  bool cut_ear(std::vector<int>& hole)
  {
    const std::size_t n = hole.size();
    std::vector<std::pair<double, std::size_t>> ears;
    for (std::size_t i = 0; i < n; ++i)
    {
      const N_space_chart& chart = m_cover.vertices()[hole[i]].chart;
      const Chart_vector a =
        place_in(chart, m_cover.vertices()[hole[(i + n - 1) % n]].chart.point).at;
      const Chart_vector c = place_in(chart, m_cover.vertices()[hole[(i + 1) % n]].chart.point).at;
      if (c[0] * a[1] - c[1] * a[0] > 0) // counterclockwise
        ears.emplace_back(std::hypot(a[0] - c[0], a[1] - c[1]) * chart.unit(), i);
    }
    std::sort(ears.begin(), ears.end());
    for (const auto& [side, i] : ears)
      if (add({hole[(i + n - 1) % n], hole[i], hole[(i + 1) % n]}))
      {
        if (n == 3)
          hole.clear();
        else
          hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    return false;
  }

  const N_space_cover& m_cover;
  std::vector<bool> m_is_stop;
  std::unordered_set<std::uint64_t> m_sides; // directed
  std::vector<Soup_triangle> m_triangles;
  std::vector<bool> m_is_agreed; // by the charts of all three corners
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_VOTES_H
