// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_HITS_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_HITS_H

// The points in which the zero set crosses the edges of the cells, each found once for the cells
// on both sides of it.

#include <CGAL/Shape_interrogation/Contours/internal/Cell_partition.h>
#include <CGAL/Shape_interrogation/Contours/internal/Edge_crossings.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The cells on both sides of each line across the axis, in order; all of them or the unresolved ones.
using Lines_of_cells = std::map<double, std::array<std::vector<int>, 2>>;

inline Lines_of_cells lines_of_cells(const std::vector<Contour_cell>& cells, int axis, bool all)
{
  Lines_of_cells lines;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (all || !cells[i].is_resolved())
    {
      lines[cells[i].box.high[axis]][0].push_back(static_cast<int>(i));
      lines[cells[i].box.low[axis]][1].push_back(static_cast<int>(i));
    }
  const auto before = [&](int a, int b) {
    return cells[a].box.low[1 - axis] < cells[b].box.low[1 - axis];
  };
  for (auto& line : lines)
    for (auto& side : line.second)
      std::sort(side.begin(), side.end(), before);
  return lines;
}

// A crossing as a cell sees it.
struct Hit
{
  int vertex;
  Segment segment;
  Crossing crossing;
};

struct Contour_vertex
{
  std::array<double, 2> point;
  int unresolved_cell = -1; // behind it
};

class Cell_hits
{
public:
  Cell_hits(const Exact_function& f, const std::vector<Contour_cell>& cells)
    : m_f(f), m_crossings(f), m_cells(cells), m_hits(cells.size()), m_corners(cells.size())
  {}

  // Finds everything. What remains are resolved cells on whose edges something is degenerate:
  // another partition is needed.
  std::vector<int> operator()()
  {
    for (std::size_t i = 0; i < m_cells.size(); ++i)
      read_corners(static_cast<int>(i));
    for (int axis = 0; axis < 2 && m_degenerate.empty(); ++axis)
      cross_lines(axis);
    return m_degenerate;
  }

  const std::vector<Contour_vertex>& vertices() const { return m_vertices; }
  const Edge_crossings& crossings() const { return m_crossings; }

  // The hits on the edge of a cell where the variable `axis` is at its end.
  const std::vector<Hit>& on_edge(int cell, int axis, int end) const
  {
    return m_hits[cell][2 * axis + end];
  }

  // The sign at the corner of a cell; zero at a corner of the unit square only.
  CGAL::Sign corner_sign(int cell, std::array<int, 2> corner) const
  {
    return m_corners[cell][2 * corner[0] + corner[1]];
  }

  // The vertex at a corner of the unit square.
  int corner_vertex(const std::array<double, 2>& point)
  {
    const int k = 2 * (point[0] == 1) + (point[1] == 1);
    if (m_corner_vertices[k] < 0)
      m_corner_vertices[k] = new_vertex(point);
    return m_corner_vertices[k];
  }

private:
  int new_vertex(const std::array<double, 2>& point)
  {
    m_vertices.push_back({point});
    return static_cast<int>(m_vertices.size()) - 1;
  }

  static bool is_end(double x) { return x == 0 || x == 1; }

  void read_corners(int cell)
  {
    const Contour_cell& c = m_cells[cell];
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
      {
        CGAL::Sign& sign = m_corners[cell][2 * i + j];
        const double u = i ? c.box.high[0] : c.box.low[0], v = j ? c.box.high[1] : c.box.low[1];
        sign = c.f.sign_at_corner(i, j);
        if (sign == ZERO)
          sign = m_f.sign_at(u, v);
        if (sign == ZERO && !(is_end(u) && is_end(v)) && c.is_resolved())
          m_degenerate.push_back(cell);
      }
  }

  void cross_lines(int axis)
  {
    for (const auto& line : lines_of_cells(m_cells, axis, true))
      if (is_end(line.first))
        for (int cell : line.second[line.first == 0 ? 1 : 0])
          cross_boundary(axis, line.first, cell);
      else
        cross_line(axis, line.first, line.second[0], line.second[1]);
  }

  void cross_line(int axis, double x, const std::vector<int>& below, const std::vector<int>& above)
  {
    const int other = 1 - axis;
    for (std::size_t i = 0, j = 0; i < below.size() && j < above.size();)
    {
      const Cell_box &a = m_cells[below[i]].box, &b = m_cells[above[j]].box;
      const Segment segment{axis, x, (std::max)(a.low[other], b.low[other]),
                            (std::min)(a.high[other], b.high[other])};
      if (segment.low < segment.high)
        cross_segment(segment, below[i], above[j]);
      if (a.high[other] < b.high[other])
        ++i;
      else
        ++j;
    }
  }

  // A segment between two cells; where one is empty, there is nothing on it.
  void cross_segment(const Segment& segment, int below, int above)
  {
    const bool has_below = m_cells[below].is_resolved(), has_above = m_cells[above].is_resolved();
    if (!has_below && !has_above)
      return;
    const auto crossings = find(segment, has_below ? below : above, has_below ? 1 : 0);
    if (!crossings)
      return;
    for (const Crossing& c : *crossings)
    {
      if (c.multiplicity != 1)
        m_degenerate.push_back(has_below ? below : above);
      const int vertex = add(segment, c);
      if (has_below)
        m_hits[below][2 * segment.axis + 1].push_back({vertex, segment, c});
      if (has_above)
        m_hits[above][2 * segment.axis].push_back({vertex, segment, c});
      if (!has_below || !has_above)
        m_vertices[vertex].unresolved_cell = has_below ? above : below;
    }
  }

  void cross_boundary(int axis, double x, int cell)
  {
    const Contour_cell& c = m_cells[cell];
    if (!c.is_resolved())
      return;
    const int end = x == 1;
    const Segment segment{axis, x, c.box.low[1 - axis], c.box.high[1 - axis]};
    if (const auto crossings = find(segment, cell, end))
      for (const Crossing& crossing : *crossings)
        m_hits[cell][2 * axis + end].push_back({add(segment, crossing), segment, crossing});
  }

  std::optional<std::vector<Crossing>> find(const Segment& segment, int cell, int end)
  {
    const Contour_cell& c = m_cells[cell];
    const int other = 1 - segment.axis;
    const double low = c.box.low[other], width = c.box.width(other);
    auto crossings =
      m_crossings(segment, c.f.edge(segment.axis, end)
                             .restricted((segment.low - low) / width, (segment.high - low) / width));
    if (!crossings)
      m_degenerate.push_back(cell);
    return crossings;
  }

  int add(const Segment& segment, const Crossing& c)
  {
    std::array<double, 2> point;
    point[segment.axis] = segment.x;
    point[1 - segment.axis] = c.at;
    return new_vertex(point);
  }

  const Exact_function& m_f;
  Edge_crossings m_crossings;
  const std::vector<Contour_cell>& m_cells;
  std::vector<std::array<std::vector<Hit>, 4>> m_hits;
  std::vector<std::array<CGAL::Sign, 4>> m_corners;
  std::vector<Contour_vertex> m_vertices;
  std::array<int, 4> m_corner_vertices{-1, -1, -1, -1};
  std::vector<int> m_degenerate;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_HITS_H
