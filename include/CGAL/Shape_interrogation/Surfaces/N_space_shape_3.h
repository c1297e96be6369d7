// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SHAPE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SHAPE_3_H

// What the evaluation of a system in n-space knows beside the waist.

#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is the second-order data at a point of a surface in n-space with its evidence.
 */
template <class NT>
struct N_space_shape_3
{
  Local_shape_3<NT> shape;            //!< the data of the projection
  int rank = 0;                       //!< the rank of the Jacobian (numerical in floating point)
  //! a basis of the tangent plane in n-space, the kernel of the Jacobian
  std::array<std::vector<NT>, 2> tangent_basis;
  //! numbers \f$ \alpha_k \f$ with \f$ \sum \alpha_k \nabla f_k = (N, 0, \ldots, 0) \f$, for the
  //! normal of `shape`
  std::vector<NT> multipliers;
  //! indices of the equations whose gradients are combinations of those of the others there. If
  //! there are any, the answer is conditional: they are assumed to vanish on the surface.
  std::vector<int> redundant_equations;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SHAPE_3_H
