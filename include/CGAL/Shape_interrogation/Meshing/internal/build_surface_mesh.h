// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BUILD_SURFACE_MESH_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BUILD_SURFACE_MESH_H

// From triangles of numbered points to a Surface_mesh. Where triangles do not meet as on a surface
// (an edge with three of them or with two of opposite orientations, fans that share only a point)
// the vertex is doubled, so that every triangle is kept.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Soup_triangle = std::array<std::size_t, 3>;

// Sets of corners that will be one vertex: corner k of triangle t has the number 3 t + k.
class Corner_sets
{
public:
  explicit Corner_sets(std::size_t size) : m_parent(size)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  // The set is named by its first corner.
  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    m_parent[(std::max)(i, j)] = (std::min)(i, j);
  }

private:
  std::vector<std::size_t> m_parent;
};

// Unites the corners at both ends of every edge that has exactly two triangles, which run along it
// in opposite directions. Sets `is_manifold` to false if an edge has other sets of triangles.
inline Corner_sets fans_of(const std::vector<Soup_triangle>& triangles, bool& is_manifold)
{
  // The ends in increasing order, the direction, and the corners at these ends.
  using Side = std::tuple<std::size_t, std::size_t, bool, std::size_t, std::size_t>;
  std::vector<Side> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3, a = triangles[t][k], b = triangles[t][l];
      if (a < b)
        sides.emplace_back(a, b, true, 3 * t + k, 3 * t + l);
      else
        sides.emplace_back(b, a, false, 3 * t + l, 3 * t + k);
    }
  std::sort(sides.begin(), sides.end());
  const auto same_edge = [](const Side& x, const Side& y) {
    return std::get<0>(x) == std::get<0>(y) && std::get<1>(x) == std::get<1>(y);
  };
  Corner_sets sets(3 * triangles.size());
  for (std::size_t i = 0; i < sides.size(); )
  {
    std::size_t end = i + 1;
    while (end < sides.size() && same_edge(sides[i], sides[end]))
      ++end;
    if (end == i + 2 && std::get<2>(sides[i]) != std::get<2>(sides[i + 1]))
    {
      sets.unite(std::get<3>(sides[i]), std::get<3>(sides[i + 1]));
      sets.unite(std::get<4>(sides[i]), std::get<4>(sides[i + 1]));
    }
    else if (end > i + 1)
      is_manifold = false;
    i = end;
  }
  return sets;
}

struct Built_mesh
{
  Shape_mesh::Surface_mesh mesh;   // the triangle t is the face t
  std::vector<std::size_t> source; // the point that each vertex is
  bool is_manifold = true;         // whether no edge had too many triangles
};

// `points[i]` has three coordinates. No two corners of a triangle may be the same point.
template <class Points>
Built_mesh build_surface_mesh(const Points& points, const std::vector<Soup_triangle>& triangles)
{
  using Vertex = Shape_mesh::Surface_mesh::Vertex_index;
  Built_mesh built;
  Corner_sets sets = fans_of(triangles, built.is_manifold);
  const auto new_vertex = [&](std::size_t i) {
    built.source.push_back(i);
    return built.mesh.add_vertex(Shape_mesh::Point_3(points[i][0], points[i][1], points[i][2]));
  };
  // The fans of each point, ordered by point: most meshes keep the order of their points.
  std::vector<std::pair<std::size_t, std::size_t>> fans;
  for (std::size_t c = 0; c < 3 * triangles.size(); ++c)
    if (sets.find(c) == c)
      fans.emplace_back(triangles[c / 3][c % 3], c);
  std::sort(fans.begin(), fans.end());
  std::vector<Vertex> vertex(3 * triangles.size());
  for (const auto& fan : fans)
    vertex[fan.second] = new_vertex(fan.first);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    std::array<Vertex, 3> v;
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = vertex[sets.find(3 * t + k)];
    if (built.mesh.add_face(v[0], v[1], v[2]) != Shape_mesh::Surface_mesh::null_face())
      continue;
    built.is_manifold = false;
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = new_vertex(triangles[t][k]);
    built.mesh.add_face(v[0], v[1], v[2]);
  }
  return built;
}

// The topological part of the report.
inline void describe_topology(const Shape_mesh::Surface_mesh& mesh, Mesh_report& report)
{
  report.vertices = mesh.number_of_vertices();
  report.faces = mesh.number_of_faces();
  report.euler_characteristic = static_cast<int>(mesh.number_of_vertices()) -
                                static_cast<int>(mesh.number_of_edges()) +
                                static_cast<int>(mesh.number_of_faces());
  for (const auto e : mesh.edges())
    report.boundary_edges += mesh.is_border(e);
  Corner_sets sets(mesh.number_of_vertices());
  for (const auto e : mesh.edges())
    sets.unite(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    report.components += sets.find(v) == v;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BUILD_SURFACE_MESH_H
