// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H

// Adaptive triangulation of one patch: which edges must be divided. Edges on the boundary are
// divided where their curve is; triangles that are not proved to be near the patch get their worst
// edges marked. The bound of a triangle goes to at most half the target when its free edges are
// divided; an edge that cannot be divided any more, or one vertex too many, is a refusal.

#include <CGAL/Shape_interrogation/Meshing/internal/flip_edges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Patch_triangulation
{
public:
  using Triangle = Parameter_triangles::Triangle;

  Patch_triangulation(const Bezier_surface_3<Exact_rational>& patch, int index,
                      const std::array<Patch_side, 4>& sides, const Patch_mesh_settings& settings,
                      Vertex_store& store)
    : m_settings(settings), m_net(make_net(patch)),
      m_vertices(patch, index, sides, settings, store), m_triangles(m_vertices)
  {}
  Patch_triangulation(const Patch_triangulation&) = delete;

  // Divides until every triangle is fine. `go_on()` is called often; false cancels.
  template <class Go_on>
  void refine(Go_on go_on)
  {
    std::size_t steps = 0;
    const auto check = [&] {
      if (++steps % 256 == 0 && !go_on())
        refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
    };
    divide_until_fine(check);
    Edge_flipper(m_vertices, m_triangles)([&](Triangle& t) {
      check();
      return is_fine(t);
    });
    divide_until_fine(check); // almost always nothing: see mark_double_edges()
  }

  const std::vector<Patch_vertices::Vertex>& vertices() const { return m_vertices.all(); }
  const std::vector<Triangle>& triangles() const { return m_triangles.all(); }

private:
  using Kind = Patch_vertices::Edge_kind;

  static Interval_net make_net(const Bezier_surface_3<Exact_rational>& patch)
  {
    const Interval_nt<false>::Protector protector;
    return interval_net(patch.degree_u(), patch.degree_v(), patch.is_rational(),
                        [&](int i, int j) { return patch.homogeneous_control_point(i, j); });
  }

  template <class Check>
  void divide_until_fine(Check check)
  {
    while (true)
    {
      for (Triangle& t : m_triangles.all())
        if (!t.is_settled)
        {
          check();
          inspect(t);
        }
      if (!m_triangles.has_marks())
        mark_double_edges();
      if (!m_triangles.has_marks())
        break;
      m_triangles.divide(check);
    }
    // A bound that is not a number neither settles a triangle nor marks an edge.
    for (const Triangle& t : m_triangles.all())
      if (!t.is_settled)
        refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                    "the distance of a triangle from the patch has no bound in floating point");
  }

  // A chord might have the same ends as an edge of another patch.
  bool must_be_divided(const Parameter_triangles::Edge& e) const
  {
    switch (e.kind)
    {
      case Kind::CHORD: return true;
      case Kind::BOUNDARY: return m_vertices.is_boundary_divided(e.ends);
      case Kind::INNER: return m_vertices.is_too_long_or_bent(e.ends);
      default: return false;
    }
  }

  // Marks the edges of a triangle that must be divided, or settles it.
  void inspect(Triangle& t)
  {
    bool is_divided = false;
    for (const int e : t.edges)
      if (must_be_divided(m_triangles.edge(e)))
      {
        m_triangles.mark(e);
        is_divided = true;
      }
    if (is_divided)
      return;
    const Triangle_bound bound = bound_of(t);
    settle(t, bound);
    if (!t.is_settled)
      mark_worst(t, bound);
  }

  void settle(Triangle& t, const Triangle_bound& bound) const
  {
    t.bound = bound.face;
    t.is_settled = bound.face <= m_settings.face_target;
  }

  bool is_fine(Triangle& t) const
  {
    for (const int e : t.edges)
      if (must_be_divided(m_triangles.edge(e)))
        return false;
    settle(t, bound_of(t));
    return t.is_settled;
  }

  // The edges that contribute most, but not those whose curve is fine.
  void mark_worst(const Triangle& t, const Triangle_bound& bound)
  {
    double most = 0;
    for (int k = 0; k < 3; ++k)
      if (m_triangles.is_free(t.edges[k]))
        most = (std::max)(most, bound.edge[k]);
    for (int k = 0; k < 3; ++k)
      if (m_triangles.is_free(t.edges[k]) && bound.edge[k] >= 0.6 * most)
        m_triangles.mark(t.edges[k]);
  }

  Triangle_bound bound_of(const Triangle& t) const
  {
    std::array<std::array<double, 2>, 3> corners, shifts;
    int pole = -1; // the corner that is one
    for (int k = 0; k < 3; ++k)
    {
      const Patch_vertices::Vertex& v = m_vertices[t.corners[k]];
      corners[k] = {parameter_value(v.uv[0]), parameter_value(v.uv[1])};
      shifts[k] = m_triangles.edge(t.edges[k]).measures.shift;
      pole = v.pole >= 0 ? k : pole;
    }
    const int axis = pole >= 0 ? m_vertices[t.corners[pole]].pole / 2 : 0; // from the pole inward
    if (pole >= 0)
    {
      corners[pole][1 - axis] = corners[(pole + 1) % 3][1 - axis];
      shifts[(pole + 1) % 3] = shifts[(pole + 2) % 3] = {0, 0};
    }
    // A box that contains the triangle and all shifted points, of which each is at most a third of
    // the longest shift away.
    std::array<double, 2> low, high;
    for (int d = 0; d < 2; ++d)
    {
      const auto [least, most] = std::minmax({corners[0][d], corners[1][d], corners[2][d]});
      const double shift = (std::max)({std::abs(shifts[0][d]), std::abs(shifts[1][d]),
                                       std::abs(shifts[2][d])});
      low[d] = (std::max)(0.0, step_down(least - 0.34 * shift));
      high[d] = (std::min)(1.0, step_up(most + 0.34 * shift));
    }
    const Interval_nt<false>::Protector protector;
    std::array<Interval_pair, 3> corners_in_box, shifts_in_box;
    for (int d = 0; d < 2; ++d)
    {
      const Mesh_interval from(low[d]), width = Mesh_interval(high[d]) - from;
      for (int k = 0; k < 3; ++k)
      {
        corners_in_box[k][d] = (Mesh_interval(corners[k][d]) - from) / width;
        shifts_in_box[k][d] = Mesh_interval(shifts[k][d]) / width;
      }
    }
    Interval_net net = m_net;
    net.restrict_to(low[0], high[0], low[1], high[1]);
    const Derivative_box box = enclosed_derivatives(net);
    return pole < 0 ? triangle_bound(box, corners_in_box, shifts_in_box)
                    : fan_bound(box, corners_in_box, shifts_in_box[pole], pole, axis);
  }

  // Two different edges with the same ends, as on a narrow closed patch, do not fit a mesh.
  void mark_double_edges()
  {
    using Directed = std::tuple<std::size_t, std::size_t, int>;
    std::vector<Directed> edges;
    for (const Triangle& t : m_triangles.all())
      for (int k = 0; k < 3; ++k)
        if (m_triangles.is_free(t.edges[k]))
          edges.emplace_back(m_vertices[t.corners[(k + 1) % 3]].global,
                             m_vertices[t.corners[(k + 2) % 3]].global, t.edges[k]);
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (std::get<0>(edges[i]) == std::get<0>(edges[i - 1]) &&
          std::get<1>(edges[i]) == std::get<1>(edges[i - 1]))
      {
        m_triangles.mark(std::get<2>(edges[i - 1]));
        m_triangles.mark(std::get<2>(edges[i]));
      }
  }

  const Patch_mesh_settings& m_settings;
  const Interval_net m_net;
  Patch_vertices m_vertices;
  Parameter_triangles m_triangles;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_TRIANGULATION_H
