// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_RUN_SURFACE_MESHER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_RUN_SURFACE_MESHER_H

// CGAL's Delaunay refinement of an implicit surface in a ball, step by step so that it can be
// stopped. The only file that includes that mesher: it takes long to compile, and is deprecated
// since CGAL 6.0, which still has it. First sizes and distances are met, then the mesh is refined
// to a manifold, which has no end at singular curves: there the first mesh stands.

#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/Surface_mesher_generator.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Surface_mesher_input
{
  Coordinates<double, 3> center;
  double squared_radius;
  double min_angle, ball_radius, distance; // the three criteria of the refinement
  std::size_t max_vertices;
};

struct Mesher_output
{
  std::vector<Coordinates<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles; // with any orientation
};

// A number in [-1, 1] from the one before.
inline double next_offset(std::uint32_t& state)
{
  state = state * 1664525u + 1013904223u;
  return double(state >> 8) / double(1 << 23) - 1;
}

// The mesher also asks for signs far outside the ball, where the function may not exist: it gets
// those of the nearest point of the ball.
template <class Point>
Coordinates<double, 3> moved_into_ball(const Point& p, const Point& center,
                                       const Surface_mesher_input& input)
{
  const auto d = p - center;
  const double squared_length = d.squared_length();
  const double t = squared_length > input.squared_radius
                     ? std::sqrt(input.squared_radius / squared_length) : 1;
  return {center.x() + t * d.x(), center.y() + t * d.y(), center.z() + t * d.z()};
}

// The mesher needs a triangulation of dimension three: seeds of a plane must not lie in it.
template <class Triangulation>
void insert_seeds(Triangulation& triangulation, const std::vector<Coordinates<double, 3>>& seeds,
                  double offset)
{
  std::uint32_t state = 1;
  for (const auto& seed : seeds)
  {
    const double x = offset * next_offset(state), y = offset * next_offset(state),
                 z = offset * next_offset(state);
    triangulation.insert(typename Triangulation::Point(seed[0] + x, seed[1] + y, seed[2] + z));
  }
}

// Refines until the rules of the mesher are met; false if that takes more vertices than these.
template <class Mesher, class Triangulation>
bool refine_within(Mesher& mesher, const Triangulation& triangulation, std::size_t most_vertices)
{
  mesher.init();
  Null_mesh_visitor visitor;
  while (!mesher.is_algorithm_done())
  {
    mesher.one_step(visitor);
    if (triangulation.number_of_vertices() > most_vertices)
      return false;
  }
  return true;
}

template <class Complex>
Mesher_output facets_of(const Complex& complex)
{
  Mesher_output output;
  std::unordered_map<typename Complex::Vertex_handle, std::size_t> number;
  for (auto it = complex.facets_begin(); it != complex.facets_end(); ++it)
  {
    std::array<std::size_t, 3> triangle;
    for (int k = 0; k < 3; ++k)
    {
      const auto v = it->first->vertex((it->second + 1 + k) & 3);
      const auto added = number.emplace(v, output.points.size());
      if (added.second)
        output.points.push_back({v->point().x(), v->point().y(), v->point().z()});
      triangle[k] = added.first->second;
    }
    output.triangles.push_back(triangle);
  }
  return output;
}

// `f` takes coordinates; `seeds` are points on the surface, some on each component.
template <class Function>
Mesher_output run_surface_mesher(Function& f, const std::vector<Coordinates<double, 3>>& seeds,
                                 const Surface_mesher_input& input)
{
  using Triangulation = Surface_mesh_default_triangulation_3;
  using Complex = Surface_mesh_complex_2_in_triangulation_3<Triangulation>;
  using Geom_traits = Triangulation::Geom_traits;
  using Point = Geom_traits::Point_3;
  using Surface = CGAL::Implicit_surface_3<Geom_traits>;
  using Surface_traits = Surface_mesh_traits_generator_3<Surface>::type;
  using Criteria = Surface_mesh_default_criteria_3<Triangulation>;
  using Mesher = Surface_mesher_generator<Complex, Surface_traits, Criteria,
                                          Non_manifold_tag>::type;
  using Manifold_mesher = Surface_mesher_generator<Complex, Surface_traits, Criteria,
                                                   Manifold_with_boundary_tag>::type;
  Triangulation triangulation;
  Complex complex(triangulation);
  const Point center(input.center[0], input.center[1], input.center[2]);
  const auto function = [&](const Point& p) { return f(moved_into_ball(p, center, input)); };
  // With larger errors than 1e-10 of the ball the points leave the surface visibly.
  const Surface surface(function, Geom_traits::Sphere_3(center, input.squared_radius), 1e-10);
  insert_seeds(triangulation, seeds, 1e-6 * std::sqrt(input.squared_radius));
  const Criteria criteria(input.min_angle, input.ball_radius, input.distance);
  Surface_traits traits;
  Mesher mesher(complex, surface, traits, criteria);
  if (!refine_within(mesher, triangulation, input.max_vertices))
    refuse_mesh(Refusal_code::LIMIT_EXCEEDED, "the mesh needs more vertices than are allowed");
  Mesher_output output = facets_of(complex);
  // A smooth surface needs hardly any more vertices to become a manifold.
  const std::size_t vertices = triangulation.number_of_vertices();
  const std::size_t allowed = (std::min)(vertices + vertices / 4 + 1000, input.max_vertices);
  Manifold_mesher manifold_mesher(complex, surface, traits, criteria);
  return refine_within(manifold_mesher, triangulation, allowed) ? facets_of(complex) : output;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_RUN_SURFACE_MESHER_H
