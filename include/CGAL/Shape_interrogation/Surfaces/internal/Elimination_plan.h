// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ELIMINATION_PLAN_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ELIMINATION_PLAN_H

// The order of a sparse Gaussian elimination with all its fill, fixed once and replayed at many
// points. Found by plan_elimination.h, which also decides the rank at one of them.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Entries live in slots: first those of the pattern, then the fill.
struct Elimination_plan
{
  struct Entry { int slot, column; };
  struct Update { int target, source; };               // slot[target] -= factor * slot[source]
  struct Reduction { int row, factor, first, last; };  // row -= factor * pivot row
  struct Pivot
  {
    int row, column, slot;
    int first_entry, last_entry;         // the rest of the pivot row
    int first_reduction, last_reduction; // the rows below
  };

  int rows = 0, columns = 0, slots = 0;
  std::vector<Pivot> pivots;
  std::vector<Entry> entries;
  std::vector<Reduction> reductions;
  std::vector<Update> updates;
  std::vector<int> free_columns;
  std::vector<int> redundant_rows;
  std::vector<int> remainders; // slots of the redundant rows that must have become zero
  bool undecided = false;      // an enclosure left entries that may or may not be zero

  int rank() const { return static_cast<int>(pivots.size()); }
};

// What a plan must keep to: how many pivots there are at most, and columns that are none.
struct Elimination_limits
{
  int max_rank = (std::numeric_limits<int>::max)();
  std::vector<int> free_columns;

  bool is_free(int column) const
  {
    return std::find(free_columns.begin(), free_columns.end(), column) != free_columns.end();
  }
};

// How good a number is as a pivot: 0 if it is not certainly different from zero. In floating point
// the size counts; exact pivots are all equally good, and plus or minus one is the cheapest.
template <class NT>
double pivot_quality(const NT& x)
{
  if (CGAL::possibly(is_zero_decision(x)))
    return 0;
  if constexpr (Number_type_traits<NT>::is_exact)
    return 1;
  else
    return std::fabs(number_cast<double>(x));
}

// Relative size below which a floating point entry counts as rounding noise of its row.
constexpr double numerical_rank_tolerance = 1.0 / (1ll << 33);

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ELIMINATION_PLAN_H
