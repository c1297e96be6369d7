// expect: principal curvatures are compared in exact number types only
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// An exact comparison of nested roots is not to be had from doubles.

#include "exact_or_double.h"

#include <CGAL/Shape_interrogation/Analysis/compare_principal_curvatures.h>

using namespace CGAL::Shape_interrogation;

CGAL::Comparison_result compare(const Local_shape_3<NT>& s, const Local_shape_3<NT>& t)
{
  return compare_principal_curvatures(s, Principal::MIN, t, Principal::MAX);
}
