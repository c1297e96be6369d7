// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_PARTITION_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_PARTITION_H

// The unit square cut into cells in which the zero set is empty, or the graph of a function over
// one of the coordinates, or unresolved because the cells became too small or too many.

#include <CGAL/Shape_interrogation/Contours/internal/Exact_function.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A cell that may meet the zero set. In a graph cell the derivative in the other variable than
// `over` has the sign `slope` everywhere.
struct Contour_cell
{
  Cell_box box;
  Cell_polynomial f;
  int over = 0;
  CGAL::Sign slope = ZERO;

  bool is_resolved() const { return slope != ZERO; }
};

struct Cell_partition
{
  std::vector<Contour_cell> cells;
  double positive_area = 0, negative_area = 0; // of the empty cells
  bool is_cancelled = false;
};

class Cell_partitioner
{
public:
  // The first cut of each variable is at `first_cut`, the others are halvings: lines at simple
  // numbers touch the curves of simple examples, and diagonals meet equal ones at corners.
  // Areas are counted by the sign of `multiple`, which has the same zero set.
  Cell_partitioner(const Exact_function& f, const Exact_function& multiple,
                   const std::array<double, 2>& first_cut, std::size_t max_cells,
                   std::function<bool(std::size_t)> go_on)
    : m_f(f), m_multiple(multiple), m_first_cut(first_cut), m_max_cells(max_cells),
      m_go_on(std::move(go_on))
  {}

  Cell_partition operator()()
  {
    examine({}, m_f.on({}));
    std::size_t steps = 0;
    while (!m_open.empty())
    {
      if (!m_go_on(++steps))
      {
        m_partition.is_cancelled = true;
        return std::move(m_partition);
      }
      const Contour_cell cell = std::move(m_waiting[m_open.top().second]);
      m_open.pop();
      cut(cell);
    }
    return std::move(m_partition);
  }

private:
  // Coordinates stay multiples of 2^-52.
  static constexpr double smallest_width = 1.0 / (1L << 43);

  void examine(const Cell_box& box, Cell_polynomial f)
  {
    if (f.is_worn_out())
      f = m_f.on(box);
    const CGAL::Sign sign = f.sign();
    if (sign != ZERO)
    {
      count_area(box, sign);
      return;
    }
    std::array<double, 2> variation;
    const std::array<CGAL::Sign, 2> slopes{f.derivative_sign(0, variation[0]),
                                           f.derivative_sign(1, variation[1])};
    // About the same in both variables: the longer side.
    const int steep = variation[1] > 2 * variation[0]   ? 1
                      : variation[0] > 2 * variation[1] ? 0
                      : box.width(1) > box.width(0)     ? 1
                                                        : 0;
    Contour_cell cell{box, std::move(f), steep, ZERO};
    if (slopes[0] == ZERO && slopes[1] == ZERO)
    {
      wait(std::move(cell));
      return;
    }
    cell.over = slopes[steep] != ZERO ? 1 - steep : steep;
    cell.slope = slopes[1 - cell.over];
    m_partition.cells.push_back(std::move(cell));
  }

  void count_area(const Cell_box& box, CGAL::Sign sign)
  {
    if (&m_multiple != &m_f)
      sign = m_multiple.sign_at(box.low[0] + box.width(0) / 2, box.low[1] + box.width(1) / 2);
    (sign == POSITIVE ? m_partition.positive_area : m_partition.negative_area) += box.area();
  }

  // Puts the cell aside to be cut across `cell.over`, unless it is too narrow.
  void wait(Contour_cell cell)
  {
    if (cell.box.width(cell.over) <= smallest_width || m_waiting.size() >= m_max_cells)
    {
      m_partition.cells.push_back(std::move(cell));
      return;
    }
    m_open.push({cell.box.area(), m_waiting.size()});
    m_waiting.push_back(std::move(cell));
  }

  void cut(const Contour_cell& cell)
  {
    const int axis = cell.over;
    const double t = cell.box.width(axis) == 1 ? m_first_cut[axis] : 0.5;
    auto parts = cell.f.split(axis, t);
    std::array<Cell_box, 2> boxes{cell.box, cell.box};
    const double middle = cell.box.low[axis] + t * cell.box.width(axis);
    boxes[0].high[axis] = boxes[1].low[axis] = middle;
    for (int k = 0; k < 2; ++k)
      examine(boxes[k], std::move(parts[k]));
  }

  const Exact_function& m_f;
  const Exact_function& m_multiple;
  std::array<double, 2> m_first_cut;
  std::size_t m_max_cells;
  std::function<bool(std::size_t)> m_go_on;
  Cell_partition m_partition;
  std::vector<Contour_cell> m_waiting;
  std::priority_queue<std::pair<double, std::size_t>> m_open; // the greatest cells first
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_PARTITION_H
