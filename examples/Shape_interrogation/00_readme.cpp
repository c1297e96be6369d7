// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The example of README.md. A test compares the two from the next line on.
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <iostream>

using NT = CGAL::Exact_rational;

int main()
{
  const CGAL::Shape_interrogation::Implicit_surface_3 torus([](auto x, auto y, auto z) {
    return square(x * x + y * y + z * z + 3) - 16 * (x * x + y * y);
  });
  const auto shape = torus(std::array<NT, 3>{NT(6) / 5, NT(8) / 5, NT(1)});
  std::cout << "K = " << gaussian_curvature(*shape) << ", parabolic: " << is_parabolic(*shape)
            << ", sign of H: " << sign_of_mean_curvature(*shape) << '\n';
}
