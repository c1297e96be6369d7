// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_VERTICES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_VERTICES_H

// The vertices of the triangulation of one patch: dyadic parameters, the vertex of the mesh that
// each stands for, and what is known about an edge between two of them. A side that is collapsed to
// a point has one vertex, a pole; an edge from it leaves the side at right angles.

#include <CGAL/Shape_interrogation/Meshing/internal/Edge_curves.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
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
    std::array<std::int32_t, 2> uv; // of a pole, the one along its side means nothing
    int sides;                      // bit k: on the side k of the square
    int pole;                       // the side that is this vertex, or -1
    std::size_t global;             // the vertex of the mesh
    Double_point normal;            // of length 1, or 0 where it is not known
    double spacing;                 // bends are not looked for on edges shorter than this
  };
  using Edge = std::array<int, 2>;
  enum class Edge_kind
  {
    INNER,
    CHORD,   // not on a side, but both ends are
    BOUNDARY // on a side with a curve
  };

  // The sides in the order of Patch_edge. No two that meet may be collapsed.
  Patch_vertices(const Bezier_surface_3<Exact_rational>& patch, int index,
                 const std::array<Patch_side, 4>& sides, const Patch_mesh_settings& settings,
                 Vertex_store& store)
    : m_exact(patch.degree_u(), patch.degree_v(),
              [&](int i, int j) { return patch.homogeneous_control_point(i, j); }),
      m_double_patch(patch.cast<double>()), m_index(index), m_sides(sides), m_settings(settings),
      m_store(store)
  {}

  const Vertex& operator[](int i) const { return m_vertices[i]; }
  const std::vector<Vertex>& all() const { return m_vertices; }
  bool is_collapsed(int side) const { return m_sides[side].curve == nullptr; }

  int add(const std::array<std::int32_t, 2>& uv)
  {
    if (m_store.size() >= m_settings.max_vertices)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the mesh needs more vertices than are allowed, in " + place(uv));
    Vertex vertex{uv, 0, -1, 0, normal(uv), 0};
    for (int k = 0; k < 4; ++k)
      if (uv[k / 2] == (k % 2 == 0 ? 0 : parameter_end))
      {
        vertex.sides |= 1 << k;
        vertex.spacing = (std::max)(vertex.spacing, m_sides[k].spacing(uv[1 - k / 2]));
      }
    const int side = first_side(vertex.sides);
    vertex.global = side < 4 ? m_sides[side].vertex(uv[1 - side / 2]) : add_inner_point(uv);
    m_vertices.push_back(vertex);
    return static_cast<int>(m_vertices.size()) - 1;
  }

  int add_pole(int side)
  {
    const int neighbours = side < 2 ? 4 | 8 : 1 | 2;
    std::array<std::int32_t, 2> uv{0, 0};
    uv[side / 2] = side % 2 == 0 ? 0 : parameter_end;
    m_vertices.push_back({uv, 1 << side | neighbours, side, m_sides[side].collapsed_vertex, {},
                          0});
    return static_cast<int>(m_vertices.size()) - 1;
  }

  int add_midpoint(const Edge& edge)
  {
    std::array<std::int32_t, 2> uv;
    for (int d = 0; d < 2; ++d)
    {
      const std::int32_t sum = end(edge, 0)[d] + end(edge, 1)[d];
      if (sum % 2 != 0)
        refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                    "the triangles cannot be made small enough in " + place(end(edge, 0)));
      uv[d] = sum / 2;
    }
    // From the boundary inward the spacing halves with each division.
    const int middle = add(uv);
    Vertex& vertex = m_vertices[middle];
    if (vertex.sides == 0)
      vertex.spacing =
        (std::max)(m_vertices[edge[0]].spacing, m_vertices[edge[1]].spacing) / 2;
    return middle;
  }

  Edge_kind kind(const Edge& edge) const
  {
    const int a = m_vertices[edge[0]].sides, b = m_vertices[edge[1]].sides;
    if ((a & b) != 0)
      return Edge_kind::BOUNDARY;
    return a != 0 && b != 0 ? Edge_kind::CHORD : Edge_kind::INNER;
  }

  // Whether the curve of a boundary edge has a vertex in the middle.
  bool is_boundary_divided(const Edge& edge) const
  {
    const int side = side_of(edge), along = 1 - side / 2;
    const std::int32_t sum = end(edge, 0)[along] + end(edge, 1)[along];
    return sum % 2 == 0 && m_sides[side].has_vertex(sum / 2);
  }

  // Whether the edge, or the angle of the normals at its ends, is too large. The angle counts on
  // edges that are longer than the fixed ones on the boundary beside them: else triangles might
  // come ever nearer to the boundary without getting better.
  bool is_too_long_or_bent(const Edge& edge) const
  {
    const Vertex &a = m_vertices[edge[0]], &b = m_vertices[edge[1]];
    const double length = distance(m_store[a.global], m_store[b.global]);
    if (length > m_settings.max_edge_length)
      return true;
    return length > (std::max)({m_settings.tolerance, a.spacing, b.spacing}) &&
           dot(a.normal, a.normal) > 0 && dot(b.normal, b.normal) > 0 &&
           dot(a.normal, b.normal) < m_settings.min_cosine;
  }

  // What is measured of an edge on the patch.
  struct Measures
  {
    double length;               // by the metric in the middle, not of the chord
    std::array<double, 2> shift; // how points slide along the patch (see triangle_bound.h)
  };

  // The shift is bounded so that x_i + x_j + shift_ij stays in [0, 2] for both parameters: then
  // sum l_i x_i + sum l_i l_j shift_ij is in the square for every triangle. Sides slide in
  // themselves. Points of the square slide continuously, so that they cover it again.
  Measures measures(const Edge& edge) const
  {
    const std::array<std::int32_t, 2> a = end(edge, 0), b = end(edge, 1);
    const Edge_kind of_edge = kind(edge);
    const std::array<double, 2> p{parameter_value(a[0]), parameter_value(a[1])};
    const std::array<double, 2> q{parameter_value(b[0]), parameter_value(b[1])};
    Measures m = free_measures({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}, q[0] - p[0], q[1] - p[1]);
    if (of_edge == Edge_kind::BOUNDARY)
    {
      const int side = side_of(edge), along = 1 - side / 2;
      m.shift[along] = m_sides[side].shift(a[along], b[along]);
      m.shift[1 - along] = 0;
    }
    else
    {
      // Beside a fold the shift is the solution of singular equations: it must shrink with the
      // edge, or the box around the shifted points never does; and with the distance from a side,
      // where edges come near to fixed ones on it, which do not slide across.
      // At regular places it shrinks with the square.
      const double extent = (std::max)(std::abs(q[0] - p[0]), std::abs(q[1] - p[1]));
      const double most = extent * (std::min)(1.0, 4 * extent);
      for (int d = 0; d < 2; ++d)
      {
        const double limit = (std::min)({most, p[d] + q[d], 2 - (p[d] + q[d])});
        m.shift[d] = std::clamp(m.shift[d], -limit, limit);
      }
    }
    return m;
  }

