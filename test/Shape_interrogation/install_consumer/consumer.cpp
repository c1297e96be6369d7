// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A user's program, built against the installed package: the curvature of a sphere, exactly.

#include <CGAL/Shape_interrogation.h>

#include <CGAL/Exact_rational.h>

#include <iostream>

struct Sphere
{
  template <class NT>
  NT operator()(NT x, NT y, NT z) const { return x * x + y * y + z * z - NT(9); }
};

int main()
{
  using NT = CGAL::Exact_rational;
  const CGAL::Shape_interrogation::Implicit_surface_3<Sphere> sphere;
  const auto shape = sphere(CGAL::Shape_interrogation::Coordinates<NT, 3>{1, 2, 2});
  if (!shape)
    return 1;
  const NT curvature = gaussian_curvature(*shape);
  std::cout << curvature << "\n";
}
