// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EXACT_NET_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EXACT_NET_H

// Exact points of patches and curves at dyadic parameters: de Casteljau over the integers, with one
// common denominator, so that fractions are reduced only once a point.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Parameters are dyadic: integers over this number.
constexpr std::int32_t parameter_end = std::int32_t(1) << 29;

inline double parameter_value(std::int32_t t) { return double(t) / double(parameter_end); }

using Exact_point = Coordinates<Exact_rational, 3>;
using Exact_homogeneous_point = Coordinates<Exact_rational, 4>;

// A net of (m + 1)(n + 1) homogeneous control points. A curve is a net with n = 0.
class Exact_net
{
  using Fraction = Fraction_traits<Exact_rational>;
  using Integer = Fraction::Numerator_type;
  using Integer_point = std::array<Integer, 4>;

public:
  // `point(i, j)` returns the control points.
  template <class Points>
  Exact_net(int m, int n, Points point) : m_m(m), m_n(n)
  {
    Integer common(1);
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j)
        for (const Exact_rational& x : point(i, j))
        {
          const Integer d = denominator(x);
          common = common / CGAL::gcd(common, d) * d;
        }
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j)
      {
        const Exact_homogeneous_point p = point(i, j);
        m_points.emplace_back();
        for (int k = 0; k < 4; ++k)
          m_points.back()[k] = numerator(Exact_rational(p[k] * Exact_rational(common)));
      }
  }

  // None where the weight is zero.
  std::optional<Exact_point> point(std::int32_t u, std::int32_t v) const
  {
    std::vector<Integer_point> row(m_m + 1), column(m_n + 1);
    for (int i = 0; i <= m_m; ++i)
    {
      for (int j = 0; j <= m_n; ++j)
        column[j] = m_points[i * (m_n + 1) + j];
      row[i] = combine(column, v);
    }
    const Integer_point p = combine(row, u);
    if (CGAL::is_zero(p[3]))
      return std::nullopt;
    return Exact_point{quotient(p[0], p[3]), quotient(p[1], p[3]), quotient(p[2], p[3])};
  }

  // The direction of the derivative along u of a curve (n = 0), or zero.
  Exact_point tangent(std::int32_t u) const
  {
    std::vector<Integer_point> p = m_points;
    reduce(p, u, 2);
    Exact_point t;
    for (int k = 0; k < 3; ++k)
      t[k] = Exact_rational(Integer(p[1][k] * p[0][3] - p[0][k] * p[1][3]));
    return t;
  }

private:
  static Integer numerator(const Exact_rational& x)
  {
    Integer n, d;
    Fraction::Decompose()(x, n, d);
    return n;
  }

  static Integer denominator(const Exact_rational& x)
  {
    Integer n, d;
    Fraction::Decompose()(x, n, d);
    return d;
  }

  static Exact_rational quotient(const Integer& n, const Integer& d)
  {
    return Fraction::Compose()(n, d);
  }

  // Steps of de Casteljau until `left` points are left, each multiplied by the same power of the
  // denominator of t in lowest terms.
  static void reduce(std::vector<Integer_point>& p, std::int32_t t, std::size_t left)
  {
    std::int32_t end = parameter_end;
    while (t % 2 == 0 && end > 1)
    {
      t /= 2;
      end /= 2;
    }
    const Integer a(end - t), b(t);
    for (std::size_t size = p.size(); size > left; --size)
      for (std::size_t i = 0; i + 1 < size; ++i)
        for (int k = 0; k < 4; ++k)
          p[i][k] = a * p[i][k] + b * p[i + 1][k];
  }

  static const Integer_point& combine(std::vector<Integer_point>& p, std::int32_t t)
  {
    reduce(p, t, 1);
    return p.front();
  }

  int m_m, m_n;
  std::vector<Integer_point> m_points;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_EXACT_NET_H
