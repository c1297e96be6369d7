// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_COVER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_COVER_H

// Covers a surface in n-space by vertices about one unit of their charts apart. Neighbours are
// those in n-space on the same sheet, whatever the projection does.

#include <CGAL/Shape_interrogation/Meshing/internal/Bound_side.h>
#include <CGAL/Shape_interrogation/Meshing/internal/N_space_chart.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_grid.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_corrector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Cover_vertex
{
  N_space_chart chart;
  std::uint64_t sides = 0; // the bounds on which it lies, a bit for each
  double error = 0;        // the length of the last correction
};

// A direction in which the surface could not be followed.
struct Cover_stop
{
  int vertex;
  Refusal_code code;
  std::string evidence;
};

struct Near_vertex
{
  int vertex;
  Chart_vector at; // in units of the chart
  double distance; // in units for the mean of both sizes
};

class N_space_cover
{
public:
  static constexpr double closest = 0.65;  // two vertices may come
  static constexpr double from_bound = 0.55; // stays a vertex that is not on it
  static constexpr double least_size = 1. / 64;

  N_space_cover(const N_space_system& system, const std::vector<Bound_side>& sides,
                double edge_length, double max_turning, std::size_t max_vertices)
    : m_corrector(system), m_sides(sides), m_grid(system.number_of_variables()),
      m_edge_length(edge_length), m_max_turning(max_turning), m_max_vertices(max_vertices)
  {}

  const std::vector<Cover_vertex>& vertices() const { return m_vertices; }
  const std::vector<Bound_side>& sides() const { return m_sides; }
  const std::vector<Cover_stop>& stops() const { return m_stops; }
  double max_turning() const { return m_max_turning; }
  bool is_full() const { return m_vertices.size() > m_max_vertices; }

  // The chart of the surface point near p; `p` gets the error of the correction.
  Result<Cover_vertex> correct(const std::vector<double>& p,
                               const std::vector<N_space_condition>& conditions = {})
  {
    const Result<N_space_point> corrected = m_corrector(p, conditions);
    if (!corrected)
      return corrected.refusal();
    Cover_vertex v;
    v.error = corrected->step;
    v.chart.point = corrected->point;
    for (int i = 0; i < 2; ++i)
      v.chart.basis[i] = m_corrector.tangent_basis()[i];
    measure_projection(v.chart);
    set_length(v.chart);
    return v;
  }

  bool is_inside(const std::vector<double>& p) const
  {
    return std::all_of(m_sides.begin(), m_sides.end(),
                       [&](const Bound_side& s) { return s.distance(p) >= 0; });
  }

  // Where the projection contracts much more than at the start it does not tell how far to go.
  void set_least_stretch(N_space_chart& start)
  {
    m_least_stretch = start.stretch > 1e-9 ? start.stretch / 16 : 1;
    set_length(start);
  }

  // Calls f with all vertices of the same sheet within `radius` units.
  template <class Function>
  void for_each_near(const N_space_chart& chart, double radius, Function f) const
  {
    // Vertices across the tangent plane are farther than they are in it.
    m_grid.for_each_near(chart.point, chart.unit(), 1.25 * radius, [&](int vertex) {
      const N_space_chart& other = m_vertices[vertex].chart;
      const Chart_place place = place_in(chart, other.point);
      const double mean = (1 + other.unit() / chart.unit()) / 2;
      const double distance = length(place.at) / mean;
      if (distance <= radius && is_on_sheet(place, angle_between(chart, other).cosine))
        f(Near_vertex{vertex, place.at, distance});
    });
  }

  // The vertices around a vertex, in the order of their indices.
  std::vector<Near_vertex> near(int vertex, double radius) const
  {
    std::vector<Near_vertex> result;
    for_each_near(m_vertices[vertex].chart, radius, [&](const Near_vertex& v) {
      if (v.vertex != vertex)
        result.push_back(v);
    });
    std::sort(result.begin(), result.end(),
              [](const Near_vertex& a, const Near_vertex& b) { return a.vertex < b.vertex; });
    return result;
  }

  bool has_within(const N_space_chart& chart, double radius) const
  {
    bool found = false;
    for_each_near(chart, radius, [&](const Near_vertex&) { found = true; });
    return found;
  }

