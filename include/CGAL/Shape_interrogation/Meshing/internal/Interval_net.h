// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_INTERVAL_NET_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_INTERVAL_NET_H

// Control nets with interval entries: restriction to a box of parameters by de Casteljau, and an
// enclosure of the derivatives there by the convex hull of their Bernstein coefficients.

#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Callers hold Interval_nt<false>::Protector.
using Mesh_interval = Interval_nt<false>;
using Interval_vector = std::array<Mesh_interval, 3>;

// The next doubles, which make up for one rounding outside the protected region.
inline double step_down(double x) { return std::nextafter(x, -HUGE_VAL); }
inline double step_up(double x) { return std::nextafter(x, HUGE_VAL); }

// The derivatives with respect to parameters that run from 0 to 1 in the box.
struct Derivative_box
{
  Interval_vector u, v, uu, uv, vv;
};

// A net of (m + 1)(n + 1) homogeneous control points. A curve is a net with n = 0.
class Interval_net
{
public:
  Interval_net(int m, int n, bool is_rational)
    : m_m(m), m_n(n), m_is_rational(is_rational), m_points((m + 1) * (n + 1))
  {}

  int degree_u() const { return m_m; }
  int degree_v() const { return m_n; }
  bool is_rational() const { return m_is_rational; }

  std::array<Mesh_interval, 4>& operator()(int i, int j) { return m_points[i * (m_n + 1) + j]; }
  const std::array<Mesh_interval, 4>& operator()(int i, int j) const
  {
    return m_points[i * (m_n + 1) + j];
  }

  // Restricts the net to a box of parameters, which then runs from 0 to 1.
  // \pre 0 <= u0 < u1 <= 1 and the same for v
  void restrict_to(double u0, double u1, double v0, double v1)
  {
    for (int j = 0; j <= m_n; ++j)
      restrict_line(j, m_n + 1, m_m, u0, u1);
    for (int i = 0; m_n > 0 && i <= m_m; ++i)
      restrict_line(i * (m_n + 1), 1, m_n, v0, v1);
  }

private:
  // One row or column: first the part up to t1, then of that the part from t0.
  void restrict_line(int first, int step, int degree, double t0, double t1)
  {
    const auto point = [&](int i) -> std::array<Mesh_interval, 4>& {
      return m_points[first + i * step];
    };
    if (t1 < 1)
      for (int r = 1; r <= degree; ++r)
        for (int i = degree; i >= r; --i)
          blend(point(i - 1), point(i), Mesh_interval(t1), point(i));
    if (t0 > 0)
    {
      const Mesh_interval t = Mesh_interval(t0) / Mesh_interval(t1);
      for (int r = 1; r <= degree; ++r)
        for (int i = 0; i <= degree - r; ++i)
          blend(point(i), point(i + 1), t, point(i));
    }
  }

  void blend(const std::array<Mesh_interval, 4>& a, const std::array<Mesh_interval, 4>& b,
             const Mesh_interval& t, std::array<Mesh_interval, 4>& to) const
  {
    const Mesh_interval s = Mesh_interval(1) - t;
    for (int k = 0; k < (m_is_rational ? 4 : 3); ++k)
      to[k] = s * a[k] + t * b[k];
  }

  int m_m, m_n;
  bool m_is_rational;
  std::vector<std::array<Mesh_interval, 4>> m_points;
};

