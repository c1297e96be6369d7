// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXES_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXES_H

// Arrays of scaled Bernstein coefficients, changed along one axis: a tensor product polynomial is
// treated as many polynomials in one variable.

#include <CGAL/Shape_interrogation/Bernstein/internal/multiply_arrays.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// How the lines along an axis stand in the array: element i of line (o, r) is at (o length + i)
// stride + r, for o < outer and r < stride.
struct Axis_layout
{
  std::size_t outer = 1, length = 1, stride = 1;
};

template <std::size_t d>
Axis_layout axis_layout(const std::array<int, d>& degree, int axis)
{
  Axis_layout layout;
  for (std::size_t k = 0; k < d; ++k)
  {
    const std::size_t size = degree[k] + 1;
    (int(k) < axis ? layout.outer : int(k) == axis ? layout.length : layout.stride) *= size;
  }
  return layout;
}

// Makes an array with lines of another length: `write(from, to)` gets for each line two functions
// that return its elements.
template <class NT, class Write>
std::vector<NT> change_lines(const std::vector<NT>& numbers, const Axis_layout& layout,
                             std::size_t new_length, Write write)
{
  std::vector<NT> changed(layout.outer * new_length * layout.stride, NT(0));
  for (std::size_t o = 0; o < layout.outer; ++o)
    for (std::size_t r = 0; r < layout.stride; ++r)
      write(
        [&](std::size_t i) -> const NT& {
          return numbers[(o * layout.length + i) * layout.stride + r];
        },
        [&](std::size_t i) -> NT& { return changed[(o * new_length + i) * layout.stride + r]; });
  return changed;
}

// The binomial coefficients of one degree.
template <class NT>
std::vector<NT> binomials_in(int n)
{
  std::vector<NT> row(n + 1, NT(1));
  for (int i = 1; i <= n; ++i)
    for (int k = i - 1; k > 0; --k)
      row[k] = row[k] + row[k - 1];
  return row;
}

// What the scaled coefficients of a degree are times the coefficients.
template <class NT, std::size_t d>
std::vector<NT> scaling(const std::array<int, d>& degree)
{
  std::vector<NT> scales{NT(1)};
  for (int n : degree)
  {
    std::vector<NT> next;
    const std::vector<NT> row = binomials_in<NT>(n);
    for (const NT& scale : scales)
      for (const NT& c : row)
        next.push_back(scale * c);
    scales = std::move(next);
  }
  return scales;
}

// The powers s^i w^(n - i).
template <class T>
std::vector<T> homogeneous_powers(int n, const T& s, const T& w)
{
  std::vector<T> powers(n + 1, T(1));
  for (int i = 1; i <= n; ++i)
    powers[i] = powers[i - 1] * s;
  T power = w;
  for (int i = n - 1; i >= 0; --i)
  {
    powers[i] = powers[i] * power;
    if (i > 0)
      power = power * w;
  }
  return powers;
}

// Row i holds the scaled coefficients of w^n u^i (1 - u)^(n - i) for w u = a (1 - x) + b x.
template <class NT>
std::vector<std::vector<NT>> restriction_matrix(int n, const NT& a, const NT& b, const NT& w)
{
  const NT one(1), c = w - a, e = w - b;
  std::vector<std::vector<NT>> u{{one}}, v{{one}};
  const auto times = [](const std::vector<NT>& p, const NT& low, const NT& high) {
    std::vector<NT> q(p.size() + 1, NT(0));
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      q[i] = q[i] + p[i] * low;
      q[i + 1] = p[i] * high;
    }
    return q;
  };
  for (int i = 0; i < n; ++i)
  {
    u.push_back(times(u.back(), a, b));
    v.push_back(times(v.back(), c, e));
  }
  std::vector<std::vector<NT>> rows;
  for (int i = 0; i <= n; ++i)
    rows.push_back(
      multiply_arrays(std::array<int, 1>{i}, u[i], std::array<int, 1>{n - i}, v[n - i]));
  return rows;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_AXES_H
