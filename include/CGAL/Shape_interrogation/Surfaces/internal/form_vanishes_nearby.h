// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FORM_VANISHES_NEARBY_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FORM_VANISHES_NEARBY_H

// Whether a second form in floating point may be rounding noise, where the sizes of the gradients
// do not tell: the square of an equation has no gradient, and the form is the square of noise.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Elimination_plan.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline Interval_nt<false> widened(double x, double size)
{
  const double d = numerical_rank_tolerance * size;
  return Interval_nt<false>(x) + Interval_nt<false>(-d, d);
}

// The form of the combination `weights` of the equations, over all points, tangent vectors and
// weights that differ by what counts as noise from those given: does it contain zero?
inline bool form_vanishes_nearby(const N_space_system& system, const std::vector<double>& point,
                                 const std::array<std::vector<double>, 2>& basis,
                                 const std::vector<double>& weights)
{
  using NT = Interval_nt<false>;
  NT::Protector protector;
  std::array<double, 2> size{0, 0};
  for (int k = 0; k < 2; ++k)
    for (double x : basis[k])
      size[k] = (std::max)(size[k], std::fabs(x));
  std::vector<Jet<NT, 2, 2>> moving(point.size()), jets(weights.size()), workspace;
  for (std::size_t i = 0; i < point.size(); ++i)
    moving[i] = Jet<NT, 2, 2>::along(
      widened(point[i], std::fabs(point[i])),
      {widened(basis[0][i], size[0]), widened(basis[1][i], size[1])});
  try
  {
    system.tape().evaluate(moving.data(), jets.data(), workspace);
  }
  catch (const Shape_error&) { return false; }
  std::array<NT, 3> h{NT(0), NT(0), NT(0)};
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    const NT weight = widened(weights[k], std::fabs(weights[k]));
    h[0] += weight * jets[k].derivative(0, 0);
    h[1] += weight * jets[k].derivative(0, 1);
    h[2] += weight * jets[k].derivative(1, 1);
  }
  return std::all_of(h.begin(), h.end(), [](const NT& x) { return x.inf() <= 0 && x.sup() >= 0; });
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FORM_VANISHES_NEARBY_H
