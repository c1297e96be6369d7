// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_NURBS_SURFACE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_NURBS_SURFACE_3_H

// B-spline surfaces, polynomial or rational: exact second-order data from either side of a knot,
// and exact extraction of the Bezier patches.

#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Curves/internal/spline_basis.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/tensor_magnitudes.h>

#include <CGAL/assertions.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief holds the second-order data of a surface from one side of the knots at a place.
 */
template <class NT>
struct One_sided_shape_3
{
  Side side_u;                    //!< the side of \f$ u \f$ from which the data come
  Side side_v;                    //!< the side of \f$ v \f$ from which the data come
  Result<Local_shape_3<NT>> shape; //!< the data, or why there are none from there
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief holds a Bezier patch of a spline surface and the parameters that it covers.
 */
template <class NT>
struct Surface_piece_3
{
  Bezier_surface_3<NT> patch; //!< the patch, on the unit square
  Coordinates<NT, 2> u;       //!< the interval of \f$ u \f$
  Coordinates<NT, 2> v;       //!< the interval of \f$ v \f$
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a tensor product B-spline surface with or without weights, oriented by
 * \f$ S_u \times S_v \f$.
 *
 * The knot vectors are full ones and may be unclamped; the domain is
 * \f$ [U_p, U_m] \times [V_q, V_n] \f$ for m x n control points. At a knot where the surface has
 * fewer than two continuous derivatives the data differ from side to side: `operator()` answers
 * from the right (from the left at the end of the domain), `one_sided_shapes()` from all sides.
 * Only the lengths of knot spans are divided by, and that once at construction.
 *
 * Const calls are thread-safe, except for `CORE::Expr`. Degenerate cases are those of
 * `Bezier_surface_3`.
 *
 * \tparam NT a field number type
 *
 * Complexity: \f$ O(p q + \log k) \f$ operations in `NT` for the degrees p, q and k knots.
 * \cgalModels{ShapeSource_3}
 */
template <class NT>
class Nurbs_surface_3
{
  using Control_points = internal::Control_points<NT, 3>;

public:
  using FT = NT;                                //!< the number type
  using Point = Coordinates<NT, 3>;             //!< a point or a vector
  using Homogeneous_point = Coordinates<NT, 4>; //!< \f$ (w x, w y, w z, w) \f$
  using Parameters = Coordinates<NT, 2>;        //!< a pair \f$ (u, v) \f$
  using Shape = Local_shape_3<NT>;              //!< the second-order data
  //! the type of a query: the two parameters
  template <class Number>
  using Query = Coordinates<Number, 2>;

  /*!
   * \brief constructs the surface with the control points `points[i][j]`, `i` along \f$ u \f$,
   * and the weights `weights[i][j]`, if any. The control points are given unweighted.
   *
   * \pre `why_invalid()` has nothing to tell
   */
  Nurbs_surface_3(Knot_vector<NT> knots_u, Knot_vector<NT> knots_v,
                  const std::vector<std::vector<Point>>& points,
                  const std::vector<std::vector<NT>>& weights = {})
    : Nurbs_surface_3(std::move(knots_u), std::move(knots_v),
                      Control_points(internal::in_a_row(points), internal::in_a_row(weights)))
  {
    CGAL_precondition_code(const auto reason = why_invalid(m_u, m_v, points, weights);)
    CGAL_precondition_msg(!reason, reason->c_str());
  }

  //! tells in one sentence why these data make no surface, or nothing if they do.
  static std::optional<std::string> why_invalid(const Knot_vector<NT>& knots_u,
                                                const Knot_vector<NT>& knots_v,
                                                const std::vector<std::vector<Point>>& points,
                                                const std::vector<std::vector<NT>>& weights = {})
  {
    const int rows = knots_u.number_of_control_points();
    const int columns = knots_v.number_of_control_points();
    if (auto reason = internal::why_no_grid("control points", points, rows, columns))
      return reason;
    if (!weights.empty())
      return internal::why_no_grid("weights", weights, rows, columns);
    return std::nullopt;
  }

