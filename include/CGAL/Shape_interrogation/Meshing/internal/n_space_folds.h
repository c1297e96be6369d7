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
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// The polylines of a graph, each edge once: from end to end, then the closed ones.
inline std::vector<std::vector<std::size_t>> chains_of(
  const std::vector<std::pair<std::size_t, std::size_t>>& edges, std::size_t nodes)
{
  std::vector<std::vector<std::size_t>> incident(nodes);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    incident[edges[e].first].push_back(e);
    incident[edges[e].second].push_back(e);
  }
  std::vector<bool> is_used(edges.size(), false);
  std::vector<std::vector<std::size_t>> chains;
  const auto follow = [&](std::size_t node) {
    std::vector<std::size_t> chain{node};
    for (;;)
    {
      const auto next = std::find_if(incident[node].begin(), incident[node].end(),
                                     [&](std::size_t e) { return !is_used[e]; });
      if (next == incident[node].end())
        break;
      is_used[*next] = true;
      node = edges[*next].first == node ? edges[*next].second : edges[*next].first;
      chain.push_back(node);
      if (incident[node].size() != 2)
        break;
    }
    if (chain.size() > 1)
      chains.push_back(std::move(chain));
  };
  for (std::size_t node = 0; node < nodes; ++node)
    if (incident[node].size() != 2)
      for (std::size_t k = 0; k < incident[node].size(); ++k)
        follow(node);
  for (std::size_t node = 0; node < nodes; ++node)
    follow(node);
  return chains;
}

// A chain whose last node is the first one is closed.
inline N_space_polyline polyline_of(const std::vector<std::size_t>& chain,
                                    const std::vector<std::vector<double>>& points)
{
  N_space_polyline line;
  line.closed = chain.size() > 2 && chain.front() == chain.back();
  for (std::size_t i = 0; i + (line.closed ? 1 : 0) < chain.size(); ++i)
    line.points.push_back(points[chain[i]]);
  return line;
}

class Fold_finder
{
public:
  explicit Fold_finder(N_space_cover& cover) : m_cover(cover) {}

  std::vector<N_space_polyline> operator()(const std::vector<Soup_triangle>& triangles)
  {
    std::vector<std::pair<std::size_t, std::size_t>> segments;
    for (const Soup_triangle& t : triangles)
    {
      std::vector<std::size_t> crossed;
      for (int i = 0; i < 3; ++i)
        if (const auto node = node_of(t[i], t[(i + 1) % 3]))
          crossed.push_back(*node);
      if (crossed.size() >= 2)
        segments.emplace_back(crossed[0], crossed[1]);
    }
    std::vector<N_space_polyline> lines;
    for (const std::vector<std::size_t>& chain : chains_of(segments, m_points.size()))
      lines.push_back(polyline_of(chain, m_points));
    return lines;
  }

private:
  // The index of the fold point on an edge, if there is one.
  std::optional<std::size_t> node_of(std::size_t a, std::size_t b)
  {
    const std::pair<std::size_t, std::size_t> edge = std::minmax(a, b);
    const auto known = m_nodes.find(edge);
    if (known != m_nodes.end())
      return known->second;
    std::optional<std::size_t> node;
    if (auto p = fold_between(m_cover.vertices()[edge.first].chart,
                              m_cover.vertices()[edge.second].chart))
    {
      node = m_points.size();
      m_points.push_back(std::move(*p));
    }
    m_nodes[edge] = node;
    return node;
  }

  // Halves the edge upstairs until the projected normal turns over within a rounding.
  std::optional<std::vector<double>> fold_between(const N_space_chart& a, const N_space_chart& b)
  {
    const Coordinates<double, 3> na = projected_normal(a), nb = projected_normal(b);
    if (dot(na, nb) >= 0)
      return std::nullopt;
    N_space_chart low = a, high = b;
    for (int i = 0; i < 40 && (std::min)(low.contraction, high.contraction) > 1e-12; ++i)
    {
      std::vector<double> middle = low.point;
      for (std::size_t k = 0; k < middle.size(); ++k)
        middle[k] = (low.point[k] + high.point[k]) / 2;
      const Result<Cover_vertex> corrected = m_cover.correct(middle);
      if (!corrected)
        return std::nullopt;
      N_space_chart chart = corrected->chart;
      if (angle_between(a, chart).is_reversed)
        std::swap(chart.basis[0], chart.basis[1]);
      // Against both ends, whose normals need not be quite opposite.
      const Coordinates<double, 3> n = projected_normal(chart);
      const double to_a = dot(n, na) / std::sqrt(dot(na, na));
      const double to_b = dot(n, nb) / std::sqrt(dot(nb, nb));
      (to_a >= to_b ? low : high) = std::move(chart);
    }
    const N_space_chart& best = low.contraction < high.contraction ? low : high;
    return best.contraction < 1e-4 ? std::optional<std::vector<double>>(best.point) : std::nullopt;
  }

  N_space_cover& m_cover;
  std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> m_nodes;
  std::vector<std::vector<double>> m_points;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_FOLDS_H
