// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_ARCS_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_ARCS_H

// The arcs of the zero set in a cell where it is a graph: over the intervals of one coordinate on
// which the polynomial has different signs on the two opposite edges.

#include <CGAL/Shape_interrogation/Contours/internal/Cell_hits.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// An arc from one vertex to another in a cell, in the direction of the coordinate it is a graph
// over. An isolated point is an arc from a vertex to itself.
struct Contour_arc
{
  std::array<int, 2> vertices;
  int cell;
};

class Cell_arcs
{
public:
  Cell_arcs(const Exact_function& f, const std::vector<Contour_cell>& cells, Cell_hits& hits)
    : m_f(f), m_cells(cells), m_hits(hits)
  {}

  // Adds the arcs in the cell; false where crossings could not be put in order.
  bool operator()(int cell, std::vector<Contour_arc>& arcs)
  {
    m_cell = cell;
    m_arcs = &arcs;
    m_over = m_cells[cell].over;
    m_start = -1;
    if (!sort_events())
      return false;
    if (!read_start())
      return false;
    for (const Event& event : m_events)
      pass(event);
    return read_end();
  }

private:
  // A hit on the edge where the other coordinate is low (0) or high (1).
  struct Event
  {
    Hit hit;
    int edge;
  };

  bool sort_events()
  {
    m_events.clear();
    for (int edge = 0; edge < 2; ++edge)
      for (const Hit& hit : m_hits.on_edge(m_cell, 1 - m_over, edge))
        m_events.push_back({hit, edge});
    const auto before = [](const Event& a, const Event& b) {
      return a.hit.crossing.at < b.hit.crossing.at;
    };
    std::sort(m_events.begin(), m_events.end(), before);
    for (std::size_t i = 0; i + 1 < m_events.size(); ++i)
      if (!separate(m_events[i], m_events[i + 1]))
        return false;
    // Refining may have shown another order.
    return std::is_sorted(m_events.begin(), m_events.end(), [](const Event& a, const Event& b) {
      return a.hit.crossing.high < b.hit.crossing.low;
    });
  }

  bool separate(Event& a, Event& b) const
  {
    Crossing &x = a.hit.crossing, &y = b.hit.crossing;
    while (x.high >= y.low && y.high >= x.low)
    {
      const bool is_finer_x = m_hits.crossings().refine(a.hit.segment, x);
      if (!m_hits.crossings().refine(b.hit.segment, y) && !is_finer_x)
        return false;
    }
    if (y.high < x.low)
      std::swap(a, b);
    return true;
  }

  // The sign at a corner, for the polynomial turned so that it increases in the other coordinate.
  int corner(int end, int edge) const
  {
    std::array<int, 2> at;
    at[m_over] = end;
    at[1 - m_over] = edge;
    return m_cells[m_cell].slope * m_hits.corner_sign(m_cell, at);
  }

  // The sign on an edge just after its start, or just before its end, where it is zero there.
  int sign_beside(int end, int edge) const
  {
    const Contour_cell& c = m_cells[m_cell];
    const double x = edge ? c.box.high[1 - m_over] : c.box.low[1 - m_over];
    const auto polynomial =
      m_f.on_segment(1 - m_over, x, c.box.low[m_over], c.box.high[m_over]);
    auto b = polynomial.scaled_coefficients();
    if (end)
      std::reverse(b.begin(), b.end());
    for (const auto& coefficient : b)
      if (!CGAL::is_zero(coefficient))
        return c.slope * CGAL::sign(coefficient);
    return 0;
  }

  bool is_inside() const { return m_sign[0] <= 0 && m_sign[1] >= 0; }

  bool read_start()
  {
    const std::array<int, 2> at{corner(0, 0), corner(0, 1)};
    for (int edge = 0; edge < 2; ++edge)
      m_sign[edge] = at[edge] != 0 ? at[edge] : sign_beside(0, edge);
    if (at[0] > 0 || at[1] < 0)
      return true;
    m_start = end_vertex(0);
    if (m_start >= 0 && !is_inside())
    {
      close(m_start);
      return true;
    }
    return m_start >= 0;
  }

  bool read_end()
  {
    const std::array<int, 2> at{corner(1, 0), corner(1, 1)};
    for (int edge = 0; edge < 2; ++edge)
      if (at[edge] != 0 && at[edge] != m_sign[edge])
        return false;
    const bool is_there = at[0] <= 0 && at[1] >= 0;
    const int vertex = is_there ? end_vertex(1) : -1;
    if (m_start >= 0)
    {
      if (!is_there || vertex < 0)
        return false;
      close(vertex);
    }
    else if (is_there)
      m_arcs->push_back({{vertex, vertex}, m_cell});
    return true;
  }

  // The vertex on the edge across the end of the cell, or at its corner.
  int end_vertex(int end)
  {
    const Cell_box& box = m_cells[m_cell].box;
    std::array<double, 2> point;
    point[m_over] = end ? box.high[m_over] : box.low[m_over];
    for (int edge = 0; edge < 2; ++edge)
      if (corner(end, edge) == 0)
      {
        point[1 - m_over] = edge ? box.high[1 - m_over] : box.low[1 - m_over];
        return m_hits.corner_vertex(point);
      }
    const auto& hits = m_hits.on_edge(m_cell, m_over, end);
    return hits.size() == 1 ? hits.front().vertex : -1;
  }

  void pass(const Event& event)
  {
    const bool was_inside = is_inside();
    if (event.hit.crossing.multiplicity % 2 == 1)
      m_sign[event.edge] = -m_sign[event.edge];
    if (was_inside)
      close(event.hit.vertex);
    if (is_inside())
      m_start = event.hit.vertex;
    else if (!was_inside)
      m_arcs->push_back({{event.hit.vertex, event.hit.vertex}, m_cell});
  }

  void close(int vertex)
  {
    m_arcs->push_back({{m_start, vertex}, m_cell});
    m_start = -1;
  }

  const Exact_function& m_f;
  const std::vector<Contour_cell>& m_cells;
  Cell_hits& m_hits;
  std::vector<Event> m_events;
  std::vector<Contour_arc>* m_arcs = nullptr;
  std::array<int, 2> m_sign{}; // on the low and the high edge
  int m_cell = 0, m_over = 0, m_start = -1;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_ARCS_H
