// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SURFACE_3_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SURFACE_3_H

// The projection into space of a 2-manifold given by m equations in n variables
// (Chuang and Hoffmann). The evaluation at a point is in N_space_evaluator.h.

#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is the projection to the first three coordinates of the 2-manifold of solutions of
 * \f$ m \f$ equations in \f$ n \f$ variables.
 *
 * The equations may be redundant, \f$ m > n - 2 \f$, also with equations whose gradient vanishes at
 * a point. Nothing is eliminated symbolically, and no \f$ n \times n \f$ Hessian is formed: with a
 * tangent basis \f$ v_1, v_2 \f$ in n-space, three numbers of a second-order jet along
 * \f$ p + s v_1 + t v_2 \f$ suffice, at a cost linear in the length of the equations.
 *
 * The normal is oriented so that its first non-zero component is positive, or has a positive
 * product with the orientation of the system where that is given. Where an enclosure does not
 * decide that, `unoriented()` has the answers that do not depend on it.
 *
 * An enclosure answers for every point that it cannot prove not to be a solution; so does a filter.
 *
 * Const calls are thread-safe, each in numbers of its own. The object is independent of the number
 * type.
 *
 * Source: Chuang and Hoffmann, "Curvature computations on surfaces in n-space", Theorem 3 and
 * Corollary 5, in root-free form, with the additional hypotheses that they need: the rank of the
 * projected tangent plane, and the second-order test for redundant equations.
 * \cgalModels{ShapeSource_3}
 * \sa `N_space_evaluator`
 */
class N_space_surface_3
{
public:
  //! the type of a query: a point of n-space on the solution
  template <class NT>
  using Query = std::vector<NT>;

  //! constructs the surface of a system.
  explicit N_space_surface_3(N_space_system system) : m_system(std::move(system)) {}

  //! returns the system.
  const N_space_system& system() const { return m_system; }

  //! computes the second-order data of the projected surface at a point of the solution.
  //! See `N_space_evaluator` for what is refused.
  template <class NT>
  Result<Local_shape_3<NT>> operator()(const std::vector<NT>& point) const
  {
    // Memory is kept from call to call for the types that hold none of their own.
    if constexpr (std::is_trivially_destructible_v<NT>)
    {
      static thread_local N_space_evaluator<NT> evaluator;
      evaluator.set_system(m_system);
      return evaluator(point);
    }
    else
      return N_space_evaluator<NT>(m_system)(point);
  }

  //! computes the data with either normal, where an enclosure does not decide its side.
  template <class NT>
  Result<Unoriented_shape_3<NT>> unoriented(const std::vector<NT>& point) const
  {
    return N_space_evaluator<NT>(m_system).unoriented(point);
  }

  //! computes the oriented data together with rank, tangent basis and multipliers.
  template <class NT>
  Result<N_space_shape_3<NT>> shape(const std::vector<NT>& point) const
  {
    return N_space_evaluator<NT>(m_system).shape(point);
  }

private:
  N_space_system m_system;
};

namespace internal {

template <> struct Needs_field<N_space_surface_3> : std::true_type {};

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SURFACE_3_H
