// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_NULL_VECTORS_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_NULL_VECTORS_H

// The null vectors of a dense matrix over an exact field.

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The null vectors of the matrix with the given rows, by Gauss and Jordan.
template <class NT>
std::vector<std::vector<NT>> null_vectors(std::vector<std::vector<NT>> rows, int columns)
{
  std::vector<int> pivot_columns, free_columns;
  for (int c = 0; c < columns; ++c)
  {
    const std::size_t rank = pivot_columns.size();
    std::size_t r = rank;
    while (r < rows.size() && CGAL::is_zero(rows[r][c]))
      ++r;
    if (r == rows.size())
    {
      free_columns.push_back(c);
      continue;
    }
    std::swap(rows[r], rows[rank]);
    const NT pivot = rows[rank][c];
    for (NT& x : rows[rank])
      x = x / pivot;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const NT factor = rows[i][c];
      if (i != rank && !CGAL::is_zero(factor))
        for (int j = c; j < columns; ++j)
          rows[i][j] -= factor * rows[rank][j];
    }
    pivot_columns.push_back(c);
  }
  std::vector<std::vector<NT>> result;
  for (int c : free_columns)
  {
    std::vector<NT> v(columns, NT(0));
    v[c] = NT(1);
    for (std::size_t r = 0; r < pivot_columns.size(); ++r)
      v[pivot_columns[r]] = -rows[r][c];
    result.push_back(std::move(v));
  }
  return result;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_NULL_VECTORS_H
