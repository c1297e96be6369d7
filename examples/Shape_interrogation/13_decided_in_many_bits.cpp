// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A ruled surface over the projections of a circle onto two cylinders, at proved points on its
// plane of symmetry and beside it. There K is zero, which no number of bits proves; beside it K is
// certainly negative, however near.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Constraints/prove_by_identities.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Surfaces/decide_at.h>

#include <cmath>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;

int main()
{
  const auto circle = [](auto r) -> Coordinates<decltype(r), 3> { // through (1, 0, 4) at r = 0
    return {(1 - 2 * r * r) / (1 + r * r), 3 * r / (1 + r * r), decltype(r)(4)};
  };
  const auto upright = [](auto x, auto y, auto) { return (x + 1) * (x + 1) + y * y - 1; };
  const auto level = [](auto s, auto t) -> Coordinates<decltype(s), 3> {
    return {3 * (1 - s * s) / (1 + s * s), t, 6 * s / (1 + s * s)};
  };
  const Constraint_system constraints = ruled_by_projection(
    Curve_entity_3(circle), Implicit_entity_3(upright), Parametric_entity_3(level));
  const N_space_system system = constraints.n_space_system();

  // Near the middle of the ruling in the plane y = 0. Held are r and lambda.
  std::vector<double> start(system.number_of_variables());
  const auto set = [&](const char* name, double value) {
    start[constraints.find_variable(name)] = value;
  };
  const double w = std::sqrt(17.);
  set("x", 0.36), set("z", 3.45), set("p0_x", 1), set("p0_z", 4), set("p1_z", 4);
  set("p2_x", 3 * w / 17), set("p2_z", 12 * w / 17), set("p2_s", (w - 1) / 4), set("lambda", 0.5);

  bool right = true;
  for (const char* r : {"0", "1/100", "1/1000000000000", "1/10000000000000000000000000000"})
  {
    const Fixed_coordinates fixed{
      {constraints.find_variable("r"), constraints.find_variable("lambda")}, {Q(r), Q(1) / 2}};
    auto e = enclose_solution(system, start, fixed);
    if (!e)
      return std::cerr << e.refusal().evidence() << '\n', 1;
    const N_space_enclosure proved = prove_by_identities(constraints, *e);
    const auto k = decide_at(system, proved, [](const auto& s) {
      return sign_of_gaussian_curvature(s);
    });
    std::cout << "r = " << r << ", " << proved.others_proved.size()
              << " equation by an identity: K ";
    if (k)
      std::cout << (k->answer == CGAL::NEGATIVE ? "< 0" : ">= 0") << " in " << k->bits << " bits\n";
    else
      std::cout << "is " << k.refusal().evidence() << '\n';
    right = right && (k ? k->answer == CGAL::NEGATIVE : CGAL::is_zero(Q(r)));
  }
  return right ? 0 : 1;
}
