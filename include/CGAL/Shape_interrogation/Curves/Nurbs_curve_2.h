// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_NURBS_CURVE_2_H
#define CGAL_SHAPE_INTERROGATION_CURVES_NURBS_CURVE_2_H

// B-spline curves in the plane, polynomial or rational: exact second-order data from either side of
// a knot, and exact extraction of the Bezier arcs.

#include <CGAL/Shape_interrogation/Curves/Bezier_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Curves/internal/spline_basis.h>

#include <CGAL/assertions.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief holds the second-order data of a plane curve from one side of a knot.
 */
template <class NT>
struct One_sided_shape_2
{
  Side side;                       //!< the side from which the data come
  Result<Local_shape_2<NT>> shape; //!< the data, or why there are none from there
};

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief holds a Bezier arc of a spline curve and the parameters that it covers.
 */
template <class NT>
struct Curve_piece_2
{
  Bezier_curve_2<NT> arc; //!< the arc, on the unit interval
  std::array<NT, 2> t;    //!< the interval of the parameter
};

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief is a plane B-spline curve with or without weights, oriented by the normal
 * \f$ (-c_2', c_1') \f$.
 *
 * At a knot where the curve has fewer than two continuous derivatives the data differ from side to
 * side: `operator()` answers from the right (from the left at the end of the domain),
 * `one_sided_shapes()` from both. Const calls are thread-safe, except for `CORE::Expr`.
 *
 * \tparam NT a field number type
 *
 * Complexity: \f$ O(p^2 + \log k) \f$ operations in `NT` for the degree p and k knots.
 */
template <class NT>
class Nurbs_curve_2
{
  using Control_points = internal::Control_points<NT, 2>;

public:
  using FT = NT;                    //!< the number type
  using Point = Coordinates<NT, 2>; //!< a point or a vector
  using Shape = Local_shape_2<NT>;  //!< the second-order data
  //! the type of a query: the parameter
  template <class Number>
  using Query = Number;

  //! constructs the curve with the given control points, which are unweighted, and weights, if
  //! any. \pre `why_invalid()` has nothing to tell
  Nurbs_curve_2(Knot_vector<NT> knots, std::vector<Point> points,
                const std::vector<NT>& weights = {})
    : m_knots(std::move(knots)), m_points(std::move(points), weights)
  {
    CGAL_precondition_msg(m_points.size() == m_knots.number_of_control_points(),
                          "a B-spline curve has as many control points as its knot vector has "
                          "knots, less the degree and one");
  }

  //! tells in one sentence why these data make no curve, or nothing if they do.
  static std::optional<std::string> why_invalid(const Knot_vector<NT>& knots,
                                                const std::vector<Point>& points,
                                                const std::vector<NT>& weights = {})
  {
    const std::size_t size = knots.number_of_control_points();
    if (points.size() != size)
      return "there are " + std::to_string(points.size()) + " control points, the knots need " +
             std::to_string(size);
    if (!weights.empty() && weights.size() != size)
      return "there are " + std::to_string(weights.size()) + " weights, the knots need " +
             std::to_string(size);
    return std::nullopt;
  }

  const Knot_vector<NT>& knots() const { return m_knots; }       //!< returns the knot vector.
  int degree() const { return m_knots.degree(); }                //!< returns the degree.
  bool is_rational() const { return m_points.is_rational(); }    //!< tells if it has weights.
  Point control_point(int i) const { return m_points.point(i); } //!< returns a control point.
  NT weight(int i) const { return m_points.weight(i); }          //!< returns a weight, or 1.
  std::array<NT, 2> domain() const { return m_knots.domain(); }  //!< returns the interval.

  /*!
   * \brief computes the second-order data at the parameter `t`, at a knot from the given side.
   *
   * Refused are parameters outside the domain (`OUTSIDE_DOMAIN`), places where the derivative
   * vanishes (`IRREGULAR_PARAMETRISATION`), zeros of the common weight (`POLE`), and what the
   * number type cannot decide (`UNDECIDED`).
   */
  Result<Shape> operator()(const NT& t, Side side = Side::RIGHT) const
  {
    return answer<Shape>(t, side, [](const auto& r) { return internal::shape(r); });
  }

