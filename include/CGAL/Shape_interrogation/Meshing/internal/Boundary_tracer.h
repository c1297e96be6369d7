// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUNDARY_TRACER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUNDARY_TRACER_H

// Puts vertices on the curves in which a surface in n-space meets its bounds.

#include <CGAL/Shape_interrogation/Meshing/internal/N_space_cover.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Path_tracer.h>
#include <CGAL/Shape_interrogation/Meshing/internal/border_beside.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Go_on>
class Boundary_tracer
{
public:
  Boundary_tracer(const N_space_system& system, N_space_cover& cover, Go_on go_on)
    : m_system(system), m_cover(cover), m_go_on(go_on)
  {}

  // Sees to it that the boundary near a vertex that comes near the given side is traced. Returns
  // false if there is no boundary of the surface near.
  bool require(const Cover_vertex& near, int side)
  {
    const Result<Cover_vertex> landed = land(near, side);
    if (!landed)
      return false;
    if (has_boundary_near(landed->chart, side, 0.75) || put_between(*landed, side))
      return true;
    trace_from(*landed, side);
    while (!m_corners.empty())
    {
      const auto [corner, next_side] = m_corners.back();
      m_corners.pop_back();
      m_go_on();
      if (!m_traced.insert({corner, next_side}).second)
        continue;
      const Cover_vertex start = m_cover.vertices()[corner];
      if (!has_boundary_near(start.chart, next_side, 1.3, corner))
        trace_from(start, next_side, corner);
      else if (!has_border(corner, next_side))
        m_cover.add_loose_end(corner); // what is near there may be another corner
    }
    return true;
  }

  // Puts a vertex into the middle between two that follow each other on a bound. Returns false if
  // they do not.
  bool split(int a, int b)
  {
    const auto border = m_cover.borders().find(std::minmax(a, b));
    if (border == m_cover.borders().end())
      return false;
    const N_space_chart &chart = m_cover.vertices()[a].chart, &other = m_cover.vertices()[b].chart;
    std::vector<double> middle = chart.point;
    for (std::size_t k = 0; k < middle.size(); ++k)
      middle[k] = (middle[k] + other.point[k]) / 2;
    Result<Cover_vertex> v = correct_on(middle, border->second);
    if (!v)
      return false;
    Cover_vertex w = *v;
    double turning;
    m_cover.fit(w, chart, turning);
    return put_between(w, border->second);
  }

private:
  // Where vertices that follow each other are far apart for the size that is needed now, another
  // one comes between them. (To trace the curve again would put a second row beside the first.)
  bool put_between(const Cover_vertex& v, int side)
  {
    const std::pair<int, int> border = border_beside(m_cover, v.chart, side);
    if (border.first < 0)
      return false;
    m_cover.split_border(border.first, border.second, m_cover.insert(v));
    return true;
  }

  static std::uint64_t bit(int side) { return std::uint64_t(1) << side; }

  Result<Cover_vertex> land(const Cover_vertex& near, int side)
  {
    const Bound_side& s = m_cover.sides()[side];
    Result<Cover_vertex> landed = correct_on(near.chart.point, side);
    if (!landed)
      return landed;
    if (length(place_in(near.chart, landed->chart.point).at) > 1.8)
      return Refusal(Refusal_code::OUTSIDE_DOMAIN, "the bound is far");
    for (const Bound_side& other : m_cover.sides())
      if (&other != &s && other.distance(landed->chart.point) < 0)
        return Refusal(Refusal_code::OUTSIDE_DOMAIN, "another bound is nearer");
    Cover_vertex v = *landed;
    double turning;
    m_cover.fit(v, near.chart, turning);
    return v;
  }

  Result<Cover_vertex> correct_on(const std::vector<double>& p, int side)
  {
    const Bound_side& s = m_cover.sides()[side];
    Result<Cover_vertex> v = m_cover.correct(p, {s.condition(p.size())});
    if (!v)
      return v;
    Cover_vertex w = *v;
    w.chart.point[s.variable] = s.value;
    w.sides = bit(side);
    return w;
  }

  bool has_border(int vertex, int side) const
  {
    return std::any_of(m_cover.borders().begin(), m_cover.borders().end(), [&](const auto& b) {
      return b.second == side && (b.first.first == vertex || b.first.second == vertex);
    });
  }

  bool has_boundary_near(const N_space_chart& chart, int side, double radius, int except = -1) const
  {
    // What lies across belongs to another branch, the other side of a strip for example.
    const Chart_vector g = gradient_of_variable(chart, m_cover.sides()[side].variable);
    bool found = false;
    m_cover.for_each_near(chart, radius, [&](const Near_vertex& v) {
      const double across = std::fabs(v.at[0] * g[0] + v.at[1] * g[1]);
      found |= v.vertex != except && (m_cover.vertices()[v.vertex].sides & bit(side)) != 0 &&
               across <= (0.6 * length(v.at) + 1e-6) * length(g);
    });
    return found;
  }

