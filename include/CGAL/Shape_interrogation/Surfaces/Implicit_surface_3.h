// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_IMPLICIT_SURFACE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_IMPLICIT_SURFACE_3_H

// Implicit surfaces f = 0: N = grad f and B = P Hess(f) P (Hartmann, section 4.1; MATH: common
// core).

#include <CGAL/Shape_interrogation/Differentiation/internal/call_over_jets.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is the surface of zeros of a function of three variables, oriented by its gradient.
 *
 * The derivatives are taken by jets; nobody writes them by hand. The object is independent of the
 * number type: each call asks for the one it wants. Const calls are thread-safe if those of the
 * function are.
 *
 * \tparam Function must be a model of `ImplicitFunction_3`: callable with three numbers of any type
 *
 * Source: Hartmann, section 4.1, in the root-free form \f$ B = P H P \f$, which needs no case
 * distinction for vanishing components of the gradient.
 * \cgalModels{ShapeSource_3}
 */
template <class Function>
class Implicit_surface_3
{
public:
  //! the type of a query: a point of space
  template <class NT>
  using Query = Coordinates<NT, 3>;

  //! constructs the surface `function = 0`.
  explicit Implicit_surface_3(Function function = Function()) : m_function(std::move(function)) {}

  //! returns the function.
  const Function& function() const { return m_function; }

  /*!
   * \brief computes the second-order data at a point of the surface.
   *
   * Refused are points that are certainly off the surface (`NOT_ON_SURFACE`; `double` makes no such
   * claim), singular points (`SINGULAR_POINT`), and values that the number type has not got.
   */
  template <class NT>
  Result<Local_shape_3<NT>> operator()(const Coordinates<NT, 3>& p) const
  {
    return shape(p, true);
  }

  /*!
   * \brief computes the second-order data of the level set of the function through any point `p`.
   *
   * This is what a point that is only approximately on the surface gets. Refused are singular
   * points of the level set.
   */
  template <class NT>
  Result<Local_shape_3<NT>> level_set_shape(const Coordinates<NT, 3>& p) const
  {
    return shape(p, false);
  }

  //! returns the Taylor polynomial of the function at `p` to the given order.
  //! \exception Shape_error where the function has no value or derivative in the number type: what
  //! the call operator turns into a refusal is thrown here
  template <int Order, class NT>
  Jet<NT, 3, Order> jet(const Coordinates<NT, 3>& p) const
  {
    return internal::call_over_jets<Order>(m_function, p);
  }

private:
  template <class NT>
  Result<Local_shape_3<NT>> shape(const Coordinates<NT, 3>& p, bool on_surface) const
  {
    using Shape = Local_shape_3<NT>;
    return internal::refuse_errors<Shape>([&] {
      if constexpr (Number_type_traits<NT>::is_light)
        return flattened(p, on_surface);
      else
        return unguarded(p, on_surface);
    });
  }

  template <class NT>
  [[gnu::flatten]] Result<Local_shape_3<NT>> flattened(const Coordinates<NT, 3>& p,
                                                       bool on_surface) const
  {
    return unguarded(p, on_surface);
  }

  template <class NT>
  Result<Local_shape_3<NT>> unguarded(const Coordinates<NT, 3>& p, bool on_surface) const
  {
    const Jet<NT, 3, 2> f = jet<2>(p);
    if (on_surface)
      if (auto refusal = internal::refuse_nonzero(f.value(), Refusal_code::NOT_ON_SURFACE,
                                                  "the function value at the point"))
        return *refusal;
    const Coordinates<NT, 3> n{f.derivative(0), f.derivative(1), f.derivative(2)};
    const Symmetric_matrix_3<NT> h(f.derivative(0, 0), f.derivative(0, 1), f.derivative(0, 2),
                                   f.derivative(1, 1), f.derivative(1, 2), f.derivative(2, 2));
    Result<Local_shape_3<NT>> s(std::in_place,
                                [&] { return Local_shape_3<NT>::from_form(p, n, h); });
    if (auto refusal = internal::refuse_zero(s->normal_squared_length(),
                                             Refusal_code::SINGULAR_POINT,
                                             "the squared length of the gradient"))
      return *refusal;
    return s;
  }

  Function m_function;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_IMPLICIT_SURFACE_3_H
