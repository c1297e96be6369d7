// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESHER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESHER_H

// The mesher of patches from its parts: edge curves, triangulations, the mesh, its properties.

#include <CGAL/Shape_interrogation/Meshing/Patch_mesh_options.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Patch_triangulation.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fill_patch_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Patch_mesher
{
  using Patch = Bezier_surface_3<Exact_rational>;

public:
  Patch_mesher(const std::vector<Patch>& patches, const Patch_mesh_options& options)
    : m_patches(patches), m_flipped(options.flipped), m_settings(settings(patches, options)),
      m_curves(m_settings, m_store)
  {}

  template <class Progress>
  Shape_mesh operator()(Progress& progress)
  {
    for (std::size_t i = 0; i < m_patches.size(); ++i)
      triangulate(static_cast<int>(i), [&] { return progress(i, m_patches.size()); });
    Built_mesh built = build_surface_mesh(m_store, m_triangles);
    Shape_mesh result{std::move(built.mesh), {}};
    describe_topology(result.surface_mesh, result.report);
    describe_distances(result.report);
    result.report.manifold = built.is_manifold;
    fill(result, built.source, [&] { return progress(m_patches.size(), m_patches.size()); });
    return result;
  }

private:
  bool is_flipped(std::size_t i) const { return i < m_flipped.size() && m_flipped[i]; }

  static double largest_coordinate(const std::vector<Patch>& patches, double& side)
  {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const Patch& p : patches)
      for (int i = 0; i <= p.degree_u(); ++i)
        for (int j = 0; j <= p.degree_v(); ++j)
          for (int k = 0; k < 3 && !CGAL::is_zero(p.weight(i, j)); ++k)
          {
            const double x = number_cast<double>(p.control_point(i, j)[k]);
            low[k] = (std::min)(low[k], x);
            high[k] = (std::max)(high[k], x);
          }
    double largest = 0;
    side = 0;
    for (int k = 0; k < 3; ++k)
    {
      side = (std::max)(side, high[k] - low[k]);
      largest = (std::max)({largest, std::abs(low[k]), std::abs(high[k])});
    }
    return largest;
  }

  static Patch_mesh_settings settings(const std::vector<Patch>& patches,
                                      const Patch_mesh_options& options)
  {
    double side = 0;
    const double largest = largest_coordinate(patches, side);
    if (patches.empty())
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "there is no patch to mesh");
    if (side == 0)
      refuse_mesh(Refusal_code::IRREGULAR_PARAMETRISATION, "the patches are a single point");
    // Squares of lengths must neither overflow nor vanish.
    if (!(largest <= 1e150 && side >= 1e-140))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the patches are too large or too small for floating point: scale the model");
    const double tolerance = options.tolerance > 0 ? options.tolerance : side / 1000;
    if (!(tolerance >= std::ldexp(largest, -42)))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the tolerance is too small beside the coordinates: it must be at least 2^-42 of"
                  " the largest one");
    const double degree = 3.14159265358979323846 / 180;
    return {tolerance, tolerance * 0.999,
            options.max_edge_length > 0 ? options.max_edge_length
                                        : std::numeric_limits<double>::infinity(),
            options.max_angle > 0 ? std::cos((std::min)(options.max_angle, 180.0) * degree) : -2,
            options.max_vertices};
  }

  template <class Go_on>
  void triangulate(int index, Go_on go_on)
  {
    const Patch& patch = m_patches[index];
    std::array<Patch_side, 4> sides;
    const std::array<Patch_edge, 4> edges{Patch_edge::U0, Patch_edge::U1, Patch_edge::V0,
                                          Patch_edge::V1};
    for (int k = 0; k < 4; ++k)
    {
      sides[k] = m_curves.side(patch, edges[k]);
      if (!sides[k].curve)
        add_limit_normal(m_limits, sides[k].collapsed_vertex, limit_normal(patch, edges[k]),
                         is_flipped(index));
    }
    if ((!sides[0].curve || !sides[1].curve) && (!sides[2].curve || !sides[3].curve))
      refuse_mesh(Refusal_code::IRREGULAR_PARAMETRISATION,
                  "two edges that meet are collapsed in patch " + std::to_string(index));
    Patch_triangulation t(patch, index, sides, m_settings, m_store);
    t.refine(go_on);
    m_places.resize(m_store.size());
    for (const Patch_vertices::Vertex& v : t.vertices())
      m_places[v.global].push_back({index, v.uv[0], v.uv[1]});
    for (const Patch_triangulation::Triangle& triangle : t.triangles())
    {
      m_face_distance = (std::max)(m_face_distance, triangle.bound);
      std::array<int, 3> c = triangle.corners;
      if (is_flipped(index))
        std::swap(c[1], c[2]);
      m_triangles.push_back({t.vertices()[c[0]].global, t.vertices()[c[1]].global,
                             t.vertices()[c[2]].global});
      m_patch_of_triangle.push_back(index);
    }
  }

  void describe_distances(Mesh_report& report) const
  {
    report.tolerance = m_settings.tolerance;
    report.max_vertex_distance = m_store.max_distance();
    const Interval_nt<true> face = Interval_nt<true>(m_face_distance) +
                                   Interval_nt<true>(m_store.max_distance());
    report.max_face_distance = face.sup();
    report.vertex_distance_certified = report.face_distance_certified = true;
    if (!(report.max_face_distance <= report.tolerance))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "rounding the vertices to doubles moves them by more than the tolerance allows");
  }

  // Those of the places that are in patches around the vertex: others only touch it.
  std::vector<Patch_place> places_of(const Shape_mesh::Surface_mesh& mesh,
                                     Shape_property_maps::Vertex v,
                                     const std::vector<Patch_place>& places) const
  {
    std::vector<int> around;
    for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if (!mesh.is_border(h))
        around.push_back(m_patch_of_triangle[mesh.face(h).idx()]);
    std::vector<Patch_place> own;
    for (const Patch_place& place : places)
      if (std::find(around.begin(), around.end(), place.patch) != around.end())
        own.push_back(place);
    return own;
  }

  template <class Go_on>
  void fill(Shape_mesh& result, const std::vector<std::size_t>& source, Go_on go_on)
  {
    std::vector<Patch_evaluator> evaluators;
    for (std::size_t i = 0; i < m_patches.size(); ++i)
      evaluators.emplace_back(m_patches[i], is_flipped(i));
    Shape_property_maps maps(result.surface_mesh);
    Patch_property_maps where(result.surface_mesh);
    std::vector<bool> has_regular_vertex(m_patches.size(), false);
    for (const auto v : result.surface_mesh.vertices())
    {
      if (v.idx() % 256 == 0 && !go_on())
        refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
      const std::size_t i = source[v.idx()];
      auto refused = fill_vertex(maps, where, v, result.surface_mesh.point(v), evaluators,
                                 places_of(result.surface_mesh, v, m_places[i]));
      if (!refused)
      {
        has_regular_vertex[where.vertex_patch[v]] = true;
        continue;
      }
      result.report.refused_places.push_back(*refused);
      const auto limit = m_limits.find(i);
      if (limit != m_limits.end() && limit->second)
        maps.normal[v] = kernel_vector(unit_vector(*limit->second));
    }
    for (std::size_t i = 0; i < m_patches.size(); ++i)
      if (!has_regular_vertex[i])
        refuse_mesh(Refusal_code::IRREGULAR_PARAMETRISATION,
                    "patch " + std::to_string(i) + " is a curve or a point, not a surface");
    for (const auto f : result.surface_mesh.faces())
      where.face_patch[f] = m_patch_of_triangle[f.idx()];
  }

  const std::vector<Patch>& m_patches;
  const std::vector<bool> m_flipped;
  const Patch_mesh_settings m_settings;
  Vertex_store m_store;
  Edge_curves m_curves;
  Limit_normals m_limits;
  std::vector<std::vector<Patch_place>> m_places; // of each vertex
  std::vector<Soup_triangle> m_triangles;
  std::vector<int> m_patch_of_triangle;
  double m_face_distance = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATCH_MESHER_H
