// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_HEIGHT_JET_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_HEIGHT_JET_H

// Higher jets on request: a surface as the graph of a height function over its tangent plane, to
// order 3 or 4. Power series Newton iteration over jets, so exact in exact types.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a surface near one of its points as the graph of a height function:
 * \f$ p + s\,t_1 + t\,t_2 + h(s,t)\,N \f$ , where \f$ h \f$ is a Taylor polynomial without constant
 * and linear terms.
 *
 * The frame \f$ (t_1, t_2, N) \f$ is orthogonal and right-handed, but not normalised, so that
 * everything stays rational: \f$ s, t, h \f$ are in units of the lengths of the three vectors.
 * \tparam NT a field number type
 * \tparam Order the order, 2 to 4
 */
template <class NT, int Order>
struct Height_jet_3
{
  Coordinates<NT, 3> point;    //!< \f$ p \f$
  Coordinates<NT, 3> tangent1; //!< \f$ t_1 \f$
  Coordinates<NT, 3> tangent2; //!< \f$ t_2 = N \times t_1 \f$
  Coordinates<NT, 3> normal;   //!< \f$ N \f$
  Jet<NT, 2, Order> height;    //!< \f$ h \f$
};

namespace internal {

// A tangent vector: the normal times the axis of a component that is certainly not the only one.
template <class NT>
Coordinates<NT, 3> any_tangent(const Coordinates<NT, 3>& n)
{
  const NT zero(0);
  if constexpr (std::is_floating_point_v<NT>)
    if (std::fabs(n[0]) < std::fabs(n[2]) && std::fabs(n[1]) < std::fabs(n[2]))
      return {n[2], zero, NT(-n[0])}; // tiny components are not squared
  if (!CGAL::possibly(is_zero_decision(n[0])) || !CGAL::possibly(is_zero_decision(n[1])))
    return {NT(-n[1]), n[0], zero};
  return {n[2], zero, NT(-n[0])};
}

template <class NT, int Order>
Height_jet_3<NT, Order> height_frame(const Local_shape_3<NT>& s)
{
  Height_jet_3<NT, Order> h;
  h.point = s.point();
  h.normal = s.normal();
  h.tangent1 = any_tangent(s.normal());
  h.tangent2 = cross(h.normal, h.tangent1);
  return h;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief computes the height function of an implicit surface at one of its points.
 *
 * Refused are the points that the surface refuses.
 */
template <int Order, class Function, class NT>
Result<Height_jet_3<NT, Order>> height_jet(const Implicit_surface_3<Function>& surface,
                                           const Coordinates<NT, 3>& p)
{
  using J = Jet<NT, 2, Order>;
  using Height = Height_jet_3<NT, Order>;
  const Result<Local_shape_3<NT>> shape = surface(p);
  if (!shape)
    return shape.refusal();
  return internal::refuse_errors<Height>([&]() -> Result<Height> {
    Height r = internal::height_frame<NT, Order>(*shape);
    const NT& slope = shape->normal_squared_length(); // derivative of f along N
    r.height = J(NT(0));
    for (int k = 2; k <= Order; ++k)
    {
      std::array<J, 3> x;
      for (int i = 0; i < 3; ++i)
        x[i] = J::along(p[i], {r.tangent1[i], r.tangent2[i]}) + r.height * r.normal[i];
      // Each step makes one more order right. Terms below order 2 are zero on the surface.
      const J residual = surface.function()(x[0], x[1], x[2]).without_affine_part();
      r.height = r.height - residual / slope;
    }
    return r;
  });
}

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief computes the height function of a parametrised surface at regular parameters.
 *
 * Refused are the parameters that the surface refuses.
 */
template <int Order, class Map, class NT>
Result<Height_jet_3<NT, Order>> height_jet(const Parametric_surface_3<Map>& surface,
                                           const Coordinates<NT, 2>& uv)
{
  using J = Jet<NT, 2, Order>;
  using Height = Height_jet_3<NT, Order>;
  const Result<Local_shape_3<NT>> shape = surface(uv);
  if (!shape)
    return shape.refusal();
  return internal::refuse_errors<Height>([&]() -> Result<Height> {
    Height r = internal::height_frame<NT, Order>(*shape);
    const Surface_derivatives_3<NT> d = surface.derivatives(uv);
    const NT l1 = internal::dot(r.tangent1, r.tangent1);
    const NT l2 = internal::dot(r.tangent2, r.tangent2);
    // The matrix from (du, dv) to (s, t), and its inverse.
    const NT a = internal::dot(d.u, r.tangent1) / l1, b = internal::dot(d.v, r.tangent1) / l1;
    const NT c = internal::dot(d.u, r.tangent2) / l2, e = internal::dot(d.v, r.tangent2) / l2;
    const NT determinant = a * e - b * c;
    J u(uv[0]), v(uv[1]);
    std::array<J, 3> x;
    for (int k = 0; k <= Order; ++k)
    {
      x = surface.map()(u, v);
      J ds = J::variable(0, NT(0)), dt = J::variable(1, NT(0));
      for (int i = 0; i < 3; ++i)
      {
        const J offset = x[i] - r.point[i];
        ds -= offset * NT(r.tangent1[i] / l1);
        dt -= offset * NT(r.tangent2[i] / l2);
      }
      u += (ds * e - dt * b) / determinant;
      v += (dt * a - ds * c) / determinant;
    }
    r.height = J(NT(0));
    for (int i = 0; i < 3; ++i)
      r.height += (x[i] - r.point[i]) * NT(r.normal[i] / shape->normal_squared_length());
    r.height = r.height.without_affine_part();
    return r;
  });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_HEIGHT_JET_H
