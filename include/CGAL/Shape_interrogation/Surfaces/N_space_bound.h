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

#include <CGAL/Exact_rational.h>

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

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BOUND_H
