// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_PARAMETRIC_CURVE_2_H
#define CGAL_SHAPE_INTERROGATION_CURVES_PARAMETRIC_CURVE_2_H

// Parametrised plane curves c(t), oriented by the normal (-c_2', c_1'): q b = det(c'', c').

#include <CGAL/Shape_interrogation/Curves/Curve_derivatives_2.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/call_over_jets.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief is a plane curve given by a map of one parameter, oriented by the normal
 * \f$ (-c_2', c_1') \f$ , the tangent turned to the left.
 *
 * A circle that is traversed counterclockwise has its normal inside and negative curvature. The
 * object is independent of the number type: each call asks for the one it wants. Const calls are
 * thread-safe if those of the map are.
 *
 * \tparam Map callable with a number of any type, returning an array of two
 *
 * Source: Hartmann, section 3.1.
 */
template <class Map>
class Parametric_curve_2
{
public:
  //! the type of a query: the parameter
  template <class NT>
  using Query = NT;

  //! constructs the curve.
  explicit Parametric_curve_2(Map map = Map()) : m_map(std::move(map)) {}

  //! returns the map.
  const Map& map() const { return m_map; }

  /*!
   * \brief computes the second-order data at the parameter `t`.
   *
   * Refused are places where the first derivative vanishes (`IRREGULAR_PARAMETRISATION`), where the
   * map divides by zero (`POLE`), and values that the number type has not got.
   */
  template <class NT>
  Result<Local_shape_2<NT>> operator()(const NT& t) const
  {
    return internal::refuse_errors<Local_shape_2<NT>>(
      [&] { return internal::shape_from_derivatives(derivatives(t)); });
  }

  //! returns the point and the derivatives to order two.
  //! \exception Shape_error where the map has none in the number type: what the call operator turns
  //! into a refusal is thrown here
  template <class NT>
  Curve_derivatives_2<NT> derivatives(const NT& t) const
  {
    const auto x = jet<2>(t);
    Curve_derivatives_2<NT> d;
    for (int i = 0; i < 2; ++i)
    {
      d.c[i] = x[i].value();
      d.t[i] = x[i].derivative(0);
      d.tt[i] = x[i].derivative(0, 0);
    }
    return d;
  }

  //! returns the Taylor polynomials of the two coordinates at `t` to the given order.
  //! \exception Shape_error as `derivatives()`
  template <int Order, class NT>
  std::array<Jet<NT, 1, Order>, 2> jet(const NT& t) const
  {
    return internal::call_over_jets<Order>(m_map, std::array<NT, 1>{t});
  }

private:
  Map m_map;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_PARAMETRIC_CURVE_2_H
