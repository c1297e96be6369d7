// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_COVER_GROWTH_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_COVER_GROWTH_H

// Lets a cover grow from its vertices: where the directions to two neighbours leave a gap, new ones
// are put at the distance one, which leads to triangles that are nearly equilateral; then into the
// middle of what is still empty.

#include <CGAL/Shape_interrogation/Meshing/internal/Boundary_tracer.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Branch_detector.h>
#include <CGAL/Shape_interrogation/Meshing/internal/N_space_cover.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Voronoi_cell.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The Voronoi cell of a vertex in its chart among the vertices near it, in a square frame.
inline Voronoi_cell cell_of(const N_space_cover& cover, int vertex, double frame)
{
  Voronoi_cell cell(frame);
  std::vector<Near_vertex> near = cover.near(vertex, 2.4);
  std::sort(near.begin(), near.end(), [](const Near_vertex& a, const Near_vertex& b) {
    return length(a.at) < length(b.at);
  });
  for (const Near_vertex& v : near)
    cell.add(v.at[0], v.at[1], v.vertex);
  return cell;
}

template <class Go_on>
class Cover_growth
{
public:
  Cover_growth(const N_space_system& system, N_space_cover& cover, Go_on go_on)
    : m_cover(cover), m_boundary(system, cover, go_on), m_go_on(go_on),
      m_branches(system, {}, system.number_of_variables() - 2)
  {}

  // Covers the component of a surface point, unless it is covered. Returns false if it is.
  bool start(Cover_vertex v)
  {
    if (m_cover.has_within(v.chart, 1.2))
      return false;
    if (touches_bound(v))
      grow();
    else
    {
      m_cover.insert(std::move(v));
      grow();
    }
    return true;
  }

private:
  enum class Outcome { DONE, SHRUNK };

  // Later vertices change the surroundings of earlier ones, so all are looked at again.
  void grow()
  {
    constexpr int most_rounds = 3;
    for (int round = 0; round < most_rounds; ++round)
    {
      const std::size_t before = m_cover.vertices().size();
      for (std::size_t checked = m_first; checked <= m_cover.vertices().size(); ++checked)
      {
        while (const auto vertex = m_cover.next())
        {
          if (m_cover.is_full() || !m_go_on())
            return;
          expand(*vertex);
        }
        if (checked < m_cover.vertices().size())
          fill(static_cast<int>(checked));
      }
      if (round > 0 && m_cover.vertices().size() == before)
        break;
    }
    m_first = m_cover.vertices().size();
  }

  void expand(int vertex)
  {
    for (int attempt = 0; attempt < 12; ++attempt)
    {
      bool is_done = true;
      for (const Chart_vector& c : directions_of_gaps(vertex))
        if (try_at(vertex, c) == Outcome::SHRUNK)
        {
          is_done = false;
          break;
        }
      if (is_done)
        return;
    }
  }

