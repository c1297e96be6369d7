// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_INTEGER_COEFFICIENTS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_INTEGER_COEFFICIENTS_H

// The Bernstein coefficients of a polynomial in one variable up to a positive factor, in integers:
// halving takes additions only.

#include <CGAL/Shape_interrogation/Bernstein/internal/axes.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Integers = std::vector<Exact_integer>;

// The coefficients times the least common multiple of the binomial coefficients.
inline Integers unscaled(const Integers& scaled)
{
  const Integers row = binomials_in<Exact_integer>(static_cast<int>(scaled.size()) - 1);
  Exact_integer multiple = 1;
  for (const Exact_integer& c : row)
    multiple = multiple / CGAL::gcd(multiple, c) * c;
  Integers b;
  for (std::size_t i = 0; i < scaled.size(); ++i)
    b.push_back(scaled[i] * (multiple / row[i]));
  return b;
}

// The polynomials on the halves of the interval, both times the same positive factor.
inline std::array<Integers, 2> halves(Integers b)
{
  const std::size_t n = b.size() - 1;
  std::array<Integers, 2> parts{b, b};
  for (std::size_t k = 0; k <= n; ++k)
  {
    Exact_integer factor = 1;
    factor <<= n - k;
    parts[0][k] = b[0] * factor;
    parts[1][n - k] = b[n - k] * factor;
    for (std::size_t i = 0; i + k < n; ++i)
      b[i] += b[i + 1];
  }
  return parts;
}

// The number of changes of sign, zeros left out.
inline int sign_variations(const Integers& b)
{
  int variations = 0;
  CGAL::Sign last = ZERO;
  for (const Exact_integer& c : b)
  {
    const CGAL::Sign sign = CGAL::sign(c);
    if (sign == ZERO)
      continue;
    variations += last != ZERO && sign != last;
    last = sign;
  }
  return variations;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_INTEGER_COEFFICIENTS_H
