// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BOUND_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BOUND_H

// The part of the solutions of a system that is meant: bounds of single variables.

#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/assertions.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a closed range of a variable of an `N_space_system`, such as
 * \f$ 0 \le \lambda \le 1 \f$.
 *
 * Bounds cut the surface that is meant out of the solutions: the segments of a ruled surface out of
 * its lines, a patch out of a polynomial surface. The numbers are exact, so that it is decided on
 * which side of them a point is. Several bounds hold together.
 */
struct N_space_bound
{
  int variable;               //!< the index of the variable
  CGAL::Exact_rational lower; //!< its least value
  CGAL::Exact_rational upper; //!< its greatest value, not less than `lower`
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief refuses a point that certainly is outside of the bounds (`OUTSIDE_DOMAIN`), and names the
 * variable.
 *
 * \details Points on a bound are inside. The decision is exact in exact types; an enclosure is
 * refused if no value in it is inside; in floating point the ends of the range are rounded.
 *
 * \tparam NT a number type
 * \param point the values of the variables
 * \param bounds the ranges
 * \param variables the names of the variables
 * \return nothing if the point may be inside
 * \pre the variables of the bounds are indices of coordinates of the point
 */
template <class NT>
std::optional<Refusal> refuse_outside_bounds(const std::vector<NT>& point,
                                             const std::vector<N_space_bound>& bounds,
                                             const std::vector<std::string>& variables)
{
  for (const N_space_bound& bound : bounds)
  {
    CGAL_precondition_msg(0 <= bound.variable && bound.variable < int(point.size()),
                          "the variables of bounds are coordinates of the point");
    const NT& x = point[bound.variable];
    const NT lower = number_cast<NT>(bound.lower), upper = number_cast<NT>(bound.upper);
    if (CGAL::certainly(sign_decision(NT(x - lower)) == CGAL::NEGATIVE) ||
        CGAL::certainly(sign_decision(NT(upper - x)) == CGAL::NEGATIVE))
      return Refusal(Refusal_code::OUTSIDE_DOMAIN,
                     variables[bound.variable] + " = " + internal::text_of(x) +
                       " is outside of the bounds [" + internal::text_of(bound.lower) + ", " +
                       internal::text_of(bound.upper) + "]");
  }
  return std::nullopt;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BOUND_H
