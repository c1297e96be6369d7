// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_BERNSTEIN_EXPRESSIONS_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_BERNSTEIN_EXPRESSIONS_H

// Bezier curves and patches as exact expressions in Bernstein form.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// The Bernstein polynomials of a degree at `t`.
inline std::vector<Expression> bernstein_expressions(int degree, const Expression& t)
{
  const Expression s = 1 - t;
  std::vector<Expression> basis;
  CGAL::Exact_rational binomial = 1;
  for (int i = 0; i <= degree; ++i)
  {
    basis.push_back(Expression(binomial) * (pow(s, degree - i) * pow(t, i)));
    binomial = binomial * CGAL::Exact_rational(degree - i) / CGAL::Exact_rational(i + 1);
  }
  return basis;
}

// The sum of `coefficient(i, j)` times the products of the basis functions, which sum up to 1:
// equal coefficients make a constant.
template <class Coefficient>
Expression combine(const std::vector<Expression>& along_u, const std::vector<Expression>& along_v,
                   Coefficient coefficient)
{
  bool is_constant = true;
  Expression sum;
  for (int i = 0; i < static_cast<int>(along_u.size()); ++i)
  {
    Expression row;
    for (int j = 0; j < static_cast<int>(along_v.size()); ++j)
    {
      row += along_v[j] * coefficient(i, j);
      is_constant = is_constant && coefficient(i, j) == coefficient(0, 0);
    }
    sum += along_u[i] * row;
  }
  return is_constant ? Expression(coefficient(0, 0)) : sum;
}

// The numerators and the weight of a patch with the homogeneous control points `point(i, j)`.
template <class Control_point>
std::array<Expression, 4> bernstein_form(const std::vector<Expression>& along_u,
                                         const std::vector<Expression>& along_v,
                                         Control_point point)
{
  std::array<Expression, 4> x;
  for (int k = 0; k < 4; ++k)
    x[k] = combine(along_u, along_v, [&](int i, int j) {
      return CGAL::Exact_rational(point(i, j)[k]);
    });
  return x;
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_BERNSTEIN_EXPRESSIONS_H
