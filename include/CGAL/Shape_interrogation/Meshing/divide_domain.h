// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_DIVIDE_DOMAIN_H
#define CGAL_SHAPE_INTERROGATION_MESHING_DIVIDE_DOMAIN_H

// The unit square divided along the curves of a contour, as triangles and as trimming loops.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Region_finder.h>
#include <CGAL/Shape_interrogation/Meshing/internal/region_loops.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// Whether a curve ends inside of the square, so that it divides nothing.
inline bool ends_inside(const Contour_curve_2& curve)
{
  const auto is_inside = [](const Domain_point& p) {
    return p[0] > 0 && p[0] < 1 && p[1] > 0 && p[1] < 1;
  };
  return !curve.is_closed &&
         ((curve.unresolved[0] < 0 && is_inside(curve.points.front())) ||
          (curve.unresolved[1] < 0 && is_inside(curve.points.back())));
}

// The edges of triangles on the zero set: constraints that are no side of a box, and sides of the
// square where the polynomial vanishes.
class Contour_edge_finder
{
public:
  Contour_edge_finder(const Contour_2& contour, const Domain_options& options)
    : m_contour(contour), m_options(options)
  {}

  bool operator()(const Domain_point& p, const Domain_point& q, bool is_outside) const
  {
    if (is_outside)
      return std::any_of(m_contour.edges.begin(), m_contour.edges.end(), [&](const auto& e) {
        return p[e.axis] == e.end && q[e.axis] == e.end;
      });
    return std::none_of(
      m_contour.unresolved.begin(), m_contour.unresolved.end(), [&](const auto& box) {
        return !Domain_triangulation::is_point(box, m_options) && is_side(box, p, q);
      });
  }

private:
  static bool is_side(const Unresolved_box_2& box, const Domain_point& p, const Domain_point& q)
  {
    for (int k = 0; k < 2; ++k)
      if (p[k] == q[k] && (p[k] == box.low[k] || p[k] == box.high[k]) &&
          (std::min)(p[1 - k], q[1 - k]) >= box.low[1 - k] &&
          (std::max)(p[1 - k], q[1 - k]) <= box.high[1 - k])
        return true;
    return false;
  }

  const Contour_2& m_contour;
  const Domain_options& m_options;
};

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief divides the unit square along the curves of a contour into regions.
 *
 * \details The square is triangulated by a constrained Delaunay triangulation with exact
 * predicates, with all edges of the contour's polygons and vertices at about the distance of
 * `options`, nearer to each other only where points of the contour are. (Edges are at most twice
 * as long if the points of the contour are that near to each other; polygons are not divided
 * further.) Triangles that are connected without crossing a curve have the same region: it is
 * asked for at one point, inside of a triangle that is as many edges as possible away from curves.
 * So the region of triangles is that of the part of the square in which this point is; beside a
 * curve, between its polygon and the curve itself, points of a triangle belong to the next region.
 * The result is deterministic.
 *
 * <b>Unresolved boxes.</b> Those up to the width `Domain_options::point_width` are contracted to a
 * vertex, in which the curves that end there meet; if the box reaches the boundary of the square,
 * so does the vertex. Greater boxes are kept as rectangles: all triangles inside of them have the
 * region `unresolved_region`.
 *
 * \tparam Classify a function object that takes a point, `const std::array<double, 2>&`, with
 * coordinates that are multiples of \f$ 2^{-52} \f$, and returns a region as an integer from 0, or
 * `unresolved_region` if it cannot tell, then up to 15 further points of the same part are tried;
 * `Sign_classifier` and `Trichotomy_classifier` are such types
 *
 * \param contour the contour, for example from `contour()`
 * \param classify tells the regions of points
 * \param options how fine the triangles must be
 *
 * \return the divided square; it is refused if it needs more vertices than allowed
 * (`LIMIT_EXCEEDED`), or if a curve ends inside of the square and not in an unresolved box
 * (`UNDECIDED`)
 *
 * \pre `options.edge_length` is positive
 *
 * Degenerate cases: curves may be closed, end on the boundary or touch it, and share points. A part
 * that is everywhere thinner than the distance of the contour's curves from their polygons can have
 * the region of its neighbour; a smaller `Contour_options::step` helps.
 */
template <class Classify>
Result<Divided_domain> divide_domain(const Contour_2& contour, Classify classify,
                                     const Domain_options& options = {})
{
  CGAL_precondition_msg(options.edge_length > 0, "the length of edges must be positive");
  double vertices = 1.2 / (options.edge_length * options.edge_length);
  for (const Contour_curve_2& curve : contour.curves)
    vertices += double(curve.points.size());
  if (!(vertices <= double(options.max_vertices)))
    return Refusal(Refusal_code::LIMIT_EXCEEDED,
                   "the triangles of the domain need more vertices than are allowed");
  if (std::any_of(contour.curves.begin(), contour.curves.end(), internal::ends_inside))
    return Refusal(Refusal_code::UNDECIDED, "a curve of the contour ends inside of the square");
  const internal::Domain_triangulation t(contour, options);
  Divided_domain domain;
  domain.points = t.points;
  domain.regions = internal::regions_of(t, contour, options, classify);
  domain.parts = internal::joined_triangles(t.triangles, [&](int i, int k) {
    return domain.regions[i] == domain.regions[t.triangles[i].neighbours[k]];
  });
  const internal::Contour_edge_finder is_contour(contour, options);
  for (std::size_t i = 0; i < t.triangles.size(); ++i)
  {
    const internal::Domain_triangle& triangle = t.triangles[i];
    domain.triangles.push_back(triangle.corners);
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangle.corners[(k + 1) % 3], b = triangle.corners[(k + 2) % 3];
      const bool is_outside = triangle.neighbours[k] < 0;
      if (triangle.is_constrained[k] && (is_outside || a < b) &&
          is_contour(t.points[a], t.points[b], is_outside))
        domain.contour_edges.push_back({a, b});
    }
  }
  domain.loops = internal::Region_loops(t, domain.regions, domain.parts)();
  return domain;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_DIVIDE_DOMAIN_H
