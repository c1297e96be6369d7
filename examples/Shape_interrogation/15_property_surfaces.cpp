// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Questions about a whole patch, answered by theorems: is it developable, is it steeper than
// 45 degrees anywhere, how much does it bend. A number that is 2^-60 greater gives another answer.

#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>

#include <CGAL/Exact_rational.h>

#include <iostream>
#include <vector>

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;

// z = a u^2 + b v^2 over the unit square.
Bezier_surface_3<Q> paraboloid(const Q& a, const Q& b)
{
  std::vector<Coordinates<Q, 3>> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      points.push_back({Q(Q(i) / 2), Q(Q(j) / 2), Q((i == 2 ? a : Q(0)) + (j == 2 ? b : Q(0)))});
  return Bezier_surface_3<Q>(2, 2, points);
}

// Whether the squared tangent of the slope is at most 1 everywhere.
Verdict is_flat_enough(const Bezier_surface_3<Q>& patch)
{
  const auto decided = decide_at_most(property_surface(patch, Property::SLOPE), Q(1));
  std::cout << "slope <= 45 degrees: " << to_string(decided->verdict) << ", at ("
            << (*decided->at)[0] << ", " << (*decided->at)[1] << ") the squared tangent is 1";
  std::cout << (decided->extreme.upper == 1 ? "\n" : " and a little more\n");
  return decided->verdict;
}

int main()
{
  const Q tiny("1/1152921504606846976"), a = Q(3) / 10, b = Q(2) / 5;
  const bool steep = is_flat_enough(paraboloid(a, b)) != Verdict::YES ||
                     is_flat_enough(paraboloid(a + tiny, b)) != Verdict::NO;

  Property_surface_maker<Q> maker(paraboloid(a, b));
  const auto k = maker(Property::GAUSSIAN), h2 = maker(Property::MEAN_SQUARED);
  std::cout << "K has the degrees (" << k.numerator().degree()[0] << ", "
            << k.numerator().degree()[1] << ") over (" << k.denominator().degree()[0] << ", "
            << k.denominator().degree()[1] << "), and at (1/3, 1/2) the value "
            << *k.value({Q(Q(1) / 3), Q(Q(1) / 2)}) << '\n';
  const auto range = bounds(h2);
  std::cout << "H^2 is between " << CGAL::to_double(range.infimum.lower) << " and "
            << range.supremum.upper << '\n';
  const bool bent = range.supremum.upper != Q(49) / 100;

  const auto developable = [](const Bezier_surface_3<Q>& patch) {
    return property_surface(patch, Property::SECOND_FORM_DETERMINANT).is_identically_zero();
  };
  const bool cylinder = developable(paraboloid(a, Q(0)));
  const bool nearly = developable(paraboloid(a, tiny));
  std::cout << "a cylinder is developable: " << (cylinder ? "yes" : "no")
            << ", its twin: " << (nearly ? "yes" : "no") << '\n';
  return steep || bent || !cylinder || nearly;
}
