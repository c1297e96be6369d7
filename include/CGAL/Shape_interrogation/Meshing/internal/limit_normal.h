// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_LIMIT_NORMAL_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_LIMIT_NORMAL_H

// The limit of the unit normal at a collapsed edge. There S = P + t D(s) + O(t^2) with t the
// distance from the edge in the parameter domain, so N = +- t D x D' + O(t^2): the limit is the
// same for all s when D stays in a plane and turns one way, which Bernstein coefficients of det(n,
// D, D') prove.

#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>

#include <CGAL/Exact_rational.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Exact_vector = Coordinates<Exact_rational, 3>;

// The control vectors of D up to a positive factor: w (Q - P) for the control points Q next to the
// edge. None if some weight is not positive.
inline std::vector<Exact_vector> inward_vectors(const Bezier_surface_3<Exact_rational>& patch,
                                                Patch_edge edge)
{
  const int m = patch.degree_u(), n = patch.degree_v();
  const bool along_v = edge == Patch_edge::U0 || edge == Patch_edge::U1;
  const int on = edge == Patch_edge::U1 ? m : edge == Patch_edge::V1 ? n : 0;
  const int inside = on == 0 ? 1 : on - 1;
  const Exact_vector p = along_v ? patch.control_point(on, 0) : patch.control_point(0, on);
  std::vector<Exact_vector> vectors;
  for (int k = 0; k <= (along_v ? n : m); ++k)
  {
    const int i = along_v ? inside : k, j = along_v ? k : inside;
    const auto q = patch.homogeneous_control_point(i, j);
    const Exact_rational w = along_v ? patch.weight(on, k) : patch.weight(k, on);
    if (!CGAL::is_positive(q[3]) || !CGAL::is_positive(w))
      return {};
    vectors.push_back({Exact_rational(q[0] - q[3] * p[0]), Exact_rational(q[1] - q[3] * p[1]),
                       Exact_rational(q[2] - q[3] * p[2])});
  }
  return vectors;
}

// A normal of the plane that contains all vectors, if there is exactly one.
inline std::optional<Exact_vector> common_plane(const std::vector<Exact_vector>& vectors)
{
  std::optional<Exact_vector> normal;
  for (std::size_t i = 0; i < vectors.size() && !normal; ++i)
    for (std::size_t j = i + 1; j < vectors.size() && !normal; ++j)
    {
      const Exact_vector c = cross(vectors[i], vectors[j]);
      if (!CGAL::is_zero(dot(c, c)))
        normal = c;
    }
  for (const Exact_vector& v : vectors)
    if (normal && !CGAL::is_zero(dot(v, *normal)))
      return std::nullopt;
  return normal;
}

// The sign of det(n, D, D') on the whole edge, or 0 if the coefficients do not prove one.
inline int turning_sign(const std::vector<Exact_vector>& d, const Exact_vector& n)
{
  const int degree = static_cast<int>(d.size()) - 1;
  // Positive multiples of the coefficients of the product, of degree 2 degree - 1.
  std::vector<Exact_rational> product(2 * degree, Exact_rational(0));
  Exact_rational ci(1); // binomials (degree, i) and (degree - 1, j)
  for (int i = 0; i <= degree; ++i)
  {
    Exact_rational cj(1);
    for (int j = 0; j < degree; ++j)
    {
      const Exact_vector turn{Exact_rational(d[j + 1][0] - d[j][0]),
                              Exact_rational(d[j + 1][1] - d[j][1]),
                              Exact_rational(d[j + 1][2] - d[j][2])};
      product[i + j] += ci * cj * determinant(n, d[i], turn);
      cj = cj * (degree - 1 - j) / (j + 1);
    }
    ci = ci * (degree - i) / (i + 1);
  }
  bool positive = false, negative = false;
  for (const Exact_rational& c : product)
  {
    positive = positive || CGAL::is_positive(c);
    negative = negative || CGAL::is_negative(c);
  }
  return int(positive && !negative) - int(negative && !positive);
}

// A positive multiple of the limit of the unit normal at a collapsed edge, if it is proved to
// exist.
inline std::optional<Exact_vector> limit_normal(const Bezier_surface_3<Exact_rational>& patch,
                                                Patch_edge edge)
{
  const std::vector<Exact_vector> d = inward_vectors(patch, edge);
  std::optional<Exact_vector> n = common_plane(d);
  if (!n)
    return std::nullopt;
  // S_u x S_v is D x D' with this sign: on two of the edges one derivative points outward, or the
  // order of the two is the other one.
  const bool same = edge == Patch_edge::U0 || edge == Patch_edge::V1;
  const int sign = turning_sign(d, *n) * (same ? 1 : -1);
  if (sign == 0)
    return std::nullopt;
  for (Exact_rational& x : *n)
    x = x * sign;
  return n;
}

// Whether both point the same way.
inline bool is_same_direction(const Exact_vector& a, const Exact_vector& b)
{
  const Exact_vector c = cross(a, b);
  return CGAL::is_zero(dot(c, c)) && CGAL::is_positive(dot(a, b));
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_LIMIT_NORMAL_H
