// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A point of the offset of an ellipsoid that is proved to exist, and the signs of the curvatures
// there. The point has no simple coordinates: it is known by a box.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/prove_by_identities.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;

struct Ellipsoid
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return x * x / 9 + y * y / 4 + z * z - 1;
  }
};

int main()
{
  const Constraint_system constraints =
    offset_system(Implicit_entity_3(Ellipsoid(), "the ellipsoid"), CGAL::Exact_rational(1) / 2);
  const N_space_surface_3 offset(constraints.n_space_system());

  // About 1/2 outside of (2, 1, 0.5), and its foot point.
  const auto enclosure = enclose_solution(offset.system(), {2.2, 1.3, 1, 2, 1.1, 0.5});
  if (!enclosure)
    return std::cerr << enclosure.refusal().evidence() << '\n', 1;
  std::cout.precision(17);
  for (std::size_t i = 0; i < enclosure->box.size(); ++i)
    std::cout << offset.system().variables()[i] << " in [" << enclosure->box[i].inf() << ", "
              << enclosure->box[i].sup() << "]\n";

  // Five equations of rank four: the fifth follows by an identity of the projection.
  const N_space_enclosure proved = prove_by_identities(constraints, *enclosure);
  for (int k : proved.others_proved)
    std::cout << "equation " << k + 1 << " vanishes by an identity\n";

  CGAL::Interval_nt<false>::Protector protector;
  const auto shape = offset(enclosure->box);
  if (!shape)
    return std::cerr << shape.refusal().evidence() << '\n', 1;
  const bool convex = CGAL::certainly(sign_of_gaussian_curvature(*shape) == CGAL::POSITIVE);
  std::cout << "Gaussian curvature " << gaussian_curvature(*shape)
            << (convex ? ": certainly positive\n" : ": undecided\n");

  // The ellipsoid has no point near here with the distance 1/2.
  const auto none = enclose_solution(
    offset.system(), {9, 0, 0, 3, 0, 0},
    Fixed_coordinates{{0, 1}, {CGAL::Exact_rational(9), CGAL::Exact_rational(0)}});
  std::cout << (none ? "a point at x = 9?\n" : none.refusal().evidence() + "\n");
  return convex && !none ? 0 : 1;
}
