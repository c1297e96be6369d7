// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H

// Adaptive triangulation of one patch over its parameter square. Edges are marked where they must be
// divided, and triangles with one, two or three marked edges are replaced by two, three or four: the
// result is conforming by construction. Edges on the boundary are divided where their curve is.
// It ends: the bound of a triangle goes to at most half the target when its free edges are divided,
// and an edge that cannot be divided any more, or one vertex too many, is a refusal.

#include <CGAL/Shape_interrogation/Meshing/internal/Patch_vertices.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Patch_triangulation
{
public:
  struct Triangle
  {
    std::array<int, 3> corners; // counterclockwise in the parameter square
    bool is_settled = false;
    double bound = 0;
  };
  using Edge = Patch_vertices::Edge;

  Patch_triangulation(const Bezier_surface_3<Exact_rational>& patch, int index,
                      const std::array<Patch_side, 4>& sides, const Patch_mesh_settings& settings,
                      Vertex_store& store)
    : m_settings(settings), m_net(make_net(patch)), m_vertices(patch, index, sides, settings, store)
  {
    const std::int32_t n = parameter_end;
    const std::array<int, 4> corner{m_vertices.add(0, 0), m_vertices.add(n, 0),
                                    m_vertices.add(n, n), m_vertices.add(0, n)};
    const int center = m_vertices.add(n / 2, n / 2);
    for (int k = 0; k < 4; ++k)
      m_triangles.push_back({{corner[k], corner[(k + 1) % 4], center}});
  }

  // Divides until every triangle is fine. `go_on()` is called often; false cancels.
  template <class Go_on>
  void refine(Go_on go_on)
  {
    do
    {
      m_marked.clear();
      m_midpoints.clear();
      for (std::size_t i = 0; i < m_triangles.size(); ++i)
        if (!m_triangles[i].is_settled)
        {
          check(go_on);
          inspect(m_triangles[i]);
        }
      if (m_marked.empty())
        mark_double_edges();
      for (const Edge& edge : m_marked)
      {
        check(go_on);
        m_midpoints[key(edge)] = m_vertices.add_midpoint(edge);
      }
      divide_triangles();
    }
    while (!m_marked.empty());
  }

  const Patch_vertices& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // Whether two corners are the same vertex: of such a triangle only an edge is left.
  bool is_flat(const Triangle& t) const
  {
    const auto id = [&](int k) { return m_vertices[t.corners[k]].global; };
    return id(0) == id(1) || id(1) == id(2) || id(2) == id(0);
  }

private:
  static Interval_net make_net(const Bezier_surface_3<Exact_rational>& patch)
  {
    const Interval_nt<false>::Protector protector;
    return interval_net(patch.degree_u(), patch.degree_v(), patch.is_rational(),
                        [&](int i, int j) { return patch.homogeneous_control_point(i, j); });
  }

  template <class Go_on>
  void check(Go_on& go_on)
  {
    if (++m_steps % 256 == 0 && !go_on())
      refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
  }

  static std::uint64_t key(const Edge& e)
  {
    return std::uint64_t((std::min)(e[0], e[1])) << 32 | std::uint64_t((std::max)(e[0], e[1]));
  }

  // Edge k is opposite corner k.
  static Edge edge(const Triangle& t, int k)
  {
    return {t.corners[(k + 1) % 3], t.corners[(k + 2) % 3]};
  }

  void mark(const Edge& e)
  {
    if (m_midpoints.emplace(key(e), -1).second)
      m_marked.push_back(e);
  }

  // Marks the edges of a triangle that must be divided, or settles it.
  void inspect(Triangle& t)
  {
    using Kind = Patch_vertices::Edge_kind;
    bool is_divided = false;
    std::array<bool, 3> is_free;
    for (int k = 0; k < 3; ++k)
    {
      const Edge e = edge(t, k);
      const Kind kind = m_vertices.kind(e);
      is_free[k] = kind != Kind::BOUNDARY;
      // A chord might have the same ends as an edge of another patch.
      if (kind == Kind::CHORD || (kind == Kind::BOUNDARY && m_vertices.is_boundary_divided(e)) ||
          (kind == Kind::INNER && m_vertices.is_too_long_or_bent(e)))
      {
        mark(e);
        is_divided = true;
      }
    }
    if (is_divided)
      return;
    const Triangle_bound bound = bound_of(t);
    t.bound = bound.face;
    t.is_settled = bound.face <= m_settings.face_target;
    if (!t.is_settled)
      mark_worst(t, bound, is_free);
  }

  // The edges that contribute most, but not those whose curve is fine.
  void mark_worst(const Triangle& t, const Triangle_bound& bound, const std::array<bool, 3>& is_free)
  {
    double most = 0;
    for (int k = 0; k < 3; ++k)
      if (is_free[k])
        most = (std::max)(most, bound.edge[k]);
    for (int k = 0; k < 3; ++k)
      if (is_free[k] && bound.edge[k] >= 0.6 * most)
        mark(edge(t, k));
  }

  Triangle_bound bound_of(const Triangle& t) const
  {
    std::array<std::int32_t, 2> low{parameter_end, parameter_end}, high{0, 0};
    for (const int c : t.corners)
    {
      const std::array<std::int32_t, 2> uv{m_vertices[c].u, m_vertices[c].v};
      for (int d = 0; d < 2; ++d)
      {
        low[d] = (std::min)(low[d], uv[d]);
        high[d] = (std::max)(high[d], uv[d]);
      }
    }
    const Interval_nt<false>::Protector protector;
    std::array<std::array<Mesh_interval, 2>, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const Patch_vertices::Vertex& v = m_vertices[t.corners[k]];
      corners[k] = {Mesh_interval(v.u - low[0]) / Mesh_interval(high[0] - low[0]),
                    Mesh_interval(v.v - low[1]) / Mesh_interval(high[1] - low[1])};
    }
    Interval_net net = m_net;
    net.restrict_to(parameter_value(low[0]), parameter_value(high[0]), parameter_value(low[1]),
                    parameter_value(high[1]));
    return triangle_bound(second_derivatives(net), corners);
  }

  // Two different edges with the same ends, as on a narrow closed patch, do not fit a mesh.
  void mark_double_edges()
  {
    using Directed = std::tuple<std::size_t, std::size_t, Edge>;
    std::vector<Directed> edges;
    for (const Triangle& t : m_triangles)
      for (int k = 0; k < 3 && !is_flat(t); ++k)
      {
        const Edge e = edge(t, k);
        if (m_vertices.kind(e) != Patch_vertices::Edge_kind::BOUNDARY)
          edges.emplace_back(m_vertices[e[0]].global, m_vertices[e[1]].global, e);
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (std::get<0>(edges[i]) == std::get<0>(edges[i - 1]) &&
          std::get<1>(edges[i]) == std::get<1>(edges[i - 1]))
      {
        mark(std::get<2>(edges[i - 1]));
        mark(std::get<2>(edges[i]));
      }
  }

  void divide_triangles()
  {
    std::vector<Triangle> divided;
    for (const Triangle& t : m_triangles)
    {
      std::array<int, 3> middle;
      int count = 0;
      for (int k = 0; k < 3; ++k)
      {
        const auto found = m_midpoints.find(key(edge(t, k)));
        middle[k] = found == m_midpoints.end() ? -1 : found->second;
        count += middle[k] >= 0;
      }
      if (count == 0)
        divided.push_back(t);
      else
        divide(t, middle, count, divided);
    }
    m_triangles.swap(divided);
  }

  // `middle[k]` is the vertex on the edge k, or -1.
  void divide(const Triangle& t, const std::array<int, 3>& middle, int count,
              std::vector<Triangle>& to) const
  {
    // Rotate: of one, the divided edge is edge 0; of two, the undivided one is.
    int k = 0;
    while (count < 3 && (middle[k] >= 0) != (count == 1))
      ++k;
    const int a = t.corners[k], b = t.corners[(k + 1) % 3], c = t.corners[(k + 2) % 3];
    const int p = middle[k], q = middle[(k + 1) % 3], r = middle[(k + 2) % 3];
    if (count == 1)
    {
      to.push_back({{a, b, p}});
      to.push_back({{a, p, c}});
      return;
    }
    to.push_back({{a, r, q}});
    if (count == 3)
    {
      to.push_back({{r, b, p}});
      to.push_back({{p, c, q}});
      to.push_back({{p, q, r}});
    }
    else if (m_vertices.length({r, c}) < m_vertices.length({b, q}))
    {
      to.push_back({{r, b, c}});
      to.push_back({{r, c, q}});
    }
    else
    {
      to.push_back({{r, b, q}});
      to.push_back({{b, c, q}});
    }
  }

  const Patch_mesh_settings& m_settings;
  const Interval_net m_net;
  Patch_vertices m_vertices;
  std::vector<Triangle> m_triangles;
  std::vector<Edge> m_marked;
  std::unordered_map<std::uint64_t, int> m_midpoints; // -1 until the vertex is there
  std::size_t m_steps = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H
