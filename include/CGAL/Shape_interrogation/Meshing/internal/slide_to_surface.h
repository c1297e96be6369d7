// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SLIDE_TO_SURFACE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SLIDE_TO_SURFACE_H

// Newton steps along the gradient to a point of an implicit surface, some coordinates held fixed.
// They end when steps that are tiny beside the coordinates or a given length stop shrinking: the
// rest is rounding, whatever the unit of length.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// `gradient(p)` returns the value and the gradient of the function: four numbers. `length` is that
// of an edge of the mesh. Bit k of `fixed` holds coordinate k. Returns whether the steps settle.
template <class Gradient>
bool slide_to_surface(const Gradient& gradient, Coordinates<double, 3>& p, double length,
                      int fixed = 0)
{
  double last = std::numeric_limits<double>::infinity();
  const double size = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2]), length});
  for (int i = 0; i < 50; ++i)
  {
    const std::array<double, 4> f = gradient(p);
    Coordinates<double, 3> g{f[1], f[2], f[3]};
    for (int k = 0; k < 3; ++k)
      if (fixed & 1 << k)
        g[k] = 0;
    const double q = dot(g, g);
    if (f[0] == 0)
      return true;
    if (!(q > 0) || !std::isfinite(f[0] / q))
      return false;
    const double step = std::abs(f[0]) / std::sqrt(q);
    if (i > 3 && step >= last / 2 && step <= std::ldexp(size, -20))
      return true;
    if (i > 3 && step >= last) // runs to and fro where there is no surface
      return false;
    last = step;
    for (int k = 0; k < 3; ++k)
      p[k] -= f[0] / q * g[k];
  }
  return false;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SLIDE_TO_SURFACE_H