// The smallest interval that contains both.
inline Mesh_interval hull(const Mesh_interval& a, const Mesh_interval& b)
{
  return Mesh_interval((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
}

// The (du, dv)-th difference of a coordinate at (i, j), for du + dv at most two.
inline Mesh_interval difference(const Interval_net& net, int i, int j, int k, int du, int dv)
{
  const Mesh_interval& p = net(i, j)[k];
  if (du + dv == 0)
    return p;
  const int su = du > 0 ? 1 : 0, sv = 1 - su; // the step of the first difference
  const Mesh_interval& q = net(i + su, j + sv)[k];
  if (du + dv == 1)
    return q - p;
  return (net(i + du, j + dv)[k] - net(i + du - su, j + dv - sv)[k]) - (q - p);
}

// The hull of the Bernstein coefficients of the (du, dv)-th derivative of the homogeneous net.
inline std::array<Mesh_interval, 4> derivative_hull(const Interval_net& net, int du, int dv)
{
  const int m = net.degree_u(), n = net.degree_v();
  const int factor = (du > 0 ? m : 1) * (du > 1 ? m - 1 : 1) * (dv > 0 ? n : 1) *
                     (dv > 1 ? n - 1 : 1);
  std::array<Mesh_interval, 4> all;
  all.fill(Mesh_interval(0)); // also where there are no coefficients: intervals start undefined
  for (int k = 0; k < (net.is_rational() ? 4 : 3); ++k)
  {
    for (int i = 0; i <= m - du; ++i)
      for (int j = 0; j <= n - dv; ++j)
      {
        const Mesh_interval x = difference(net, i, j, k, du, dv);
        all[k] = i + j == 0 ? x : hull(all[k], x);
      }
    all[k] *= Mesh_interval(factor);
  }
  return all;
}

// Moves the origin near the net: quotient rules lose less there.
inline void center(Interval_net& net)
{
  const int m = net.degree_u(), n = net.degree_v();
  for (int k = 0; k < 3; ++k)
  {
    double c = 0;
    for (const auto* p : {&net(0, 0), &net(0, n), &net(m, 0), &net(m, n)})
      c += ((*p)[k] / (*p)[3]).inf() / 4;
    for (int i = 0; std::isfinite(c) && i <= m; ++i)
      for (int j = 0; j <= n; ++j)
        net(i, j)[k] -= Mesh_interval(c) * net(i, j)[3];
  }
}

// S = A / W by the quotient rule, W S_u = A_u - W_u S and so on. Infinite where W may vanish.
inline Derivative_box rational_derivatives(Interval_net net)
{
  center(net);
  const auto a = derivative_hull(net, 0, 0), au = derivative_hull(net, 1, 0);
  const auto av = derivative_hull(net, 0, 1), auu = derivative_hull(net, 2, 0);
  const auto auv = derivative_hull(net, 1, 1), avv = derivative_hull(net, 0, 2);
  const Mesh_interval w = a[3], two(2);
  Derivative_box box;
  for (int k = 0; k < 3; ++k)
  {
    const Mesh_interval s = a[k] / w;
    const Mesh_interval su = box.u[k] = (au[k] - au[3] * s) / w;
    const Mesh_interval sv = box.v[k] = (av[k] - av[3] * s) / w;
    box.uu[k] = (auu[k] - two * au[3] * su - auu[3] * s) / w;
    box.uv[k] = (auv[k] - au[3] * sv - av[3] * su - auv[3] * s) / w;
    box.vv[k] = (avv[k] - two * av[3] * sv - avv[3] * s) / w;
  }
  return box;
}

// Encloses the derivatives over the whole net.
inline Derivative_box enclosed_derivatives(const Interval_net& net)
{
  if (net.is_rational())
    return rational_derivatives(net);
  const auto vector = [&net](int du, int dv) -> Interval_vector {
    const auto x = derivative_hull(net, du, dv);
    return {x[0], x[1], x[2]};
  };
  return {vector(1, 0), vector(0, 1), vector(2, 0), vector(1, 1), vector(0, 2)};
}

// Encloses exact homogeneous control points, given by point(i, j).
template <class Points>
Interval_net interval_net(int m, int n, bool is_rational, Points point)
{
  Interval_net net(m, n, is_rational);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
    {
      const auto& p = point(i, j);
      for (int k = 0; k < 4; ++k)
        net(i, j)[k] = number_cast<Mesh_interval>(p[k]);
    }
  return net;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_INTERVAL_NET_H
