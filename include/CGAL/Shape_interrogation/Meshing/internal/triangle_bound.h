// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H

// How far a patch is from a flat triangle between three of its points.
// With the second derivatives in H +- R over the triangle's box, the distance of S(x) from the
// interpolant at x = sum l_i x_i is at most
//   1/2 | sum_{i<j} l_i l_j H(d_ij, d_ij) | + 1/8 (R_uu + 2 R_uv + R_vv),  d_ij = x_i - x_j,
// for parameters scaled to the unit box (Taylor at x; the variance of a number in [0, 1] is <= 1/4).

#include <CGAL/Shape_interrogation/Meshing/internal/Interval_net.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Bounds for one triangle. Corner k is opposite edge k.
struct Triangle_bound
{
  double face;                // the patch from the triangle
  std::array<double, 3> edge; // what each edge contributes, times 8: tells which one to split
};

inline double upper_norm(const Interval_vector& v)
{
  const Mesh_interval s = CGAL::square(v[0]) + CGAL::square(v[1]) + CGAL::square(v[2]);
  return CGAL::sqrt(s).sup();
}

// A vector in the middle of a box, and the length that its distance to the box's points has at most.
struct Middle_and_radius
{
  explicit Middle_and_radius(const Interval_vector& box)
  {
    Interval_vector rest;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = box[k].inf() + (box[k].sup() - box[k].inf()) / 2;
      rest[k] = box[k] - Mesh_interval(middle[k]);
    }
    radius = upper_norm(rest);
  }
  std::array<double, 3> middle;
  double radius;
};

// max of sum_{i<j} l_i l_j e_ij over the triangle: for e the squared sides of a triangle this is the
// squared circumradius if it is acute, else a quarter of the largest.
inline double largest_mixture(std::array<double, 3> e)
{
  std::sort(e.begin(), e.end());
  const Mesh_interval a(e[0]), b(e[1]), c(e[2]);
  const Mesh_interval excess = a + b - c;
  if (!(excess.sup() > 0))
    return (c / Mesh_interval(4)).sup();
  const Mesh_interval area16 = Mesh_interval(4) * a * b - CGAL::square(excess);
  if (!(area16.inf() > 0))
    return (c / Mesh_interval(3)).sup();
  return (std::min)((c / Mesh_interval(3)).sup(), (a * b * c / area16).sup());
}

// `corners` are the parameters of the triangle's corners in its unit box.
inline Triangle_bound triangle_bound(const Second_derivative_box& box,
                                     const std::array<std::array<Mesh_interval, 2>, 3>& corners)
{
  const Middle_and_radius uu(box.uu), uv(box.uv), vv(box.vv);
  const Mesh_interval ruu(uu.radius), ruv = Mesh_interval(2) * Mesh_interval(uv.radius),
                      rvv(vv.radius);
  if (!std::isfinite(uu.radius) || !std::isfinite(uv.radius) || !std::isfinite(vv.radius))
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return {infinity, {infinity, infinity, infinity}};
  }
  Triangle_bound bound;
  std::array<double, 3> middle;
  for (int k = 0; k < 3; ++k)
  {
    const auto& p = corners[(k + 1) % 3];
    const auto& q = corners[(k + 2) % 3];
    const Mesh_interval du = p[0] - q[0], dv = p[1] - q[1];
    const Mesh_interval du2 = CGAL::square(du), dudv = du * dv, dv2 = CGAL::square(dv);
    Interval_vector h;
    for (int x = 0; x < 3; ++x)
      h[x] = Mesh_interval(uu.middle[x]) * du2 + Mesh_interval(vv.middle[x]) * dv2 +
             Mesh_interval(2) * Mesh_interval(uv.middle[x]) * dudv;
    middle[k] = upper_norm(h);
    bound.edge[k] = (Mesh_interval(middle[k]) + ruu * du2 + ruv * CGAL::abs(dudv) + rvv * dv2).sup();
  }
  bound.face = (Mesh_interval(largest_mixture(middle)) / Mesh_interval(2) +
                (ruu + ruv + rvv) / Mesh_interval(8)).sup();
  return bound;
}

// The same for a curve and its chord.
inline double chord_bound(const Interval_vector& second_derivative)
{
  const Middle_and_radius h(second_derivative);
  Interval_vector middle;
  for (int k = 0; k < 3; ++k)
    middle[k] = Mesh_interval(h.middle[k]);
  return ((Mesh_interval(upper_norm(middle)) + Mesh_interval(h.radius)) / Mesh_interval(8)).sup();
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H
