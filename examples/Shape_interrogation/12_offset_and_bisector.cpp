// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The offset of an ellipsoid, a surface of degree 8 that is hardly ever written down, against the
// formulas for offsets; and the bisector of a point and a plane, which is a paraboloid.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Constraints/equal_distance.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <cstdlib>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

int main()
{
  const auto f = [](auto x, auto y, auto z) { return x * x / 4 + y * y + z * z - 1; };
  const NT d = NT(1) / 2;
  const Constraint_system system = offset_system(Implicit_entity_3(f, "the ellipsoid"), d);
  const N_space_surface_3 offset(system.n_space_system());

  // The point p of the ellipsoid has the unit normal (3, 12, 4) / 13; q = p + d n comes before it.
  const Coordinates<NT, 3> p{NT(6) / 7, NT(6) / 7, NT(2) / 7};
  std::vector<NT> point{p[0] + d * 3 / 13, p[1] + d * 12 / 13, p[2] + d * 4 / 13,
                        p[0], p[1], p[2]};
  const auto base = Implicit_surface_3(f)(p);
  const auto shape = offset(point);
  if (!base || !shape)
    return EXIT_FAILURE;
  const NT k = gaussian_curvature(*base), h2 = squared_mean_curvature(*base);
  const NT h = NT(1526) / 2197; // the root of h2
  const NT expected = k / (1 + 2 * d * h + d * d * k);
  const NT found = gaussian_curvature(*shape);
  std::cout << "K = " << k << " on the ellipsoid, " << found << " on its offset\n";

  // A bound leaves out what is not meant, here what is beyond x = 6/7.
  const std::vector<N_space_bound> bounds{{system.find_variable("x"), 0, NT(6) / 7}};
  const auto outside = refuse_outside_bounds(point, bounds, system.variables());
  if (outside)
    std::cout << outside->evidence() << '\n';

  const Constraint_system bisector = equal_distance(
    Constraint_point_3{"the focus", {0, 0, 1}},
    Implicit_entity_3([](auto, auto, auto z) { return z + 1; }, "the plane"));
  for (const Constraint& constraint : bisector.constraints())
    std::cout << constraint.statement() << '\n';
  const NT z = NT(1) / 2; // of z = (x^2 + y^2) / 4 at (1, 1)
  const auto paraboloid = N_space_surface_3(bisector.n_space_system())(
    std::vector<NT>{1, 1, z, 1, 1, -1});
  const bool right = paraboloid && gaussian_curvature(*paraboloid) == NT(1) / 9 &&
                     h * h == h2 && found == expected && outside;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
