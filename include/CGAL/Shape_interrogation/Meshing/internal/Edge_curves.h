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
#include <iterator>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Exact_control = std::vector<Exact_homogeneous_point>;

inline Exact_point affine_point(const Exact_homogeneous_point& p)
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
    : m_settings(settings), m_store(store), m_exact(make_exact(control)), m_net(make_net(control))
  {
    const Break begin{0, first, tangent(0), 0};
    const Break end{parameter_end, last, tangent(parameter_end), 0};
    // Two segments, or four of a closed curve: then no two segments have the same ends.
    subdivide(begin, end, first == last ? 2 : 1);
    m_breaks.push_back(end);
  }

  // Whether there is a vertex at t.
  bool has_vertex(std::int32_t t) const { return find(t)->t == t; }

  // The vertex at t. \pre there is one
  std::size_t vertex(std::int32_t t) const { return find(t)->vertex; }

  // How the points of the segment from s to t > s slide along the curve (see triangle_bound.h);
  // 0 unless it is one segment.
  double shift(std::int32_t s, std::int32_t t) const
  {
    const auto at = find(s);
    return at->t == s && std::next(at) != m_breaks.end() && std::next(at)->t == t ? at->shift : 0;
  }

  // The length of the longest segment that ends at the vertex at t.
  double spacing(std::int32_t t) const
  {
    const auto at = find(t);
    double longest = 0;
    if (at != m_breaks.begin())
      longest = distance(m_store[at->vertex], m_store[std::prev(at)->vertex]);
    if (std::next(at) != m_breaks.end())
      longest = (std::max)(longest, distance(m_store[at->vertex], m_store[std::next(at)->vertex]));
    return longest;
  }

private:
  struct Break
  {
    std::int32_t t;
    std::size_t vertex;
    Double_point tangent;
    double shift; // of the segment that begins here
  };
  static Exact_net make_exact(const Exact_control& control)
  {
    return Exact_net(static_cast<int>(control.size()) - 1, 0,
                     [&](int i, int) -> const auto& { return control[i]; });
  }

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

  Double_point tangent(std::int32_t t) const { return unit_vector(m_exact.tangent(t)); }

  void subdivide(Break a, const Break& b, int least_depth)
  {
    a.shift = least_depth > 0 ? 0 : best_shift(a.t, b.t);
    if (least_depth <= 0 && is_fine(a, b))
    {
      m_breaks.push_back(a);
      return;
    }
    if (b.t - a.t < 2)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "an edge of a patch cannot be divided finely enough");
    if (m_store.size() >= m_settings.max_vertices)
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "the mesh needs more vertices than are allowed");
    const std::int32_t t = a.t + (b.t - a.t) / 2;
    const std::optional<Exact_point> point = m_exact.point(t, 0);
    if (!point)
      refuse_mesh(Refusal_code::POLE, "the weight of a patch is zero on an edge");
    const Break middle{t, m_store.add(*point), tangent(t), 0};
    subdivide(a, middle, least_depth - 1);
    subdivide(middle, b, least_depth - 1);
  }

  // Half of the target is left for the triangles: they come as close to the chord's bound as one
  // likes by dividing their other edges, but not below it.
  bool is_fine(const Break& a, const Break& b) const
  {
    const double length = distance(m_store[a.vertex], m_store[b.vertex]);
    if (length > m_settings.max_edge_length)
      return false;
    if (length > m_settings.tolerance && dot(a.tangent, a.tangent) > 0 &&
        dot(b.tangent, b.tangent) > 0 && dot(a.tangent, b.tangent) < m_settings.min_cosine)
      return false;
    const double s = parameter_value(a.t), t = parameter_value(b.t);
    // As wide as the boxes of the triangles beside, whose bounds then tend to this one.
    const double low = (std::max)(0.0, step_down(s - 0.34 * std::abs(a.shift)));
    const double high = (std::min)(1.0, step_up(t + 0.34 * std::abs(a.shift)));
    const Interval_nt<false>::Protector protector;
    Interval_net net = m_net;
    net.restrict_to(low, high, 0, 1);
    const Mesh_interval width = Mesh_interval(high) - Mesh_interval(low);
    return chord_bound(enclosed_derivatives(net), (Mesh_interval(t) - Mesh_interval(s)) / width,
                       Mesh_interval(a.shift) / width) <= m_settings.face_target / 2;
  }

  double best_shift(std::int32_t from, std::int32_t to) const
  {
    const double s = parameter_value(from), t = parameter_value(to);
    const Interval_nt<false>::Protector protector;
    Interval_net net = m_net;
    net.restrict_to(s, t, 0, 1);
    const double shift = (t - s) * Split_derivatives(enclosed_derivatives(net)).best_shift(0, 1, 1);
    // It must shrink with the edge, also beside a point where the curve is stationary.
    return std::clamp(std::clamp(shift, s - t, t - s), -(s + t), 2 - s - t);
  }

  const Patch_mesh_settings& m_settings;
  Vertex_store& m_store;
  const Exact_net m_exact;
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
  double spacing(std::int32_t t) const { return curve ? curve->spacing(along(t)) : 0; }
  double shift(std::int32_t s, std::int32_t t) const
  {
    if (!curve)
      return 0;
    const std::int32_t a = along(s), b = along(t);
    const double along_curve = curve->shift((std::min)(a, b), (std::max)(a, b));
    return is_reversed ? -along_curve : along_curve;
  }

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
