// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_BEZIER_SURFACE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_BEZIER_SURFACE_3_H

// Bezier patches, polynomial or rational, with exact second-order data in any ring:
// Bernstein form without division (Elber and Cohen, section 3, in Hartmann's sign).

#include <CGAL/Shape_interrogation/Curves/internal/refuse_outside.h>
#include <CGAL/Shape_interrogation/Surfaces/Patch_edge.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/tensor_magnitudes.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/collapsed_edge.h>

#include <CGAL/assertions.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a tensor product Bezier patch on the unit square, oriented by \f$ S_u \times S_v \f$.
 *
 * With weights it is \f$ S = A / W \f$, \f$ A = \sum w_{ij} P_{ij} B_i(u) B_j(v) \f$ and
 * \f$ W = \sum w_{ij} B_i(u) B_j(v) \f$; the weights may have any sign. All decisions about the
 * shape are free of division, for rational patches too: the frame \f$ W^2 S_u, W^2 S_v \f$ has the
 * normal \f$ W^4 \, S_u \times S_v \f$ , which keeps the orientation for either sign of \f$ W \f$.
 *
 * Const calls are thread-safe, except for `CORE::Expr`. For degrees up to seven a call in an
 * inexact number type allocates nothing.
 *
 * \tparam NT a ring number type; the point of a rational patch needs a field
 *
 * Degenerate cases: where an edge is collapsed to a point, or the partial derivatives are linearly
 * dependent for another reason, the shape is refused (`IRREGULAR_PARAMETRISATION`); where \f$ W \f$
 * vanishes, everything is (`POLE`).
 *
 * Complexity: \f$ O(m n) \f$ operations in `NT` for the bidegree (m, n).
 * \cgalModels{ShapeSource_3}
 */
template <class NT>
class Bezier_surface_3
{
  using Control_points = internal::Control_points<NT, 3>;

public:
  using FT = NT;                                         //!< the number type
  using Point = Coordinates<NT, 3>;                      //!< a point or a vector
  using Homogeneous_point = Coordinates<NT, 4>;          //!< \f$ (w x, w y, w z, w) \f$
  using Parameters = Coordinates<NT, 2>;                 //!< a pair \f$ (u, v) \f$
  using Shape = Local_shape_3<NT>;                       //!< the second-order data
  //! the type of a query: the two parameters
  template <class Number>
  using Query = Coordinates<Number, 2>;

  /*!
   * \brief constructs the polynomial patch with the control points `points[i][j]`, `i` along
   * \f$ u \f$, or the rational one with the weights `weights[i][j]`.
   *
   * The control points are given unweighted.
   * \pre there are at least two rows of equal length at least two, and as many weights or none
   */
  explicit Bezier_surface_3(const std::vector<std::vector<Point>>& points,
                            const std::vector<std::vector<NT>>& weights = {})
    : Bezier_surface_3(static_cast<int>(points.size()) - 1,
                       points.empty() ? 0 : static_cast<int>(points.front().size()) - 1,
                       internal::in_a_row(points), internal::in_a_row(weights))
  {}

  /*!
   * \brief constructs the patch of bidegree (`degree_u`, `degree_v`) whose control point (i, j) is
   * element \f$ i (degree_v + 1) + j \f$ of `points`, with the weights in the same order, or none.
   *
   * \pre both degrees are at least 1, and the numbers of points and weights belong to them
   */
  Bezier_surface_3(int degree_u, int degree_v, std::vector<Point> points,
                   const std::vector<NT>& weights = {})
    : m_degree_u(degree_u), m_degree_v(degree_v),
      m_points(std::move(points), weights)
  {
    check_size();
  }

  //! returns the rational patch with the homogeneous control points \f$ (w x, w y, w z, w) \f$, of
  //! which some may have the weight 0. The order is as above.
  static Bezier_surface_3 from_homogeneous(int degree_u, int degree_v,
                                           const std::vector<Homogeneous_point>& points)
  {
    return Bezier_surface_3(degree_u, degree_v, Control_points(points));
  }

  int degree_u() const { return m_degree_u; } //!< returns the degree along \f$ u \f$.
  int degree_v() const { return m_degree_v; } //!< returns the degree along \f$ v \f$.

  //! tells whether the patch has weights.
  bool is_rational() const { return m_points.is_rational(); }

  //! returns a control point, unweighted. Needs a field if the patch was made from homogeneous
  //! points. \pre the weight is not zero
  Point control_point(int i, int j) const { return m_points.point(index(i, j)); }

  //! returns a weight; 1 if the patch has none.
  NT weight(int i, int j) const { return m_points.weight(index(i, j)); }

  //! returns \f$ (w x, w y, w z, w) \f$ of a control point.
  Homogeneous_point homogeneous_control_point(int i, int j) const
  {
    return m_points.homogeneous_point(index(i, j));
  }

  //! returns the parameter domain, the unit square, as the intervals of \f$ u \f$ and \f$ v \f$.
  std::array<Parameters, 2> domain() const
  {
    return {Parameters{NT(0), NT(1)}, Parameters{NT(0), NT(1)}};
  }

