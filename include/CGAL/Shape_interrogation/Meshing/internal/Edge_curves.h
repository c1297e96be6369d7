// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EDGE_CURVES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EDGE_CURVES_H

// The edge curves of patches and their vertices. How a curve is divided depends on the curve alone,
// in a canonical orientation and scaling: patches with a common edge get the same vertices on it,
// whether they are meshed together or one by one.

#include <CGAL/Shape_interrogation/Meshing/internal/Patch_mesh_settings.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_store.h>
#include <CGAL/Shape_interrogation/Meshing/internal/triangle_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Exact_control = std::vector<Coordinates<Exact_rational, 4>>;

inline Exact_point affine_point(const Coordinates<Exact_rational, 4>& p)
{
  if (CGAL::is_zero(p[3]))
    refuse_mesh(Refusal_code::POLE, "the weight of a patch is zero at a vertex on its boundary");
  return {Exact_rational(p[0] / p[3]), Exact_rational(p[1] / p[3]), Exact_rational(p[2] / p[3])};
}

// A vector of doubles in the direction of `v`, of length 1, or 0 if it has no direction.
template <class NT>
Double_point unit_vector(const Coordinates<NT, 3>& v)
{
  Double_point d{number_cast<double>(v[0]), number_cast<double>(v[1]), number_cast<double>(v[2])};
  const double length = std::hypot(d[0], d[1], d[2]);
  for (double& x : d)
    x = length > 0 && std::isfinite(length) ? x / length : 0;
  return d;
}

inline double distance(const Double_point& a, const Double_point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class Edge_curve
{
public:
  // `first` and `last` are the vertices of the ends.
  Edge_curve(const Exact_control& control, std::size_t first, std::size_t last,
             const Patch_mesh_settings& settings, Vertex_store& store)
    : m_control(control), m_settings(settings), m_store(store), m_net(make_net(control))
  {
    m_breaks.push_back({0, first, evaluate(0).tangent});
    // Two segments, or four of a closed curve: then no two segments have the same ends.
    const Break end{parameter_end, last, evaluate(parameter_end).tangent};
    subdivide(m_breaks.front(), end, first == last ? 2 : 1);
    m_breaks.push_back(end);
  }

  // Whether there is a vertex at t.
  bool has_vertex(std::int32_t t) const { return find(t)->t == t; }

  // The vertex at t. \pre there is one
  std::size_t vertex(std::int32_t t) const { return find(t)->vertex; }

private:
  struct Break
  {
    std::int32_t t;
    std::size_t vertex;
    Double_point tangent;
  };
  struct Evaluation
  {
    Exact_point point;
    Double_point tangent;
  };

  static Interval_net make_net(const Exact_control& control)
  {
    const bool is_rational = std::any_of(control.begin(), control.end(),
                                         [](const auto& p) { return p[3] != 1; });
    const Interval_nt<false>::Protector protector;
    return interval_net(static_cast<int>(control.size()) - 1, 0, is_rational,
                        [&](int i, int) -> const auto& { return control[i]; });
  }

  std::vector<Break>::const_iterator find(std::int32_t t) const
  {
    return std::lower_bound(m_breaks.begin(), m_breaks.end(), t,
                            [](const Break& b, std::int32_t s) { return b.t < s; });
  }

  // De Casteljau; the last but one step gives the tangent.
  Evaluation evaluate(std::int32_t at) const
  {
    const Exact_rational t = exact_parameter(at), s = 1 - t;
    Exact_control p = m_control;
    Exact_point tangent;
    for (std::size_t left = p.size() - 1; left > 0; --left)
    {
      if (left == 1)
        for (int k = 0; k < 3; ++k)
          tangent[k] = p[1][k] * p[0][3] - p[0][k] * p[1][3];
      for (std::size_t i = 0; i < left; ++i)
        for (int k = 0; k < 4; ++k)
          p[i][k] = s * p[i][k] + t * p[i + 1][k];
    }
    return {affine_point(p[0]), unit_vector(tangent)};
  }

  void subdivide(const Break& a, const Break& b, int least_depth)
  {
    if (least_depth <= 0 && is_fine(a, b))
      return;
    if (b.t - a.t < 2)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "an edge of a patch cannot be divided finely enough");
    const std::int32_t t = a.t + (b.t - a.t) / 2;
    const Evaluation e = evaluate(t);
    const Break middle{t, m_store.add(e.point), e.tangent};
    if (m_store.size() > m_settings.max_vertices)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "the mesh needs more vertices than are allowed");
    subdivide(a, middle, least_depth - 1);
    m_breaks.push_back(middle);
    subdivide(middle, b, least_depth - 1);
  }

  // Half of the tolerance is left for the triangles: they come as close to the chord's bound as one
  // likes by dividing their other edges, but not below it.
  bool is_fine(const Break& a, const Break& b) const
  {
    const double length = distance(m_store[a.vertex], m_store[b.vertex]);
    if (length > m_settings.max_edge_length)
      return false;
    if (length > m_settings.tolerance && dot(a.tangent, a.tangent) > 0 &&
        dot(b.tangent, b.tangent) > 0 && dot(a.tangent, b.tangent) < m_settings.min_cosine)
      return false;
    const Interval_nt<false>::Protector protector;
    Interval_net net = m_net;
    net.restrict_to(parameter_value(a.t), parameter_value(b.t), 0, 1);
    return chord_bound(second_derivatives(net).uu) <= m_settings.face_target / 2;
  }

  const Exact_control m_control;
  const Patch_mesh_settings& m_settings;
  Vertex_store& m_store;
  const Interval_net m_net;
  std::vector<Break> m_breaks;
};

// An edge of a patch: a piece of the common curve, or a single vertex.
struct Patch_side
{
  const Edge_curve* curve; // null if the edge is collapsed
  bool is_reversed;
  std::size_t collapsed_vertex;

  std::size_t vertex(std::int32_t t) const
  {
    return curve ? curve->vertex(along(t)) : collapsed_vertex;
  }
  bool has_vertex(std::int32_t t) const { return curve && curve->has_vertex(along(t)); }

private:
  std::int32_t along(std::int32_t t) const { return is_reversed ? parameter_end - t : t; }
};

// All curves of a mesh, each once.
class Edge_curves
{
public:
  Edge_curves(const Patch_mesh_settings& settings, Vertex_store& store)
    : m_settings(settings), m_store(store)
  {}

  Patch_side side(const Bezier_surface_3<Exact_rational>& patch, Patch_edge edge)
  {
    Exact_control forward = edge_points(patch, edge);
    const std::size_t first = m_store.add_corner(affine_point(forward.front()));
    const std::size_t last = m_store.add_corner(affine_point(forward.back()));
    if (is_collapsed(forward))
      return {nullptr, false, first};
    Exact_control backward(forward.rbegin(), forward.rend());
    normalise(forward);
    normalise(backward);
    const bool is_reversed = backward < forward;
    const Exact_control& control = is_reversed ? backward : forward;
    auto found = m_curves.find(control);
    if (found == m_curves.end())
      found = m_curves.try_emplace(control, control, is_reversed ? last : first,
                                   is_reversed ? first : last, m_settings, m_store).first;
    return {&found->second, is_reversed, 0};
  }

private:
  // Weights are given up to a common factor.
  static void normalise(Exact_control& control)
  {
    const Exact_rational w = control.front()[3];
    for (auto& p : control)
      for (Exact_rational& x : p)
        x = x / w;
  }

  const Patch_mesh_settings& m_settings;
  Vertex_store& m_store;
  std::map<Exact_control, Edge_curve> m_curves;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EDGE_CURVES_H
