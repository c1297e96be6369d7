// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_MESHER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_MESHER_H

// Covers a surface in n-space from its start points, triangulates the cover, and describes it.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Triangle_votes.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fill_n_space_properties.h>
#include <CGAL/Shape_interrogation/Meshing/internal/n_space_folds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The element `index` of the van der Corput sequence to a base.
inline double radical_inverse(std::size_t index, std::size_t base)
{
  double x = 0, factor = 1;
  for (; index > 0; index /= base)
  {
    factor /= static_cast<double>(base);
    x += factor * static_cast<double>(index % base);
  }
  return x;
}

template <class Go_on>
class N_space_mesher
{
public:
  N_space_mesher(const N_space_system& system, const N_space_mesh_options& options, Go_on go_on)
    : m_system(system), m_options(options), m_go_on(go_on),
      m_cover(system, sides_of(options.bounds), options.edge_length, options.max_turning,
              options.max_vertices),
      m_growth(system, m_cover, go_on)
  {}

  N_space_mesh operator()(const std::vector<std::vector<double>>& starts)
  {
    for (std::size_t i = 0; i < starts.size(); ++i)
      start_at(starts[i], i);
    search();
    if (m_cover.vertices().empty())
      refuse_mesh(Refusal_code::NOT_ON_SOLUTION, "no start point leads to the surface");
    const std::vector<Soup_triangle> triangles = triangulate();
    if (triangles.empty())
      refuse_without_triangles();
    return build(triangles);
  }

private:
  void start_at(const std::vector<double>& p, std::size_t index)
  {
    const std::string name = "start point " + std::to_string(index + 1);
    const Result<Cover_vertex> v = m_cover.correct(p);
    if (!v)
      refuse_mesh(v.refusal().code(), name + ": " + v.refusal().evidence());
    for (const Bound_side& s : m_cover.sides())
      if (s.distance(v->chart.point) <
          -length(gradient_of_variable(v->chart, s.variable)))
        refuse_mesh(Refusal_code::OUTSIDE_DOMAIN,
                    name + ": the variable " + m_system.variables()[s.variable] +
                      " is out of bounds on the surface near");
    grow_from(*v);
  }

