// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_CURVE_DERIVATIVES_2_H
#define CGAL_SHAPE_INTERROGATION_CURVES_CURVE_DERIVATIVES_2_H

// The point and two derivatives of a plane curve from its control points, and what they mean where
// the third coordinate is a weight: with c = A / W, a' = W A' - A W' = W^2 c' and
// det(W A'' - A W'', a') = W^4 det(c'', c').

#include <CGAL/Shape_interrogation/Curves/internal/Basis_values.h>
#include <CGAL/Shape_interrogation/Curves/internal/Control_points.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief holds the point of a parametrised plane curve and its derivatives to order two.
 */
template <class NT>
struct Curve_derivatives_2
{
  Coordinates<NT, 2> c;   //!< the point
  Coordinates<NT, 2> t;   //!< \f$ c' \f$
  Coordinates<NT, 2> tt;  //!< \f$ c'' \f$
};

namespace internal {

// The derivatives of orders 0, 1, 2.
template <class NT, int Dim>
using Row_derivatives = std::array<Coordinates<NT, Dim>, 3>;

template <int Dim, class NT, int Degree>
Row_derivatives<NT, Dim> row_derivatives(const NT* points, const Basis_values<NT, Degree>& b)
{
  Row_derivatives<NT, Dim> r;
  for (int d = 0; d < Dim; ++d)
  {
    const std::array<NT, 3> sums = sum_row(points + d, Dim, b);
    for (int order = 0; order < 3; ++order)
      r[order][d] = sums[order];
  }
  return r;
}

// The data of the normal (-t_2, t_1) and the numerator factor * det(tt, t).
template <class NT>
Result<Local_shape_2<NT>> shape_from_derivatives(const Curve_derivatives_2<NT>& d,
                                                 const NT& factor = NT(1))
{
  const NT determinant = d.tt[0] * d.t[1] - d.tt[1] * d.t[0];
  return Local_shape_2<NT>::make(d.c, {NT(-d.t[1]), d.t[0]}, NT(factor * determinant),
                                 Refusal_code::IRREGULAR_PARAMETRISATION,
                                 "the squared length of the first derivative");
}

template <class NT>
Result<Curve_derivatives_2<NT>> derivatives_or_pole(const Row_derivatives<NT, 2>& r)
{
  return Curve_derivatives_2<NT>{r[0], r[1], r[2]};
}

// The quotient rule: A' = c' W + c W' and A'' = c'' W + 2 c' W' + c W''.
template <class NT>
Result<Curve_derivatives_2<NT>> derivatives_or_pole(const Row_derivatives<NT, 3>& r)
{
  if (auto refusal = refuse_zero(r[0][2], Refusal_code::POLE, "the weight"))
    return *refusal;
  Curve_derivatives_2<NT> d;
  const NT& w = r[0][2];
  for (int i = 0; i < 2; ++i)
  {
    d.c[i] = r[0][i] / w;
    d.t[i] = (r[1][i] - d.c[i] * r[1][2]) / w;
    const NT product = d.t[i] * r[1][2];
    d.tt[i] = (r[2][i] - product - product - d.c[i] * r[2][2]) / w;
  }
  return d;
}

template <class NT>
Result<Coordinates<NT, 2>> point_or_pole(const Row_derivatives<NT, 2>& r)
{
  return r[0];
}

template <class NT>
Result<Coordinates<NT, 2>> point_or_pole(const Row_derivatives<NT, 3>& r)
{
  if (auto refusal = refuse_zero(r[0][2], Refusal_code::POLE, "the weight"))
    return *refusal;
  return quotient<NT, 2>(r[0].data(), r[0][2]);
}

template <class NT>
Result<Local_shape_2<NT>> shape(const Row_derivatives<NT, 2>& r)
{
  return shape_from_derivatives(Curve_derivatives_2<NT>{r[0], r[1], r[2]});
}

// Decides without division; only the point needs one.
template <class NT>
Result<Local_shape_2<NT>> shape(const Row_derivatives<NT, 3>& r)
{
  const Result<Coordinates<NT, 2>> point = point_or_pole(r);
  if (!point)
    return point.refusal();
  const NT& w = r[0][2];
  Curve_derivatives_2<NT> d{*point, {}, {}};
  for (int i = 0; i < 2; ++i)
  {
    d.t[i] = w * r[1][i] - r[0][i] * r[1][2];
    d.tt[i] = w * r[2][i] - r[0][i] * r[2][2];
  }
  return shape_from_derivatives(d, NT(w * w));
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_CURVE_DERIVATIVES_2_H
