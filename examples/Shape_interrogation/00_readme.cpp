// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The example of README.md, which repeats this file from the next line on.
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>
#include <iostream>

int main()
{
  using Point = CGAL::Epick::Point_3;
  const CGAL::Shape_interrogation::Implicit_surface_3 torus([](auto x, auto y, auto z) {
    return square(x * x + y * y + z * z + 3) - 16 * (x * x + y * y);
  });
  const CGAL::Shape_interrogation::Interrogation_3 ask(torus);
  for (const Point& p : {Point(3, 0, 0), Point(2, 0, 1), Point(1, 0, 0)}) // outside, top, inside
    std::cout << "K = " << gaussian_curvature(*ask.shape(p)) << ", its certified sign "
              << *ask.sign_of_gaussian_curvature(p) << '\n';
}
