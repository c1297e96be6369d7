// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PIVOT_QUEUE_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PIVOT_QUEUE_H

// The best pivot of a sparse matrix that changes: the smallest (r - 1)(c - 1) for the entries r of
// its row and c of its column, then the largest quality. All entries of a column share the factor
// c - 1, so a heap for each column and one for the bests of the columns are enough.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Heaps keep what is out of date until it comes to the top.
class Pivot_queue
{
public:
  Pivot_queue(std::size_t rows, std::size_t columns) : m_versions(rows, 0), m_columns(columns) {}

  // Forgets all candidates.
  void clear()
  {
    m_bests.clear();
    for (Column& column : m_columns)
      column.candidates.clear();
  }

  // Forgets the candidates of a row. All its columns must be told of.
  void forget_row(int row) { ++m_versions[row]; }

  // Forgets a column for good.
  void drop_column(int column)
  {
    m_columns[column].candidates = {};
    tell(column);
  }

  // Adds an entry as a candidate. The column must be told of.
  void add(int row, int column, int row_size, double quality)
  {
    std::vector<Candidate>& heap = m_columns[column].candidates;
    if (heap.size() == heap.capacity())
      make_room(heap);
    heap.push_back({row_size, row, m_versions[row], quality});
    std::push_heap(heap.begin(), heap.end(), Is_worse());
  }

  // Tells that the candidates of a column or the number of its entries have changed.
  void tell(int column)
  {
    if (m_columns[column].is_told)
      return;
    m_columns[column].is_told = true;
    m_told.push_back(column);
  }

  // Finds the best candidate; false if there is none. `counts` are the entries of the columns.
  bool find(const std::vector<int>& counts, int& row, int& column)
  {
    for (int j : m_told)
      renew_best(j, counts[j]);
    m_told.clear();
    while (!m_bests.empty() && m_bests.front().version != m_columns[m_bests.front().column].version)
      pop(m_bests);
    if (m_bests.empty())
      return false;
    row = m_bests.front().row;
    column = m_bests.front().column;
    return true;
  }

private:
  struct Candidate
  {
    int row_size, row, version;
    double quality;
  };
  struct Best
  {
    long cost;
    double quality;
    int row, column, version;
  };
  struct Column
  {
    std::vector<Candidate> candidates;
    int version = 0;
    bool is_told = false;
  };

  struct Is_worse
  {
    bool operator()(const Candidate& a, const Candidate& b) const
    {
      if (a.row_size != b.row_size)
        return a.row_size > b.row_size;
      return a.quality != b.quality ? a.quality < b.quality : a.row > b.row;
    }
    bool operator()(const Best& a, const Best& b) const
    {
      if (a.cost != b.cost)
        return a.cost > b.cost;
      if (a.quality != b.quality)
        return a.quality < b.quality;
      return a.row != b.row ? a.row > b.row : a.column > b.column;
    }
  };

  template <class T>
  static void pop(std::vector<T>& heap)
  {
    std::pop_heap(heap.begin(), heap.end(), Is_worse());
    heap.pop_back();
  }

  bool is_outdated(const Candidate& x) const { return x.version != m_versions[x.row]; }

  // Half of the memory is free then, so that it is not looked through often.
  void make_room(std::vector<Candidate>& heap) const
  {
    heap.erase(std::remove_if(heap.begin(), heap.end(),
                              [this](const Candidate& x) { return is_outdated(x); }),
               heap.end());
    std::make_heap(heap.begin(), heap.end(), Is_worse());
    heap.reserve((std::max)(2 * heap.size(), std::size_t(8)));
  }

  void renew_best(int j, int count)
  {
    Column& column = m_columns[j];
    column.is_told = false;
    ++column.version;
    std::vector<Candidate>& heap = column.candidates;
    while (!heap.empty() && is_outdated(heap.front()))
      pop(heap);
    if (heap.empty())
      return;
    const Candidate& best = heap.front();
    m_bests.push_back({static_cast<long>(best.row_size - 1) * (count - 1), best.quality, best.row,
                       j, column.version});
    std::push_heap(m_bests.begin(), m_bests.end(), Is_worse());
  }

  std::vector<int> m_versions; // of the rows
  std::vector<Column> m_columns;
  std::vector<Best> m_bests; // of the columns
  std::vector<int> m_told;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PIVOT_QUEUE_H
