// expect: one number is needed for each variable
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A function of three variables is called with three numbers.

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>

using CGAL::Shape_interrogation::Expression_function;

double value(const Expression_function<3>& f)
{
#ifdef CONTROL
  return f(1.0, 2.0, 3.0);
#else
  return f(1.0, 2.0);
#endif
}
