// expect: deleted
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A recorded expression has no value, so none is greater: it must not pass for a number.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>

using CGAL::Shape_interrogation::Expression;

#ifdef CONTROL
Expression of_two(const Expression& a, const Expression& b) { return a + b; }
#else
bool of_two(const Expression& a, const Expression& b) { return a < b; }
#endif
