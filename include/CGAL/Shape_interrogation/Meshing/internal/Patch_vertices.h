// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_VERTICES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_VERTICES_H

// The vertices of the triangulation of one patch: dyadic parameters, the vertex of the mesh that each
// stands for, and what is known about an edge between two of them.

#include <CGAL/Shape_interrogation/Meshing/internal/Edge_curves.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Patch_vertices
{
public:
  struct Vertex
  {
    std::int32_t u, v;
    int sides;           // bit k: on the side k of the parameter square
    std::size_t global;  // the vertex of the mesh
    Double_point normal; // of length 1, or 0 where it is not known
  };
  using Edge = std::array<int, 2>;
  enum class Edge_kind
  {
    INNER,
    CHORD,     // not on a side, but both ends are
    COLLAPSED, // on a side that is a single point
    BOUNDARY   // on a side with a curve
  };

  Patch_vertices(const Bezier_surface_3<Exact_rational>& patch, int index,
                 const std::array<Patch_side, 4>& sides, const Patch_mesh_settings& settings,
                 Vertex_store& store)
    : m_patch(patch), m_double_patch(patch.cast<double>()), m_index(index), m_sides(sides),
      m_settings(settings), m_store(store)
  {}

  const Vertex& operator[](int i) const { return m_vertices[i]; }
  const std::vector<Vertex>& all() const { return m_vertices; }

  int add(std::int32_t u, std::int32_t v)
  {
    if (m_store.size() >= m_settings.max_vertices)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the mesh needs more vertices than are allowed, in " + place(u, v));
    Vertex vertex{u, v, 0, 0, normal(u, v)};
    const std::array<bool, 4> on{u == 0, u == parameter_end, v == 0, v == parameter_end};
    for (int k = 0; k < 4; ++k)
      vertex.sides |= on[k] ? 1 << k : 0;
    const int side = first_side(vertex.sides);
    vertex.global = side < 4 ? m_sides[side].vertex(side < 2 ? v : u) : add_inner_point(u, v);
    m_vertices.push_back(vertex);
    return static_cast<int>(m_vertices.size()) - 1;
  }

  int add_midpoint(const Edge& edge)
  {
    const Vertex &a = m_vertices[edge[0]], &b = m_vertices[edge[1]];
    const std::int32_t u = a.u + b.u, v = a.v + b.v;
    if (u % 2 != 0 || v % 2 != 0)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the triangles cannot be made small enough in " + place(a.u, a.v));
    return add(u / 2, v / 2);
  }

  Edge_kind kind(const Edge& edge) const
  {
    const int a = m_vertices[edge[0]].sides, b = m_vertices[edge[1]].sides;
    if ((a & b) != 0)
      return m_sides[first_side(a & b)].curve ? Edge_kind::BOUNDARY : Edge_kind::COLLAPSED;
    return a != 0 && b != 0 ? Edge_kind::CHORD : Edge_kind::INNER;
  }

  // Whether the curve of a boundary edge has a vertex in the middle.
  bool is_boundary_divided(const Edge& edge) const
  {
    const Vertex &a = m_vertices[edge[0]], &b = m_vertices[edge[1]];
    const int side = first_side(a.sides & b.sides);
    const std::int32_t sum = side < 2 ? a.v + b.v : a.u + b.u;
    return sum % 2 == 0 && m_sides[side].has_vertex(sum / 2);
  }

  bool is_too_long_or_bent(const Edge& edge) const
  {
    const Vertex &a = m_vertices[edge[0]], &b = m_vertices[edge[1]];
    const double d = length(edge);
    if (d > m_settings.max_edge_length)
      return true;
    return d > m_settings.tolerance && dot(a.normal, a.normal) > 0 && dot(b.normal, b.normal) > 0 &&
           dot(a.normal, b.normal) < m_settings.min_cosine;
  }

  double length(const Edge& edge) const
  {
    return distance(m_store[m_vertices[edge[0]].global], m_store[m_vertices[edge[1]].global]);
  }

private:
  // 4 if there is none.
  static int first_side(int sides)
  {
    int k = 0;
    while (k < 4 && (sides & 1 << k) == 0)
      ++k;
    return k;
  }

  std::string place(std::int32_t u, std::int32_t v) const
  {
    return "patch " + std::to_string(m_index) + " near (u, v) = (" +
           std::to_string(parameter_value(u)) + ", " + std::to_string(parameter_value(v)) + ")";
  }

  std::size_t add_inner_point(std::int32_t u, std::int32_t v)
  {
    const auto point = m_patch.point({exact_parameter(u), exact_parameter(v)});
    if (!point)
      refuse_mesh(point.refusal().code(), point.refusal().evidence() + " in " + place(u, v));
    return m_store.add(*point);
  }

  // Serves the choice of edges only: nothing is claimed of it.
  Double_point normal(std::int32_t u, std::int32_t v) const
  {
    const auto d = m_double_patch.derivatives({parameter_value(u), parameter_value(v)});
    return d ? unit_vector(cross(d->u, d->v)) : Double_point{0, 0, 0};
  }

  const Bezier_surface_3<Exact_rational>& m_patch;
  const Bezier_surface_3<double> m_double_patch;
  const int m_index;
  const std::array<Patch_side, 4> m_sides;
  const Patch_mesh_settings& m_settings;
  Vertex_store& m_store;
  std::vector<Vertex> m_vertices;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_VERTICES_H
