// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_PROGRESS_H
#define CGAL_SHAPE_INTERROGATION_WAIST_PROGRESS_H

// Progress of long computations, and how a caller stops them.

#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is the progress callback that ignores progress and never stops a computation.
 *
 * A progress callback is called often with the number of steps done and of all steps; the latter is
 * 0 as long as it is not known. When it returns `false` the computation stops with the refusal
 * `CANCELLED`.
 */
struct No_progress
{
  //! goes on.
  bool operator()(std::size_t /*done*/, std::size_t /*total*/) const { return true; }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_PROGRESS_H
