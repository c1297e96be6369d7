// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_N_SPACE_PROPERTIES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_N_SPACE_PROPERTIES_H

// Curvature data at the vertices of a mesh of a surface in n-space, and its distances from it.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/N_space_cover.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/n_space_folds.h>
#include <CGAL/Shape_interrogation/Meshing/internal/set_shape.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// In floating point. For the opposite normal if the frame says so.
inline Vertex_shape double_shape(const Local_shape_3<double>& s, bool is_reversed)
{
  Vertex_shape v;
  v.normal = normalised(s.normal());
  set_curvatures(v, gaussian_curvature(s), mean_curvature(s),
                 std::sqrt((std::max)(squared_curvature_gap(s), 0.)));
  const auto frame = tangent_frame(v.normal);
  const std::array<double, 2> t = traceless_part(s.form(), frame);
  if (t[0] != 0 || t[1] != 0)
    set_directions(v, frame, t);
  return is_reversed ? opposite(v) : v;
}

inline void fill_n_space_properties(const N_space_system& system, const N_space_cover& cover,
                                    const std::vector<std::size_t>& source, N_space_mesh& mesh)
{
  Shape_property_maps maps(mesh.surface_mesh);
  N_space_property_maps more(mesh.surface_mesh);
  // Each point finds its own order of elimination: with the equations that are independent at
  // another one the curvatures can be less accurate.
  N_space_evaluator<double> evaluate(system);
  for (const auto vertex : mesh.surface_mesh.vertices())
  {
    const Cover_vertex& v = cover.vertices()[source[vertex.idx()]];
    more.n_space_point[vertex] = v.chart.point;
    more.projection_contraction[vertex] = v.chart.contraction;
    for (double x : system.tape().evaluate(v.chart.point))
      mesh.max_residual = (std::max)(mesh.max_residual, std::fabs(x));
    const Result<Local_shape_3<double>> s = evaluate(v.chart.point);
    if (s)
      set_shape(maps, vertex,
                double_shape(*s, dot(s->normal(), projected_normal(v.chart)) < 0));
    else
    {
      Refused_place place;
      place.vertex = vertex.idx();
      for (int i = 0; i < 3; ++i)
        place.point[i] = v.chart.point[i];
      place.code = s.refusal().code();
      place.evidence = s.refusal().evidence();
      mesh.report.refused_places.push_back(place);
    }
  }
}

// The distances that are seen from the middles of edges and triangles, and the largest turning.
template <class Go_on>
void measure_distances(N_space_cover& cover, const std::vector<Soup_triangle>& triangles,
                       const std::vector<std::size_t>& source, double edge_length,
                       N_space_mesh& mesh, Go_on go_on)
{
  const auto sample = [&](const std::vector<std::size_t>& corners) {
    std::vector<double> middle(cover.vertices()[corners[0]].chart.point.size(), 0.);
    for (std::size_t v : corners)
      add_multiple(middle, 1. / static_cast<double>(corners.size()),
                   cover.vertices()[v].chart.point);
    const Result<Cover_vertex> on_surface = cover.correct(middle);
    double distance = edge_length;
    if (on_surface)
      distance = std::hypot(on_surface->chart.point[0] - middle[0],
                            on_surface->chart.point[1] - middle[1],
                            on_surface->chart.point[2] - middle[2]);
    else
      ++mesh.report.unmeasured_samples;
    mesh.report.max_face_distance = (std::max)(mesh.report.max_face_distance, distance);
  };
  for (const Soup_triangle& t : triangles)
  {
    go_on();
    sample({t[0], t[1], t[2]});
  }
  for (const auto e : mesh.surface_mesh.edges())
  {
    const std::size_t a = source[mesh.surface_mesh.vertex(e, 0).idx()],
                      b = source[mesh.surface_mesh.vertex(e, 1).idx()];
    sample({a, b});
    const double cosine =
      angle_between(cover.vertices()[a].chart, cover.vertices()[b].chart).cosine;
    mesh.max_turning = (std::max)(mesh.max_turning, std::acos(cosine));
  }
  for (const Cover_vertex& v : cover.vertices())
    mesh.report.max_vertex_distance = (std::max)(mesh.report.max_vertex_distance, v.error);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_N_SPACE_PROPERTIES_H
