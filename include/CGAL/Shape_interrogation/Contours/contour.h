// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_H

// The zero set of a polynomial on the unit square with certified topology (Elber and Cohen contour
// their property surfaces in floating point): Bernstein exclusion and monotonicity.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/Contours/internal/Contour_chains.h>
#include <CGAL/Shape_interrogation/Contours/internal/common_edges.h>
#include <CGAL/Shape_interrogation/Contours/internal/square_free_part.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// A check on everything before: inside of the square each vertex joins two arcs, unless an
// unresolved cell is behind it.
inline void add_cells_of_loose_ends(const std::vector<Contour_vertex>& vertices,
                                    const std::vector<Contour_arc>& arcs, std::vector<int>& cells)
{
  std::vector<int> degree(vertices.size(), 0);
  for (const Contour_arc& arc : arcs)
    for (int vertex : arc.vertices)
      ++degree[vertex];
  const auto is_loose = [&](int vertex) {
    const std::array<double, 2>& p = vertices[vertex].point;
    return degree[vertex] != 2 && vertices[vertex].unresolved_cell < 0 && p[0] > 0 && p[0] < 1 &&
           p[1] > 0 && p[1] < 1;
  };
  for (const Contour_arc& arc : arcs)
    if (is_loose(arc.vertices[0]) || is_loose(arc.vertices[1]))
      cells.push_back(arc.cell);
}

// Traces the zero set in a partition; false where another partition is needed. In the last attempt
// the cells where it is are given up.
inline bool trace(const Exact_function& f, std::vector<Contour_cell>& cells, double step,
                  bool is_last, Contour_2& contour)
{
  for (;;)
  {
    Cell_hits hits(f, cells);
    std::vector<int> degenerate = hits();
    std::vector<Contour_arc> arcs;
    Cell_arcs add_arcs(f, cells, hits);
    if (degenerate.empty())
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i].is_resolved() && !add_arcs(static_cast<int>(i), arcs))
          degenerate.push_back(static_cast<int>(i));
    add_cells_of_loose_ends(hits.vertices(), arcs, degenerate);
    if (degenerate.empty())
    {
      Contour_chains(cells, hits.vertices(), arcs, step)(contour);
      return true;
    }
    if (!is_last)
      return false;
    for (int cell : degenerate)
      cells[cell].slope = ZERO;
  }
}

// Adds the zero set of `f` to the contour, with the areas for `multiple`, which has the same one.
template <class Progress>
Result<Contour_2> contour_of_part(const Exact_function& f, const Exact_function& multiple,
                                  const Contour_options& options, Contour_2 contour,
                                  Progress& progress)
{
  constexpr std::array<double, 2> first_cuts[] = {
    {125. / 256, 119. / 256}, {131. / 256, 121. / 256}, {117. / 256, 143. / 256}};
  for (const auto& first_cut : first_cuts)
  {
    auto partition =
      Cell_partitioner(f, multiple, first_cut, options.max_cells, [&](std::size_t steps) {
        return progress(steps, std::size_t(0));
      })();
    if (partition.is_cancelled)
      return Refusal(Refusal_code::CANCELLED, "the contour was cancelled");
    if (!trace(f, partition.cells, options.step, &first_cut == std::end(first_cuts) - 1, contour))
      continue;
    contour.positive_area = partition.positive_area;
    contour.negative_area = partition.negative_area;
    break;
  }
  return contour;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief computes the zero set of `f` on the unit square with certified topology.
 *
 * Powers of \f$ u, 1-u, v, 1-v \f$ are divided out and reported as edges, of multiple factors one
 * is kept. The square is cut into cells until each has no point of the curve or a partial
 * derivative without zero: there the curve is a graph, known from its crossings with the edges of
 * the cell. All signs are certified: in floating point with a running bound of the error, exactly
 * where that is not enough. Cells are cut down to a width of \f$ 2^{-43} \f$; those that remain are
 * at a singular point, or parts of the curve are closer than that, and are unresolved.
 *
 * \param f the polynomial; with positive degree in a variable or not
 * \param options the step and the limit of the effort
 * \param progress the progress callback, see `No_progress`
 *
 * \return the zero set; it is refused only when the callback stops it (`CANCELLED`)
 *
 * The result depends on the input only. Complexity: a cell costs \f$ O(m n (m + n)) \f$ operations
 * in floating point. Their number is proportional to the length of the curve over its distance to
 * other parts of it, and to the logarithm of the least width at a simple singular point.
 */
template <class Progress = No_progress>
Result<Contour_2> contour(const Bernstein_polynomial_2<Exact_integer>& f,
                          const Contour_options& options = {}, Progress progress = Progress())
{
  Contour_2 contour;
  if (f.is_zero())
  {
    contour.is_everything = true;
    return contour;
  }
  std::vector<internal::Integer_polynomial_2> inside{f};
  internal::divide_by_common_edges(inside, contour.edges);
  const internal::Exact_function multiple(inside.front());
  if (internal::is_proved_square_free(multiple.polynomial()))
    return internal::contour_of_part(multiple, multiple, options, contour, progress);
  // A multiple factor is found at some expense, and perhaps has no zero in the square.
  Contour_options few = options;
  few.max_cells = (std::min)(options.max_cells, std::size_t(2000));
  const Result<Contour_2> first =
    internal::contour_of_part(multiple, multiple, few, contour, progress);
  if (!first || first->has_certified_topology())
    return first;
  const internal::Exact_function part(internal::square_free_part(multiple.polynomial()));
  return internal::contour_of_part(part, multiple, options, contour, progress);
}

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief computes the zero set of a polynomial with rational coefficients, by clearing their
 * denominators.
 */
template <class Progress = No_progress>
Result<Contour_2> contour(const Bernstein_polynomial_2<Exact_rational>& f,
                          const Contour_options& options = {}, Progress progress = Progress())
{
  return contour(internal::in_integers(f), options, progress);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_H
