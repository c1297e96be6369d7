// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CLIP_TO_BOX_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CLIP_TO_BOX_H

// Cuts a mesh of an implicit surface at the faces of a box. New vertices are on the surface and on
// the face; vertices near a face are moved there, so that no slivers arise.

#include <CGAL/Shape_interrogation/Meshing/internal/implicit_seeds.h>
#include <CGAL/Shape_interrogation/Meshing/internal/slide_to_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// `Gradient` maps a point to the value and the gradient of the function: four numbers.
template <class Gradient>
class Box_clipper
{
  using Point = Coordinates<double, 3>;
  using Triangle = std::array<std::size_t, 3>;

public:
  // `length` is that of the edges.
  Box_clipper(std::vector<Point>& points, std::vector<Triangle>& triangles, Gradient gradient,
              double length)
    : m_points(points), m_triangles(triangles), m_gradient(std::move(gradient)), m_length(length),
      m_fixed(points.size(), 0)
  {}

  void operator()(const Mesh_box& box)
  {
    for (int d = 0; d < 3; ++d)
      for (int side = 0; side < 2; ++side)
        clip(d, box[d][side], side == 0 ? -1 : 1);
  }

private:
  // Keeps what is on the side sign * (x_d - bound) <= 0.
  void clip(int d, double bound, int sign)
  {
    const auto outside = [&](std::size_t i) { return sign * (m_points[i][d] - bound); };
    if (std::none_of(m_triangles.begin(), m_triangles.end(), [&](const Triangle& t) {
          return outside(t[0]) > 0 || outside(t[1]) > 0 || outside(t[2]) > 0;
        }))
      return;
    snap(d, bound);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> cuts;
    const auto cut = [&](std::size_t in, std::size_t out) {
      const auto added = cuts.emplace(std::minmax(in, out), m_points.size());
      if (added.second)
        add_cut(in, out, d, bound);
      return added.first->second;
    };
    std::vector<Triangle> kept;
    for (Triangle t : m_triangles)
    {
      const int out = static_cast<int>(std::count_if(t.begin(), t.end(),
                                                     [&](auto i) { return outside(i) > 0; }));
      const int in = static_cast<int>(std::count_if(t.begin(), t.end(),
                                                    [&](auto i) { return outside(i) < 0; }));
      if (in == 0)
        continue; // outside, or in the face
      // Turn the triangle so that it begins with the corner that is alone.
      while (out > 0 && (out == 1 ? outside(t[0]) <= 0 : outside(t[0]) > 0))
        std::rotate(t.begin(), t.begin() + 1, t.end());
      if (out == 0)
        kept.push_back(t);
      else if (out == 2)
        kept.push_back({t[0], cut(t[0], t[1]), cut(t[0], t[2])});
      else
        keep_two_corners(t, outside(t[1]) == 0, outside(t[2]) == 0, cut, kept);
    }
    m_triangles.swap(kept);
  }

  // The corner t[0] is outside; the others are inside, or one of them is on the face.
  template <class Cut>
  static void keep_two_corners(const Triangle& t, bool first_on_face, bool second_on_face, Cut& cut,
                               std::vector<Triangle>& kept)
  {
    if (first_on_face)
      kept.push_back({t[1], t[2], cut(t[2], t[0])});
    else if (second_on_face)
      kept.push_back({t[1], t[2], cut(t[1], t[0])});
    else
    {
      const std::size_t p = cut(t[1], t[0]), q = cut(t[2], t[0]);
      kept.push_back({p, t[1], t[2]});
      kept.push_back({p, t[2], q});
    }
  }

  // Moves vertices to the face that are nearer to it than a fifth of their shortest edge.
  void snap(int d, double bound)
  {
    std::vector<double> shortest(m_points.size(), std::numeric_limits<double>::infinity());
    for (const Triangle& t : m_triangles)
      for (int k = 0; k < 3; ++k)
      {
        const std::size_t a = t[k], b = t[(k + 1) % 3];
        const double length = std::sqrt(squared_distance(m_points[a], m_points[b]));
        shortest[a] = (std::min)(shortest[a], length);
        shortest[b] = (std::min)(shortest[b], length);
      }
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (std::abs(m_points[i][d] - bound) < shortest[i] / 5)
      {
        Point p = m_points[i];
        p[d] = bound;
        const int fixed = m_fixed[i] | 1 << d;
        if (!slide_to_surface(m_gradient, p, m_length, fixed) ||
            squared_distance(p, m_points[i]) > shortest[i] * shortest[i] / 9)
          continue;
        m_points[i] = p;
        m_fixed[i] = fixed;
      }
  }

  void add_cut(std::size_t a, std::size_t b, int d, double bound)
  {
    const Point &p = m_points[a], &q = m_points[b];
    const double t = (bound - p[d]) / (q[d] - p[d]);
    Point on_chord;
    for (int k = 0; k < 3; ++k)
      on_chord[k] = p[k] + t * (q[k] - p[k]);
    on_chord[d] = bound;
    const int fixed = (m_fixed[a] & m_fixed[b]) | 1 << d;
    Point on_surface = on_chord;
    const bool is_near = slide_to_surface(m_gradient, on_surface, m_length, fixed) &&
                         squared_distance(on_surface, on_chord) <= squared_distance(p, q) / 4;
    m_points.push_back(is_near ? on_surface : on_chord);
    m_fixed.push_back(fixed);
  }

  std::vector<Point>& m_points;
  std::vector<Triangle>& m_triangles;
  Gradient m_gradient;
  const double m_length;
  std::vector<int> m_fixed; // bit k: the coordinate k is that of a face
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CLIP_TO_BOX_H
