// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_TENSOR_INDEX_H
#define CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_TENSOR_INDEX_H

// The elements of arrays with several indices, and products of weights along the axes.

#include <CGAL/Shape_interrogation/Bernstein/internal/multiply_arrays.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Calls f with all indices from 0 to the last ones, the last index running fastest.
template <std::size_t d, class Function>
void for_each_index(const std::array<int, d>& last, Function f)
{
  std::array<int, d> i{};
  for (std::size_t count = size_of(last); count > 0; --count)
  {
    f(i);
    for (int k = d - 1; k >= 0 && ++i[k] > last[k]; --k)
      i[k] = 0;
  }
}

template <class Array>
Array filled(const typename Array::value_type& x)
{
  Array a;
  a.fill(x);
  return a;
}

template <class NT>
std::vector<NT> outer_product(const std::vector<NT>& a, const std::vector<NT>& b)
{
  std::vector<NT> c;
  for (const NT& x : a)
    for (const NT& y : b)
      c.push_back(x * y);
  return c;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_TENSOR_INDEX_H
