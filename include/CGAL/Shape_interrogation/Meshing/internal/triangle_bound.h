// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H

// How far a patch is from a flat triangle between three of its points, not counting how the points
// slide along the patch: a point x = sum l_i x_i of the triangle is compared with S at
// f(x) = x + sum_{i<j} l_i l_j c_ij, where the shift c_ij of an edge can be chosen at will. With
// the second derivatives in H +- R and the first in J over a box that contains x and f(x), the
// distance of the two points is at most
//   | sum_{i<j} l_i l_j (1/2 H(d_ij, d_ij) - J c_ij) |
//     + 1/8 (R_uu |u|^2 + 2 R_uv |u| |v| + R_vv |v|^2),  d_ij = x_i - x_j,
// |u|, |v| the extent of the triangle (Taylor at x; the variance of numbers in [0, a] is <= a^2/4).

#include <CGAL/Shape_interrogation/Meshing/internal/Interval_net.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Interval_pair = std::array<Mesh_interval, 2>;

// Bounds for one triangle. Corner k is opposite edge k.
struct Triangle_bound
{
  double face;                // the patch from the triangle
  std::array<double, 3> edge; // what each edge contributes: tells which one to divide
};

inline double upper_norm(const Interval_vector& v)
{
  const Mesh_interval s = CGAL::square(v[0]) + CGAL::square(v[1]) + CGAL::square(v[2]);
  return CGAL::sqrt(s).sup();
}

inline Interval_pair difference(const Interval_pair& p, const Interval_pair& q)
{
  return {p[0] - q[0], p[1] - q[1]};
}

// A vector in the middle of a box, and the length that its distance to the box's points has at
// most.
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

// The maximum of sum_{i<j} l_i l_j e_ij over the triangle: if the e are the squared sides of an
// acute triangle this is its squared circumradius, else a quarter of the largest.
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

// The enclosed second derivatives in the form H +- R, and J.
class Split_derivatives
{
public:
  explicit Split_derivatives(const Derivative_box& box)
    : m_u(box.u), m_v(box.v), m_uu(box.uu), m_uv(box.uv), m_vv(box.vv)
  {}

  bool is_finite() const
  {
    return std::isfinite(m_uu.radius) && std::isfinite(m_uv.radius) && std::isfinite(m_vv.radius);
  }

  // An upper bound of | 1/2 H(d, d) - J c |.
  double term(const Interval_pair& d, const Interval_pair& c) const
  {
    const Mesh_interval half(0.5), uu = half * CGAL::square(d[0]), vv = half * CGAL::square(d[1]);
    Interval_vector t;
    for (int k = 0; k < 3; ++k)
      t[k] = Mesh_interval(m_uu.middle[k]) * uu + Mesh_interval(m_uv.middle[k]) * d[0] * d[1] +
             Mesh_interval(m_vv.middle[k]) * vv - m_u[k] * c[0] - m_v[k] * c[1];
    return upper_norm(t);
  }

  // 1/8 R over a box of the extent d.
  Mesh_interval spread(const Interval_pair& d) const
  {
    return (Mesh_interval(m_uu.radius) * CGAL::square(d[0]) +
            Mesh_interval(m_vv.radius) * CGAL::square(d[1]) +
            Mesh_interval(2) * Mesh_interval(m_uv.radius) * CGAL::abs(d[0] * d[1])) /
           Mesh_interval(8);
  }

  // The distance of the patch from an edge.
  double edge_bound(const Interval_pair& d, const Interval_pair& c) const
  {
    return (Mesh_interval(term(d, c)) / Mesh_interval(4) + spread(d)).sup();
  }