  void grow_from(Cover_vertex v)
  {
    if (m_cover.vertices().empty())
      m_cover.set_least_stretch(v.chart);
    m_growth.start(std::move(v));
    if (m_cover.is_full())
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the surface needs more than " + std::to_string(m_options.max_vertices) +
                    " vertices: bound it, or allow longer edges");
  }

  // From points that fill the box evenly, those come to the surface that can.
  void search()
  {
    const std::vector<Bound_side> box = sides_of(m_options.search_box);
    if (box.empty())
      return;
    double largest = 0;
    for (const Bound_side& s : box)
      largest = (std::max)(largest, std::fabs(s.value));
    const int n = m_system.number_of_variables();
    std::vector<std::array<double, 2>> range(n, {-largest, largest});
    for (std::size_t i = 0; i < box.size(); i += 2)
      range[box[i].variable] = {box[i].value, box[i + 1].value};
    const std::vector<std::size_t> bases = primes(n);
    for (std::size_t k = 1; k <= m_options.search_points; ++k)
    {
      m_go_on();
      std::vector<double> p(n);
      for (int i = 0; i < n; ++i)
        p[i] = range[i][0] + radical_inverse(k, bases[i]) * (range[i][1] - range[i][0]);
      const Result<Cover_vertex> v = m_cover.correct(p);
      if (v && m_cover.is_inside(v->chart.point) &&
          std::all_of(box.begin(), box.end(),
                      [&](const Bound_side& s) { return s.distance(v->chart.point) >= 0; }))
        grow_from(*v);
    }
  }

  // The first prime numbers: the sequences of different bases are independent.
  static std::vector<std::size_t> primes(int count)
  {
    std::vector<std::size_t> result;
    for (std::size_t candidate = 2; static_cast<int>(result.size()) < count; ++candidate)
      if (std::none_of(result.begin(), result.end(),
                       [&](std::size_t d) { return candidate % d == 0; }))
        result.push_back(candidate);
    return result;
  }

  std::vector<Soup_triangle> triangulate()
  {
    std::vector<Candidate_triangle> candidates = candidate_triangles(m_cover, m_go_on);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate_triangle& a, const Candidate_triangle& b) {
                       return a.votes != b.votes ? a.votes > b.votes : a.radius < b.radius;
                     });
    Triangle_assembly assembly(m_cover);
    for (const Candidate_triangle& t : candidates)
      if (!lies_outside(t.corners))
        assembly.add(t.corners, t.votes == 3);
    assembly.fill_holes();
    return assembly.triangles();
  }

  // The solution may be a curve, a point, or too small a part of a surface.
  void refuse_without_triangles() const
  {
    const auto shape = N_space_evaluator<double>(m_system)(m_cover.vertices()[0].chart.point);
    if (!shape && shape.refusal().code() == Refusal_code::NOT_TWO_DIMENSIONAL)
      refuse_mesh(shape.refusal().code(), shape.refusal().evidence());
    if (!m_cover.stops().empty())
      refuse_mesh(m_cover.stops()[0].code, m_cover.stops()[0].evidence);
    refuse_mesh(Refusal_code::UNDECIDED, "no triangle was found between the bounds");
  }

  // A triangle between vertices on the bounds may lie beyond a bound that curves inward.
  bool lies_outside(const std::array<int, 3>& t)
  {
    std::vector<double> middle(m_system.number_of_variables(), 0.);
    for (int v : t)
    {
      if (m_cover.vertices()[v].sides == 0)
        return false;
      add_multiple(middle, 1. / 3, m_cover.vertices()[v].chart.point);
    }
    const Result<Cover_vertex> v = m_cover.correct(middle);
    return v && !m_cover.is_inside(v->chart.point);
  }

  N_space_mesh build(const std::vector<Soup_triangle>& triangles)
  {
    std::vector<std::array<double, 3>> points;
    for (const Cover_vertex& v : m_cover.vertices())
      points.push_back({v.chart.point[0], v.chart.point[1], v.chart.point[2]});
    Built_mesh built = build_surface_mesh(points, triangles);
    N_space_mesh mesh;
    mesh.surface_mesh = std::move(built.mesh);
    describe_topology(mesh.surface_mesh, mesh.report);
    mesh.report.manifold = built.is_manifold;
    fill_n_space_properties(m_system, m_cover, built.source, mesh);
    measure_distances(m_cover, triangles, built.source, m_options.edge_length, mesh, m_go_on);
    Fold_finder find_folds(m_cover);
    mesh.folds = find_folds(triangles);
    mesh.rims = rims(triangles);
    for (const Cover_stop& s : m_cover.stops())
      mesh.stops.push_back({m_cover.vertices()[s.vertex].chart.point, s.code, s.evidence});
    for (const std::vector<double>& end : find_folds.ends())
      mesh.stops.push_back({end, Refusal_code::UNDECIDED, "a fold could not be followed"});
    return mesh;
  }

  // Sides with one triangle whose ends do not follow each other on a bound.
  std::vector<N_space_polyline> rims(const std::vector<Soup_triangle>& triangles) const
  {
    std::vector<std::pair<std::size_t, std::size_t>> sides;
    for (const Soup_triangle& t : triangles)
      for (int i = 0; i < 3; ++i)
        sides.push_back(std::minmax(t[i], t[(i + 1) % 3]));
    std::sort(sides.begin(), sides.end());
    std::vector<std::pair<std::size_t, std::size_t>> open;
    for (std::size_t i = 0; i < sides.size(); )
    {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end] == sides[i])
        ++end;
      const auto& [a, b] = sides[i];
      if (end == i + 1 && !m_cover.is_border(static_cast<int>(a), static_cast<int>(b)))
        open.push_back(sides[i]);
      i = end;
    }
    std::vector<std::vector<double>> points;
    for (const Cover_vertex& v : m_cover.vertices())
      points.push_back(v.chart.point);
    std::vector<N_space_polyline> lines;
    for (const std::vector<std::size_t>& chain : chains_of(open, points.size()))
      lines.push_back(polyline_of(chain, points));
    return lines;
  }

  const N_space_system& m_system;
  const N_space_mesh_options& m_options;
  Go_on m_go_on;
  N_space_cover m_cover;
  Cover_growth<Go_on> m_growth;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_MESHER_H
