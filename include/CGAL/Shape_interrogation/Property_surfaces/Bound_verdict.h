// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_BOUND_VERDICT_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_BOUND_VERDICT_H

// The answer to "at most" and "at least" about a property of a whole surface.

#include <CGAL/Shape_interrogation/Bernstein/Certified_extreme.h>
#include <CGAL/Shape_interrogation/Bernstein/decide_nonnegative.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <optional>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief holds what was found out about a bound of a property on a whole patch or surface.
 */
template <class NT>
struct Bound_verdict
{
  Verdict verdict = Verdict::UNDECIDED;     //!< whether the bound holds
  Certified_extreme<NT, 2> extreme;         //!< the supremum for "at most", else the infimum
  std::optional<Coordinates<NT, 2>> at;     //!< a witness for `NO`, else the place of the extreme
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_BOUND_VERDICT_H