private:
  // An end of an edge; a pole is where the other end's parameter line meets its side.
  std::array<std::int32_t, 2> end(const Edge& edge, int i) const
  {
    const Vertex &v = m_vertices[edge[i]], &other = m_vertices[edge[1 - i]];
    std::array<std::int32_t, 2> uv = v.uv;
    if (v.pole >= 0)
      uv[1 - v.pole / 2] = other.uv[1 - v.pole / 2];
    return uv;
  }

  // 4 if there is none.
  static int first_side(int sides)
  {
    int k = 0;
    while (k < 4 && (sides & 1 << k) == 0)
      ++k;
    return k;
  }

  int side_of(const Edge& edge) const
  {
    return first_side(m_vertices[edge[0]].sides & m_vertices[edge[1]].sides);
  }

  std::string place(const std::array<std::int32_t, 2>& uv) const
  {
    return "patch " + std::to_string(m_index) + " near (u, v) = (" +
           std::to_string(parameter_value(uv[0])) + ", " + std::to_string(parameter_value(uv[1])) +
           ")";
  }

  std::size_t add_inner_point(const std::array<std::int32_t, 2>& uv)
  {
    const std::optional<Exact_point> point = m_exact.point(uv[0], uv[1]);
    if (!point)
      refuse_mesh(Refusal_code::POLE, "the weight is zero in " + place(uv));
    return m_store.add(*point);
  }

  // Serves the choice of edges only: nothing is claimed of it.
  Double_point normal(const std::array<std::int32_t, 2>& uv) const
  {
    const auto d = m_double_patch.derivatives({parameter_value(uv[0]), parameter_value(uv[1])});
    return d ? unit_vector(cross(d->u, d->v)) : Double_point{0, 0, 0};
  }

  // As if the patch had no boundary. The shift c is the vector for which S_u c_u + S_v c_v is
  // nearest to half the second derivative along (du, dv).
  Measures free_measures(const std::array<double, 2>& uv, double du, double dv) const
  {
    const auto d = m_double_patch.derivatives(uv);
    if (!d)
      return {0, {0, 0}};
    Double_point h, t;
    for (int k = 0; k < 3; ++k)
    {
      t[k] = d->u[k] * du + d->v[k] * dv;
      h[k] = (d->uu[k] * du * du + 2 * d->uv[k] * du * dv + d->vv[k] * dv * dv) / 2;
    }
    const double e = dot(d->u, d->u), f = dot(d->u, d->v), g = dot(d->v, d->v);
    const double hu = dot(h, d->u), hv = dot(h, d->v), determinant = e * g - f * f;
    const double cu = (hu * g - hv * f) / determinant, cv = (hv * e - hu * f) / determinant;
    const bool is_finite = std::isfinite(cu) && std::isfinite(cv);
    return {std::sqrt(dot(t, t)), {is_finite ? cu : 0, is_finite ? cv : 0}};
  }

  const Exact_net m_exact;
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