  // Unit vectors that part the gaps between the neighbours evenly.
  std::vector<Chart_vector> directions_of_gaps(int vertex) const
  {
    const double pi = std::acos(-1.);
    std::vector<double> angles;
    for (const Near_vertex& v : m_cover.near(vertex, 1.45))
      angles.push_back(std::atan2(v.at[1], v.at[0]));
    std::sort(angles.begin(), angles.end());
    if (angles.empty())
      angles.push_back(0.1 * vertex);
    std::vector<Chart_vector> directions;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * pi;
      const double gap = next - angles[i];
      const int parts = static_cast<int>(std::lround(gap / (pi / 3)));
      for (int k = 1; k < parts; ++k)
      {
        const double a = angles[i] + gap * k / parts;
        directions.push_back({std::cos(a), std::sin(a)});
      }
    }
    return directions;
  }

  // Makes the surroundings of a vertex finer if the plane turns too much along an edge. Puts a
  // vertex into the largest empty circle there if that is too large.
  void fill(int vertex)
  {
    for (int attempt = 0; attempt < 12; ++attempt)
    {
      const Voronoi_cell cell = cell_of(m_cover, vertex, 1.6);
      const auto [turning, farther] = largest_turning(vertex, cell);
      if (turning > 0.9 * m_cover.max_turning() && m_boundary.split(vertex, farther))
        continue;
      if (turning > 0.9 * m_cover.max_turning() &&
          m_cover.shrink(vertex, 0.8 * m_cover.max_turning() / turning))
      {
        expand(vertex);
        continue;
      }
      const Voronoi_cell::Corner* farthest = nullptr;
      double largest = 0;
      for (const Voronoi_cell::Corner& c : cell.corners())
        if (c.before >= 0 && c.after >= 0)
        {
          const double radius = std::hypot(c.x, c.y) / mean_unit(vertex, c);
          if (radius > largest)
          {
            largest = radius;
            farthest = &c;
          }
        }
      if (largest < 0.85)
        return;
      const std::size_t before = m_cover.vertices().size();
      const double r = std::hypot(farthest->x, farthest->y), limited = (std::min)(r, 1.);
      if (try_at(vertex, {farthest->x * limited / r, farthest->y * limited / r}) ==
            Outcome::DONE && m_cover.vertices().size() == before)
        return;
    }
  }

  // The largest turning along an edge, and the vertex at the other end.
  std::pair<double, int> largest_turning(int vertex, const Voronoi_cell& cell) const
  {
    std::pair<double, int> largest(0, vertex);
    for (const Voronoi_cell::Corner& c : cell.corners())
      for (int other : {c.before, c.after})
        if (other >= 0)
          largest = (std::max)(largest, {std::acos(angle_between(
            m_cover.vertices()[vertex].chart, m_cover.vertices()[other].chart).cosine), other});
    return largest;
  }

  double mean_unit(int vertex, const Voronoi_cell::Corner& c) const
  {
    const auto unit = [&](int v) { return m_cover.vertices()[v].chart.unit(); };
    return (1 + (unit(c.before) + unit(c.after)) / unit(vertex)) / 3;
  }

  Outcome try_at(int vertex, const Chart_vector& c)
  {
    const Cover_vertex& parent = m_cover.vertices()[vertex];
    if (leads_outside(parent, c))
      return Outcome::DONE;
    const Result<Cover_vertex> corrected = m_cover.correct(point_at(parent.chart, c));
    if (!corrected)
      return shrink(vertex, 0.5, corrected.refusal());
    Cover_vertex v = *corrected;
    const Chart_place place = place_in(parent.chart, v.chart.point);
    const double off = std::hypot(place.at[0] - c[0], place.at[1] - c[1]);
    if (off > 0.35 || place.across > 0.7)
      return shrink(vertex, 0.5, Refusal(Refusal_code::RANK_DEFICIENT,
                                         "the surface leaves its tangent plane too fast"));
    double turning;
    if (!m_cover.fit(v, parent.chart, turning))
      return shrink(vertex, 0.8 * m_cover.max_turning() / turning,
                    Refusal(Refusal_code::RANK_DEFICIENT, "the tangent plane turns too fast"));
    // Near a singular point, where units are small, a step can go straight through it.
    if (parent.chart.size < 0.25 && m_branches.is_able() && m_branches.is_square() &&
        m_branches.may_branch(parent.chart.point, {parent.chart.basis[0], parent.chart.basis[1]},
                              v.chart.point, {v.chart.basis[0], v.chart.basis[1]}))
      return shrink(vertex, 0.5, Refusal(Refusal_code::RANK_DEFICIENT,
                                         "the equations become dependent on the way"));
    if (!touches_bound(v) && !m_cover.has_within(v.chart, N_space_cover::closest))
      m_cover.insert(std::move(v));
    return Outcome::DONE;
  }

  Outcome shrink(int vertex, double factor, const Refusal& reason)
  {
    if (m_cover.shrink(vertex, factor))
      return Outcome::SHRUNK;
    m_cover.stop(vertex, reason.code(), reason.evidence());
    return Outcome::DONE;
  }

  // From a bound only the inside is looked at.
  bool leads_outside(const Cover_vertex& v, const Chart_vector& c) const
  {
    for (std::size_t i = 0; i < m_cover.sides().size(); ++i)
      if (v.sides >> i & 1)
      {
        const Bound_side& s = m_cover.sides()[i];
        const Chart_vector g = gradient_of_variable(v.chart, s.variable);
        if (s.sign * (g[0] * c[0] + g[1] * c[1]) < 0.3 * length(g))
          return true;
      }
    return false;
  }

  // Whether the vertex lies outside of a bound or so near that the bound has the vertices there.
  bool touches_bound(const Cover_vertex& v)
  {
    bool touches = false;
    for (std::size_t i = 0; i < m_cover.sides().size(); ++i)
    {
      const Bound_side& s = m_cover.sides()[i];
      const double d = s.distance(v.chart.point);
      const double limit =
        N_space_cover::from_bound * length(gradient_of_variable(v.chart, s.variable));
      if (d >= limit)
        continue;
      const bool has_boundary = m_boundary.require(v, static_cast<int>(i));
      touches = touches || has_boundary || d < 0;
    }
    return touches;
  }

  N_space_cover& m_cover;
  Boundary_tracer<Go_on> m_boundary;
  Go_on m_go_on;
  Branch_detector m_branches;
  std::size_t m_first = 0; // vertex of the component
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_COVER_GROWTH_H
