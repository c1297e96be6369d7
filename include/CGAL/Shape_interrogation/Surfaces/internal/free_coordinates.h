// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FREE_COORDINATES_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FREE_COORDINATES_H

// The two coordinates that serve best as parameters of a surface in n-space near a point.

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Those with the largest minor of the tangent basis, found by two steps of complete pivoting.
inline std::array<int, 2> free_coordinates(const std::vector<std::vector<double>>& basis)
{
  const std::vector<double>&a = basis[0], &b = basis[1];
  const int n = static_cast<int>(a.size());
  int first = 0;
  for (int i = 1; i < n; ++i)
    if (std::hypot(a[i], b[i]) > std::hypot(a[first], b[first]))
      first = i;
  const auto minor = [&](int i) { return std::fabs(a[first] * b[i] - a[i] * b[first]); };
  int second = first == 0 ? 1 : 0;
  for (int i = 0; i < n; ++i)
    if (i != first && minor(i) > minor(second))
      second = i;
  return {first, second};
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_FREE_COORDINATES_H
