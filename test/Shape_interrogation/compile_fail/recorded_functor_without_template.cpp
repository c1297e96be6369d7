// expect: the functor must be callable with N numbers of any number type
// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// What takes doubles only cannot be recorded.

#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>

struct Product
{
#ifdef CONTROL
  template <class NT>
  NT operator()(const NT& x, const NT& y) const { return x * y; }
#else
  double operator()(double x, double y) const { return x * y; }
#endif
};

auto recorded() { return CGAL::Shape_interrogation::record_expression<2>(Product()); }
