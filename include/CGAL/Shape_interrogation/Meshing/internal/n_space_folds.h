// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_FOLDS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_FOLDS_H

// The curves along which the projection folds a surface in n-space: there the projected tangent
// plane, oriented as upstairs, turns over. Each edge of the mesh that crosses one gets a point of
// it, and these are joined across the triangles.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/N_space_cover.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/chains_of_edges.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The normal of the projected plane, its length the factor of areas.
inline Coordinates<double, 3> projected_normal(const N_space_chart& chart)
{
  const auto &a = chart.basis[0], &b = chart.basis[1];
  return cross(Coordinates<double, 3>{a[0], a[1], a[2]}, Coordinates<double, 3>{b[0], b[1], b[2]});
}

// Where the folds cross the edges of the mesh. An edge near a fold is looked at in between, as it
// may be crossed twice; where folds are too near to each other for a triangle it is parted.
class Fold_finder
{
public:
  explicit Fold_finder(N_space_cover& cover) : m_cover(cover)
  {
    for (const Cover_vertex& v : cover.vertices())
      m_vertices.push_back(v.chart);
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      leave_fold(v);
  }

  std::vector<N_space_polyline> operator()(const std::vector<Soup_triangle>& triangles)
  {
    do // an edge that is parted can turn out to have more crossings
    {
      m_is_changed = false;
      for (const Soup_triangle& t : triangles)
        part({t[0], t[1], t[2]}, most_parts);
    } while (m_is_changed);
    for (const Soup_triangle& t : triangles)
      join({t[0], t[1], t[2]}, most_parts);
    std::vector<N_space_polyline> lines;
    for (const std::vector<std::size_t>& chain : chains_of(m_segments, m_points.size()))
      lines.push_back(polyline_of(chain, m_points));
    return lines;
  }

  // Points in triangles that an odd number of folds crosses, as far as can be seen.
  const std::vector<std::vector<double>>& ends() const { return m_ends; }

private:
  using Triangle = std::array<std::size_t, 3>;
  using Nodes = std::vector<std::size_t>;
  static constexpr int most_parts = 4;   // times that a triangle is parted
  static constexpr int most_halvings = 4; // of an edge in which folds are looked for

  struct Edge
  {
    Nodes nodes; // from the lower to the higher vertex
    std::optional<std::size_t> middle;
  };

  // The sides at a vertex on a fold cannot be told: a point beside it stands for the vertex.
  void leave_fold(std::size_t vertex)
  {
    const N_space_chart chart = m_vertices[vertex];
    if (chart.contraction > 1e-6)
      return;
    for (const Chart_vector& c : {Chart_vector{1e-3, 0}, Chart_vector{0, 1e-3},
                                  Chart_vector{1e-2, 1e-2}})
      if (const auto beside = correct(point_at(chart, c), chart))
        if (beside->contraction > 1e-6)
        {
          m_vertices[vertex] = *beside;
          return;
        }
  }

  // The surface point near p, oriented like a chart.
  std::optional<N_space_chart> correct(const std::vector<double>& p, const N_space_chart& like)
  {
    Result<Cover_vertex> corrected = m_cover.correct(p);
    if (!corrected)
      return std::nullopt;
    N_space_chart chart = corrected->chart;
    if (angle_between(like, chart).is_reversed)
      std::swap(chart.basis[0], chart.basis[1]);
    return chart;
  }

  std::optional<N_space_chart> middle_of(const N_space_chart& a, const N_space_chart& b)
  {
    std::vector<double> p = a.point;
    for (std::size_t k = 0; k < p.size(); ++k)
      p[k] = (a.point[k] + b.point[k]) / 2;
    return correct(p, a);
  }

  Edge& edge(std::size_t a, std::size_t b)
  {
    const std::pair<std::size_t, std::size_t> key = std::minmax(a, b);
    const auto [known, is_new] = m_edges.emplace(key, Edge());
    if (is_new)
      look_between(m_vertices[key.first], m_vertices[key.second], most_halvings,
                   known->second.nodes);
    return known->second;
  }

