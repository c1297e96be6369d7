// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_SPLINE_BASIS_H
#define CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_SPLINE_BASIS_H

// The B-spline basis by the recursion of Cox and de Boor, and its blossom, of which the Bezier
// points of a span are values. The derivative has the control points
// p (P_{i+1} - P_i) / (t_{i+p+1} - t_{i+1}) (Elber and Cohen, section 2, corrected).

#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Curves/internal/Basis_values.h>

#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// From the r functions of degree r - 1 that live on the span to the r + 1 of degree r, at t:
// b_i <- (t - t_i) b_i / (t_{i+r} - t_i) + (t_{i+r+1} - t) b_{i+1} / (t_{i+r+1} - t_{i+1}).
template <class NT, class Row>
void raise_degree(const Knot_vector<NT>& knots, int span, int r, const NT& t, Row b)
{
  const int first = span - r + 1;
  NT before(0);
  for (int j = 0; j < r; ++j)
  {
    const NT ratio = b(j) * knots.inverse_length(first + j, r);
    b(j) = before + (knots.knots()[first + j + r] - t) * ratio;
    before = (t - knots.knots()[first + j]) * ratio;
  }
  b(r) = before;
}

// The functions that are not zero on the span, with two derivatives, valid for the polynomials that
// continue them too.
template <int Degree, class NT>
Basis_values<NT, Degree> spline_basis(const Knot_vector<NT>& knots, int span, const NT& t)
{
  Basis_values<NT, Degree> b(knots.degree());
  const int p = b.degree();
  b(0, 0) = NT(1);
  b(2, 0) = NT(0);
  b(2, 1) = NT(0);
  for (int r = 1; r <= p; ++r)
  {
    const auto weight = [&](int j) {
      return NT(NT(r) * knots.inverse_length(span - r + 1 + j, r));
    };
    if (r == p - 1)
      differentiate(b, 0, 2, r, weight);
    if (r == p)
    {
      differentiate(b, 0, 1, r, weight);
      if (p > 1)
        differentiate(b, 2, 2, r, weight);
    }
    raise_degree(knots, span, r, t, [&b](int j) -> NT& { return b(0, j); });
  }
  return b;
}

// The matrix from the control points of a span to its Bezier points: row i holds the coefficients
// of the blossom with p - i arguments at the start of the span and i at its end.
template <class NT>
std::vector<std::vector<NT>> bezier_matrix(const Knot_vector<NT>& knots, int span)
{
  const int p = knots.degree();
  std::vector<std::vector<NT>> rows(p + 1, std::vector<NT>(p + 1, NT(0)));
  for (int i = 0; i <= p; ++i)
  {
    std::vector<NT>& row = rows[i];
    row[0] = NT(1);
    for (int r = 1; r <= p; ++r)
      raise_degree(knots, span, r, knots.knots()[r <= i ? span + 1 : span],
                   [&row](int j) -> NT& { return row[j]; });
  }
  return rows;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_SPLINE_BASIS_H
