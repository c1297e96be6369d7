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
// points. Found by Markowitz pivoting on the values at one point, which also decides the rank
// there.

#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

template <class NT>
class Elimination_planner
{
public:
  Elimination_planner(const Sparse_pattern& pattern, int columns, const std::vector<NT>& values,
                      const Elimination_limits& limits)
    : m_rows(pattern.number_of_rows()), m_column_counts(columns, 0), m_values(values),
      m_scale(m_rows.size(), 0), m_active(m_rows.size(), true), m_limits(limits)
  {
    m_plan.rows = static_cast<int>(m_rows.size());
    m_plan.columns = columns;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (std::size_t k = pattern.row_starts[i]; k < pattern.row_starts[i + 1]; ++k)
      {
        m_rows[i][pattern.columns[k]] = static_cast<int>(k);
        ++m_column_counts[pattern.columns[k]];
        m_scale[i] = (std::max)(m_scale[i], magnitude(values[k]));
        m_largest_scale = (std::max)(m_largest_scale, m_scale[i]);
      }
  }

  Elimination_plan operator()()
  {
    std::vector<bool> is_free(m_plan.columns, true);
    int row, column;
    while (m_plan.rank() < m_limits.max_rank && find_pivot(row, column))
    {
      is_free[column] = false;
      eliminate(row, column);
    }
    for (int j = 0; j < m_plan.columns; ++j)
      if (is_free[j])
        m_plan.free_columns.push_back(j);
    collect_redundant_rows();
    m_plan.slots = static_cast<int>(m_values.size());
    return std::move(m_plan);
  }

private:
  using Row = std::map<int, int>; // column -> slot

  static double magnitude(const NT& x)
  {
    if constexpr (Number_type_traits<NT>::is_exact)
      return 1;
    else
      return std::fabs(number_cast<double>(x));
  }

  // In floating point, rows that are small beside others or have nearly cancelled wait until there
  // are no others: beside a solution, redundant rows are not quite zero or dependent.
  bool find_pivot(int& row, int& column)
  {
    constexpr bool has_noise =
      !Number_type_traits<NT>::is_exact && !Number_type_traits<NT>::is_enclosure;
    for (; has_noise && m_patience > 0; --m_patience)
      if (find_acceptable_pivot(row, column))
        return true;
    return find_acceptable_pivot(row, column);
  }

  // The smallest fill estimate (r - 1)(c - 1) among pivots that are not small in their row.
  bool find_acceptable_pivot(int& row, int& column) const
  {
    long best = -1;
    double best_quality = 0;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
    {
      if (!m_active[i])
        continue;
      const double floor = row_floor(i);
      for (const auto& [j, slot] : m_rows[i])
      {
        const double quality = pivot_quality(m_values[slot]);
        if (quality == 0 || quality < floor || m_limits.is_free(j))
          continue;
        const long cost = (static_cast<long>(m_rows[i].size()) - 1) * (m_column_counts[j] - 1);
        if (best >= 0 && (cost > best || (cost == best && quality <= best_quality)))
          continue;
        best = cost;
        best_quality = quality;
        row = static_cast<int>(i);
        column = j;
      }
    }
    return best >= 0;
  }

  double row_floor(std::size_t i) const
  {
    if constexpr (Number_type_traits<NT>::is_exact)
      return 0;
    double largest = 0;
    for (const auto& entry : m_rows[i])
      if (!m_limits.is_free(entry.first))
        largest = (std::max)(largest, pivot_quality(m_values[entry.second]));
    // An enclosure takes whatever is certainly not zero; only floating point guesses what is noise.
    if constexpr (Number_type_traits<NT>::is_enclosure)
      return 0.1 * largest;
    if (m_patience == 0)
      return (std::max)(0.1 * largest, numerical_rank_tolerance * m_scale[i]);
    const double size = m_patience == 1 ? 0 : std::ldexp(m_largest_scale, 10 * (m_patience - 7));
    return (std::max)({0.1 * largest, m_scale[i] / 1024, size});
  }

  void eliminate(int row, int column)
  {
    Elimination_plan::Pivot pivot;
    pivot.row = row;
    pivot.column = column;
    pivot.slot = m_rows[row][column];
    pivot.first_entry = static_cast<int>(m_plan.entries.size());
    for (const auto& [j, slot] : m_rows[row])
    {
      --m_column_counts[j];
      if (j != column)
        m_plan.entries.push_back({slot, j});
    }
    pivot.last_entry = static_cast<int>(m_plan.entries.size());
    pivot.first_reduction = static_cast<int>(m_plan.reductions.size());
    m_active[row] = false;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      if (m_active[i] && m_rows[i].count(column))
        reduce(static_cast<int>(i), pivot);
    pivot.last_reduction = static_cast<int>(m_plan.reductions.size());
    m_plan.pivots.push_back(pivot);
  }

  void reduce(int i, const Elimination_plan::Pivot& pivot)
  {
    Row& target = m_rows[i];
    const int factor = target[pivot.column];
    target.erase(pivot.column);
    --m_column_counts[pivot.column];
    Elimination_plan::Reduction reduction{i, factor, static_cast<int>(m_plan.updates.size()), 0};
    const NT f = m_values[factor] / m_values[pivot.slot];
    for (int k = pivot.first_entry; k < pivot.last_entry; ++k)
    {
      const Elimination_plan::Entry& e = m_plan.entries[k];
      auto [it, inserted] = target.try_emplace(e.column, static_cast<int>(m_values.size()));
      if (inserted)
      {
        m_values.push_back(NT(0));
        ++m_column_counts[e.column];
      }
      m_values[it->second] -= f * m_values[e.slot];
      m_plan.updates.push_back({it->second, e.slot});
    }
    reduction.last = static_cast<int>(m_plan.updates.size());
    m_plan.reductions.push_back(reduction);
  }

  void collect_redundant_rows()
  {
    for (std::size_t i = 0; i < m_rows.size(); ++i)
    {
      if (!m_active[i])
        continue;
      m_plan.redundant_rows.push_back(static_cast<int>(i));
      for (const auto& entry : m_rows[i])
      {
        m_plan.remainders.push_back(entry.second);
        if (Number_type_traits<NT>::is_enclosure &&
            !CGAL::certainly(is_zero_decision(m_values[entry.second])))
          m_plan.undecided = true;
      }
    }
  }

  Elimination_plan m_plan;
  std::vector<Row> m_rows;
  std::vector<int> m_column_counts;
  std::vector<NT> m_values;
  std::vector<double> m_scale;
  double m_largest_scale = 0;
  int m_patience = 6; // with less and less of it smaller and smaller rows are taken
  std::vector<bool> m_active;
  const Elimination_limits& m_limits;
};

template <class NT>
Elimination_plan plan_elimination(const Sparse_pattern& pattern, int columns,
                                  const std::vector<NT>& values,
                                  const Elimination_limits& limits = Elimination_limits())
{
  return Elimination_planner<NT>(pattern, columns, values, limits)();
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ELIMINATION_PLAN_H
