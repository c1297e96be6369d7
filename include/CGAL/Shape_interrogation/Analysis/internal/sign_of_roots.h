// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_ANALYSIS_INTERNAL_SIGN_OF_ROOTS_H
#define CGAL_SHAPE_INTERROGATION_ANALYSIS_INTERNAL_SIGN_OF_ROOTS_H

// Exact signs of a + b sqrt(e) and a + b sqrt(e) + c sqrt(f). (CGAL/functions_on_signs.h does the
// same, but does not compile for number types with expression templates.)

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
CGAL::Sign sign_with_root(const NT& a, const NT& b, const NT& e)
{
  const CGAL::Sign first = CGAL::sign(a);
  const CGAL::Sign second = CGAL::is_zero(e) ? ZERO : CGAL::sign(b);
  if (second == ZERO || first == second)
    return first;
  if (first == ZERO)
    return second;
  const NT difference = a * a - b * b * e;
  return first * CGAL::sign(difference);
}

template <class NT>
CGAL::Sign sign_with_roots(const NT& a, const NT& b, const NT& e, const NT& c, const NT& f)
{
  const CGAL::Sign first = sign_with_root(a, b, e);
  const CGAL::Sign second = CGAL::is_zero(f) ? ZERO : CGAL::sign(c);
  if (second == ZERO || first == second)
    return first;
  if (first == ZERO)
    return second;
  // (a + b sqrt(e))^2 - c^2 f
  const NT constant = a * a + b * b * e - c * c * f;
  const NT root = NT(2) * a * b;
  return first * sign_with_root(constant, root, e);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_ANALYSIS_INTERNAL_SIGN_OF_ROOTS_H
