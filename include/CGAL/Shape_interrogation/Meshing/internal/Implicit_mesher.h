// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_MESHER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_MESHER_H

// The mesher of implicit surfaces from its parts: seeds, CGAL's refinement, projection, clipping,
// the mesh and its properties.

#include <CGAL/Shape_interrogation/Meshing/Implicit_mesh_options.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Checked_function.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_shape.h>
#include <CGAL/Shape_interrogation/Meshing/internal/build_surface_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/clip_to_box.h>
#include <CGAL/Shape_interrogation/Meshing/internal/implicit_distance.h>
#include <CGAL/Shape_interrogation/Meshing/internal/run_surface_mesher.h>
#include <CGAL/Shape_interrogation/Meshing/internal/set_shape.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Function, class Go_on>
class Implicit_mesher
{
  using Point = Coordinates<double, 3>;

public:
  Implicit_mesher(const Implicit_surface_3<Function>& surface, const Mesh_box& box,
                  const Implicit_mesh_options& options, Go_on go_on)
    : m_surface(surface), m_box(box), m_options(options), m_go_on(go_on),
      m_function(surface.function(), go_on)
  {
    double side = 0, largest = 0;
    for (int d = 0; d < 3; ++d)
    {
      if (!(box[d][0] < box[d][1]) || !std::isfinite(box[d][1] - box[d][0]))
        refuse_mesh(Refusal_code::OUTSIDE_DOMAIN, "the box is empty or not finite");
      side = (std::max)(side, box[d][1] - box[d][0]);
      largest = (std::max)({largest, std::abs(box[d][0]), std::abs(box[d][1])});
    }
    m_edge_length = options.edge_length > 0 ? options.edge_length : side / 20;
    // The mesher's points are no better than that.
    if (!(m_edge_length >= 1e-9 * largest))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the edge length is too small: it must be at least 1e-9 of the largest coordinate"
                  " of the box");
    m_tolerance = options.tolerance > 0 ? options.tolerance : side / 1000;
  }

  Shape_mesh operator()()
  {
    const int cells = std::clamp(m_options.seed_cells, 2, 300);
    const Seed_grid grid(m_function, m_box, cells);
    if (!grid.has_both_signs([this](const Point& p) { return certain_sign(p); }))
      refuse_mesh(Refusal_code::NOT_ON_SURFACE,
                  "nothing was found in the box: the function changes its sign nowhere on a grid"
                  " with " + std::to_string(cells) + " cells a side (zeros without a change of"
                  " sign, as of a square, are not found)");
    const std::vector<Point> seeds = grid.seeds(m_function);
    // What the refinement measures is not quite the distance of the result.
    std::optional<Shape_mesh> best;
    double aim = m_tolerance * 0.7;
    for (int attempt = 0; attempt < 3; ++attempt)
    {
      Shape_mesh mesh = make(seeds, aim);
      const double distance = mesh.report.max_face_distance;
      if (!best || distance < best->report.max_face_distance)
        best = std::move(mesh);
      if (distance <= m_tolerance)
        break;
      aim *= (std::max)(0.2, 0.7 * m_tolerance / distance);
    }
    fill(*best);
    return std::move(*best);
  }

