// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_SURFACE_FORMS_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_SURFACE_FORMS_H

// The first and second form of S = A / W in the lowest degree and without division, over numbers
// and over polynomials alike: (7) and (14) of Elber and Cohen for any weights.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <array>
#include <optional>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A function and its partial derivatives to order two.
template <class T>
struct Second_jet
{
  T x, u, v, uu, uv, vv;
};

// Each of the quantities is computed when it is asked for first. The comments tell by which power
// of W it is multiplied.
template <class R>
class Surface_forms
{
public:
  using Vector = Coordinates<R, 3>;

  explicit Surface_forms(Second_jet<Vector> a, std::optional<Second_jet<R>> w = std::nullopt)
    : m_a(std::move(a)), m_w(std::move(w))
  {}

  bool is_rational() const { return m_w.has_value(); }

  // x W^k.
  R times_weight(R x, int k) const
  {
    if (m_w)
      for (; k > 0; --k)
        x = x * m_w->x;
    return x;
  }

  // S_u and S_v (2).
  const Vector& tangent_u() { return tangent(m_tangent_u, m_a.u, &Second_jet<R>::u); }
  const Vector& tangent_v() { return tangent(m_tangent_v, m_a.v, &Second_jet<R>::v); }

  // n = S_u x S_v (3): W A_u x A_v - W_v A_u x A - W_u A x A_v.
  const Vector& normal()
  {
    return once(m_normal, [&] {
      Vector n = cross(m_a.u, m_a.v);
      if (!m_w)
        return n;
      const Vector with_v = cross(m_a.u, m_a.x), with_u = cross(m_a.x, m_a.v);
      for (int i = 0; i < 3; ++i)
        n[i] = m_w->x * n[i] - m_w->v * with_v[i] - m_w->u * with_u[i];
      return n;
    });
  }

  // n . n (6).
  const R& normal_squared()
  {
    return once(m_q, [&] { return square_sum(normal()); });
  }

  // n . S (4): W det(A, A_u, A_v), here without the factor W (3).
  const R& height()
  {
    return once(m_height, [&] { return dot(m_a.x, cross(m_a.u, m_a.v)); });
  }

  // n . S_uu, n . S_uv, n . S_vv (4): n . A_uu - W_uu det(A, A_u, A_v).
  const R& second_uu() { return second(m_uu, m_a.uu, &Second_jet<R>::uu); }
  const R& second_uv() { return second(m_uv, m_a.uv, &Second_jet<R>::uv); }
  const R& second_vv() { return second(m_vv, m_a.vv, &Second_jet<R>::vv); }

  // E, F, G (4).
  const R& first_uu()
  {
    return once(m_e, [&] { return square_sum(tangent_u()); });
  }
  const R& first_uv()
  {
    return once(m_f, [&] { return dot(tangent_u(), tangent_v()); });
  }
  const R& first_vv()
  {
    return once(m_g, [&] { return square_sum(tangent_v()); });
  }

  // The determinant of the second form (8).
  const R& determinant()
  {
    return once(m_determinant, [&] {
      R d = second_uu() * second_vv() - second_uv() * second_uv();
      return d;
    });
  }

  // E N - 2 F M + G L (8).
  const R& mean()
  {
    return once(m_mean, [&] {
      const R mixed = first_uv() * second_uv();
      R h = first_uu() * second_vv() - mixed - mixed + first_vv() * second_uu();
      return h;
    });
  }

  // The square of it (16).
  const R& mean_squared()
  {
    return once(m_mean_squared, [&] {
      R h = mean() * mean();
      return h;
    });
  }

  // (n . n)^2 (12).
  const R& normal_fourth()
  {
    return once(m_q2, [&] {
      R q2 = normal_squared() * normal_squared();
      return q2;
    });
  }

  // (n . n)^3 (18).
  const R& normal_sixth()
  {
    return once(m_q3, [&] {
      R q3 = normal_fourth() * normal_squared();
      return q3;
    });
  }

  // |S_uv|^2 (6): the vector is W (W^2 S_u)_v - 2 W_v (W^2 S_u) by W^3, symmetric in u and v.
  const R& twist_squared()
  {
    return once(m_twist, [&] {
      if (!m_w)
        return square_sum(m_a.uv);
      const Second_jet<R>& w = *m_w;
      const Vector& s = tangent_u();
      Vector t;
      for (int i = 0; i < 3; ++i)
      {
        const R derivative = w.v * m_a.u[i] + w.x * m_a.uv[i] - w.uv * m_a.x[i] - w.u * m_a.v[i];
        const R product = w.v * s[i];
        t[i] = w.x * derivative - product - product;
      }
      return square_sum(t);
    });
  }

private:
  template <class T, class Make>
  static const T& once(std::optional<T>& place, Make make)
  {
    if (!place)
      place.emplace(make());
    return *place;
  }

  // Squares of large numbers are cheaper than their products.
  static R square_sum(const Vector& x)
  {
    R s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    return s;
  }

  const Vector& tangent(std::optional<Vector>& place, const Vector& a, R Second_jet<R>::*w)
  {
    return once(place, [&] {
      if (!m_w)
        return a;
      Vector t;
      for (int i = 0; i < 3; ++i)
        t[i] = m_w->x * a[i] - (*m_w).*w * m_a.x[i];
      return t;
    });
  }

  const R& second(std::optional<R>& place, const Vector& a, R Second_jet<R>::*w)
  {
    return once(place, [&] {
      R l = dot(normal(), a);
      if (m_w)
        l = l - (*m_w).*w * height();
      return l;
    });
  }

  Second_jet<Vector> m_a;
  std::optional<Second_jet<R>> m_w;
  std::optional<Vector> m_tangent_u, m_tangent_v, m_normal;
  std::optional<R> m_q, m_height, m_uu, m_uv, m_vv, m_e, m_f, m_g, m_determinant, m_mean,
    m_mean_squared, m_q2, m_q3, m_twist;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_SURFACE_FORMS_H
