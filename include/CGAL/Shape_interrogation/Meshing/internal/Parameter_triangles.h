// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PARAMETER_TRIANGLES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PARAMETER_TRIANGLES_H

// Triangles over the parameter square of a patch that are divided at marked edges: those with one,
// two or three marked edges are replaced by two, three or four, so that the result is conforming. A
// triangle with a marked edge also gets its longest one marked, which keeps angles from becoming
// small (Rivara's longest edge bisection).

#include <CGAL/Shape_interrogation/Meshing/internal/Patch_vertices.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Parameter_triangles
{
public:
  struct Edge
  {
    Patch_vertices::Edge ends;
    Patch_vertices::Edge_kind kind;
    Patch_vertices::Measures measures;
    bool is_marked = false;
    int middle = -1;                // the vertex, once it is divided
    std::array<int, 2> halves{};    // the edges from the ends to the middle
  };
  struct Triangle
  {
    std::array<int, 3> corners; // counterclockwise
    std::array<int, 3> edges;   // edge k is opposite corner k
    bool is_settled = false;
    double bound = 0;
  };

  // The square, in triangles around its center: every side that is not a pole in two.
  explicit Parameter_triangles(Patch_vertices& vertices) : m_vertices(vertices)
  {
    const std::vector<int> around = add_boundary();
    const int center = vertices.add({parameter_end / 2, parameter_end / 2});
    const std::size_t n = around.size();
    std::vector<int> spokes, sides;
    for (std::size_t k = 0; k < n; ++k)
    {
      spokes.push_back(add_edge(around[k], center));
      sides.push_back(add_edge(around[k], around[(k + 1) % n]));
    }
    for (std::size_t k = 0; k < n; ++k)
      m_triangles.push_back({{around[k], around[(k + 1) % n], center},
                             {spokes[(k + 1) % n], spokes[k], sides[k]}});
  }

  std::vector<Triangle>& all() { return m_triangles; }
  const std::vector<Triangle>& all() const { return m_triangles; }
  const Edge& edge(int e) const { return m_edges[e]; }
  std::size_t number_of_edges() const { return m_edges.size(); }
  Edge& edge(int e) { return m_edges[e]; }

  Edge make_edge(int a, int b) const
  {
    return {{a, b}, m_vertices.kind({a, b}), m_vertices.measures({a, b})};
  }

  // Whether the edge may be divided by a triangle's choice: those on a curve follow the curve.
  bool is_free(int e) const { return m_edges[e].kind != Patch_vertices::Edge_kind::BOUNDARY; }

  void mark(int e)
  {
    m_marks += !m_edges[e].is_marked;
    m_edges[e].is_marked = true;
  }
  bool has_marks() const { return m_marks > 0; }

  // Divides all marked edges, and the triangles at them. `check()` is called before each new
  // vertex.
  template <class Check>
  void divide(Check check)
  {
    while (mark_longest_edges())
      ;
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (m_edges[e].is_marked)
      {
        check();
        divide_edge(static_cast<int>(e));
      }
    std::vector<Triangle> divided;
    divided.reserve(2 * m_triangles.size());
    for (const Triangle& t : m_triangles)
      divide_triangle(t, divided);
    m_triangles.swap(divided);
    m_marks = 0;
  }

private:
  // The vertices on the boundary, counterclockwise from u = v = 0: corners, poles, middles of
  // sides.
  std::vector<int> add_boundary()
  {
    const std::int32_t n = parameter_end;
    const std::array<std::array<std::int32_t, 2>, 4> corner{{{0, 0}, {n, 0}, {n, n}, {0, n}}};
    const std::array<int, 4> side{2, 1, 3, 0}; // from each corner to the next, as in Patch_edge
    std::vector<int> around;
    for (int k = 0; k < 4; ++k)
    {
      const auto &a = corner[k], &b = corner[(k + 1) % 4];
      if (m_vertices.is_collapsed(side[k]))
        around.push_back(m_vertices.add_pole(side[k]));
      else
      {
        if (!m_vertices.is_collapsed(side[(k + 3) % 4]))
          around.push_back(m_vertices.add(a));
        around.push_back(m_vertices.add({a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2}));
      }
    }
    return around;
  }

  int add_edge(int a, int b)
  {
    m_edges.push_back(make_edge(a, b));
    return static_cast<int>(m_edges.size()) - 1;
  }

  double length(int e) const { return m_edges[e].measures.length; }

  bool mark_longest_edges()
  {
    const std::size_t before = m_marks;
    for (const Triangle& t : m_triangles)
      if (std::any_of(t.edges.begin(), t.edges.end(), [&](int e) { return m_edges[e].is_marked; }))
      {
        int longest = -1;
        for (const int e : t.edges)
          if (is_free(e) && (longest < 0 || length(e) > length(longest)))
            longest = e;
        if (longest >= 0)
          mark(longest);
      }
    return m_marks > before;
  }

  void divide_edge(int e)
  {
    const Patch_vertices::Edge ends = m_edges[e].ends;
    const int middle = m_vertices.add_midpoint(ends);
    const std::array<int, 2> halves{add_edge(ends[0], middle), add_edge(middle, ends[1])};
    m_edges[e].is_marked = false;
    m_edges[e].middle = middle;
    m_edges[e].halves = halves;
  }

  // The half of a divided edge at one of its ends.
  int half(int e, int end) const { return m_edges[e].halves[m_edges[e].ends[0] == end ? 0 : 1]; }

  void divide_triangle(const Triangle& t, std::vector<Triangle>& to)
  {
    int count = 0;
    for (const int e : t.edges)
      count += m_edges[e].middle >= 0;
    if (count == 0)
    {
      to.push_back(t);
      return;
    }
    // Turn the triangle: of one divided edge, this is edge 0; of two, the undivided one is.
    int k = 0;
    while (count < 3 && (m_edges[t.edges[k]].middle >= 0) != (count == 1))
      ++k;
    const auto at = [k](const std::array<int, 3>& x, int i) { return x[(k + i) % 3]; };
    const std::array<int, 3> c{at(t.corners, 0), at(t.corners, 1), at(t.corners, 2)};
    const std::array<int, 3> e{at(t.edges, 0), at(t.edges, 1), at(t.edges, 2)};
    if (count == 1)
      divide_in_two(c, e, to);
    else if (count == 2)
      divide_in_three(c, e, to);
    else
      divide_in_four(c, e, to);
  }

  void divide_in_two(const std::array<int, 3>& c, const std::array<int, 3>& e,
                     std::vector<Triangle>& to)
  {
    const int p = m_edges[e[0]].middle;
    const int inner = add_edge(c[0], p);
    to.push_back({{c[0], c[1], p}, {half(e[0], c[1]), inner, e[2]}});
    to.push_back({{c[0], p, c[2]}, {half(e[0], c[2]), e[1], inner}});
  }

  // As if the longer edge had been divided first.
  void divide_in_three(const std::array<int, 3>& c, const std::array<int, 3>& e,
                       std::vector<Triangle>& to)
  {
    const int q = m_edges[e[1]].middle, r = m_edges[e[2]].middle;
    const int inner = add_edge(q, r);
    to.push_back({{c[0], r, q}, {inner, half(e[1], c[0]), half(e[2], c[0])}});
    if (length(e[2]) > length(e[1]))
    {
      const int diagonal = add_edge(r, c[2]);
      to.push_back({{r, c[1], c[2]}, {e[0], diagonal, half(e[2], c[1])}});
      to.push_back({{r, c[2], q}, {half(e[1], c[2]), inner, diagonal}});
    }
    else
    {
      const int diagonal = add_edge(c[1], q);
      to.push_back({{r, c[1], q}, {diagonal, inner, half(e[2], c[1])}});
      to.push_back({{c[1], c[2], q}, {half(e[1], c[2]), diagonal, e[0]}});
    }
  }

  void divide_in_four(const std::array<int, 3>& c, const std::array<int, 3>& e,
                      std::vector<Triangle>& to)
  {
    const int p = m_edges[e[0]].middle, q = m_edges[e[1]].middle, r = m_edges[e[2]].middle;
    const int a = add_edge(q, r), b = add_edge(r, p), d = add_edge(p, q);
    to.push_back({{c[0], r, q}, {a, half(e[1], c[0]), half(e[2], c[0])}});
    to.push_back({{r, c[1], p}, {half(e[0], c[1]), b, half(e[2], c[1])}});
    to.push_back({{q, p, c[2]}, {half(e[0], c[2]), half(e[1], c[2]), d}});
    to.push_back({{p, q, r}, {a, b, d}});
  }

  Patch_vertices& m_vertices;
  std::vector<Edge> m_edges;
  std::vector<Triangle> m_triangles;
  std::size_t m_marks = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PARAMETER_TRIANGLES_H