  int insert(Cover_vertex v)
  {
    const int index = static_cast<int>(m_vertices.size());
    m_grid.insert(v.chart.point, v.chart.unit());
    m_vertices.push_back(std::move(v));
    m_queue.push_back(index);
    return index;
  }

  // The next vertex whose surroundings were not looked at.
  std::optional<int> next()
  {
    if (m_queue.empty())
      return std::nullopt;
    const int vertex = m_queue.front();
    m_queue.pop_front();
    return vertex;
  }

  // Orients a vertex like its neighbour and fits its size to the turning between them. Returns
  // false if the plane turns too much.
  bool fit(Cover_vertex& v, const N_space_chart& neighbour, double& turning) const
  {
    const Plane_angle angle = angle_between(neighbour, v.chart);
    turning = std::acos(angle.cosine);
    if (angle.is_reversed)
      std::swap(v.chart.basis[0], v.chart.basis[1]);
    const double growth = (std::min)(1.4, 0.7 * m_max_turning / (turning + 1e-12));
    v.chart.size = (std::min)(1., (std::max)(neighbour.size * growth, least_size));
    return turning <= m_max_turning;
  }

  // Makes the surroundings of a vertex finer. Returns false if they are as fine as allowed.
  bool shrink(int vertex, double factor)
  {
    N_space_chart& chart = m_vertices[vertex].chart;
    if (chart.size <= least_size)
      return false;
    chart.size = (std::max)(chart.size * (std::min)((std::max)(factor, 0.4), 0.8), least_size);
    return true;
  }

  // The first reason at a vertex stands for all directions.
  void stop(int vertex, Refusal_code code, std::string evidence)
  {
    if (m_is_stop.insert(vertex).second)
      m_stops.push_back({vertex, code, std::move(evidence)});
  }

  // A vertex can be found to lie on more bounds.
  void add_sides(int vertex, std::uint64_t sides) { m_vertices[vertex].sides |= sides; }

  // Vertices that follow each other on a bound: between them the mesh may end.
  void add_border(int a, int b, int side)
  {
    if (a != b)
      m_borders.emplace(std::minmax(a, b), side);
  }

  // A new vertex comes between two that follow each other.
  void split_border(int a, int b, int middle)
  {
    const auto found = m_borders.find(std::minmax(a, b));
    const int side = found->second;
    m_borders.erase(found);
    add_border(a, middle, side);
    add_border(middle, b, side);
  }

  // Who follows a vertex is not known where the curve on the bound could not be traced further.
  void add_loose_end(int vertex) { m_loose_ends.insert(vertex); }

  // The pairs of vertices that follow each other, and on which bound.
  const std::map<std::pair<int, int>, int>& borders() const { return m_borders; }

  bool is_border(int a, int b) const
  {
    return (m_vertices[a].sides & m_vertices[b].sides) != 0 &&
           (m_borders.count(std::minmax(a, b)) != 0 || m_loose_ends.count(a) != 0 ||
            m_loose_ends.count(b) != 0);
  }

private:
  // A sheet leaves its tangent plane about in proportion to the angle by which that turns. A vertex
  // that is farther from the plane than this explains belongs to another sheet.
  static bool is_on_sheet(const Chart_place& place, double cosine)
  {
    if (cosine <= 0.3)
      return false;
    const double angle = std::acos((std::min)(cosine, 1.));
    return place.across <= (0.1 + 0.8 * angle) * length(place.at) + 1e-9;
  }

  void set_length(N_space_chart& chart) const
  {
    chart.length = m_edge_length / (std::max)(chart.stretch, m_least_stretch);
  }

  N_space_corrector m_corrector;
  std::vector<Bound_side> m_sides;
  Vertex_grid m_grid;
  double m_edge_length, m_max_turning;
  std::size_t m_max_vertices;
  double m_least_stretch = 1;
  std::vector<Cover_vertex> m_vertices;
  std::deque<int> m_queue;
  std::vector<Cover_stop> m_stops;
  std::unordered_set<int> m_is_stop, m_loose_ends;
  std::map<std::pair<int, int>, int> m_borders;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_COVER_H
