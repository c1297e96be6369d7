// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHAINS_OF_EDGES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHAINS_OF_EDGES_H

// Joins edges to polylines.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

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

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHAINS_OF_EDGES_H
