// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A NURBS surface that is a plane up to the knot u = 1 and a quarter of a cylinder from there on.
// At the knot it has one tangent plane but two curvatures; both are reported, never a mean.

#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>

#include <CGAL/Exact_rational.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

// Prints the data, and tells whether they are those of a plane, or of a cylinder of radius 1.
bool print_and_check(const Local_shape_3<NT>& s, bool is_plane)
{
  std::cout << (is_planar(s) ? "planar" : is_parabolic(s) ? "parabolic" : "curved")
            << ", K = " << gaussian_curvature(s) << ", sign of H = " << sign_of_mean_curvature(s)
            << ", H^2 = " << squared_mean_curvature(s) << '\n';
  const NT expected = is_plane ? NT(0) : NT(1) / 4;
  return is_planar(s) == is_plane && squared_mean_curvature(s) == expected;
}

int main()
{
  // The profile: the line from (1, -2) to (1, 0), then the arc of the unit circle to (0, 1). It is
  // extruded along z, from 0 to 3.
  const std::vector<std::array<int, 2>> profile{{1, -2}, {1, -1}, {1, 1}, {0, 1}};
  const std::vector<int> profile_weights{1, 1, 1, 2};
  std::vector<std::vector<Coordinates<NT, 3>>> points;
  std::vector<std::vector<NT>> weights;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const NT x = profile[i][0], y = profile[i][1], w = profile_weights[i];
    points.push_back({{x, y, NT(0)}, {x, y, NT(3)}});
    weights.push_back({w, w});
  }
  const Nurbs_surface_3<NT> surface(Knot_vector<NT>(2, {0, 0, 0, 1, 2, 2, 2}),
                                    Knot_vector<NT>(1, {0, 0, 1, 1}), points, weights);

  bool is_right = true;
  for (const NT& u : std::array<NT, 3>{NT(1) / 2, NT(1), NT(3) / 2})
  {
    const auto shapes = surface.one_sided_shapes({u, NT(1) / 3});
    std::cout << "u = " << u << ", " << shapes->size()
              << (shapes->size() == 1 ? " answer\n" : " answers\n");
    is_right &= shapes->size() == (u == 1 ? 2 : 1);
    for (const auto& side : *shapes)
    {
      std::cout << (side.side_u == Side::LEFT ? "  from the left:  " : "  from the right: ");
      is_right &= print_and_check(*side.shape, u < 1 || (u == 1 && side.side_u == Side::LEFT));
    }
  }
  // The same surface as Bezier patches, exactly.
  for (const auto& piece : surface.bezier_patches())
  {
    std::cout << "the patch over [" << piece.u[0] << ", " << piece.u[1] << "]: ";
    is_right &= print_and_check(*piece.patch({NT(1) / 2, NT(1) / 3}), piece.u[1] == 1);
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
