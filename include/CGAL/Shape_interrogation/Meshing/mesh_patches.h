// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H

// Adaptive triangulation of Bezier patches with a certified distance, and with identical vertices
// on the edges that patches have in common.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Patch_triangulation.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fill_patch_properties.h>
#include <CGAL/Shape_interrogation/Meshing/progress.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how fine a mesh of patches must be.
 */
struct Patch_mesh_options
{
  //! largest distance of the mesh from the patches; 0 stands for a thousandth of the largest side
  //! of the box around all control points
  double tolerance = 0;
  //! largest length of an edge; 0 stands for no bound
  double max_edge_length = 0;
  //! largest angle in degrees between the normals at the ends of an edge, on the boundary of a
  //! patch between the tangents of the boundary; it does not divide edges shorter than the
  //! tolerance; 0 stands for no bound
  double max_angle = 15;
  //! largest number of vertices
  std::size_t max_vertices = 5000000;
};

namespace internal {

class Patch_mesher
{
  using Patch = Bezier_surface_3<Exact_rational>;

public:
  Patch_mesher(const std::vector<Patch>& patches, const Patch_mesh_options& options)
    : m_patches(patches), m_settings(settings(patches, options)), m_curves(m_settings, m_store)
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
    if (!(side > 0 && largest <= (std::numeric_limits<double>::max)()))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "the patches are empty, or larger than a double");
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
        add_limit_normal(m_limits, sides[k].collapsed_vertex, limit_normal(patch, edges[k]));
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
      const auto& c = triangle.corners;
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

  template <class Go_on>
  void fill(Shape_mesh& result, const std::vector<std::size_t>& source, Go_on go_on)
  {
    std::vector<Patch_evaluator> evaluators(m_patches.begin(), m_patches.end());
    Shape_property_maps maps(result.surface_mesh);
    Patch_property_maps where(result.surface_mesh);
    std::vector<bool> has_regular_vertex(m_patches.size(), false);
    for (const auto v : result.surface_mesh.vertices())
    {
      if (v.idx() % 256 == 0 && !go_on())
        refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
      const std::size_t i = source[v.idx()];
      auto refused = fill_vertex(maps, where, v, result.surface_mesh.point(v), evaluators,
                                 m_places[i]);
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
    for (const auto f : result.surface_mesh.faces())
      where.face_patch[f] = m_patch_of_triangle[f.idx()];
  }

  const std::vector<Patch>& m_patches;
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

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates Bezier patches, polynomial or rational, into one mesh.
 *
 * \details The parameter square of each patch is divided adaptively until each triangle is proved
 * to be within the tolerance of its piece of the patch, and the other bounds of `options` hold. The
 * proof bounds the second derivatives over the triangle's parameters by their Bernstein
 * coefficients in interval arithmetic; vertices are points of the patches, evaluated exactly and
 * rounded to the nearest doubles. Triangles are oriented by \f$ S_u \times S_v \f$. The result is
 * deterministic.
 *
 * <b>Common edges.</b> Edges of patches are common when their control points, and their weights up
 * to a common factor, are equal, in either order. They get identical vertices, also when the
 * patches are meshed one by one with the same tolerance and bounds: the division of an edge depends
 * on its curve alone. Within one mesh the patches are connected there, unless the edge has more
 * than two patches, or two of opposite orientations: then vertices are doubled and
 * `Mesh_report::manifold` is `false`.
 *
 * <b>Degenerate patches.</b> An edge that is collapsed to a point becomes one vertex, and no
 * triangle has two equal corners. Vertices where the parametrisation is irregular have no
 * curvature; see `Shape_property_maps` for their properties and `Mesh_report::refused_places` for
 * the list.
 *
 * The vertex properties are those of `Shape_property_maps` and `Patch_property_maps`. Curvatures
 * are computed in interval arithmetic, and exactly where that is not accurate to about
 * \f$ 10^{-13} \f$ of the largest curvature there. On an edge between patches they belong to one of
 * the patches: they differ from those of the other where the patches do not join smoothly.
 *
 * \tparam Progress is called as `progress(done, total)` with the number of patches, see
 * `No_progress`
 *
 * \param patches the patches, with exact control points
 * \param options how fine the mesh must be
 * \param progress the progress callback
 *
 * \return the mesh with its report, whose distances are certified; or a refusal:
 * `LIMIT_EXCEEDED` when the bounds need more vertices than allowed, or a tolerance beyond the
 * resolution of doubles (2^-42 of the largest coordinate), `POLE` where the weight of a rational
 * patch vanishes, `IRREGULAR_PARAMETRISATION` for a patch that is a single curve or point,
 * `CANCELLED`
 *
 * Source: the bound of Filip, Magedson and Markot for the interpolation of a surface by triangles,
 * in a form that keeps the directions of the edges (see triangle_bound.h).
 */
template <class Progress = No_progress>
Result<Shape_mesh> mesh_patches(const std::vector<Bezier_surface_3<Exact_rational>>& patches,
                                const Patch_mesh_options& options = Patch_mesh_options(),
                                Progress progress = Progress())
{
  try
  {
    return internal::Patch_mesher(patches, options)(progress);
  }
  catch (const internal::Mesh_refused& refused)
  {
    return refused.refusal;
  }
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H
