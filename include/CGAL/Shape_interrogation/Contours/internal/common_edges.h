// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_COMMON_EDGES_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_COMMON_EDGES_H

// Edges of the unit square on which polynomials vanish together, found exactly and divided out.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/Contours/internal/Exact_function.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A polynomial with rational coefficients times a positive integer.
inline Integer_polynomial_2 in_integers(const Bernstein_polynomial_2<Exact_rational>& f)
{
  typename Fraction_traits<Exact_rational>::Denominator_type denominator;
  return Integer_polynomial_2::from_scaled_coefficients(
    f.degree(), clear_denominators(f.scaled_coefficients(), denominator));
}

// How often the polynomial vanishes where the variable `axis` is at its end.
inline int multiplicity_at(const Integer_polynomial_2& f, int axis, int end)
{
  const auto is_zero_line = [&](int i) {
    for (int j = 0; j <= f.degree()[1 - axis]; ++j)
      if (!CGAL::is_zero(f.scaled_coefficient(axis == 0 ? std::array<int, 2>{i, j}
                                                        : std::array<int, 2>{j, i})))
        return false;
    return true;
  };
  int multiplicity = 0;
  while (is_zero_line(end ? f.degree()[axis] - multiplicity : multiplicity))
    ++multiplicity;
  return multiplicity;
}

// Divides by u^a (1 - u)^b v^c (1 - v)^d. \pre the polynomial is a multiple of it
inline Integer_polynomial_2 divided_by_edges(const Integer_polynomial_2& f,
                                             const std::array<std::array<int, 2>, 2>& powers)
{
  std::vector<Exact_integer> scaled;
  for (int i = powers[0][0]; i <= f.degree()[0] - powers[0][1]; ++i)
    for (int j = powers[1][0]; j <= f.degree()[1] - powers[1][1]; ++j)
      scaled.push_back(f.scaled_coefficient({i, j}));
  return Integer_polynomial_2::from_scaled_coefficients(
    {f.degree()[0] - powers[0][0] - powers[0][1], f.degree()[1] - powers[1][0] - powers[1][1]},
    std::move(scaled));
}

// Divides polynomials by the highest power that they have in common for each edge, and adds the
// edges. Polynomials that are zero stay so. \pre one of them is not zero
inline void divide_by_common_edges(std::vector<Integer_polynomial_2>& polynomials,
                                   std::vector<Contour_edge_2>& edges)
{
  std::array<std::array<int, 2>, 2> powers{};
  for (int axis = 0; axis < 2; ++axis)
    for (int end = 0; end < 2; ++end)
    {
      int common = -1;
      for (const Integer_polynomial_2& f : polynomials)
        if (!f.is_zero())
        {
          const int multiplicity = multiplicity_at(f, axis, end);
          common = common < 0 ? multiplicity : (std::min)(common, multiplicity);
        }
      powers[axis][end] = common;
      if (common > 0)
        edges.push_back({axis, end, common});
    }
  for (Integer_polynomial_2& f : polynomials)
    if (!f.is_zero())
      f = divided_by_edges(f, powers);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_COMMON_EDGES_H
