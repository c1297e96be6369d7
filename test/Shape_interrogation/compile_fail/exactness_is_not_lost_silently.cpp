// expect: could not convert
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// From exact to double leads a cast that says so, never an assignment.

#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <CGAL/Exact_rational.h>

template <class NT>
using Local_shape_3 = CGAL::Shape_interrogation::Local_shape_3<NT>;

Local_shape_3<double> rounded(const Local_shape_3<CGAL::Exact_rational>& shape)
{
#ifdef CONTROL
  return shape.cast<double>();
#else
  return shape;
#endif
}
