// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_SURFACE_DERIVATIVES_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_SURFACE_DERIVATIVES_3_H

// From the partial derivatives of a parametrisation to the waist:
// N = S_u x S_v, B = -W+^T [[L, M], [M, N]] W+ (MATH: parametric).

#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief holds the point of a parametrised surface and its partial derivatives to order two.
 */
template <class NT>
struct Surface_derivatives_3
{
  Coordinates<NT, 3> s;  //!< the point
  Coordinates<NT, 3> u;  //!< \f$ S_u \f$
  Coordinates<NT, 3> v;  //!< \f$ S_v \f$
  Coordinates<NT, 3> uu; //!< \f$ S_{uu} \f$
  Coordinates<NT, 3> uv; //!< \f$ S_{uv} \f$
  Coordinates<NT, 3> vv; //!< \f$ S_{vv} \f$
};

namespace internal {

template <class NT>
Result<Local_shape_3<NT>> shape_from_derivatives(const Surface_derivatives_3<NT>& d)
{
  const Coordinates<NT, 3> n = cross(d.u, d.v);
  Result<Local_shape_3<NT>> s(std::in_place, [&] {
    return Local_shape_3<NT>::from_frame(d.s, d.u, d.v, -dot(n, d.uu), -dot(n, d.uv),
                                         -dot(n, d.vv));
  });
  if (auto refusal = refuse_zero(s->normal_squared_length(),
                                 Refusal_code::IRREGULAR_PARAMETRISATION,
                                 "the squared length of S_u x S_v"))
    return *refusal;
  return s;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_SURFACE_DERIVATIVES_3_H