  //! computes the data from both sides: two answers where `t` is a knot with fewer than two
  //! continuous derivatives, else one.
  Result<std::vector<One_sided_shape_2<NT>>> one_sided_shapes(const NT& t) const
  {
    const auto spans = m_knots.spans_at(t);
    if (!spans)
      return spans.refusal();
    std::vector<One_sided_shape_2<NT>> shapes;
    for (const auto& span : *spans)
      shapes.push_back({span.side, on_span<Shape>(t, span.index, [](const auto& r) {
                          return internal::shape(r);
                        })});
    return shapes;
  }

  //! computes the point and the derivatives to order two, at a knot from the given side.
  Result<Curve_derivatives_2<NT>> derivatives(const NT& t, Side side = Side::RIGHT) const
  {
    return answer<Curve_derivatives_2<NT>>(
      t, side, [](const auto& r) { return internal::derivatives_or_pole(r); });
  }

  //! computes the point, at a knot from the given side.
  Result<Point> point(const NT& t, Side side = Side::RIGHT) const
  {
    return answer<Point>(t, side, [](const auto& r) { return internal::point_or_pole(r); });
  }

  //! returns the Bezier arcs of the curve in order: exactly, if `NT` is exact.
  std::vector<Curve_piece_2<NT>> bezier_arcs() const
  {
    std::vector<Curve_piece_2<NT>> pieces;
    for (int k : m_knots.spans())
      pieces.push_back({is_rational() ? bezier_arc<3>(k) : bezier_arc<2>(k),
                        {m_knots.knots()[k], m_knots.knots()[k + 1]}});
    return pieces;
  }

  //! returns the curve in another number type; the numbers given at construction are converted.
  template <class To>
  Nurbs_curve_2<To> cast() const
  {
    return Nurbs_curve_2<To>(m_knots.template cast<To>(), m_points.template cast<To>());
  }

private:
  template <class> friend class Nurbs_curve_2;

  Nurbs_curve_2(Knot_vector<NT> knots, Control_points points)
    : m_knots(std::move(knots)), m_points(std::move(points))
  {}

  // The first of the control points that the span uses.
  template <int Dim>
  const NT* first_point(int span) const
  {
    return m_points.numbers() + Dim * (span - degree());
  }

  // Evaluates in the span on the given side and lets `ask` make the answer of it.
  template <class T, class Ask>
  Result<T> answer(const NT& t, Side side, Ask ask) const
  {
    const Result<int> span = m_knots.span(t, side);
    if (!span)
      return span.refusal();
    return on_span<T>(t, *span, ask);
  }

  template <class T, class Ask>
  Result<T> on_span(const NT& t, int span, Ask ask) const
  {
    return internal::refuse_errors<T>([&]() -> Result<T> {
      if (is_rational())
        return ask(evaluate<3>(t, span));
      return ask(evaluate<2>(t, span));
    });
  }

  template <int Dim>
  internal::Row_derivatives<NT, Dim> evaluate(const NT& t, int span) const
  {
    return internal::with_degrees<NT>(degree(), degree(), [&](auto d) {
      return internal::row_derivatives<Dim>(first_point<Dim>(span),
                                            internal::spline_basis<d.value>(m_knots, span, t));
    });
  }

  template <int Dim>
  Bezier_curve_2<NT> bezier_arc(int span) const
  {
    std::vector<Coordinates<NT, Dim>> points;
    for (const std::vector<NT>& row : internal::bezier_matrix(m_knots, span))
    {
      Coordinates<NT, Dim> x;
      x.fill(NT(0));
      for (std::size_t i = 0; i < row.size(); ++i)
        internal::add_multiple(x, row[i], first_point<Dim>(span) + Dim * i);
      points.push_back(x);
    }
    if constexpr (Dim == 3)
      return Bezier_curve_2<NT>::from_homogeneous(points);
    else
      return Bezier_curve_2<NT>(std::move(points));
  }

  Knot_vector<NT> m_knots;
  Control_points m_points;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_NURBS_CURVE_2_H
