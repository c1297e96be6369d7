// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_BOUNDARY_FACTORS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_BOUNDARY_FACTORS_H

// Powers of u and 1 - u that polynomials have in common, as on collapsed edges of patches.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Whether the polynomial has the factor u, or 1 - u at the end, for the variable u of the axis.
template <class NT, int d>
bool has_boundary_factor(const Bernstein_polynomial<NT, d>& p, int axis, bool at_end)
{
  const Axis_layout layout = axis_layout(p.degree(), axis);
  if (layout.length == 1)
    return false;
  const std::size_t i = at_end ? layout.length - 1 : 0;
  for (std::size_t o = 0; o < layout.outer; ++o)
    for (std::size_t r = 0; r < layout.stride; ++r)
      if (!CGAL::is_zero(p.scaled_coefficients()[(o * layout.length + i) * layout.stride + r]))
        return false;
  return true;
}

template <class NT, int d>
Bernstein_polynomial<NT, d> without_boundary_factor(const Bernstein_polynomial<NT, d>& p, int axis,
                                                    bool at_end)
{
  const Axis_layout layout = axis_layout(p.degree(), axis);
  std::array<int, d> degree = p.degree();
  --degree[axis];
  return Bernstein_polynomial<NT, d>::from_scaled_coefficients(
    degree, change_lines(p.scaled_coefficients(), layout, layout.length - 1,
                         [&](auto from, auto to) {
                           for (std::size_t i = 0; i + 1 < layout.length; ++i)
                             to(i) = from(at_end ? i : i + 1);
                         }));
}

// Divides by the factors that all the polynomials have in common. Tells whether there were any.
template <class NT, int d>
bool divide_by_boundary_factors(std::vector<Bernstein_polynomial<NT, d>>& polynomials)
{
  bool is_divided = false;
  for (int axis = 0; axis < d; ++axis)
    for (bool at_end : {false, true})
    {
      const auto is_common = [&] {
        for (const auto& p : polynomials)
          if (!has_boundary_factor(p, axis, at_end))
            return false;
        return true;
      };
      for (; is_common(); is_divided = true)
        for (auto& p : polynomials)
          p = without_boundary_factor(p, axis, at_end);
    }
  return is_divided;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_BOUNDARY_FACTORS_H
