// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The package with the kernels of CGAL: EPICK users get certified decisions for double input, EPECK
// users exact ones. A question of one's own is a function object of the second-order data.

#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;

// The paraboloid z = x^2 + y^2 with downward normal: it is convex seen from below.
struct Paraboloid
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const { return x * x + y * y - z; }
};
const Implicit_surface_3<Paraboloid> paraboloid;

// The sign of |N_x, N_y| - |N_z|: is the surface steeper than 45 degrees?
struct Compare_slope_to_45_degrees
{
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const
  {
    const NT& z = s.normal()[2];
    return sign_decision(NT(s.normal_squared_length() - (z * z + z * z)));
  }
};

template <class Traits>
bool interrogate(const char* name)
{
  using Point_3 = typename Traits::Point_3;
  const Interrogation_3<Implicit_surface_3<Paraboloid>, Traits> ask(paraboloid);
  const typename Traits::FT tenth = typename Traits::FT(1) / 10;
  bool is_right = true;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(tenth, 0, tenth * tenth)})
  {
    is_right &= *ask.is_umbilic(p) == (p.x() == 0) && *ask.sign_of_mean_curvature(p) > 0;
    std::cout << name << ", at " << p << ": umbilic " << *ask.is_umbilic(p) << ", sign of H "
              << *ask.sign_of_mean_curvature(p) << ", K = " << gaussian_curvature(*ask.shape(p))
              << ", normal " << Traits::vector(ask.shape(p)->normal()) << '\n';
  }
  return is_right;
}

int main()
{
  bool is_right = interrogate<Filtered_shape_traits_3<>>("EPICK, filtered");
  is_right &= interrogate<Shape_traits_3<CGAL::Epeck>>("EPECK");
  // Half a unit from the axis the slope is exactly 1.
  const Filtered<Shape_chain<Compare_slope_to_45_degrees>> compare_slope;
  for (const double x : {0.5 - 0x1p-40, 0.5, 0.5 + 0x1p-40})
  {
    const auto slope = compare_slope(paraboloid, Coordinates<double, 3>{x, 0, x * x});
    std::cout << "slope compared with 45 degrees: " << *slope << '\n';
    is_right &= *slope == CGAL::compare(x, 0.5);
  }
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
