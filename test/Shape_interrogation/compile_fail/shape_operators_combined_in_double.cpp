// expect: shape operators of hypersurfaces are combined in exact number types only
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The cross-check of systems solves for its multipliers by exact elimination.

#include "exact_or_double.h"

#include <CGAL/Shape_interrogation/Surfaces/N_space_cross_checks.h>

using namespace CGAL::Shape_interrogation;

bool has_curvature(const N_space_system& system, const std::vector<NT>& p)
{
  return bool(normal_curvature_by_shape_operators(system, p, p));
}
