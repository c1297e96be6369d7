// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CONTOUR_CHAINS_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CONTOUR_CHAINS_H

// The arcs in the cells joined to curves, with points between; unresolved cells joined to boxes.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/Contours/internal/Cell_arcs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Contour_chains
{
public:
  Contour_chains(const std::vector<Contour_cell>& cells,
                 const std::vector<Contour_vertex>& vertices,
                 const std::vector<Contour_arc>& arcs, double step)
    : m_cells(cells), m_vertices(vertices), m_arcs(arcs), m_step(step), m_at(vertices.size()),
      m_is_used(arcs.size(), false), m_box_of(cells.size(), -1)
  {}

  void operator()(Contour_2& contour)
  {
    m_contour = &contour;
    join_unresolved();
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      if (m_arcs[i].vertices[0] == m_arcs[i].vertices[1])
        contour.isolated_points.push_back(m_vertices[m_arcs[i].vertices[0]].point);
      else
        for (int vertex : m_arcs[i].vertices)
          m_at[vertex].push_back(static_cast<int>(i));
    for (std::size_t vertex = 0; vertex < m_at.size(); ++vertex)
      if (m_at[vertex].size() == 1 && !m_is_used[m_at[vertex].front()])
        follow(static_cast<int>(vertex));
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      if (!m_is_used[i] && m_arcs[i].vertices[0] != m_arcs[i].vertices[1])
        follow(m_arcs[i].vertices[0]);
  }

private:
  void follow(int start)
  {
    Contour_curve_2 curve;
    curve.points.push_back(m_vertices[start].point);
    int vertex = start;
    for (int arc = unused_at(start); arc >= 0; arc = unused_at(vertex))
    {
      m_is_used[arc] = true;
      const bool is_forward = m_arcs[arc].vertices[0] == vertex;
      vertex = m_arcs[arc].vertices[is_forward ? 1 : 0];
      add_points(m_arcs[arc], is_forward, curve.points);
      curve.points.push_back(m_vertices[vertex].point);
      if (vertex == start)
        break;
    }
    curve.is_closed = vertex == start;
    if (curve.is_closed)
      curve.points.pop_back();
    else
      curve.unresolved = {end_at(start), end_at(vertex)};
    m_contour->curves.push_back(std::move(curve));
  }

  int unused_at(int vertex) const
  {
    for (int arc : m_at[vertex])
      if (!m_is_used[arc])
        return arc;
    return -1;
  }

  // The box in which a curve ends, which counts it.
  int end_at(int vertex)
  {
    const int cell = m_vertices[vertex].unresolved_cell;
    if (cell < 0)
      return -1;
    ++m_contour->unresolved[m_box_of[cell]].branches;
    return m_box_of[cell];
  }

  using Point = std::array<double, 2>;

  // Points of the graph between the ends of an arc, at most a step from each other.
  void add_points(const Contour_arc& arc, bool is_forward, std::vector<Point>& points) const
  {
    add_between(m_cells[arc.cell], m_vertices[arc.vertices[is_forward ? 0 : 1]].point,
                m_vertices[arc.vertices[is_forward ? 1 : 0]].point, points);
  }

  void add_between(const Contour_cell& cell, const Point& from, const Point& to,
                   std::vector<Point>& points) const
  {
    const int over = cell.over, other = 1 - over;
    const double middle = from[over] + (to[over] - from[over]) / 2;
    if (std::hypot(to[0] - from[0], to[1] - from[1]) <= m_step ||
        !(middle > (std::min)(from[over], to[over]) && middle < (std::max)(from[over], to[over])))
      return;
    Point point;
    point[over] = middle;
    point[other] =
      cell.box.low[other] +
      cell.box.width(other) *
        graph(cell, (middle - cell.box.low[over]) / cell.box.width(over));
    add_between(cell, from, point, points);
    points.push_back(point);
    add_between(cell, point, to, points);
  }

  // The value of the graph, both in the unit interval of the cell, by false position.
  static double graph(const Contour_cell& cell, double t)
  {
    const Edge_coefficients line = cell.f.line(cell.over, t);
    double t0 = 0, t1 = 1, f0 = line.b.front() * cell.slope, f1 = line.b.back() * cell.slope;
    if (f0 >= 0 || f1 <= 0)
      return f0 >= 0 ? 0 : 1;
    double x = 0;
    for (int step = 0; step < 60 && t1 - t0 > 1e-15; ++step)
    {
      x = step % 4 == 3 ? (t0 + t1) / 2 : t0 + (t1 - t0) * (f0 / (f0 - f1));
      const double f = line.value(x) * cell.slope;
      if (f == 0 || !(x > t0 && x < t1))
        break;
      (f < 0 ? t0 : t1) = x;
      (f < 0 ? f0 : f1) = f;
      (f < 0 ? f1 : f0) /= 2;
    }
    return x;
  }

  // Unresolved cells that touch are one place: those on the two sides of a line, in order.
  void join_unresolved()
  {
    std::vector<int> place(m_cells.size());
    std::iota(place.begin(), place.end(), 0);
    const auto root = [&](int i) {
      while (place[i] != i)
        i = place[i] = place[place[i]];
      return i;
    };
    for (int axis = 0; axis < 2; ++axis)
      for (const auto& line : lines_of_cells(m_cells, axis, false))
        for_touching(line.second, 1 - axis, [&](int a, int b) { place[root(b)] = root(a); });
    for (std::size_t i = 0; i < m_cells.size(); ++i)
    {
      if (m_cells[i].is_resolved())
        continue;
      int& box = m_box_of[root(static_cast<int>(i))];
      if (box < 0)
      {
        box = static_cast<int>(m_contour->unresolved.size());
        m_contour->unresolved.push_back({m_cells[i].box.low, m_cells[i].box.high});
      }
      m_box_of[i] = box;
      extend(m_contour->unresolved[box], m_cells[i].box);
    }
  }

  // Calls `join` for the cells below and above a line that have a point in common.
  template <class Join>
  void for_touching(const std::array<std::vector<int>, 2>& sides, int other, Join join) const
  {
    const std::vector<int>&below = sides[0], &above = sides[1];
    for (std::size_t i = 0, j = 0; i < below.size() && j < above.size();)
    {
      const Cell_box &a = m_cells[below[i]].box, &b = m_cells[above[j]].box;
      if (a.low[other] <= b.high[other] && b.low[other] <= a.high[other])
        join(below[i], above[j]);
      if (a.high[other] < b.high[other])
        ++i;
      else
        ++j;
    }
  }

  static void extend(Unresolved_box_2& place, const Cell_box& box)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      place.low[axis] = (std::min)(place.low[axis], box.low[axis]);
      place.high[axis] = (std::max)(place.high[axis], box.high[axis]);
    }
  }

  const std::vector<Contour_cell>& m_cells;
  const std::vector<Contour_vertex>& m_vertices;
  const std::vector<Contour_arc>& m_arcs;
  double m_step;
  std::vector<std::vector<int>> m_at; // the arcs at a vertex
  std::vector<bool> m_is_used;
  std::vector<int> m_box_of;
  Contour_2* m_contour = nullptr;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CONTOUR_CHAINS_H
