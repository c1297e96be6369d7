// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PLAN_ELIMINATION_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PLAN_ELIMINATION_H

// Finds the order of a sparse Gaussian elimination by Markowitz pivoting on the values at one
// point: the smallest fill estimate (r - 1)(c - 1) among pivots that are not small in their row.

#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Elimination_plan.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Pivot_queue.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
class Elimination_planner
{
public:
  Elimination_planner(const Sparse_pattern& pattern, int columns, const std::vector<NT>& values,
                      const Elimination_limits& limits)
    : m_rows(pattern.number_of_rows()), m_column_rows(columns), m_column_counts(columns, 0),
      m_values(values), m_scale(m_rows.size(), 0), m_active(m_rows.size(), true),
      m_queue(m_rows.size(), columns), m_limits(limits)
  {
    m_plan.rows = static_cast<int>(m_rows.size());
    m_plan.columns = columns;
    std::vector<int> sizes(columns, 0);
    for (int j : pattern.columns)
      ++sizes[j];
    for (int j = 0; j < columns; ++j)
      m_column_rows[j].reserve(sizes[j]);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (std::size_t k = pattern.row_starts[i]; k < pattern.row_starts[i + 1]; ++k)
      {
        m_rows[i].push_back({static_cast<int>(k), pattern.columns[k]});
        note_entry(static_cast<int>(i), pattern.columns[k]);
        m_scale[i] = (std::max)(m_scale[i], magnitude(values[k]));
        m_largest_scale = (std::max)(m_largest_scale, m_scale[i]);
      }
  }

  Elimination_plan operator()()
  {
    std::vector<bool> is_free(m_plan.columns, true);
    int row, column;
    queue_all_rows();
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
  using Entry = Elimination_plan::Entry;
  using Row = std::vector<Entry>; // by increasing column

  static double magnitude(const NT& x)
  {
    if constexpr (Number_type_traits<NT>::is_exact)
      return 1;
    else
      return std::fabs(number_cast<double>(x));
  }

  static int slot_of(const Row& row, int column)
  {
    return std::lower_bound(row.begin(), row.end(), column,
                            [](const Entry& e, int j) { return e.column < j; })->slot;
  }

  void note_entry(int row, int column)
  {
    m_column_rows[column].push_back(row);
    ++m_column_counts[column];
  }

  // In floating point, rows that are small beside others or have nearly cancelled wait until there
  // are no others: beside a solution, redundant rows are not quite zero or dependent.
  bool find_pivot(int& row, int& column)
  {
    constexpr bool has_noise =
      !Number_type_traits<NT>::is_exact && !Number_type_traits<NT>::is_enclosure;
    while (!m_queue.find(m_column_counts, row, column))
    {
      if (!has_noise || m_patience == 0)
        return false;
      --m_patience;
      queue_all_rows();
    }
    return true;
  }

  void queue_all_rows()
  {
    m_queue.clear();
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      if (m_active[i])
        queue_row(static_cast<int>(i));
  }

  // Makes those entries of a row candidates that are not small in it.
  void queue_row(int i)
  {
    m_queue.forget_row(i);
    const double floor = row_floor(i);
    const int size = static_cast<int>(m_rows[i].size());
    for (const auto& [slot, j] : m_rows[i])
    {
      const double quality = pivot_quality(m_values[slot]);
      if (quality != 0 && quality >= floor && !m_limits.is_free(j))
        m_queue.add(i, j, size, quality);
      m_queue.tell(j);
    }
  }

  double row_floor(std::size_t i) const
  {
    if constexpr (Number_type_traits<NT>::is_exact)
      return 0;
    double largest = 0;
    for (const Entry& entry : m_rows[i])
      if (!m_limits.is_free(entry.column))
        largest = (std::max)(largest, pivot_quality(m_values[entry.slot]));
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
    pivot.slot = -1;
    pivot.first_entry = static_cast<int>(m_plan.entries.size());
    for (const Entry& entry : m_rows[row])
    {
      --m_column_counts[entry.column];
      m_queue.tell(entry.column);
      if (entry.column == column)
        pivot.slot = entry.slot;
      else
        m_plan.entries.push_back(entry);
    }
    pivot.last_entry = static_cast<int>(m_plan.entries.size());
    pivot.first_reduction = static_cast<int>(m_plan.reductions.size());
    m_active[row] = false;
    m_queue.forget_row(row);
    m_queue.drop_column(column);
    std::vector<int> below = std::move(m_column_rows[column]);
    std::sort(below.begin(), below.end());
    const NT inverse = NT(1) / m_values[pivot.slot];
    for (int i : below)
      if (m_active[i])
        reduce(i, pivot, inverse);
    pivot.last_reduction = static_cast<int>(m_plan.reductions.size());
    m_plan.pivots.push_back(pivot);
  }

  // By the operations of the replay, which then has the same numbers.
  void reduce(int i, const Elimination_plan::Pivot& pivot, const NT& inverse)
  {
    const Row& target = m_rows[i];
    const int factor = slot_of(target, pivot.column);
    --m_column_counts[pivot.column];
    Elimination_plan::Reduction reduction{i, factor, static_cast<int>(m_plan.updates.size()), 0};
    const NT f = m_values[factor] * inverse;
    m_merged.clear();
    auto next = target.begin();
    const auto keep_before = [&](int column) {
      for (; next != target.end() && next->column < column; ++next)
        if (next->column != pivot.column)
          m_merged.push_back(*next);
    };
    for (int k = pivot.first_entry; k < pivot.last_entry; ++k)
    {
      const Entry& e = m_plan.entries[k];
      keep_before(e.column);
      if (next != target.end() && next->column == e.column)
        m_merged.push_back(*next++);
      else
      {
        m_merged.push_back({static_cast<int>(m_values.size()), e.column});
        m_values.push_back(NT(0));
        note_entry(i, e.column);
      }
      const int slot = m_merged.back().slot;
      m_values[slot] -= f * m_values[e.slot];
      m_plan.updates.push_back({slot, e.slot});
    }
    keep_before(m_plan.columns);
    m_rows[i].assign(m_merged.begin(), m_merged.end());
    reduction.last = static_cast<int>(m_plan.updates.size());
    m_plan.reductions.push_back(reduction);
    queue_row(i);
  }

  void collect_redundant_rows()
  {
    for (std::size_t i = 0; i < m_rows.size(); ++i)
    {
      if (!m_active[i])
        continue;
      m_plan.redundant_rows.push_back(static_cast<int>(i));
      for (const Entry& entry : m_rows[i])
      {
        m_plan.remainders.push_back(entry.slot);
        if (Number_type_traits<NT>::is_enclosure &&
            !CGAL::certainly(is_zero_decision(m_values[entry.slot])))
          m_plan.undecided = true;
      }
    }
  }

  Elimination_plan m_plan;
  std::vector<Row> m_rows;
  Row m_merged;
  std::vector<std::vector<int>> m_column_rows; // also rows that are not active any more
  std::vector<int> m_column_counts;            // of the active rows
  std::vector<NT> m_values;
  std::vector<double> m_scale;
  double m_largest_scale = 0;
  int m_patience = 6; // with less and less of it smaller and smaller rows are taken
  std::vector<bool> m_active;
  Pivot_queue m_queue;
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

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PLAN_ELIMINATION_H
