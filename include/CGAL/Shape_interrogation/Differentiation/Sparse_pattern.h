// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_SPARSE_PATTERN_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_SPARSE_PATTERN_H

// Where the entries of a sparse matrix are (compressed rows).

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief stores which entries of a matrix may be non-zero.
 *
 * Entry `k` with `row_starts[i] <= k < row_starts[i+1]` lies in row `i` and column `columns[k]`;
 * the columns of a row increase.
 */
struct Sparse_pattern
{
  std::vector<std::size_t> row_starts{0}; //!< first entry of each row, and the number of entries
  std::vector<int> columns;               //!< the column of each entry

  //! returns the number of rows.
  std::size_t number_of_rows() const { return row_starts.size() - 1; }
  //! returns the number of entries.
  std::size_t number_of_entries() const { return columns.size(); }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_SPARSE_PATTERN_H
