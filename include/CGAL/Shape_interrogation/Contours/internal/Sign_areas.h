// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SIGN_AREAS_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SIGN_AREAS_H

// The unit square cut into cells on which a polynomial has a sign, until the rest is small; for a
// second polynomial it is told where it has one, too.

#include <CGAL/Shape_interrogation/Contours/internal/Exact_function.h>

#include <array>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A cell and the signs of the two polynomials on all of it, ZERO where that is not known.
struct Signed_cell
{
  Cell_box box;
  std::array<CGAL::Sign, 2> signs;
};

class Sign_areas
{
public:
  Sign_areas(const Exact_function& f, const Exact_function& g) : m_functions{&f, &g}
  {
    add({{}, {f.on({}), g.on({})}});
  }

  // Cuts cells, the greatest first, until the area without a sign of the first polynomial is at
  // most `open_area` or `max_cells` were cut. Returns false where `go_on()` stops it.
  template <class Go_on>
  bool cut(double open_area, std::size_t max_cells, Go_on go_on)
  {
    for (std::size_t steps = 0; m_open_area > open_area && steps < max_cells; ++steps)
    {
      if (!go_on())
        return false;
      const Cell cell = std::move(m_cells[m_greatest.top().second]);
      m_greatest.pop();
      m_open_area -= cell.box.area();
      halve(cell);
    }
    return true;
  }

  // The cells with a sign of the first polynomial, then those without.
  std::vector<Signed_cell> cells()
  {
    std::vector<Signed_cell> all = m_signed;
    for (auto open = m_greatest; !open.empty(); open.pop())
    {
      const Cell& cell = m_cells[open.top().second];
      all.push_back({cell.box, {ZERO, cell.f[1].sign()}});
    }
    return all;
  }

private:
  struct Cell
  {
    Cell_box box;
    std::array<Cell_polynomial, 2> f;
  };

  void add(Cell cell)
  {
    for (int k = 0; k < 2; ++k)
      if (cell.f[k].is_worn_out())
        cell.f[k] = m_functions[k]->on(cell.box);
    const CGAL::Sign sign = cell.f[0].sign();
    if (sign != ZERO)
    {
      m_signed.push_back({cell.box, {sign, cell.f[1].sign()}});
      return;
    }
    m_open_area += cell.box.area();
    m_greatest.push({cell.box.area(), m_cells.size()});
    m_cells.push_back(std::move(cell));
  }

  void halve(const Cell& cell)
  {
    std::array<double, 2> variation;
    for (int axis = 0; axis < 2; ++axis)
      cell.f[0].derivative_sign(axis, variation[axis]);
    // Not too narrow: areas are wanted.
    const std::array<double, 2> width{cell.box.width(0), cell.box.width(1)};
    int axis = variation[1] > variation[0] ? 1 : 0;
    if (width[1 - axis] > 8 * width[axis])
      axis = 1 - axis;
    auto f = cell.f[0].split(axis, 0.5), g = cell.f[1].split(axis, 0.5);
    std::array<Cell_box, 2> boxes{cell.box, cell.box};
    boxes[0].high[axis] = boxes[1].low[axis] = cell.box.low[axis] + width[axis] / 2;
    for (int k = 0; k < 2; ++k)
      add({boxes[k], {std::move(f[k]), std::move(g[k])}});
  }

  std::array<const Exact_function*, 2> m_functions;
  double m_open_area = 0;
  std::vector<Cell> m_cells;
  std::vector<Signed_cell> m_signed;
  std::priority_queue<std::pair<double, std::size_t>> m_greatest;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SIGN_AREAS_H