  const Knot_vector<NT>& knots_u() const { return m_u; } //!< returns the knots along \f$ u \f$.
  const Knot_vector<NT>& knots_v() const { return m_v; } //!< returns the knots along \f$ v \f$.
  int degree_u() const { return m_u.degree(); }          //!< returns the degree along \f$ u \f$.
  int degree_v() const { return m_v.degree(); }          //!< returns the degree along \f$ v \f$.

  //! tells whether the surface has weights.
  bool is_rational() const { return m_points.is_rational(); }

  //! returns a control point, unweighted.
  Point control_point(int i, int j) const { return m_points.point(i * columns() + j); }

  //! returns a weight; 1 if the surface has none.
  NT weight(int i, int j) const { return m_points.weight(i * columns() + j); }

  //! returns the parameter domain, as the intervals of \f$ u \f$ and \f$ v \f$.
  std::array<Parameters, 2> domain() const { return {m_u.domain(), m_v.domain()}; }

  /*!
   * \brief computes the second-order data at the parameters `uv`, at a knot from the given sides.
   *
   * Refused are parameters outside the domain (`OUTSIDE_DOMAIN`), irregular places
   * (`IRREGULAR_PARAMETRISATION`), zeros of the common weight (`POLE`), and what the number type
   * cannot decide (`UNDECIDED`).
   */
  Result<Shape> operator()(const Parameters& uv, Side side_u = Side::RIGHT,
                           Side side_v = Side::RIGHT) const
  {
    return answer<Shape>(uv, side_u, side_v, [](const auto& t) { return internal::shape(t); });
  }

  //! computes the same data moved so that the point is the origin, without dividing by the weight:
  //! the form for filters.
  Result<Shape> shape_at_origin(const Parameters& uv, Side side_u = Side::RIGHT,
                                Side side_v = Side::RIGHT) const
  {
    return answer<Shape>(uv, side_u, side_v,
                         [](const auto& t) { return internal::shape_at_origin(t); });
  }

  /*!
   * \brief computes the second-order data from all sides: one, two or four answers, of which two or
   * four come where `uv` lies on knots with fewer than two continuous derivatives across.
   */
  Result<std::vector<One_sided_shape_3<NT>>> one_sided_shapes(const Parameters& uv) const
  {
    const auto spans_u = m_u.spans_at(uv[0], "u");
    const auto spans_v = m_v.spans_at(uv[1], "v");
    if (!spans_u || !spans_v)
      return !spans_u ? spans_u.refusal() : spans_v.refusal();
    std::vector<One_sided_shape_3<NT>> shapes;
    for (const auto& u : *spans_u)
      for (const auto& v : *spans_v)
        shapes.push_back({u.side, v.side, on_spans<Shape>(uv, u.index, v.index, [](const auto& t) {
                            return internal::shape(t);
                          })});
    return shapes;
  }

  //! computes the point and the partial derivatives to order two, at a knot from the given sides.
  Result<Surface_derivatives_3<NT>> derivatives(const Parameters& uv, Side side_u = Side::RIGHT,
                                                Side side_v = Side::RIGHT) const
  {
    return answer<Surface_derivatives_3<NT>>(
      uv, side_u, side_v, [](const auto& t) { return internal::derivatives_or_pole(t); });
  }

  //! computes the point, at a knot from the given sides.
  Result<Point> point(const Parameters& uv, Side side_u = Side::RIGHT,
                      Side side_v = Side::RIGHT) const
  {
    return answer<Point>(uv, side_u, side_v,
                         [](const auto& t) { return internal::point_or_pole(t); });
  }

