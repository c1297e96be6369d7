// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_SHAPE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_SHAPE_H

// The vertex properties from the waist, with an error well below 1e-12 relative to the curvatures:
// intervals first, exact numbers where those are too wide. The gap of the principal curvatures and
// their directions come from the traceless part of the shape operator in an orthonormal frame of
// the tangent plane, which loses no digits near umbilics.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Vertex_shape
{
  Coordinates<double, 3> normal{}, direction_min{}, direction_max{};
  double gaussian_curvature = 0, mean_curvature = 0, kmin = 0, kmax = 0;
};

// The same shape for the opposite normal.
inline Vertex_shape opposite(const Vertex_shape& s)
{
  const auto& n = s.normal;
  return {{-n[0], -n[1], -n[2]}, s.direction_max, s.direction_min,
          s.gaussian_curvature, -s.mean_curvature, -s.kmax, -s.kmin};
}

inline Coordinates<double, 3> normalised(const Coordinates<double, 3>& v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// H and the gap rounded, and K: the larger principal curvature first, the other as a quotient.
inline void set_curvatures(Vertex_shape& s, double k, double h, double gap)
{
  s.gaussian_curvature = k;
  s.mean_curvature = h;
  const double large = std::abs(h) + gap / 2;
  const double small = large > 0 ? k / large : 0;
  s.kmin = h < 0 ? -large : (std::min)(small, large);
  s.kmax = h < 0 ? (std::max)(-small, -large) : large;
}

// An orthonormal frame of the tangent plane.
inline std::array<Coordinates<double, 3>, 2> tangent_frame(const Coordinates<double, 3>& n)
{
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(n[i]) < std::abs(n[least]))
      least = i;
  Coordinates<double, 3> axis{0, 0, 0};
  axis[least] = 1;
  const Coordinates<double, 3> e1 = normalised(cross(axis, n));
  return {e1, cross(n, e1)};
}

// e1'M e1 - e2'M e2 and 2 e1'M e2: the length of this vector is the difference of the eigenvalues,
// and half its angle leads from e1 to the direction of the larger one.
template <class NT>
std::array<NT, 2> traceless_part(const Symmetric_matrix_3<NT>& m,
                                 const std::array<Coordinates<double, 3>, 2>& frame)
{
  std::array<Coordinates<NT, 3>, 2> e;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 3; ++i)
      e[k][i] = NT(frame[k][i]);
  const Coordinates<NT, 3> m1 = multiply(m, e[0]), m2 = multiply(m, e[1]);
  return {NT(dot(e[0], m1) - dot(e[1], m2)), NT(NT(2) * dot(e[0], m2))};
}

// Directions right-handed with the unit normal.
inline void set_directions(Vertex_shape& s, const std::array<Coordinates<double, 3>, 2>& frame,
                           const std::array<double, 2>& traceless)
{
  const double angle = std::atan2(traceless[1], traceless[0]) / 2;
  for (int i = 0; i < 3; ++i)
    s.direction_max[i] = std::cos(angle) * frame[0][i] + std::sin(angle) * frame[1][i];
  s.direction_max = normalised(s.direction_max);
  s.direction_min = normalised(cross(s.direction_max, s.normal));
}

inline double middle(const Interval_nt<false>& x) { return number_cast<double>(x); }
inline double width(const Interval_nt<false>& x) { return x.sup() - x.inf(); }

// The properties, and whether all of them are narrow enough. Callers hold a Protector.
struct Enclosed_shape
{
  Vertex_shape shape;
  bool is_narrow;
};

inline Enclosed_shape enclosed_shape(const Local_shape_3<Interval_nt<false>>& s)
{
  using NT = Interval_nt<false>;
  Coordinates<double, 3> normal;
  double normal_width = 0;
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = middle(s.normal()[i]);
    normal_width = (std::max)(normal_width, width(s.normal()[i]));
  }
  Enclosed_shape e;
  e.shape.normal = normalised(normal);
  const auto frame = tangent_frame(e.shape.normal);
  const std::array<NT, 2> t = traceless_part(s.form(), frame);
  const NT q = s.normal_squared_length(), root = CGAL::sqrt(q);
  const NT length = CGAL::sqrt(CGAL::square(t[0]) + CGAL::square(t[1]));
  const NT gap = length / (s.form_denominator() * root);
  const NT k = gaussian_curvature(s), h = s.trace_numerator() / (NT(2) * s.scale() * q * root);
  const double scale = std::abs(middle(h)) + middle(gap) / 2, enough = 1e-12;
  e.is_narrow = width(h) <= enough * scale && width(gap) <= enough * scale &&
                width(k) <= enough * scale * scale && normal_width <= enough * root.inf() &&
                (std::max)(width(t[0]), width(t[1])) <= enough * length.inf();
  set_curvatures(e.shape, middle(k), middle(h), middle(gap));
  if (length.inf() > 0)
    set_directions(e.shape, frame, {middle(t[0]), middle(t[1])});
  return e;
}

inline Vertex_shape exact_shape(const Local_shape_3<Exact_rational>& s)
{
  Vertex_shape v;
  const Coordinates<Exact_rational, 3>& n = s.normal();
  const Exact_rational largest = (std::max)({Exact_rational(CGAL::abs(n[0])),
                                             Exact_rational(CGAL::abs(n[1])),
                                             Exact_rational(CGAL::abs(n[2]))});
  for (int i = 0; i < 3; ++i)
    v.normal[i] = number_cast<double>(Exact_rational(n[i] / largest));
  v.normal = normalised(v.normal);
  const double h = std::sqrt(number_cast<double>(squared_mean_curvature(s)));
  set_curvatures(v, number_cast<double>(gaussian_curvature(s)),
                 sign_of_mean_curvature(s) == NEGATIVE ? -h : h,
                 std::sqrt(number_cast<double>(squared_curvature_gap(s))));
  // This matrix has no trace in exact numbers already: rounding its entries costs nothing.
  const Symmetric_matrix_3<Exact_rational> m = umbilic_deviation(s);
  Exact_rational scale(0);
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      scale += CGAL::abs(m(i, j));
  if (CGAL::is_zero(scale))
    return v;
  Symmetric_matrix_3<double> rounded;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      rounded(i, j) = number_cast<double>(Exact_rational(m(i, j) / scale));
  const auto frame = tangent_frame(v.normal);
  set_directions(v, frame, traceless_part(rounded, frame));
  return v;
}

// `enclose()` and `evaluate()` return the local shape in intervals and in exact numbers. Where
// there are no exact numbers, the middle of the intervals is taken.
template <class Enclose, class Evaluate>
Result<Vertex_shape> vertex_shape(Enclose enclose, Evaluate evaluate)
{
  const auto enclosed = [&]() -> Result<Enclosed_shape> {
    const Interval_nt<false>::Protector protector;
    const Result<Local_shape_3<Interval_nt<false>>> s = enclose();
    if (!s)
      return s.refusal();
    return enclosed_shape(*s);
  }();
  if (enclosed && enclosed->is_narrow)
    return enclosed->shape;
  const Result<Local_shape_3<Exact_rational>> s = evaluate();
  if (s)
    return exact_shape(*s);
  if (s.refusal().code() != Refusal_code::NOT_ALGEBRAIC)
    return s.refusal();
  return enclosed ? Result<Vertex_shape>(enclosed->shape) : enclosed.refusal();
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_SHAPE_H
