// expect: the filtered traits need a kernel over double
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A filter starts from doubles: what has been rounded before it is lost.

#include <CGAL/Shape_interrogation/Traits/Shape_traits_3.h>

using namespace CGAL::Shape_interrogation;

#ifdef CONTROL
using Kernel = CGAL::Simple_cartesian<double>;
#else
using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
#endif

Filtered_shape_traits_3<Kernel>::FT value() { return 1; }
