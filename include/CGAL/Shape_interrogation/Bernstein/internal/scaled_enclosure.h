// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_ENCLOSURE_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_ENCLOSURE_H

// Integers of any size as intervals of doubles, divided by a power of two so that they fit.

#include <CGAL/Shape_interrogation/Bernstein/internal/gmp_access.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// An enclosure of x / 2^e for integers of any size.
template <class Ring>
CGAL::Interval_nt<true> scaled_enclosure(const Ring& x, long e)
{
  using Interval = CGAL::Interval_nt<true>;
  if constexpr (Has_gmp<Ring>::value)
  {
    long exponent;
    const double mantissa = mpz_get_d_2exp(&exponent, gmp_of(x)); // rounded towards zero
    if (mantissa == 0)
      return Interval(0);
    const double to_zero = std::ldexp(mantissa, static_cast<int>(exponent - e));
    const double away = std::nextafter(to_zero, mantissa > 0 ? HUGE_VAL : -HUGE_VAL);
    return mantissa > 0 ? Interval((std::max)(0.0, std::nextafter(to_zero, 0.0)), away)
                        : Interval(away, (std::min)(0.0, std::nextafter(to_zero, 0.0)));
  }
  else
    return number_cast<Interval>(x);
}

template <class Ring>
long exponent_of(const std::vector<Ring>& numbers)
{
  long bits = 0;
  if constexpr (Has_gmp<Ring>::value)
    for (const Ring& x : numbers)
      bits = (std::max)(bits, static_cast<long>(mpz_sizeinbase(gmp_of(x), 2)));
  return bits;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SCALED_ENCLOSURE_H
