// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EDGE_CROSSINGS_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EDGE_CROSSINGS_H

// The points of the zero set on a segment of a cell's edge: isolated in floating point where signs
// are certain, exactly where they are not.

#include <CGAL/Shape_interrogation/Bernstein/isolate_roots.h>
#include <CGAL/Shape_interrogation/Contours/internal/Exact_function.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Part of a line: where the variable `axis` has the value `x`, the other one from `low` to `high`.
struct Segment
{
  int axis;
  double x, low, high;
};

// A point of the zero set on a segment, strictly between two doubles unless they agree.
struct Crossing
{
  double low, high;
  double at; // about there
  int multiplicity = 1;
  CGAL::Sign sign_at_low = ZERO; // unless the bounds agree or the multiplicity is even
};

class Edge_crossings
{
public:
  explicit Edge_crossings(const Exact_function& f) : m_f(f) {}

  // All crossings strictly inside the segment, in increasing order; `b` is the polynomial on it.
  // Nothing where two crossings are too close for doubles.
  std::optional<std::vector<Crossing>> operator()(const Segment& segment,
                                                  const Edge_coefficients& b) const
  {
    std::vector<Crossing> crossings;
    if (isolate(b, segment.low, segment.high, 40, crossings))
      return crossings;
    return isolate_exactly(segment);
  }

  // Halves the distance of the bounds; false where doubles do not allow it.
  bool refine(const Segment& segment, Crossing& c) const
  {
    const double middle = c.low + (c.high - c.low) / 2;
    if (middle <= c.low || middle >= c.high || c.sign_at_low == ZERO)
      return false;
    const CGAL::Sign sign = sign_at(segment, middle);
    if (sign == ZERO)
      c.low = c.high = middle;
    else
      (sign == c.sign_at_low ? c.low : c.high) = middle;
    c.at = (std::min)((std::max)(c.at, c.low), c.high);
    return true;
  }

private:
  CGAL::Sign sign_at(const Segment& segment, double x) const
  {
    return segment.axis == 0 ? m_f.sign_at(segment.x, x) : m_f.sign_at(x, segment.x);
  }

  // False where the error leaves it open, or after `depth` cuts.
  static bool isolate(const Edge_coefficients& b, double low, double high, int depth,
                      std::vector<Crossing>& crossings)
  {
    const std::optional<int> variations = b.certain_variations();
    if (variations && *variations == 0)
      return true;
    if (variations && *variations == 1)
    {
      crossings.push_back(narrowed(b, low, high));
      return true;
    }
    if (depth == 0 || high - low < 1e-13)
      return false;
    for (double t : {0.5, 0.4375, 0.59375})
    {
      const auto parts = b.split(t);
      if (common_sign(parts[1].b.data(), 1, parts[1].error) == ZERO)
        continue;
      const double middle = low + t * (high - low);
      return isolate(parts[0], low, middle, depth - 1, crossings) &&
             isolate(parts[1], middle, high, depth - 1, crossings);
    }
    return false;
  }

  // The only root, by false position with bounds that stay certain.
  static Crossing narrowed(const Edge_coefficients& b, double low, double high)
  {
    const double error = b.value_error(), width = high - low;
    double t0 = 0, t1 = 1, f0 = b.b.front(), f1 = b.b.back(), t = 0.5;
    Crossing c{low, high, low, 1, f0 > 0 ? POSITIVE : NEGATIVE};
    for (int step = 0; step < 60 && t1 - t0 > 1e-14; ++step)
    {
      t = step % 4 == 3 ? (t0 + t1) / 2 : t0 + (t1 - t0) * (f0 / (f0 - f1));
      const double f = b.value(t);
      if (std::fabs(f) <= error || !(t > t0 && t < t1))
        break;
      if ((f > 0) == (f0 > 0))
      {
        t0 = t;
        f0 = f;
        f1 /= 2;
      }
      else
      {
        t1 = t;
        f1 = f;
        f0 /= 2;
      }
    }
    // The nearest bounds with certain signs.
    for (double d = 1e-12; d < 1e-3; d *= 10)
    {
      const double left = t - d, right = t + d;
      if (left > t0 && b.value(left) * (c.sign_at_low == POSITIVE ? 1 : -1) > error)
        t0 = left;
      if (right < t1 && b.value(right) * (c.sign_at_low == POSITIVE ? -1 : 1) > error)
        t1 = right;
    }
    // The sums round: one step outward.
    c.low = t0 > 0 ? std::nextafter(low + t0 * width, low) : low;
    c.high = t1 < 1 ? std::nextafter(low + t1 * width, high) : high;
    c.at = low + t * width;
    return c;
  }

  std::optional<std::vector<Crossing>> isolate_exactly(const Segment& segment) const
  {
    std::vector<Crossing> crossings;
    const Exact_rational low(segment.low), width = Exact_rational(segment.high) - low;
    for (Bernstein_root& root :
         isolate_roots(m_f.on_segment(segment.axis, segment.x, segment.low, segment.high)))
    {
      if (root.is_exact() && (root.lower() == 0 || root.lower() == 1))
        continue;
      root.refine(Exact_rational(1, 1L << 40));
      Crossing c{CGAL::to_interval(Exact_rational(low + width * root.lower())).first,
                 CGAL::to_interval(Exact_rational(low + width * root.upper())).second, 0,
                 root.multiplicity()};
      c.at = c.low + (c.high - c.low) / 2;
      if (c.multiplicity % 2 == 1 && c.low != c.high)
        c.sign_at_low = sign_at(segment, c.low);
      if (!crossings.empty() && c.low <= crossings.back().high)
        return std::nullopt;
      crossings.push_back(c);
    }
    return crossings;
  }

  const Exact_function& m_f;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_EDGE_CROSSINGS_H
