// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_MESHER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_MESHER_H

// A divided domain lifted to its patch, with the second-order data at the vertices. Edges of the
// square that the patch maps to a point become one vertex.

#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/Region_property_maps.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Edge_curves.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fill_patch_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Region_mesher
{
  using Patch = Bezier_surface_3<Exact_rational>;

public:
  Region_mesher(const Patch& patch, const Divided_domain& domain)
    : m_patch(patch), m_domain(domain), m_evaluator(patch, false), m_vertex(domain.points.size())
  {}

  template <class Progress>
  Shape_mesh operator()(Progress& progress)
  {
    evaluate([&](std::size_t done) { return progress(done, 2 * m_vertex.size()); });
    join_collapsed();
    Built_mesh built = build();
    if (!built.is_manifold)
    {
      std::iota(m_vertex.begin(), m_vertex.end(), std::size_t(0));
      built = build();
    }
    Shape_mesh result{std::move(built.mesh), {}};
    describe_topology(result.surface_mesh, result.report);
    result.report.manifold = built.is_manifold;
    describe_distances(result.report);
    fill_faces(result.surface_mesh);
    mark_contour(result.surface_mesh, built.source);
    fill_vertices(result, built.source, [&](std::size_t done) {
      return progress(m_vertex.size() + done, 2 * m_vertex.size());
    });
    return result;
  }

private:
  template <class Go_on>
  static void check(std::size_t done, Go_on go_on)
  {
    if (done % 256 == 0 && !go_on(done))
      refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
  }

  template <class Go_on>
  void evaluate(Go_on go_on)
  {
    for (const auto& p : m_domain.points)
    {
      check(m_points.size(), go_on);
      double distance = 0;
      const Result<Double_point> point = m_evaluator.point(p[0], p[1], distance);
      if (!point)
        throw Mesh_refused{point.refusal()};
      m_points.push_back(*point);
      m_vertex_distance = (std::max)(m_vertex_distance, distance);
    }
  }

  void join_collapsed()
  {
    Corner_sets sets(m_vertex.size());
    for (const Patch_edge edge : m_patch.collapsed_edges())
    {
      const std::size_t none = m_vertex.size();
      std::size_t first = none;
      const auto normal = limit_normal(m_patch, edge);
      for (std::size_t i = 0; i < m_vertex.size(); ++i)
        if (m_domain.points[i][static_cast<int>(edge) / 2] == static_cast<int>(edge) % 2)
        {
          add_limit_normal(m_limits, i, normal, false);
          first = (std::min)(first, i);
          sets.unite(first, i);
        }
    }
    for (std::size_t i = 0; i < m_vertex.size(); ++i)
      m_vertex[i] = sets.find(i);
  }

  // Without triangles with two equal corners.
  Built_mesh build()
  {
    std::vector<Soup_triangle> triangles;
    m_triangles.clear();
    for (std::size_t t = 0; t < m_domain.triangles.size(); ++t)
    {
      Soup_triangle corners;
      for (int k = 0; k < 3; ++k)
        corners[k] = m_vertex[m_domain.triangles[t][k]];
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        continue;
      triangles.push_back(corners);
      m_triangles.push_back(t);
    }
    return build_surface_mesh(m_points, triangles);
  }

  // Of the centres of triangles from the points of the patch with their parameters.
  void describe_distances(Mesh_report& report) const
  {
    report.max_vertex_distance = report.max_face_distance = m_vertex_distance;
    report.vertex_distance_certified = true;
    const auto patch = m_patch.cast<double>();
    for (const std::size_t t : m_triangles)
    {
      Double_point middle{0, 0, 0};
      std::array<double, 2> uv{0, 0};
      for (const int corner : m_domain.triangles[t])
      {
        for (int k = 0; k < 3; ++k)
          middle[k] += m_points[corner][k] / 3;
        for (int k = 0; k < 2; ++k)
          uv[k] += m_domain.points[corner][k] / 3;
      }
      const auto p = patch.point({(std::min)(uv[0], 1.), (std::min)(uv[1], 1.)});
      if (p)
        report.max_face_distance =
          (std::max)(report.max_face_distance, std::hypot((*p)[0] - middle[0], (*p)[1] - middle[1],
                                                          (*p)[2] - middle[2]));
    }
  }

  void fill_faces(Shape_mesh::Surface_mesh& mesh) const
  {
    Patch_property_maps where(mesh);
    Region_property_maps regions(mesh);
    for (const auto f : mesh.faces())
    {
      where.face_patch[f] = 0;
      regions.face_region[f] = m_domain.regions[m_triangles[f.idx()]];
    }
  }

  void mark_contour(Shape_mesh::Surface_mesh& mesh, const std::vector<std::size_t>& source) const
  {
    Region_property_maps regions(mesh);
    std::vector<std::size_t> place(m_vertex.size());
    for (std::size_t v = 0; v < source.size(); ++v)
      place[source[v]] = v;
    for (const auto& edge : m_domain.contour_edges)
    {
      using Vertex = Shape_mesh::Surface_mesh::Vertex_index;
      const std::size_t a = m_vertex[edge[0]], b = m_vertex[edge[1]];
      if (a == b)
        continue;
      const auto h = mesh.halfedge(Vertex(static_cast<Vertex::size_type>(place[a])),
                                   Vertex(static_cast<Vertex::size_type>(place[b])));
      if (h != Shape_mesh::Surface_mesh::null_halfedge())
        regions.contour_edge[mesh.edge(h)] = true;
    }
  }

  template <class Go_on>
  void fill_vertices(Shape_mesh& result, const std::vector<std::size_t>& source, Go_on go_on)
  {
    Shape_property_maps maps(result.surface_mesh);
    Patch_property_maps where(result.surface_mesh);
    for (const auto v : result.surface_mesh.vertices())
    {
      check(v.idx(), go_on);
      const std::size_t i = source[v.idx()];
      const std::array<double, 2>& uv = m_domain.points[i];
      where.vertex_patch[v] = 0;
      where.parameter[v] = Shape_mesh::Point_2(uv[0], uv[1]);
      const Result<Vertex_shape> shape = m_evaluator(uv[0], uv[1]);
      if (shape)
      {
        set_shape(maps, v, *shape);
        continue;
      }
      result.report.refused_places.push_back(
        {v.idx(), 0, uv, m_points[i], shape.refusal().code(), shape.refusal().evidence()});
      const auto limit = m_limits.find(i);
      if (limit != m_limits.end() && limit->second)
        maps.normal[v] = kernel_vector(unit_vector(*limit->second));
    }
    if (result.report.refused_places.size() == result.surface_mesh.number_of_vertices())
      refuse_mesh(Refusal_code::IRREGULAR_PARAMETRISATION,
                  "the patch is a curve or a point, not a surface");
  }

  const Patch& m_patch;
  const Divided_domain& m_domain;
  const Patch_evaluator m_evaluator;
  std::vector<Double_point> m_points;  // of the vertices of the domain
  std::vector<std::size_t> m_vertex;   // the first of those that are one vertex of the mesh
  std::vector<std::size_t> m_triangles; // those that are triangles of the mesh
  Limit_normals m_limits;
  double m_vertex_distance = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_REGION_MESHER_H
