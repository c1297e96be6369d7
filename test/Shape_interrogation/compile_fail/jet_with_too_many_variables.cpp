// expect: the jet has more than 64 coefficients
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The mask of a jet has 64 bits.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>

#ifdef CONTROL
constexpr int variables = 3;
#else
constexpr int variables = 4;
#endif

int number_of_coefficients()
{
  return CGAL::Shape_interrogation::Jet<double, variables, 4>::size;
}