  // Traces the boundary curve through a point, which is a vertex already if it is a corner.
  void trace_from(const Cover_vertex& start, int side, int corner = -1)
  {
    Path_limits limits;
    limits.cos_turning = std::cos(m_cover.max_turning());
    limits.stops_at_branches = true;
    Path_tracer tracer(m_system, {m_cover.sides()[side].condition(start.chart.point.size())},
                       m_cover.sides(), limits);
    const Result<Path_point> p = tracer.start(start.chart.point);
    if (!p)
      return;
    Path_point s = *p;
    s.point = start.chart.point;
    std::vector<Cover_vertex> curve{start};
    bool is_closed = false;
    for (int direction = 0; direction < 2 && !is_closed; ++direction)
    {
      if (direction == 1)
      {
        std::reverse(curve.begin(), curve.end());
        for (double& x : s.tangent)
          x = -x;
      }
      if (corner < 0 || goes_inside(s, start.sides & ~bit(side)))
        is_closed = follow(tracer, s, side, curve);
    }
    const bool keeps_front = corner >= 0 || is_corner(curve.front());
    thin(curve, keeps_front, is_corner(curve.back()));
    std::vector<int> vertices;
    for (const Cover_vertex& v : curve)
      vertices.push_back(add(v, side));
    for (std::size_t i = 1; i < vertices.size(); ++i)
      m_cover.add_border(vertices[i - 1], vertices[i], side);
    if (is_closed)
      m_cover.add_border(vertices.back(), vertices.front(), side);
    else
      for (const Cover_vertex* end : {&curve.front(), &curve.back()})
        if (!is_corner(*end))
          m_cover.add_loose_end(end == &curve.front() ? vertices.front() : vertices.back());
    for (const auto& [point, evidence] : m_singular_ends)
      for (int v = static_cast<int>(m_cover.vertices().size()); v-- > 0;)
        if (m_cover.vertices()[v].chart.point == point)
        {
          m_cover.stop(v, Refusal_code::RANK_DEFICIENT, "on a bound: " + evidence);
          break;
        }
    m_singular_ends.clear();
  }

  bool is_corner(const Cover_vertex& v) const { return (v.sides & (v.sides - 1)) != 0; }

  bool goes_inside(const Path_point& p, std::uint64_t sides) const
  {
    for (std::size_t i = 0; i < m_cover.sides().size(); ++i)
      if (sides & bit(static_cast<int>(i)))
      {
        const Bound_side& s = m_cover.sides()[i];
        if (s.sign * p.tangent[s.variable] <= 0)
          return false;
      }
    return true;
  }

  // Appends the points of a path. Returns whether it is closed.
  bool follow(Path_tracer& tracer, const Path_point& start, int side,
              std::vector<Cover_vertex>& curve)
  {
    N_space_chart chart = curve.back().chart;
    const auto update = [&](const Path_point& p) {
      Result<Cover_vertex> v = correct_on(p.point, side);
      if (!v)
        return;
      Cover_vertex w = *v;
      double turning;
      m_cover.fit(w, chart, turning);
      chart = w.chart;
    };
    const Path path = tracer.trace(start, [&](const Path_point& p) {
      update(p);
      return 0.85 * chart.unit();
    }, m_go_on);
    chart = curve.back().chart;
    for (std::size_t i = 0; i < path.points.size(); ++i)
    {
      Result<Cover_vertex> v = correct_on(path.points[i].point, side);
      if (!v)
        continue;
      Cover_vertex w = *v;
      double turning;
      m_cover.fit(w, chart, turning);
      chart = w.chart;
      if (path.end == Path_end::BOUND && i + 1 == path.points.size())
      {
        const Bound_side& end = m_cover.sides()[path.side];
        w.chart.point[end.variable] = end.value;
        w.sides |= bit(path.side);
      }
      curve.push_back(w);
    }
    if (path.end == Path_end::SINGULAR)
      m_singular_ends.push_back({curve.back().chart.point, path.evidence});
    return path.end == Path_end::CLOSED;
  }

  // Removes points that are too near to an end that stays.
  static void thin(std::vector<Cover_vertex>& curve, bool keeps_front, bool keeps_back)
  {
    const auto is_near = [](const Cover_vertex& a, const Cover_vertex& b) {
      return length(place_in(a.chart, b.chart.point).at) < 0.45;
    };
    if (keeps_back && curve.size() > 2 && is_near(curve.back(), curve[curve.size() - 2]))
      curve.erase(curve.end() - 2);
    if (keeps_front && curve.size() > 2 && is_near(curve.front(), curve[1]))
      curve.erase(curve.begin() + 1);
  }

  // Corners are shared by the curves that end there. Returns the index.
  int add(const Cover_vertex& v, int side)
  {
    if (!is_corner(v))
      return m_cover.insert(v);
    int corner = -1;
    m_cover.for_each_near(v.chart, 0.3, [&](const Near_vertex& near) {
      const std::uint64_t sides = m_cover.vertices()[near.vertex].sides;
      if ((sides & v.sides) == v.sides || (sides != 0 && near.distance < 1e-6))
        corner = near.vertex;
    });
    if (corner < 0)
      corner = m_cover.insert(v);
    else
      m_cover.add_sides(corner, v.sides);
    for (int i = 0; i < static_cast<int>(m_cover.sides().size()); ++i)
      if (i != side && (v.sides & bit(i)))
        m_corners.emplace_back(corner, i);
    return corner;
  }

  const N_space_system& m_system;
  N_space_cover& m_cover;
  Go_on m_go_on;
  std::vector<std::pair<int, int>> m_corners; // with the side still to be traced
  std::vector<std::pair<std::vector<double>, std::string>> m_singular_ends;
  std::set<std::pair<int, int>> m_traced;     // of these
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BOUNDARY_TRACER_H