  /*!
   * \brief computes the second-order data at the parameters `uv`.
   *
   * Refused are parameters outside the unit square (`OUTSIDE_DOMAIN`), irregular places
   * (`IRREGULAR_PARAMETRISATION`), zeros of the common weight (`POLE`), and what the number type
   * cannot decide (`UNDECIDED`).
   */
  Result<Shape> operator()(const Parameters& uv) const
  {
    if (auto refusal = refuse_outside(uv))
      return *refusal;
    return extended_shape(uv);
  }

  //! computes the second-order data at any parameters, on the polynomial or rational extension.
  Result<Shape> extended_shape(const Parameters& uv) const
  {
    return answer<Shape>(uv, [](const auto& t) { return internal::shape(t); });
  }

  /*!
   * \brief computes the data of the patch moved so that its point at `uv` is the origin.
   *
   * Decisions about the shape do not depend on the point, and without it they need no division:
   * this is the form for filters and exact rings. The refusals are those of the call operator.
   */
  Result<Shape> shape_at_origin(const Parameters& uv) const
  {
    if (auto refusal = refuse_outside(uv))
      return *refusal;
    return answer<Shape>(uv, [](const auto& t) { return internal::shape_at_origin(t); });
  }

  //! computes the point and the partial derivatives to order two. Rational patches need a field.
  Result<Surface_derivatives_3<NT>> derivatives(const Parameters& uv) const
  {
    if (auto refusal = refuse_outside(uv))
      return *refusal;
    return extended_derivatives(uv);
  }

  //! computes the derivatives at any parameters, on the polynomial or rational extension.
  Result<Surface_derivatives_3<NT>> extended_derivatives(const Parameters& uv) const
  {
    return answer<Surface_derivatives_3<NT>>(
      uv, [](const auto& t) { return internal::derivatives_or_pole(t); });
  }

  //! computes the point. Rational patches need a field.
  Result<Point> point(const Parameters& uv) const
  {
    if (auto refusal = refuse_outside(uv))
      return *refusal;
    return answer<Point>(uv, [](const auto& t) { return internal::point_or_pole(t); });
  }

  /*!
   * \brief returns those edges of the parameter domain that are mapped to a single point, for
   * enclosures those that certainly are. Needs a ring only.
   */
  std::vector<Patch_edge> collapsed_edges() const
  {
    std::vector<Patch_edge> edges;
    for (Patch_edge edge : {Patch_edge::U0, Patch_edge::U1, Patch_edge::V0, Patch_edge::V1})
      if (internal::is_collapsed(internal::edge_points(*this, edge)))
        edges.push_back(edge);
    return edges;
  }

  //! returns the patch \f$ S(v, u) \f$, which has the opposite normal.
  Bezier_surface_3 transposed() const
  {
    const int rows = m_degree_u + 1, columns = m_degree_v + 1;
    return Bezier_surface_3(m_degree_v, m_degree_u, m_points.reordered([&](int k) {
      return k % rows * columns + k / rows;
    }));
  }

  //! returns the patch in another number type; the numbers given at construction are converted.
  template <class To>
  Bezier_surface_3<To> cast() const
  {
    return Bezier_surface_3<To>(m_degree_u, m_degree_v, m_points.template cast<To>());
  }

private:
  template <class> friend class Bezier_surface_3;

  Bezier_surface_3(int degree_u, int degree_v, Control_points points)
    : m_degree_u(degree_u), m_degree_v(degree_v), m_points(std::move(points))
  {
    check_size();
  }

  void check_size() const
  {
    CGAL_precondition_msg(m_degree_u >= 1 && m_degree_v >= 1 &&
                            m_points.size() == (m_degree_u + 1) * (m_degree_v + 1),
                          "a Bezier patch of bidegree (m, n), m and n at least 1, has "
                          "(m + 1)(n + 1) control points");
  }

  int index(int i, int j) const
  {
    CGAL_precondition_msg(0 <= i && i <= m_degree_u && 0 <= j && j <= m_degree_v,
                          "there is no such control point");
    return i * (m_degree_v + 1) + j;
  }

  static std::optional<Refusal> refuse_outside(const Parameters& uv)
  {
    const NT zero(0), one(1);
    if (auto refusal = internal::refuse_outside("u", uv[0], zero, one))
      return refusal;
    return internal::refuse_outside("v", uv[1], zero, one);
  }

  // Evaluates with or without weights and lets `ask` make the answer of it.
  template <class T, class Ask>
  Result<T> answer(const Parameters& uv, Ask ask) const
  {
    return internal::refuse_errors<T>([&]() -> Result<T> {
      if (is_rational())
        return ask(internal::as_numbers(evaluate<4>(uv)));
      return ask(internal::as_numbers(evaluate<3>(uv)));
    });
  }

  // Not inlined: all questions share it.
  template <int Dim>
  [[gnu::noinline]] auto evaluate(const Parameters& uv) const
  {
    return internal::with_degrees<NT>(m_degree_u, m_degree_v, [&](auto degree) {
      return internal::tensor_derivatives<Dim>(
        m_points.numbers(), Dim * (m_degree_v + 1),
        internal::bernstein_with_bounds<degree.value>(m_degree_u, uv[0]),
        internal::bernstein_with_bounds<degree.value>(m_degree_v, uv[1]));
    });
  }

  int m_degree_u, m_degree_v;
  Control_points m_points;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_BEZIER_SURFACE_3_H
