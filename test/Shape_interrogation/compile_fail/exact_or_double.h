// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_EXACT_OR_DOUBLE_H
#define SHAPE_INTERROGATION_TEST_EXACT_OR_DOUBLE_H

// The number type of cases that compile with an exact type only.

#include <CGAL/Exact_rational.h>

#ifdef CONTROL
using NT = CGAL::Exact_rational;
#else
using NT = double;
#endif

#endif // SHAPE_INTERROGATION_TEST_EXACT_OR_DOUBLE_H