  /*!
   * \brief returns the Bezier patches of the surface, one for each pair of knot spans, in the order
   * of \f$ u \f$, then \f$ v \f$: exactly, if `NT` is exact.
   *
   * Rational patches are made from homogeneous control points, so that weights may be zero.
   */
  std::vector<Surface_piece_3<NT>> bezier_patches() const
  {
    std::vector<Surface_piece_3<NT>> pieces;
    for (int u : m_u.spans())
      for (int v : m_v.spans())
        pieces.push_back({is_rational() ? bezier_patch<4>(u, v) : bezier_patch<3>(u, v),
                          {m_u.knots()[u], m_u.knots()[u + 1]},
                          {m_v.knots()[v], m_v.knots()[v + 1]}});
    return pieces;
  }

  //! returns the surface in another number type; the numbers given at construction are converted.
  template <class To>
  Nurbs_surface_3<To> cast() const
  {
    return Nurbs_surface_3<To>(m_u.template cast<To>(), m_v.template cast<To>(),
                               m_points.template cast<To>());
  }

private:
  template <class> friend class Nurbs_surface_3;

  Nurbs_surface_3(Knot_vector<NT> knots_u, Knot_vector<NT> knots_v, Control_points points)
    : m_u(std::move(knots_u)), m_v(std::move(knots_v)), m_points(std::move(points))
  {}

  int rows() const { return m_u.number_of_control_points(); }
  int columns() const { return m_v.number_of_control_points(); }

  // The first of the control points that the pair of spans uses.
  template <int Dim>
  const NT* net(int span_u, int span_v) const
  {
    return m_points.numbers() + Dim * ((span_u - degree_u()) * columns() + span_v - degree_v());
  }

  // Evaluates in the spans on the given sides and lets `ask` make the answer of it.
  template <class T, class Ask>
  Result<T> answer(const Parameters& uv, Side side_u, Side side_v, Ask ask) const
  {
    const Result<int> u = m_u.span(uv[0], side_u, "u");
    if (!u)
      return u.refusal();
    const Result<int> v = m_v.span(uv[1], side_v, "v");
    if (!v)
      return v.refusal();
    return on_spans<T>(uv, *u, *v, ask);
  }

  template <class T, class Ask>
  Result<T> on_spans(const Parameters& uv, int span_u, int span_v, Ask ask) const
  {
    return internal::refuse_errors<T>([&]() -> Result<T> {
      if (is_rational())
        return ask(internal::as_numbers(evaluate<4>(uv, span_u, span_v)));
      return ask(internal::as_numbers(evaluate<3>(uv, span_u, span_v)));
    });
  }

  template <int Dim>
  [[gnu::noinline]] auto evaluate(const Parameters& uv, int span_u, int span_v) const
  {
    return internal::with_degrees<NT>(degree_u(), degree_v(), [&](auto degree) {
      return internal::tensor_derivatives<Dim>(
        net<Dim>(span_u, span_v), Dim * columns(),
        internal::with_bounds(internal::spline_basis<degree.value>(m_u, span_u, uv[0])),
        internal::with_bounds(internal::spline_basis<degree.value>(m_v, span_v, uv[1])));
    });
  }

  template <int Dim>
  Bezier_surface_3<NT> bezier_patch(int span_u, int span_v) const
  {
    const auto to_bezier_u = internal::bezier_matrix(m_u, span_u);
    const auto to_bezier_v = internal::bezier_matrix(m_v, span_v);
    const NT* first = net<Dim>(span_u, span_v);
    std::vector<Coordinates<NT, Dim>> points;
    for (const std::vector<NT>& a : to_bezier_u)
      for (const std::vector<NT>& b : to_bezier_v)
      {
        Coordinates<NT, Dim> x;
        x.fill(NT(0));
        for (std::size_t i = 0; i < a.size(); ++i)
          for (std::size_t j = 0; j < b.size(); ++j)
            internal::add_multiple(x, NT(a[i] * b[j]), first + Dim * (i * columns() + j));
        points.push_back(x);
      }
    if constexpr (Dim == 4)
      return Bezier_surface_3<NT>::from_homogeneous(degree_u(), degree_v(), points);
    else
      return Bezier_surface_3<NT>(degree_u(), degree_v(), std::move(points));
  }

  Knot_vector<NT> m_u, m_v;
  Control_points m_points;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_NURBS_SURFACE_3_H
