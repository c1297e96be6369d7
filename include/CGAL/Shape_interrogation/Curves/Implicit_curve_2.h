// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_IMPLICIT_CURVE_2_H
#define CGAL_SHAPE_INTERROGATION_CURVES_IMPLICIT_CURVE_2_H

// Implicit plane curves f = 0, oriented by the gradient: q b is minus the bordered determinant
// (the form printed in Hartmann, section 3.1, has the opposite sign).

#include <CGAL/Shape_interrogation/Differentiation/internal/call_over_jets.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief is the plane curve of zeros of a function of two variables, oriented by its gradient.
 *
 * The derivatives are taken by jets. The object is independent of the number type: each call asks
 * for the one it wants. Const calls are thread-safe if those of the function are.
 *
 * \tparam Function callable with two numbers of any type
 *
 * Source: Hartmann, section 3.1, with the sign corrected.
 */
template <class Function>
class Implicit_curve_2
{
public:
  //! the type of a query: a point of the plane
  template <class NT>
  using Query = Coordinates<NT, 2>;

  //! constructs the curve `function = 0`.
  explicit Implicit_curve_2(Function function = Function()) : m_function(std::move(function)) {}

  //! returns the function.
  const Function& function() const { return m_function; }

  /*!
   * \brief computes the second-order data at a point of the curve.
   *
   * Refused are points that are certainly off the curve (`NOT_ON_SURFACE`; `double` makes no such
   * claim), singular points (`SINGULAR_POINT`), and values that the number type has not got.
   */
  template <class NT>
  Result<Local_shape_2<NT>> operator()(const Coordinates<NT, 2>& p) const
  {
    return shape(p, true);
  }

  //! computes the second-order data of the level curve of the function through any point `p`.
  template <class NT>
  Result<Local_shape_2<NT>> level_set_shape(const Coordinates<NT, 2>& p) const
  {
    return shape(p, false);
  }

  //! returns the Taylor polynomial of the function at `p` to the given order.
  //! \exception Shape_error where the function has no value or derivative in the number type: what
  //! the call operator turns into a refusal is thrown here
  template <int Order, class NT>
  Jet<NT, 2, Order> jet(const Coordinates<NT, 2>& p) const
  {
    return internal::call_over_jets<Order>(m_function, p);
  }

private:
  template <class NT>
  Result<Local_shape_2<NT>> shape(const Coordinates<NT, 2>& p, bool on_curve) const
  {
    using Shape = Local_shape_2<NT>;
    return internal::refuse_errors<Shape>([&]() -> Result<Shape> {
      const Jet<NT, 2, 2> f = jet<2>(p);
      if (on_curve)
        if (auto refusal = internal::refuse_nonzero(f.value(), Refusal_code::NOT_ON_SURFACE,
                                                    "the function value at the point"))
          return *refusal;
      const NT x = f.derivative(0), y = f.derivative(1);
      const NT mixed = x * y * f.derivative(0, 1);
      const NT numerator =
        y * y * f.derivative(0, 0) - mixed - mixed + x * x * f.derivative(1, 1);
      return Shape::make(p, {x, y}, numerator, Refusal_code::SINGULAR_POINT,
                         "the squared length of the gradient");
    });
  }

  Function m_function;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_IMPLICIT_CURVE_2_H
