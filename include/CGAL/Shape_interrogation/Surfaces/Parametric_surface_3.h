// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_PARAMETRIC_SURFACE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_PARAMETRIC_SURFACE_3_H

// Parametrised surfaces S(u, v), oriented by S_u x S_v.

#include <CGAL/Shape_interrogation/Differentiation/internal/call_over_jets.h>
#include <CGAL/Shape_interrogation/Surfaces/Surface_derivatives_3.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a surface given by a map of two parameters, oriented by \f$ S_u \times S_v \f$.
 *
 * The object is independent of the number type: each call asks for the one it wants. Const calls
 * are thread-safe if those of the map are.
 *
 * \tparam Map must be a model of `ParametricMap_3`: callable with two numbers of any type,
 * returning an array of three
 *
 * Source: the root-free form of Elber and Cohen, section 3, in Hartmann's sign.
 * \cgalModels{ShapeSource_3}
 */
template <class Map>
class Parametric_surface_3
{
public:
  //! the type of a query: the two parameters
  template <class NT>
  using Query = Coordinates<NT, 2>;

  //! constructs the surface.
  explicit Parametric_surface_3(Map map = Map()) : m_map(std::move(map)) {}

  //! returns the map.
  const Map& map() const { return m_map; }

  /*!
   * \brief computes the second-order data at the parameters `uv`.
   *
   * Refused are places where the partial derivatives are linearly dependent
   * (`IRREGULAR_PARAMETRISATION`), where the map divides by zero (`POLE`), and values that the
   * number type has not got.
   */
  template <class NT>
  Result<Local_shape_3<NT>> operator()(const Coordinates<NT, 2>& uv) const
  {
    return internal::refuse_errors<Local_shape_3<NT>>(
      [&] { return internal::shape_from_derivatives(derivatives(uv)); });
  }

  //! returns the point and the partial derivatives to order two.
  //! \exception Shape_error where the map has none in the number type: what the call operator turns
  //! into a refusal is thrown here
  template <class NT>
  Surface_derivatives_3<NT> derivatives(const Coordinates<NT, 2>& uv) const
  {
    const auto x = jet<2>(uv);
    Surface_derivatives_3<NT> d;
    for (int i = 0; i < 3; ++i)
    {
      d.s[i] = x[i].value();
      d.u[i] = x[i].derivative(0);
      d.v[i] = x[i].derivative(1);
      d.uu[i] = x[i].derivative(0, 0);
      d.uv[i] = x[i].derivative(0, 1);
      d.vv[i] = x[i].derivative(1, 1);
    }
    return d;
  }

  //! returns the Taylor polynomials of the three coordinates at `uv` to the given order.
  //! \exception Shape_error as `derivatives()`
  template <int Order, class NT>
  std::array<Jet<NT, 2, Order>, 3> jet(const Coordinates<NT, 2>& uv) const
  {
    return internal::call_over_jets<Order>(m_map, uv);
  }

private:
  Map m_map;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_PARAMETRIC_SURFACE_3_H
