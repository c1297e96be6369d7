// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_CHART_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_CHART_H

// The tangent plane of a surface in n-space at a vertex, with the length that edges shall have
// there: in units of that length a vertex lies in the middle of a circle of radius 1, and its
// neighbours near that circle. The unit is the same in all directions, although the projection may
// contract some of them: so it varies slowly, and neighbouring charts agree on triangles.

#include <CGAL/Shape_interrogation/Surfaces/internal/orthonormal_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Chart_vector = std::array<double, 2>;

inline double length(const Chart_vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); }

struct N_space_chart
{
  std::vector<double> point;
  std::array<std::vector<double>, 2> basis; // orthonormal
  // How long the projection of a unit tangent vector is at most and at least.
  double stretch = 0, contraction = 0;
  double length = 1; // of an edge whose projection is as long as asked for, at most
  double size = 1;   // factor of that length, smaller where the tangent plane turns fast

  double unit() const { return size * length; }
};

// The singular values of the projection of the tangent plane.
inline void measure_projection(N_space_chart& chart)
{
  double g[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
  {
    const double x = chart.basis[0][i], y = chart.basis[1][i];
    g[0] += x * x;
    g[1] += x * y;
    g[2] += y * y;
  }
  const double squared_stretch = (g[0] + g[2]) / 2 + std::hypot((g[0] - g[2]) / 2, g[1]);
  chart.stretch = std::sqrt(squared_stretch);
  const double determinant = (std::max)(g[0] * g[2] - g[1] * g[1], 0.);
  chart.contraction = squared_stretch > 0 ? std::sqrt(determinant / squared_stretch) : 0;
}

// The position of a point of n-space relative to a chart, in units.
struct Chart_place
{
  Chart_vector at{};  // of the orthogonal projection to the tangent plane
  double across = 0;  // the distance from that plane
};

inline Chart_place place_in(const N_space_chart& chart, const std::vector<double>& x)
{
  double a = 0, b = 0, square = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double d = x[i] - chart.point[i];
    a += d * chart.basis[0][i];
    b += d * chart.basis[1][i];
    square += d * d;
  }
  const double unit = chart.unit();
  return {{a / unit, b / unit}, std::sqrt((std::max)(square - a * a - b * b, 0.)) / unit};
}

// The point of the tangent plane with the given coordinates.
inline std::vector<double> point_at(const N_space_chart& chart, const Chart_vector& c)
{
  std::vector<double> x = chart.point;
  add_multiple(x, c[0] * chart.unit(), chart.basis[0]);
  add_multiple(x, c[1] * chart.unit(), chart.basis[1]);
  return x;
}

// The gradient of the variable i along the chart.
inline Chart_vector gradient_of_variable(const N_space_chart& chart, int i)
{
  return {chart.unit() * chart.basis[0][i], chart.unit() * chart.basis[1][i]};
}

// The products of the vectors of two bases: its singular values are the cosines of the angles
// between the planes, its determinant says whether they are oriented alike.
struct Plane_angle
{
  double cosine = 1; // of the largest angle
  bool is_reversed = false;
};

inline Plane_angle angle_between(const N_space_chart& a, const N_space_chart& b)
{
  const double m00 = dot_product(a.basis[0], b.basis[0]), m01 = dot_product(a.basis[0], b.basis[1]);
  const double m10 = dot_product(a.basis[1], b.basis[0]), m11 = dot_product(a.basis[1], b.basis[1]);
  const double determinant = m00 * m11 - m01 * m10;
  const double sum = m00 * m00 + m01 * m01 + m10 * m10 + m11 * m11;
  const double gap = std::sqrt((std::max)(sum * sum - 4 * determinant * determinant, 0.));
  const double square = (std::max)(sum - gap, 0.) / 2;
  return {std::sqrt((std::min)(square, 1.)), determinant < 0};
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_N_SPACE_CHART_H