  // The shift of a line along one axis that removes the part of the second derivative in its
  // direction, at most `limit`. Any number is right; a good one makes bounds smaller.
  double best_shift(int axis, double length, double limit) const
  {
    const auto& second = axis == 0 ? m_uu.middle : m_vv.middle;
    const auto first = Middle_and_radius(axis == 0 ? m_u : m_v).middle;
    const double c = length * length * dot(first, second) / (2 * dot(first, first));
    return std::isfinite(c) ? std::clamp(c, -limit, limit) : 0;
  }

private:
  Interval_vector m_u, m_v;
  Middle_and_radius m_uu, m_uv, m_vv;
};

inline Triangle_bound no_bound()
{
  const double infinity = std::numeric_limits<double>::infinity();
  return {infinity, {infinity, infinity, infinity}};
}

// `corners` and `shifts` (of the edges opposite to the corners) in the parameters of the box.
inline Triangle_bound triangle_bound(const Derivative_box& box,
                                     const std::array<Interval_pair, 3>& corners,
                                     const std::array<Interval_pair, 3>& shifts)
{
  const Split_derivatives derivatives(box);
  if (!derivatives.is_finite())
    return no_bound();
  Triangle_bound bound;
  std::array<double, 3> terms;
  Interval_pair extent{Mesh_interval(0), Mesh_interval(0)};
  for (int k = 0; k < 3; ++k)
  {
    const Interval_pair d = difference(corners[(k + 1) % 3], corners[(k + 2) % 3]);
    for (int i = 0; i < 2; ++i)
      extent[i] = Mesh_interval((std::max)(extent[i].sup(), CGAL::abs(d[i]).sup()));
    terms[k] = derivatives.term(d, shifts[k]);
    bound.edge[k] = derivatives.edge_bound(d, shifts[k]);
  }
  bound.face = (Mesh_interval(largest_mixture(terms)) + derivatives.spread(extent)).sup();
  return bound;
}

// For a triangle with a pole, which stands for all of the patch between its opposite edge and the
// collapsed side. On a line across, from the pole to a point of that edge, the patch is compared
// with the chord, and the end of the chord with the edge. `axis` is the parameter that goes across.
inline Triangle_bound fan_bound(const Derivative_box& box,
                                const std::array<Interval_pair, 3>& corners,
                                const Interval_pair& shift, int pole, int axis)
{
  const Split_derivatives derivatives(box);
  if (!derivatives.is_finite())
    return no_bound();
  const int a = (pole + 1) % 3, b = (pole + 2) % 3;
  Triangle_bound bound;
  bound.edge[pole] = derivatives.edge_bound(difference(corners[a], corners[b]), shift);
  // The shifted edge may be a little farther from the pole than its ends.
  const Mesh_interval p = CGAL::abs(corners[a][axis] - corners[pole][axis]),
                      q = CGAL::abs(corners[b][axis] - corners[pole][axis]);
  const Mesh_interval longest = Mesh_interval((std::max)(p.sup(), q.sup())) +
                                CGAL::abs(shift[axis]) / Mesh_interval(4);
  // A line of length r is shifted by r^2 times that of one of length 1: at most by its length.
  Interval_pair d{Mesh_interval(0), Mesh_interval(0)}, c = d;
  d[axis] = Mesh_interval(1);
  c[axis] = Mesh_interval(derivatives.best_shift(axis, 1, 0.99 / longest.sup()));
  bound.edge[a] = bound.edge[b] =
    (Mesh_interval(derivatives.edge_bound(d, c)) * CGAL::square(longest)).sup();
  bound.face = (Mesh_interval(bound.edge[a]) + Mesh_interval(bound.edge[pole])).sup();
  return bound;
}

// For a curve over the box and its chord, in the parameters of the box.
inline double chord_bound(const Derivative_box& box, const Mesh_interval& length,
                          const Mesh_interval& shift)
{
  const Split_derivatives derivatives(box);
  if (!derivatives.is_finite())
    return std::numeric_limits<double>::infinity();
  return derivatives.edge_bound({length, Mesh_interval(0)}, {shift, Mesh_interval(0)});
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_TRIANGLE_BOUND_H