private:
  Shape_mesh make(const std::vector<Point>& seeds, double distance)
  {
    Surface_mesher_input input{{}, 0, (std::min)(m_options.min_angle, 30.0), m_edge_length / 2,
                               distance, m_options.max_vertices};
    double squared_half_diagonal = 0;
    for (int d = 0; d < 3; ++d)
    {
      const double half = (m_box[d][1] - m_box[d][0]) / 2;
      input.center[d] = m_box[d][0] + half;
      squared_half_diagonal += half * half;
    }
    // The refinement ends about an edge before the boundary of its ball.
    const double radius = std::sqrt(squared_half_diagonal) + 2 * m_edge_length;
    input.squared_radius = radius * radius;
    Mesher_output output = run_surface_mesher(m_function, seeds, input);
    const auto gradient = [this](const Point& p) { return value_and_gradient(p); };
    for (Point& p : output.points)
    {
      Point projected = p;
      if (slide_to_surface(gradient, projected, m_edge_length) &&
          squared_distance(projected, p) < m_edge_length * m_edge_length)
        p = projected;
    }
    for (auto& t : output.triangles)
      orient(t, output.points);
    Box_clipper<decltype(gradient)>(output.points, output.triangles, gradient,
                                    m_edge_length)(m_box);
    if (output.triangles.empty())
      refuse_mesh(Refusal_code::NOT_ON_SURFACE,
                  "nothing was found in the box: the surface lies outside or only touches it");
    Built_mesh built = build_surface_mesh(output.points, output.triangles);
    Shape_mesh result{std::move(built.mesh), {}};
    describe_topology(result.surface_mesh, result.report);
    result.report.manifold = built.is_manifold;
    describe_distances(result);
    return result;
  }

  // Turns a triangle so that its normal goes along the gradient.
  void orient(Soup_triangle& t, const std::vector<Point>& points) const
  {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Point middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3,
                       (a[2] + b[2] + c[2]) / 3};
    const std::array<double, 4> f = value_and_gradient(middle);
    const Point gradient{f[1], f[2], f[3]};
    const Point ab{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point ac{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    if (dot(cross(ab, ac), gradient) < 0)
      std::swap(t[1], t[2]);
  }

  static Point coordinates(const Shape_mesh::Point_3& p) { return {p.x(), p.y(), p.z()}; }

  // -1, 1, or 0 if the interval of the value contains zero.
  int certain_sign(const Point& p) const
  {
    const Interval_nt<false>::Protector protector;
    try
    {
      const Mesh_interval value =
        m_surface.function()(Mesh_interval(p[0]), Mesh_interval(p[1]), Mesh_interval(p[2]));
      return value.inf() > 0 ? 1 : value.sup() < 0 ? -1 : 0;
    }
    catch (const Shape_error&) // not defined on the whole interval
    {
      return 0;
    }
  }

  // Of a triangle or, three times the same point, of a vertex. Adds a bound that is
  // certified, or else what is seen at samples.
  void add_distance(const std::array<Point, 3>& t, double& largest, bool& is_certified,
                    std::size_t& unmeasured) const
  {
    const Implicit_distance<Function> distance(m_surface, 2 * m_tolerance, 0.9 * m_tolerance);
    if (const auto bound = distance.bound(t))
    {
      largest = (std::max)(largest, *bound);
      return;
    }
    is_certified = false;
    std::vector<std::array<double, 3>> samples{{1, 0, 0}};
    if (t[0] != t[1])
      samples.insert(samples.end(), {{0, 1, 0}, {0, 0, 1}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0},
                                     {.4, .3, .3}});
    for (const std::array<double, 3>& l : samples)
    {
      Point p;
      for (int k = 0; k < 3; ++k)
        p[k] = l[0] * t[0][k] + l[1] * t[1][k] + l[2] * t[2][k];
      const std::optional<double> sampled = sampled_distance(p);
      unmeasured += !sampled;
      // What is not known counts as the length of an edge, never as nothing.
      largest = (std::max)(largest, sampled.value_or(m_edge_length));
    }
  }

  // Nothing at a place without a way to the surface.
  std::optional<double> sampled_distance(const Point& p) const
  {
    Point projected = p;
    const auto gradient = [this](const Point& x) { return value_and_gradient(x); };
    if (!slide_to_surface(gradient, projected, m_edge_length))
      return std::nullopt;
    return std::sqrt(squared_distance(projected, p));
  }

  std::array<double, 4> value_and_gradient(const Point& p) const
  {
    const Jet<double, 3, 1> f = m_surface.template jet<1>(p);
    return {f.value(), f.derivative(0), f.derivative(1), f.derivative(2)};
  }

  void describe_distances(Shape_mesh& result) const
  {
    const Shape_mesh::Surface_mesh& mesh = result.surface_mesh;
    Mesh_report& report = result.report;
    report.tolerance = m_tolerance;
    report.vertex_distance_certified = report.face_distance_certified = true;
    double largest = 0;
    for (const auto v : mesh.vertices())
    {
      const Point p = coordinates(mesh.point(v));
      largest = (std::max)({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
      add_distance({p, p, p}, report.max_vertex_distance, report.vertex_distance_certified,
                   report.unmeasured_samples);
    }
    for (const auto f : mesh.faces())
    {
      check_progress();
      std::array<Point, 3> t;
      int k = 0;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        t[k++] = coordinates(mesh.point(v));
      add_distance(t, report.max_face_distance, report.face_distance_certified,
                   report.unmeasured_samples);
    }
    // Triangles are divided at rounded points.
    report.max_face_distance += std::ldexp(largest, -50);
  }

  void fill(Shape_mesh& result) const
  {
    Shape_property_maps maps(result.surface_mesh);
    for (const auto v : result.surface_mesh.vertices())
    {
      check_progress();
      const Point p = coordinates(result.surface_mesh.point(v));
      const Result<Vertex_shape> shape = vertex_shape(
        [&] { return m_surface.level_set_shape(convert<Interval_nt<false>>(p)); },
        [&] { return m_surface.level_set_shape(convert<Exact_rational>(p)); });
      if (shape)
        set_shape(maps, v, *shape);
      else
        result.report.refused_places.push_back({v.idx(), -1, {0, 0}, p, shape.refusal().code(),
                                                shape.refusal().evidence()});
    }
  }

  template <class NT>
  static Coordinates<NT, 3> convert(const Point& p)
  {
    return {NT(p[0]), NT(p[1]), NT(p[2])};
  }

  void check_progress() const
  {
    if (++m_steps % 1024 == 0 && !m_go_on())
      refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
  }

  const Implicit_surface_3<Function>& m_surface;
  const Mesh_box m_box;
  const Implicit_mesh_options m_options;
  Go_on m_go_on;
  Checked_function<Function, Go_on> m_function;
  double m_edge_length, m_tolerance;
  mutable std::size_t m_steps = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_MESHER_H
