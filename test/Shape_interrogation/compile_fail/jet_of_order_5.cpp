// expect: jets have order 1 to 4
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Jets are written out for the orders that a question needs, and 5 is none of them.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>

#ifdef CONTROL
constexpr int order = 4;
#else
constexpr int order = 5;
#endif

int number_of_coefficients()
{
  return CGAL::Shape_interrogation::Jet<double, 2, order>::size;
}
