// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_BEZIER_CURVE_2_H
#define CGAL_SHAPE_INTERROGATION_CURVES_BEZIER_CURVE_2_H

// Bezier curves in the plane, polynomial or rational, with exact second-order data in any ring.

#include <CGAL/Shape_interrogation/Curves/Curve_derivatives_2.h>
#include <CGAL/Shape_interrogation/Curves/internal/refuse_outside.h>

#include <CGAL/assertions.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief is a plane Bezier curve on the unit interval, oriented by the normal
 * \f$ (-c_2', c_1') \f$.
 *
 * The weights, if any, may have any sign; where their common function vanishes, everything is
 * refused (`POLE`). Decisions about the shape are free of division. Const calls are thread-safe,
 * except for `CORE::Expr`.
 *
 * \tparam NT a ring number type; the points of a rational curve need a field
 *
 * Complexity: \f$ O(n^2) \f$ operations in `NT` for the degree n.
 */
template <class NT>
class Bezier_curve_2
{
  using Control_points = internal::Control_points<NT, 2>;

public:
  using FT = NT;                                //!< the number type
  using Point = Coordinates<NT, 2>;             //!< a point or a vector
  using Homogeneous_point = Coordinates<NT, 3>; //!< \f$ (w x, w y, w) \f$
  using Shape = Local_shape_2<NT>;              //!< the second-order data
  //! the type of a query: the parameter
  template <class Number>
  using Query = Number;

  //! constructs the curve with the given control points, which are unweighted, and weights, if
  //! any. \pre there are at least two points, and as many weights or none
  explicit Bezier_curve_2(std::vector<Point> points, const std::vector<NT>& weights = {})
    : m_points(std::move(points), weights)
  {
    check();
  }

  //! returns the rational curve with the homogeneous control points \f$ (w x, w y, w) \f$, of which
  //! some may have the weight 0. \pre there are at least two points
  static Bezier_curve_2 from_homogeneous(const std::vector<Homogeneous_point>& points)
  {
    return Bezier_curve_2(Control_points(points));
  }

  int degree() const { return m_points.size() - 1; }             //!< returns the degree.
  bool is_rational() const { return m_points.is_rational(); }    //!< tells if it has weights.
  Point control_point(int i) const { return m_points.point(i); } //!< returns a control point.
  NT weight(int i) const { return m_points.weight(i); }          //!< returns a weight, or 1.
  std::array<NT, 2> domain() const { return {NT(0), NT(1)}; }    //!< returns the interval.

  //! returns \f$ (w x, w y, w) \f$ of a control point.
  Homogeneous_point homogeneous_control_point(int i) const { return m_points.homogeneous_point(i); }

  /*!
   * \brief computes the second-order data at the parameter `t`.
   *
   * Refused are parameters outside the unit interval (`OUTSIDE_DOMAIN`), places where the
   * derivative vanishes (`IRREGULAR_PARAMETRISATION`), and zeros of the common weight (`POLE`).
   */
  Result<Shape> operator()(const NT& t) const
  {
    if (auto refusal = refuse_outside(t))
      return *refusal;
    return extended_shape(t);
  }

  //! computes the second-order data at any parameter, on the polynomial or rational extension.
  Result<Shape> extended_shape(const NT& t) const
  {
    return answer<Shape>(t, [](const auto& r) { return internal::shape(r); });
  }

  //! computes the point and the derivatives to order two.
  Result<Curve_derivatives_2<NT>> derivatives(const NT& t) const
  {
    if (auto refusal = refuse_outside(t))
      return *refusal;
    return answer<Curve_derivatives_2<NT>>(
      t, [](const auto& r) { return internal::derivatives_or_pole(r); });
  }

  //! computes the point.
  Result<Point> point(const NT& t) const
  {
    if (auto refusal = refuse_outside(t))
      return *refusal;
    return answer<Point>(t, [](const auto& r) { return internal::point_or_pole(r); });
  }

  //! returns the curve \f$ c(1 - t) \f$, which has the opposite normal.
  Bezier_curve_2 reversed() const
  {
    return Bezier_curve_2(m_points.reordered([this](int k) { return degree() - k; }));
  }

  //! returns the curve in another number type; the numbers given at construction are converted.
  template <class To>
  Bezier_curve_2<To> cast() const
  {
    return Bezier_curve_2<To>(m_points.template cast<To>());
  }

private:
  template <class> friend class Bezier_curve_2;

  explicit Bezier_curve_2(Control_points points) : m_points(std::move(points)) { check(); }

  void check() const
  {
    CGAL_precondition_msg(m_points.size() >= 2, "a Bezier curve has at least two control points");
  }

  static std::optional<Refusal> refuse_outside(const NT& t)
  {
    return internal::refuse_outside("t", t, NT(0), NT(1));
  }

  // Evaluates with or without weights and lets `ask` make the answer of it.
  template <class T, class Ask>
  Result<T> answer(const NT& t, Ask ask) const
  {
    return internal::refuse_errors<T>([&]() -> Result<T> {
      if (is_rational())
        return ask(evaluate<3>(t));
      return ask(evaluate<2>(t));
    });
  }

  template <int Dim>
  internal::Row_derivatives<NT, Dim> evaluate(const NT& t) const
  {
    return internal::with_degrees<NT>(degree(), degree(), [&](auto d) {
      return internal::row_derivatives<Dim>(m_points.numbers(),
                                            internal::bernstein_basis<d.value>(degree(), t));
    });
  }

  Control_points m_points;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_BEZIER_CURVE_2_H
