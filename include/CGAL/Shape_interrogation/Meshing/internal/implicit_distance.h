// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_DISTANCE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_DISTANCE_H

// Bounds of the distance from a triangle to an implicit surface. On the triangle |f| <= F by the
// values at the corners and the second derivatives; if f grows by at least D > 0 along a direction
// in a box around the triangle that F / D does not leave, every point is within F / D of the
// surface.

#include <CGAL/Shape_interrogation/Meshing/internal/triangle_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Function>
class Implicit_distance
{
  using Point = Coordinates<double, 3>;
  using Jet_2 = Jet<Mesh_interval, 3, 2>;

public:
  // `reach`: how far from the triangle the surface is looked for; `enough`: a bound that need not
  // be improved by dividing the triangle.
  Implicit_distance(const Implicit_surface_3<Function>& surface, double reach, double enough)
    : m_surface(surface), m_reach(reach), m_enough(enough)
  {}

  // An upper bound of the distance of all points of the triangle, if one is found.
  std::optional<double> bound(const std::array<Point, 3>& t) const
  {
    try
    {
      return bound(t, 3);
    }
    catch (const Shape_error&) // the function does not exist everywhere near the triangle
    {
      return std::nullopt;
    }
  }

private:
  // Divides the triangle where the enclosures are too wide; then the corners tell most.
  std::optional<double> bound(const std::array<Point, 3>& t, int divisions) const
  {
    std::optional<double> whole = bound_at_once(t, m_reach);
    // A smaller box gives a better bound, and that a smaller box.
    for (int i = 0; whole && *whole > 0 && i < 3; ++i)
      if (const std::optional<double> better = bound_at_once(t, *whole))
        whole = (std::min)(*whole, *better);
    if (divisions == 0 || (whole && *whole <= m_enough))
      return whole;
    const Point p = middle(t[1], t[2]), q = middle(t[2], t[0]), r = middle(t[0], t[1]);
    double largest = 0;
    for (const std::array<Point, 3>& part : {std::array<Point, 3>{t[0], r, q}, {r, t[1], p},
                                             {q, p, t[2]}, {p, q, r}})
    {
      const std::optional<double> b = bound(part, divisions - 1);
      if (!b)
        return whole;
      largest = (std::max)(largest, *b);
    }
    return whole ? (std::min)(largest, *whole) : largest;
  }

  static Point middle(const Point& a, const Point& b)
  {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  }

  std::optional<double> bound_at_once(const std::array<Point, 3>& t, double reach) const
  {
    const Point direction = gradient(middle(middle(t[0], t[1]), t[2]));
    const Interval_nt<false>::Protector protector;
    Coordinates<Mesh_interval, 3> box, extent;
    for (int d = 0; d < 3; ++d)
    {
      const auto [low, high] = std::minmax({t[0][d], t[1][d], t[2][d]});
      extent[d] = Mesh_interval(high) - Mesh_interval(low);
      box[d] = Mesh_interval(low, high) + Mesh_interval(-reach, reach);
    }
    const Jet_2 f = m_surface.template jet<2>(box);
    Mesh_interval slope(0);
    for (int d = 0; d < 3; ++d)
      slope += f.derivative(d) * Mesh_interval(direction[d]);
    if (!(slope.inf() > 0))
      return std::nullopt;
    const auto along = interval_vector(direction);
    const Mesh_interval norm = CGAL::sqrt(dot(along, along));
    const double distance =
      (Mesh_interval(largest_value(f, t, extent)) * norm / Mesh_interval(slope.inf())).sup();
    return distance <= reach ? std::optional<double>(distance) : std::nullopt;
  }

  static Interval_vector interval_vector(const Point& p)
  {
    return {Mesh_interval(p[0]), Mesh_interval(p[1]), Mesh_interval(p[2])};
  }

  Point gradient(const Point& p) const
  {
    const Jet<double, 3, 1> f = m_surface.template jet<1>(p);
    return {f.derivative(0), f.derivative(1), f.derivative(2)};
  }

  // An upper bound of |f| on the triangle; `f` is its jet over a box around it.
  double largest_value(const Jet_2& f, const std::array<Point, 3>& t,
                       const Interval_vector& extent) const
  {
    double at_corners = 0;
    for (const Point& p : t)
    {
      const Mesh_interval x(p[0]), y(p[1]), z(p[2]);
      const Mesh_interval value = m_surface.function()(x, y, z);
      at_corners = (std::max)(at_corners, CGAL::abs(value).sup());
    }
    Symmetric_matrix_3<Mesh_interval> h;
    Mesh_interval spread(0);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
      {
        const Mesh_interval x = f.derivative(i, j);
        h(i, j) = Mesh_interval(x.inf() + (x.sup() - x.inf()) / 2);
        const Mesh_interval weight(i == j ? 1 : 2);
        spread += weight * CGAL::abs(x - h(i, j)) * extent[i] * extent[j] / Mesh_interval(8);
      }
    std::array<double, 3> terms;
    for (int k = 0; k < 3; ++k)
    {
      Interval_vector d;
      for (int i = 0; i < 3; ++i)
        d[i] = Mesh_interval(t[k][i]) - Mesh_interval(t[(k + 1) % 3][i]);
      terms[k] = (CGAL::abs(dot(d, multiply(h, d))) / Mesh_interval(2)).sup();
    }
    return (Mesh_interval(at_corners) + Mesh_interval(largest_mixture(terms)) + spread).sup();
  }

  const Implicit_surface_3<Function>& m_surface;
  const double m_reach, m_enough;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_DISTANCE_H