  // The crossings of an edge, or those of its parts.
  Nodes crossings(std::size_t a, std::size_t b)
  {
    const Edge& e = edge(a, b);
    Nodes nodes = e.nodes;
    if (e.middle)
    {
      nodes = crossings(a, *e.middle);
      const Nodes rest = crossings(*e.middle, b);
      nodes.insert(nodes.end(), rest.begin(), rest.end());
    }
    else if (a > b)
      std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  Nodes crossings(const Triangle& t)
  {
    Nodes all;
    for (int i = 0; i < 3; ++i)
      for (std::size_t node : crossings(t[i], t[(i + 1) % 3]))
        all.push_back(node);
    return all;
  }

  // The contraction of a plane differs from that of another one by their angle at most.
  void look_between(const N_space_chart& a, N_space_chart b, int halvings, Nodes& nodes)
  {
    const Plane_angle angle = angle_between(a, b);
    if (angle.is_reversed)
      std::swap(b.basis[0], b.basis[1]);
    const bool turns_over = dot(projected_normal(a), projected_normal(b)) < 0;
    const double slack = m_cover.max_turning() * std::ldexp(0.5, halvings - most_halvings);
    if (!turns_over && (halvings == 0 || a.contraction + b.contraction >
                                           std::acos((std::min)(angle.cosine, 1.)) + slack))
      return;
    const auto middle = halvings > 0 ? middle_of(a, b) : std::nullopt;
    if (middle)
    {
      look_between(a, *middle, halvings - 1, nodes);
      look_between(*middle, b, halvings - 1, nodes);
    }
    else if (turns_over)
      if (auto p = fold_between(a, b))
      {
        nodes.push_back(m_points.size());
        m_points.push_back(std::move(*p));
      }
  }

  // Halves the edge upstairs until the projected normal turns over within a rounding.
  std::optional<std::vector<double>> fold_between(const N_space_chart& a, const N_space_chart& b)
  {
    const Coordinates<double, 3> na = projected_normal(a), nb = projected_normal(b);
    N_space_chart low = a, high = b;
    for (int i = 0; i < 40 && (std::min)(low.contraction, high.contraction) > 1e-12; ++i)
    {
      auto chart = middle_of(low, high);
      if (!chart)
        return std::nullopt;
      // Against both ends, whose normals need not be quite opposite.
      const Coordinates<double, 3> n = projected_normal(*chart);
      const double to_a = dot(n, na) / std::sqrt(dot(na, na));
      const double to_b = dot(n, nb) / std::sqrt(dot(nb, nb));
      (to_a >= to_b ? low : high) = std::move(*chart);
    }
    const N_space_chart& best = low.contraction < high.contraction ? low : high;
    return best.contraction < 1e-4 ? std::optional<std::vector<double>>(best.point) : std::nullopt;
  }

  // Parts a triangle until no part has other than no or two crossings.
  void part(const Triangle& t, int times)
  {
    if (is_simple(t) || times == 0)
      return;
    bool is_able = true;
    for (int i = 0; i < 3; ++i)
      is_able = halve(t[i], t[(i + 1) % 3]) && is_able;
    if (is_able)
      for (const Triangle& small : parts_of(t))
        part(small, times - 1);
  }

  bool is_simple(const Triangle& t)
  {
    const std::size_t count = crossings(t).size();
    return count == 0 || count == 2;
  }

  bool halve(std::size_t a, std::size_t b)
  {
    if (edge(a, b).middle)
      return true;
    auto middle = middle_of(m_vertices[a], m_vertices[b]);
    if (!middle)
      return false;
    edge(a, b).middle = m_vertices.size();
    m_vertices.push_back(std::move(*middle));
    leave_fold(m_vertices.size() - 1);
    return m_is_changed = true;
  }

  // None if an edge is not parted.
  std::vector<Triangle> parts_of(const Triangle& t)
  {
    Triangle m;
    for (int i = 0; i < 3; ++i)
    {
      const Edge& e = edge(t[i], t[(i + 1) % 3]);
      if (!e.middle)
        return {};
      m[i] = *e.middle;
    }
    return {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, m};
  }

  void join(const Triangle& t, int times)
  {
    const auto parts = is_simple(t) || times == 0 ? std::vector<Triangle>() : parts_of(t);
    for (const Triangle& small : parts)
      join(small, times - 1);
    if (parts.empty())
      join(crossings(t));
  }

  // The nodes around a triangle: the nearest neighbours first, so that no segments cross.
  void join(Nodes nodes)
  {
    while (nodes.size() > 1)
    {
      std::size_t best = 0;
      double shortest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const double d = distance(nodes[i], nodes[(i + 1) % nodes.size()]);
        best = d < shortest ? i : best;
        shortest = (std::min)(d, shortest);
      }
      m_segments.emplace_back(nodes[best], nodes[(best + 1) % nodes.size()]);
      std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(best), nodes.end());
      nodes.erase(nodes.begin(), nodes.begin() + 2);
    }
    if (nodes.size() == 1)
      m_ends.push_back(m_points[nodes[0]]);
  }

  double distance(std::size_t a, std::size_t b) const
  {
    double square = 0;
    for (std::size_t k = 0; k < m_points[a].size(); ++k)
      square += (m_points[a][k] - m_points[b][k]) * (m_points[a][k] - m_points[b][k]);
    return std::sqrt(square);
  }

  N_space_cover& m_cover;
  std::vector<N_space_chart> m_vertices; // of the mesh, then the middles of parted edges
  std::map<std::pair<std::size_t, std::size_t>, Edge> m_edges;
  std::vector<std::vector<double>> m_points;
  std::vector<std::pair<std::size_t, std::size_t>> m_segments;
  std::vector<std::vector<double>> m_ends;
  bool m_is_changed = false;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_FOLDS_H
