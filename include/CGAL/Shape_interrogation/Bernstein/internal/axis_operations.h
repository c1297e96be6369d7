// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXIS_OPERATIONS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXIS_OPERATIONS_H

// What is done to scaled Bernstein coefficients along one axis after the other: values,
// derivatives, degree elevation and restriction.

#include <CGAL/Shape_interrogation/Bernstein/internal/axes.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Where the coefficient stands in the array.
template <std::size_t d>
std::size_t position(const std::array<int, d>& degree, const std::array<int, d>& index)
{
  std::size_t at = 0;
  for (std::size_t axis = 0; axis < d; ++axis)
  {
    CGAL_precondition_msg(0 <= index[axis] && index[axis] <= degree[axis],
                          "there is no such coefficient");
    at = at * (degree[axis] + 1) + index[axis];
  }
  return at;
}

template <std::size_t d>
std::array<int, d - 1> without_axis(const std::array<int, d>& degree, int axis)
{
  std::array<int, d - 1> rest;
  std::copy(degree.begin(), degree.begin() + axis, rest.begin());
  std::copy(degree.begin() + axis + 1, degree.end(), rest.begin() + axis);
  return rest;
}

// The value at x / (x + complement) times the power of the sum.
template <class T, std::size_t d>
T value_homogeneous(const std::array<int, d>& degree, std::vector<T> values,
                    const std::array<T, d>& x, const std::array<T, d>& complement)
{
  for (std::size_t axis = d; axis-- > 0;)
  {
    const auto powers = homogeneous_powers(degree[axis], x[axis], complement[axis]);
    const std::size_t count = values.size() / powers.size();
    std::vector<T> sums(count, T(0));
    for (std::size_t o = 0; o < count; ++o)
      for (std::size_t i = 0; i < powers.size(); ++i)
        add_product(sums[o], values[o * powers.size() + i], powers[i]);
    values = std::move(sums);
  }
  return values.front();
}

// The values with the coordinate fixed, from its powers.
template <class NT>
std::vector<NT> fixed_lines(const std::vector<NT>& numbers, const Axis_layout& layout,
                            const std::vector<NT>& powers)
{
  return change_lines(numbers, layout, 1, [&](auto from, auto to) {
    for (std::size_t i = 0; i < powers.size(); ++i)
      add_product(to(0), from(i), powers[i]);
  });
}

// The derivative, of a degree n less by one. \pre n is not 0
template <class NT>
std::vector<NT> differentiated_lines(const std::vector<NT>& numbers, const Axis_layout& layout)
{
  const int n = static_cast<int>(layout.length) - 1;
  return change_lines(numbers, layout, n, [&](auto from, auto to) {
    for (int i = 0; i < n; ++i)
      to(i) = NT(i + 1) * from(i + 1) - NT(n - i) * from(i);
  });
}

// The degree n higher by one.
template <class NT>
std::vector<NT> elevated_lines(const std::vector<NT>& numbers, const Axis_layout& layout)
{
  const std::size_t n = layout.length - 1;
  return change_lines(numbers, layout, n + 2, [&](auto from, auto to) {
    to(0) = from(0);
    for (std::size_t i = 1; i <= n; ++i)
      to(i) = from(i - 1) + from(i);
    to(n + 1) = from(n);
  });
}

// The lines times a matrix of their size, see restriction_matrix().
template <class NT>
std::vector<NT> multiplied_lines(const std::vector<NT>& numbers, const Axis_layout& layout,
                                 const std::vector<std::vector<NT>>& rows)
{
  return change_lines(numbers, layout, rows.size(), [&](auto from, auto to) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < rows.size(); ++k)
        add_product(to(k), from(i), rows[i][k]);
  });
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXIS_OPERATIONS_H
