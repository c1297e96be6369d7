// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_REGULARITY_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_REGULARITY_H

// Where a patch is regular: the three components of its normal have no common zero.

#include <CGAL/Shape_interrogation/Contours/contour.h>
#include <CGAL/Shape_interrogation/Contours/internal/Exact_function.h>
#include <CGAL/Shape_interrogation/Contours/internal/common_edges.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Trichotomy.h>

#include <array>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// Cells in which no component of a vector has a sign are cut, the greatest first.
class Common_zeros
{
public:
  explicit Common_zeros(const std::vector<Integer_polynomial_2>& components)
  {
    for (const Integer_polynomial_2& f : components)
      if (!f.is_zero())
        m_f.emplace_back(f);
  }

  void operator()(std::size_t max_cells, Regularity& result)
  {
    std::vector<Cell_polynomial> whole;
    for (const Exact_function& f : m_f)
      whole.push_back(f.on({}));
    add({}, std::move(whole));
    for (std::size_t steps = 0; !m_greatest.empty(); ++steps)
    {
      const Cell cell = std::move(m_cells[m_greatest.top().second]);
      m_greatest.pop();
      if (steps >= max_cells || cell.box.area() < 1e-12)
        give_up(cell.box, result);
      else
        halve(cell);
    }
  }

private:
  struct Cell
  {
    Cell_box box;
    std::vector<Cell_polynomial> f;
  };

  void add(const Cell_box& box, std::vector<Cell_polynomial> f)
  {
    for (std::size_t k = 0; k < f.size(); ++k)
    {
      if (f[k].is_worn_out())
        f[k] = m_f[k].on(box);
      if (f[k].sign() != ZERO)
        return;
    }
    m_greatest.push({box.area(), m_cells.size()});
    m_cells.push_back({box, std::move(f)});
  }

  void halve(const Cell& cell)
  {
    const int axis = cell.box.width(1) > cell.box.width(0) ? 1 : 0;
    std::array<std::vector<Cell_polynomial>, 2> parts;
    for (const Cell_polynomial& f : cell.f)
    {
      auto halves = f.split(axis, 0.5);
      for (int k = 0; k < 2; ++k)
        parts[k].push_back(std::move(halves[k]));
    }
    std::array<Cell_box, 2> boxes{cell.box, cell.box};
    boxes[0].high[axis] = boxes[1].low[axis] =
      cell.box.low[axis] + cell.box.width(axis) / 2;
    for (int k = 0; k < 2; ++k)
      add(boxes[k], std::move(parts[k]));
  }

  // A box that became too small: its corners may be common zeros.
  void give_up(const Cell_box& box, Regularity& result) const
  {
    bool is_explained = false;
    for (double u : {box.low[0], box.high[0]})
      for (double v : {box.low[1], box.high[1]})
        if (vanishes(u, v))
        {
          is_explained = true;
          const std::array<double, 2> point{u, v};
          if (std::find(result.points.begin(), result.points.end(), point) == result.points.end())
            result.points.push_back(point);
        }
    if (!is_explained)
      result.boxes.push_back({box.low, box.high});
  }

  bool vanishes(double u, double v) const
  {
    for (const Exact_function& f : m_f)
      if (f.sign_at(u, v) != ZERO)
        return false;
    return true;
  }

  std::vector<Exact_function> m_f;
  std::vector<Cell> m_cells;
  std::priority_queue<std::pair<double, std::size_t>> m_greatest;
};

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief finds the places where a patch is not regular, from the components of its normal: edges
 * exactly, points exactly where they are corners of the cells into which the square is halved, else
 * in boxes of an area of about \f$ 10^{-12} \f$.
 *
 * Poles, where the common weight \f$ W \f$ vanishes, are a contour of their own: the polynomial
 * normal \f$ W^3 S_u \times S_v \f$ need not vanish there. Beside a point that is found, a box of
 * that size is not searched any further.
 *
 * The verdict is `NO` where a place is proved, `UNDECIDED` where there are boxes only.
 * \pre the normal does not vanish identically
 */
inline Regularity regularity(const std::array<Bernstein_polynomial_2<Exact_rational>, 3>& normal,
                             const Bernstein_polynomial_2<Exact_rational>& weight,
                             std::size_t max_cells = 20000)
{
  Regularity result;
  Contour_options options;
  options.max_cells = max_cells;
  result.poles = *contour(weight, options); // it is refused only when it is stopped
  std::vector<internal::Integer_polynomial_2> components;
  for (const auto& component : normal)
    components.push_back(internal::in_integers(component));
  internal::divide_by_common_edges(components, result.edges);
  internal::Common_zeros zeros(components);
  zeros(max_cells, result);
  const Contour_2& poles = result.poles;
  if (!result.edges.empty() || !result.points.empty() || poles.is_everything ||
      !poles.curves.empty() || !poles.edges.empty() || !poles.isolated_points.empty())
    result.verdict = Verdict::NO;
  else if (!result.boxes.empty() || !poles.unresolved.empty())
    result.verdict = Verdict::UNDECIDED;
  else
    result.verdict = Verdict::YES;
  return result;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_REGULARITY_H
