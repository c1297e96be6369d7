// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Curvature of an implicit surface at a point, in three number types: double makes no claim, the
// exact rationals are exact, and the filter is as certain as these and mostly as fast as double.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using Exact = CGAL::Exact_rational;

// The torus with the radii 2 and 1, for every number type. Nobody writes derivatives.
struct Torus
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT a = x * x + y * y;
    const NT b = a + z * z + 3;
    return b * b - 16 * a;
  }
};

bool interrogate(const Coordinates<Exact, 3>& p)
{
  const Implicit_surface_3<Torus> torus;
  const auto exact = torus(p);
  const auto approximate = torus(cast_argument<double>(p));
  // The whole chain is filtered, from the rational coordinates to the sign.
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> certified_sign;
  const CGAL::Sign sign = *certified_sign(torus, p);
  const auto k = principal_curvatures(*approximate);

  std::cout << "at (" << p[0] << ", " << p[1] << ", " << p[2] << ")\n"
            << "  K in double   " << gaussian_curvature(*approximate) << '\n'
            << "  K exactly     " << gaussian_curvature(*exact) << '\n'
            << "  sign of K     double " << sign_of_gaussian_curvature(*approximate)
            << ", exact " << sign_of_gaussian_curvature(*exact) << ", filtered " << sign << '\n'
            << "  H squared     " << squared_mean_curvature(*exact) << '\n'
            << "  kmin, kmax    " << k[0] << ", " << k[1] << '\n';
  return sign == sign_of_gaussian_curvature(*exact);
}

int main()
{
  bool agree = true;
  agree &= interrogate({Exact(14) / 5, 0, Exact(3) / 5}); // outside, both curvatures are positive
  agree &= interrogate({Exact(6) / 5, Exact(8) / 5, 1});  // on the circle on top, K = 0
  agree &= interrogate({Exact(3) / 5, Exact(4) / 5, 0});  // inside, the surface is a saddle
  return agree ? EXIT_SUCCESS : EXIT_FAILURE;
}
