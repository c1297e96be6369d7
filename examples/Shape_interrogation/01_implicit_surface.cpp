// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Curvature of an implicit surface at a point, in three number types: double makes no claim, the
// exact rationals are exact, and the filter takes and returns what is certain about exact data.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using Exact = CGAL::Exact_rational;

// The torus with the radii 2 and 1. Nobody writes derivatives.
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

// From the input to a decision, in every number type. It asks for the level set through the point:
// that the point lies on the torus is known here, and an enclosure could not prove it.
struct Sign_of_gaussian_curvature
{
  template <class NT>
  Result<typename Number_type_traits<NT>::Sign> operator()(const Implicit_surface_3<Torus>& torus,
                                                           const Coordinates<NT, 3>& p) const
  {
    const auto shape = torus.level_set_shape(p);
    if (!shape)
      return shape.refusal();
    return sign_of_gaussian_curvature(*shape);
  }
};

void interrogate(const Coordinates<Exact, 3>& p)
{
  const Implicit_surface_3<Torus> torus;
  const auto exact = torus(p);
  const auto approximate = torus(cast_argument<double>(p));
  const Filtered<Sign_of_gaussian_curvature> certified_sign;
  const auto k = principal_curvatures(*approximate);
  std::cout << "at (" << p[0] << ", " << p[1] << ", " << p[2] << ")\n"
            << "  K in double   " << gaussian_curvature(*approximate) << '\n'
            << "  K exactly     " << gaussian_curvature(*exact) << '\n'
            << "  sign of K     double " << sign_of_gaussian_curvature(*approximate)
            << ", exact " << sign_of_gaussian_curvature(*exact)
            << ", filtered " << *certified_sign(torus, p) << '\n'
            << "  H squared     " << squared_mean_curvature(*exact) << '\n'
            << "  kmin, kmax    " << k[0] << ", " << k[1] << '\n';
}

int main()
{
  interrogate({Exact(14) / 5, Exact(0), Exact(3) / 5}); // outside, both curvatures are positive
  interrogate({Exact(6) / 5, Exact(8) / 5, Exact(1)});  // on the circle on top, K = 0
  interrogate({Exact(3) / 5, Exact(4) / 5, Exact(0)});  // inside, the surface is a saddle
}
