// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// An exact umbilic, points 2^-60 and 1/1024 beside it, and an umbilic without finite decimals:
// double is wrong about two of them. The filter decides all four, and tells by what means.

#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using Exact = CGAL::Exact_rational;

// The ellipsoid 13 x^2 + 25 y^2 + 52 z^2 = 1300, moved so that the umbilic (8, 0, 3) is the origin.
struct Ellipsoid
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT a = x + 8, c = z + 3;
    return 13 * a * a + 25 * y * y + 52 * c * c - 1300;
  }
};

// Asks about the level set through the point: where the point lies is not the question here.
template <class FT>
bool interrogate(const char* name, const Coordinates<FT, 3>& p, bool truth)
{
  const Implicit_surface_3<Ellipsoid> ellipsoid;
  const Shape_chain<Is_umbilic> chain;
  Filter_statistics count;
  const Filtered<Shape_chain<Is_umbilic>> filtered(chain, &count);
  const bool in_double = *chain(ellipsoid, cast_argument<double>(p));
  const bool certified = *filtered(ellipsoid, p);

  std::cout << name << "\n  double:   " << (in_double ? "umbilic" : "no umbilic")
            << "\n  filtered: " << (certified ? "umbilic" : "no umbilic") << ", decided by "
            << (count.magnitude    ? "floating point with an error bound\n"
                : count.interval   ? "intervals\n"
                : count.exact_ring ? "the exact ring of dyadic numbers\n"
                                   : "exact rationals\n");
  return certified == truth;
}

int main()
{
  using Dyadic = Coordinates<double, 3>;
  using Rational = Coordinates<Exact, 3>;
  bool right = interrogate("an umbilic", Dyadic{0, 0, 0}, true);
  right &= interrogate("2^-60 beside it", Dyadic{std::ldexp(1, -60), 0, 0}, false);
  right &= interrogate("1/1024 beside it", Dyadic{std::ldexp(1, -10), 0, 0}, false);
  // The level set through (4/3) (8, 0, 3), before the ellipsoid was moved.
  right &= interrogate("an umbilic of another level", Rational{Exact(8) / 3, 0, 1}, true);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
