// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Surfaces that are stated instead of written down: a ball of radius 1 rolls along a plane and a
// sphere, which makes a torus; and the paper's ruled surface, from a curve and two cylinders.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Constraints/rolling_ball.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Constraints/verify_identities.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <cstdlib>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

int main()
{
  const Implicit_entity_3 plane([](auto, auto, auto z) { return z; }, "the plane");
  const Implicit_entity_3 sphere(
    [](auto x, auto y, auto z) { return x * x + y * y + (z + 2) * (z + 2) - 16; }, "the sphere");
  const Constraint_system ball = rolling_ball(plane, sphere, 1);
  for (const Constraint& constraint : ball.constraints())
    std::cout << constraint.statement() << '\n';

  // x y z, c_x c_y c_z, p_A_x p_A_y p_A_z, p_B_x p_B_y p_B_z at a point of the torus.
  const NT fifth = NT(1) / NT(5);
  std::vector<NT> p{NT(23 * fifth), 0, NT(9 * fifth), 4, 0, 1, 4, 0, 0, NT(16 * fifth), 0,
                    NT(2 * fifth)};
  const N_space_surface_3 blend(ball.n_space_system());
  const auto shape = blend(p);
  if (!shape)
    return EXIT_FAILURE;
  const NT k = gaussian_curvature(*shape);
  std::cout << "K = " << k << " at the point (23/5, 0, 9/5)\n\n";
  p[9] += 1; // a wrong place is told in words
  const std::vector<Violation<NT>> wrong = ball.violated(p);
  for (const auto& violation : wrong)
  {
    std::cout << violation.sentence << ", with the residuals";
    for (const NT& residual : violation.residuals)
      std::cout << ' ' << residual;
    std::cout << '\n';
  }

  // X, Y, Z, W of the circle and of one cylinder.
  const Curve_entity_3 circle([](auto r) {
    using T = decltype(r);
    return std::array<T, 4>{3 * (1 - r * r) - (1 + r * r), 6 * r, 8 * (1 + r * r), 2 * (1 + r * r)};
  });
  const Implicit_entity_3 f([](auto x, auto y, auto) { return (x + 1) * (x + 1) + y * y - 1; });
  const Parametric_entity_3 g([](auto s, auto t) {
    using T = decltype(s);
    return std::array<T, 4>{3 * (1 - s * s), t * (1 + s * s), 6 * s, 1 + s * s};
  });
  const Constraint_system ruled = ruled_by_projection(circle, f, g);
  std::cout << '\n' << ruled.number_of_equations() << " equations in";
  for (const std::string& name : ruled.variables())
    std::cout << ' ' << name;
  std::cout << '\n';
  const bool right = k == NT(3) / NT(23) && wrong.size() == 3 && ruled.variables().size() == 16;
  return right && CGAL::certainly(verify_identities(ruled)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
