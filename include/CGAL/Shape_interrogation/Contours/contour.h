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
#include <CGAL/Shape_interrogation/Contours/internal/square_free_part.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// Divides by the highest powers of u, 1 - u, v, 1 - v, and names the edges where they vanish.
inline Integer_polynomial_2 without_edges(const Integer_polynomial_2& f,
                                          std::vector<Contour_edge_2>& edges)
{
  std::array<int, 2> first, last;
  const auto is_zero_line = [&](int axis, int i) {
    for (int j = 0; j <= f.degree()[1 - axis]; ++j)
      if (!CGAL::is_zero(f.scaled_coefficient(axis == 0 ? std::array<int, 2>{i, j}
                                                        : std::array<int, 2>{j, i})))
        return false;
    return true;
  };
  for (int axis = 0; axis < 2; ++axis)
  {
    first[axis] = 0;
    last[axis] = f.degree()[axis];
    while (is_zero_line(axis, first[axis]))
      ++first[axis];
    while (is_zero_line(axis, last[axis]))
      --last[axis];
    if (first[axis] > 0)
      edges.push_back({axis, 0, first[axis]});
    if (last[axis] < f.degree()[axis])
      edges.push_back({axis, 1, f.degree()[axis] - last[axis]});
  }
  std::vector<Exact_integer> scaled;
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
      scaled.push_back(f.scaled_coefficient({i, j}));
  return Integer_polynomial_2::from_scaled_coefficients(
    {last[0] - first[0], last[1] - first[1]}, std::move(scaled));
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

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationContours
 * \brief computes the zero set of `f` on the unit square with certified topology.
 *
 * Powers of \f$ u, 1-u, v, 1-v \f$ are divided out and reported as edges, of multiple factors one is
 * kept. The square is cut into cells until each has no point of the curve or a partial derivative
 * without zero: there the curve is a graph, known from its crossings with the edges of the cell. All
 * signs are certified: in floating point with a running bound of the error, exactly where that is
 * not enough. Cells are cut down to a width of \f$ 2^{-43} \f$; those that remain are at a singular
 * point, or parts of the curve are closer than that, and are reported as unresolved.
 *
 * \param f the polynomial; with positive degree in a variable or not
 * \param options the step and the limit of the effort
 * \param progress the progress callback, see `No_progress`
 *
 * \return the zero set; it is refused only when the callback stops it (`CANCELLED`)
 *
 * The result depends on the input only. Complexity: a cell costs \f$ O(m n (m + n)) \f$ operations in
 * floating point; their number is proportional to the length of the curve over the distance to other
 * parts of it, and \f$ O(\log) \f$ of the distance to a simple singular point.
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
  const internal::Exact_function multiple(internal::without_edges(f, contour.edges));
  const internal::Exact_function part(internal::square_free_part(multiple.polynomial()));
  const bool is_square_free = part.polynomial().degree() == multiple.polynomial().degree();
  const internal::Exact_function& function = is_square_free ? multiple : part;
  constexpr std::array<double, 2> first_cuts[] = {
    {125. / 256, 119. / 256}, {131. / 256, 121. / 256}, {117. / 256, 143. / 256}};
  for (const auto& first_cut : first_cuts)
  {
    auto partition = internal::Cell_partitioner(
      function, multiple, first_cut, options.max_cells,
      [&](std::size_t steps) { return progress(steps, std::size_t(0)); })();
    if (partition.is_cancelled)
      return Refusal(Refusal_code::CANCELLED, "the contour was cancelled");
    if (!internal::trace(function, partition.cells, options.step,
                         &first_cut == std::end(first_cuts) - 1, contour))
      continue;
    contour.positive_area = partition.positive_area;
    contour.negative_area = partition.negative_area;
    break;
  }
  return contour;
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
  typename Fraction_traits<Exact_rational>::Denominator_type denominator;
  return contour(
    Bernstein_polynomial_2<Exact_integer>::from_scaled_coefficients(
      f.degree(), internal::clear_denominators(f.scaled_coefficients(), denominator)),
    options, progress);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_CONTOUR_H
