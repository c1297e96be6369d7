// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_OF_PATCH_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_OF_PATCH_H

// Elber and Cohen's trichotomy: the patch divided by the signs of the Gaussian and the mean
// curvature, with a certified boundary and certified areas.

#include <CGAL/Shape_interrogation/Contours/contour.h>
#include <CGAL/Shape_interrogation/Contours/internal/Sign_areas.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Trichotomy.h>
#include <CGAL/Shape_interrogation/Property_surfaces/regularity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// Without the factors of the edges, which are positive inside.
inline Exact_function inside_of(const Bernstein_polynomial_2<Exact_rational>& f)
{
  std::vector<Integer_polynomial_2> inside{in_integers(f)};
  std::vector<Contour_edge_2> edges;
  if (!f.is_zero())
    divide_by_common_edges(inside, edges);
  return Exact_function(inside.front());
}

// The areas of the regions, of cells with the signs of the Gaussian and the mean curvature. The
// first one is perhaps zero everywhere.
class Region_areas
{
public:
  Region_areas(const Exact_function& mean, bool is_developable)
    : m_mean(mean), m_is_developable(is_developable)
  {}

  void add(const Signed_cell& cell)
  {
    const Exact_rational area =
      Exact_rational(cell.box.width(0)) * Exact_rational(cell.box.width(1));
    const auto possible = regions(cell);
    for (int k = 0; k < 3; ++k)
      if (possible[k])
      {
        m_areas[k].upper += area;
        if (std::count(possible.begin(), possible.end(), true) == 1)
          m_areas[k].lower += area;
      }
  }

  std::array<Area_range, 4> areas(const Exact_rational& whole) const
  {
    std::array<Area_range, 4> areas;
    for (int k = 0; k < 3; ++k)
      areas[k] = {m_areas[k].lower * whole, m_areas[k].upper * whole};
    return areas;
  }

private:
  // The regions to which more than a set of area 0 of the cell can belong: convex, concave, saddle.
  std::array<bool, 3> regions(const Signed_cell& cell) const
  {
    const CGAL::Sign gauss = m_is_developable ? POSITIVE : cell.signs[0];
    CGAL::Sign mean = cell.signs[m_is_developable ? 0 : 1];
    // Where the Gaussian curvature is positive, the mean curvature has no zero.
    if (!m_is_developable && gauss == POSITIVE && mean == ZERO)
      mean = m_mean.sign_at(cell.box.low[0] + cell.box.width(0) / 2,
                            cell.box.low[1] + cell.box.width(1) / 2);
    return {gauss != NEGATIVE && mean != NEGATIVE, gauss != NEGATIVE && mean != POSITIVE,
            gauss != POSITIVE};
  }

  const Exact_function& m_mean;
  bool m_is_developable;
  std::array<Area_range, 3> m_areas;
};

// The edges of the first list that are not in the second one.
inline std::vector<Contour_edge_2> without(std::vector<Contour_edge_2> edges,
                                           const std::vector<Contour_edge_2>& others)
{
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](const Contour_edge_2& e) {
                               return std::any_of(
                                 others.begin(), others.end(), [&](const Contour_edge_2& o) {
                                   return o.axis == e.axis && o.end == e.end;
                                 });
                             }),
              edges.end());
  return edges;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief divides a patch into its convex, concave and saddle parts, for its own normal
 * \f$ S_u \times S_v \f$.
 *
 * Whether the patch is developable or flat is decided exactly. The boundary of the parts is the
 * zero set of the second form's determinant, where there are umbilic or flat points perhaps without
 * a change of sign; on a developable patch it is that of the mean curvature. The areas are of the
 * parameter domain: a lower bound counts the cells in which the signs are proved, an upper bound
 * all cells in which they are not excluded. An upper bound of 0 proves that there is no such part.
 *
 * \param piece the patch and its intervals of parameters
 * \param options how well the areas must be known, and what may be spent
 * \param progress the progress callback, see `No_progress`
 *
 * \return the division. Refused are a patch that is nowhere regular
 * (`IRREGULAR_PARAMETRISATION`), and what the callback stops (`CANCELLED`).
 *
 * Degenerate cases: where the patch is not regular, such as on a collapsed edge, both polynomials
 * vanish; those edges are among `Regularity::edges`, and not in the boundary of the parts.
 * Source: Elber and Cohen, section 3.4, with the correction that the determinant may vanish without
 * changing its sign.
 */
template <class Progress = No_progress>
Result<Trichotomy> trichotomy_of_patch(const Surface_piece_3<Exact_rational>& piece,
                                       const Trichotomy_options& options = {},
                                       Progress progress = Progress())
{
  Property_surface_maker<Exact_rational> properties(piece.patch);
  const auto normal = properties.normal();
  if (normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero())
    return Refusal(Refusal_code::IRREGULAR_PARAMETRISATION,
                   "the patch is nowhere regular: it is a curve or a point");
  const auto gauss = properties.sign(Property::GAUSSIAN);
  const auto mean = properties.sign(Property::MEAN_SQUARED);
  const Exact_rational whole =
    (piece.u[1] - piece.u[0]) * (piece.v[1] - piece.v[0]);
  Trichotomy parts;
  parts.regularity = regularity(normal, properties.weight());
  parts.is_developable = gauss.is_zero();
  if (parts.is_developable && mean.is_zero())
  {
    parts.boundary.is_everything = true;
    parts.areas[static_cast<int>(Region::FLAT)] = {whole, whole};
    return parts;
  }
  const auto& divisor = parts.is_developable ? mean : gauss;
  const Result<Contour_2> boundary = contour(divisor, options.contour, progress);
  if (!boundary)
    return boundary.refusal();
  parts.boundary = *boundary;
  parts.boundary.edges = internal::without(parts.boundary.edges, parts.regularity.edges);
  const internal::Exact_function f = internal::inside_of(divisor), h = internal::inside_of(mean);
  internal::Sign_areas cells(f, h);
  std::size_t steps = 0;
  if (!cells.cut(options.open_area, options.max_cells,
                 [&] { return progress(++steps, options.max_cells); }))
    return Refusal(Refusal_code::CANCELLED, "the trichotomy was cancelled");
  internal::Region_areas areas(h, parts.is_developable);
  for (const internal::Signed_cell& cell : cells.cells())
    areas.add(cell);
  parts.areas = areas.areas(whole);
  return parts;
}

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief divides a Bezier patch into its convex, concave and saddle parts.
template <class Progress = No_progress>
Result<Trichotomy> trichotomy_of_patch(const Bezier_surface_3<Exact_rational>& patch,
                                       const Trichotomy_options& options = {},
                                       Progress progress = Progress())
{
  return trichotomy_of_patch(Surface_piece_3<Exact_rational>{patch, {0, 1}, {0, 1}}, options,
                             progress);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_OF_PATCH_H
