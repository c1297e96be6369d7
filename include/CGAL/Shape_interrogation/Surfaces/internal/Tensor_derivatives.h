// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_DERIVATIVES_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_DERIVATIVES_H

// The point and the derivatives of a tensor product, and what they mean where the last coordinate
// is a weight: with S = A / W, a_x = W A_x - A W_x = W^2 S_x and N.(W A_xy - A W_xy) = W^2 N.S_xy.

#include <CGAL/Shape_interrogation/Curves/internal/Basis_values.h>
#include <CGAL/Shape_interrogation/Curves/internal/Control_points.h>
#include <CGAL/Shape_interrogation/Surfaces/Surface_derivatives_3.h>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The derivatives of orders (0,0), (1,0), (0,1), (2,0), (1,1), (0,2).
template <class NT, int Dim>
struct Tensor_derivatives
{
  Coordinates<NT, Dim> s, u, v, uu, uv, vv;
};

// Sums the control points, `stride` numbers from row to row, over both bases.
template <int Dim, class Net, class NT, int DegreeU, int DegreeV>
Tensor_derivatives<NT, Dim> tensor_derivatives(Net net, int stride,
                                               const Basis_values<NT, DegreeU>& bu,
                                               const Basis_values<NT, DegreeV>& bv)
{
  Tensor_derivatives<NT, Dim> t;
  t.s.fill(NT(0));
  t.u = t.v = t.uu = t.uv = t.vv = t.s;
  for (int d = 0; d < Dim; ++d)
    for (int i = 0; i <= bu.degree(); ++i)
    {
      const std::array<NT, 3> row = sum_row(net + (i * stride + d), Dim, bv);
      t.s[d] += bu(0, i) * row[0];
      t.u[d] += bu(1, i) * row[0];
      t.v[d] += bu(0, i) * row[1];
      t.uu[d] += bu(2, i) * row[0];
      t.uv[d] += bu(1, i) * row[1];
      t.vv[d] += bu(0, i) * row[2];
    }
  return t;
}

template <class NT>
Surface_derivatives_3<NT> surface_derivatives(const Tensor_derivatives<NT, 3>& t)
{
  return {t.s, t.u, t.v, t.uu, t.uv, t.vv};
}

// The quotient rule: A_x = S_x W + S W_x and A_xy = S_xy W + S_x W_y + S_y W_x + S W_xy.
// The weight t.s[3] must not be zero.
template <class NT>
Surface_derivatives_3<NT> surface_derivatives(const Tensor_derivatives<NT, 4>& t)
{
  Surface_derivatives_3<NT> d;
  const NT& w = t.s[3];
  for (int i = 0; i < 3; ++i)
  {
    d.s[i] = t.s[i] / w;
    d.u[i] = (t.u[i] - d.s[i] * t.u[3]) / w;
    d.v[i] = (t.v[i] - d.s[i] * t.v[3]) / w;
    const NT su = d.u[i] * t.u[3], sv = d.v[i] * t.v[3];
    d.uu[i] = (t.uu[i] - su - su - d.s[i] * t.uu[3]) / w;
    d.uv[i] = (t.uv[i] - d.u[i] * t.v[3] - d.v[i] * t.u[3] - d.s[i] * t.uv[3]) / w;
    d.vv[i] = (t.vv[i] - sv - sv - d.s[i] * t.vv[3]) / w;
  }
  return d;
}

// W A_x - A W_x for a derivative x of any order.
template <class NT>
Coordinates<NT, 3> cleared(const Coordinates<NT, 4>& a, const Coordinates<NT, 4>& x)
{
  return {NT(a[3] * x[0] - a[0] * x[3]), NT(a[3] * x[1] - a[1] * x[3]),
          NT(a[3] * x[2] - a[2] * x[3])};
}

// The data moved to the origin, without division: those of the frame W^2 S_u, W^2 S_v, whose normal
// is W^4 S_u x S_v and whose second form is W^2 times the products with the cleared derivatives.
template <class NT>
Result<Local_shape_3<NT>> shape_at_origin(const Tensor_derivatives<NT, 4>& t)
{
  if (auto refusal = refuse_zero(t.s[3], Refusal_code::POLE, "the weight"))
    return *refusal;
  const Coordinates<NT, 3> u = cleared(t.s, t.u), v = cleared(t.s, t.v);
  Coordinates<NT, 3> n = cross(u, v);
  const NT w2 = t.s[3] * t.s[3];
  for (NT& x : n)
    x = -(w2 * x);
  const auto s = Local_shape_3<NT>::from_frame({NT(0), NT(0), NT(0)}, u, v,
                                               dot(n, cleared(t.s, t.uu)),
                                               dot(n, cleared(t.s, t.uv)),
                                               dot(n, cleared(t.s, t.vv)));
  if (auto refusal = refuse_zero(s.normal_squared_length(),
                                 Refusal_code::IRREGULAR_PARAMETRISATION,
                                 "the squared length of S_u x S_v"))
    return *refusal;
  return s;
}

template <class NT>
Result<Local_shape_3<NT>> shape_at_origin(const Tensor_derivatives<NT, 3>& t)
{
  Surface_derivatives_3<NT> d = surface_derivatives(t);
  d.s = {NT(0), NT(0), NT(0)};
  return shape_from_derivatives(d);
}

template <class NT>
Result<Local_shape_3<NT>> shape(const Tensor_derivatives<NT, 3>& t)
{
  return shape_from_derivatives(surface_derivatives(t));
}

template <class NT>
Result<Local_shape_3<NT>> shape(const Tensor_derivatives<NT, 4>& t)
{
  const auto s = shape_at_origin(t);
  if (!s)
    return s;
  return s->at(quotient<NT, 3>(t.s.data(), t.s[3]));
}

template <class NT>
Result<Surface_derivatives_3<NT>> derivatives_or_pole(const Tensor_derivatives<NT, 3>& t)
{
  return surface_derivatives(t);
}

template <class NT>
Result<Surface_derivatives_3<NT>> derivatives_or_pole(const Tensor_derivatives<NT, 4>& t)
{
  if (auto refusal = refuse_zero(t.s[3], Refusal_code::POLE, "the weight"))
    return *refusal;
  return surface_derivatives(t);
}

template <class NT>
Result<Coordinates<NT, 3>> point_or_pole(const Tensor_derivatives<NT, 3>& t)
{
  return t.s;
}

template <class NT>
Result<Coordinates<NT, 3>> point_or_pole(const Tensor_derivatives<NT, 4>& t)
{
  if (auto refusal = refuse_zero(t.s[3], Refusal_code::POLE, "the weight"))
    return *refusal;
  return quotient<NT, 3>(t.s.data(), t.s[3]);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_DERIVATIVES_H
