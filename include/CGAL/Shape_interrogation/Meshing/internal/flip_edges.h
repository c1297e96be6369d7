// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FLIP_EDGES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FLIP_EDGES_H

// Exchanges the diagonals of pairs of triangles where that makes the smallest angle on the patch
// larger and the new triangles are fine. Each exchange improves the sorted list of smallest angles.

#include <CGAL/Shape_interrogation/Meshing/internal/Parameter_triangles.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Edge_flipper
{
  using Triangle = Parameter_triangles::Triangle;

public:
  Edge_flipper(const Patch_vertices& vertices, Parameter_triangles& triangles)
    : m_vertices(vertices), m_triangles(triangles), m_sides(triangles.number_of_edges(), {-1, -1})
  {
    for (std::size_t t = 0; t < triangles.all().size(); ++t)
      for (const int e : triangles.all()[t].edges)
        m_sides[e][m_sides[e][0] < 0 ? 0 : 1] = static_cast<int>(t);
  }

  // `is_fine(t)` tells whether a new triangle may stay, and settles it.
  template <class Is_fine>
  void operator()(Is_fine is_fine)
  {
    // A few rounds reach almost everything.
    bool changed = true;
    for (int round = 0; changed && round < 8; ++round)
    {
      changed = false;
      for (std::size_t e = 0; e < m_sides.size(); ++e)
        changed = try_flip(static_cast<int>(e), is_fine) || changed;
    }
  }

private:
  // The cosine of the smallest angle of a triangle with the given sides: the less the better.
  static double sharpness(std::array<double, 3> l)
  {
    std::sort(l.begin(), l.end());
    const double product = 2 * l[1] * l[2];
    return product > 0 ? (l[1] * l[1] + l[2] * l[2] - l[0] * l[0]) / product : 1;
  }

  double length(int e) const { return m_triangles.edge(e).measures.length; }

  bool is_counterclockwise(int a, int b, int c) const
  {
    const auto &p = m_vertices[a].uv, &q = m_vertices[b].uv, &r = m_vertices[c].uv;
    const std::int64_t x = q[0] - p[0], y = q[1] - p[1], s = r[0] - p[0], t = r[1] - p[1];
    return x * t - y * s > 0;
  }

  bool has_pole(const Triangle& t) const
  {
    return std::any_of(t.corners.begin(), t.corners.end(),
                       [&](int c) { return m_vertices[c].pole >= 0; });
  }

  static int place(const std::array<int, 3>& x, int value)
  {
    return static_cast<int>(std::find(x.begin(), x.end(), value) - x.begin());
  }

  template <class Is_fine>
  bool try_flip(int e, Is_fine& is_fine)
  {
    const auto [i, j] = m_sides[e];
    if (j < 0 || m_triangles.edge(e).kind != Patch_vertices::Edge_kind::INNER)
      return false;
    Triangle &s = m_triangles.all()[i], &t = m_triangles.all()[j];
    const int k = place(s.edges, e), l = place(t.edges, e);
    // s = (c, a, b) and t = (d, b, a) become (c, a, d) and (d, b, c).
    const int c = s.corners[k], a = s.corners[(k + 1) % 3], b = s.corners[(k + 2) % 3];
    const int d = t.corners[l];
    if (has_pole(s) || has_pole(t) ||
        m_vertices.kind({c, d}) != Patch_vertices::Edge_kind::INNER ||
        !is_counterclockwise(c, a, d) || !is_counterclockwise(d, b, c))
      return false;
    const int bc = s.edges[(k + 1) % 3], ca = s.edges[(k + 2) % 3];
    const int ad = t.edges[(l + 1) % 3], db = t.edges[(l + 2) % 3];
    const double cd = m_vertices.measures({c, d}).length;
    if ((std::max)(sharpness({length(ca), length(ad), cd}),
                   sharpness({length(db), length(bc), cd})) >=
        (std::max)(sharpness({length(ca), length(bc), length(e)}),
                   sharpness({length(db), length(ad), length(e)})))
      return false;
    const Parameter_triangles::Edge old = m_triangles.edge(e);
    m_triangles.edge(e) = m_triangles.make_edge(c, d);
    Triangle new_s{{c, a, d}, {ad, e, ca}}, new_t{{d, b, c}, {bc, e, db}};
    if (!is_fine(new_s) || !is_fine(new_t))
    {
      m_triangles.edge(e) = old;
      return false;
    }
    s = new_s;
    t = new_t;
    std::replace(m_sides[ad].begin(), m_sides[ad].end(), j, i);
    std::replace(m_sides[bc].begin(), m_sides[bc].end(), i, j);
    return true;
  }

  const Patch_vertices& m_vertices;
  Parameter_triangles& m_triangles;
  std::vector<std::array<int, 2>> m_sides; // the triangles at each edge
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FLIP_EDGES_H
