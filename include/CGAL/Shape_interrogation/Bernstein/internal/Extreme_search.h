// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_EXTREME_SEARCH_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_EXTREME_SEARCH_H

// The supremum of (p + sqrt(r)) / q by branch and bound: boxes in the order of their bounds, which
// are found in rounded arithmetic from exact coefficients. Where rounding cannot tell a box from
// the best value, the coefficients are compared exactly.

#include <CGAL/Shape_interrogation/Bernstein/Certified_extreme.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/Subdivision_box.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/boundary_factors.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/scaled_enclosure.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT, int d>
class Extreme_search
{
  using Polynomial = Bernstein_polynomial<NT, d>;
  using Interval = CGAL::Interval_nt<true>;
  using Boxes = Subdivision_box<NT, d>;
  using Ring = typename Boxes::Ring;
  using Array = typename Boxes::Array;
  using Point = std::array<NT, d>;

  struct Box : Boxes
  {
    double upper = HUGE_VAL;

    bool operator<(const Box& other) const { return upper < other.upper; }
  };

  // A value at a corner of a box: the quotient of two coefficients.
  struct Best
  {
    Ring numerator, denominator;
    Interval value;
    Point at;
  };

public:
  Extreme_search(const Polynomial& p, const Polynomial& q, const Bound_limits& limits,
                 const std::optional<Polynomial>& r = std::nullopt, int sign_of_root = 1,
                 double known_bound = HUGE_VAL)
    : m_limits(limits), m_known_bound(known_bound), m_sign_of_root(sign_of_root)
  {
    std::vector<Array> arrays = quotient(p, q);
    if (r)
      for (Array& a : quotient(*r, q * q))
        arrays.push_back(std::move(a));
    m_limits.boxes = affordable_boxes(limits.boxes, arrays[0].numbers.size());
    Box box;
    static_cast<Boxes&>(box) = Boxes(std::move(arrays));
    add(std::move(box));
  }

  Certified_extreme<NT, d> run()
  {
    std::size_t looked_at = 0;
    while (!m_boxes.empty())
    {
      if (m_best && m_boxes.front().upper <= m_best->value.inf())
        break;
      if (is_near_best(m_boxes.front()))
      {
        if (is_below_best(m_boxes.front()))
        {
          pop();
          continue;
        }
        if (is_narrow(m_boxes.front()))
          return result(m_boxes.front().upper);
      }
      if (looked_at++ >= m_limits.boxes || is_point(m_boxes.front()))
        return result(m_boxes.front().upper);
      for (Boxes& half : pop().split())
      {
        Box box;
        static_cast<Boxes&>(box) = std::move(half);
        add(std::move(box));
      }
    }
    return result(-HUGE_VAL);
  }

private:
  // Numerator and denominator in one degree, so that their coefficients belong together.
  static std::vector<Array> quotient(const Polynomial& p, const Polynomial& q)
  {
    std::vector<Polynomial> both{p, q};
    divide_by_boundary_factors(both);
    std::array<int, d> degree;
    bool is_constant = true;
    for (int k = 0; k < d; ++k)
    {
      degree[k] = (std::max)(both[0].degree()[k], both[1].degree()[k]);
      is_constant = is_constant && both[1].degree()[k] == 0;
    }
    both[0] = both[0].elevated(degree);
    if (!is_constant)
      both[1] = both[1].elevated(degree);
    return subdivision_arrays(both);
  }

  static const Ring& denominator(const Array& q, std::size_t i)
  {
    return q.numbers.size() == 1 ? q.numbers[0] : q.numbers[i];
  }

  // A bound of the sign times the k-th quotient on the box: of a mean of the quotients of the
  // coefficients.
  static double bound(const Boxes& box, int k, int sign)
  {
    const Array &p = box.arrays[2 * k], &q = box.arrays[2 * k + 1];
    const long exponent = exponent_of(q.numbers);
    double upper = -HUGE_VAL;
    for (std::size_t i = 0; i < p.numbers.size(); ++i)
    {
      const Ring& b = denominator(q, i);
      const int sign_p = sign * sign_of(p.numbers[i]), sign_q = sign_of(b);
      if (sign_q < 0 || (sign_q == 0 && sign_p > 0))
        return HUGE_VAL;
      if (sign_q > 0)
        upper = (std::max)(upper, (Interval(sign) * scaled_enclosure(p.numbers[i], exponent) /
                                   scaled_enclosure(b, exponent))
                                    .sup());
    }
    return upper;
  }

  void add(Box box)
  {
    m_has_root = box.arrays.size() == 4;
    box.upper = bound(box, 0, 1);
    if (m_has_root)
    {
      const Interval square((std::max)(0.0, m_sign_of_root * bound(box, 1, m_sign_of_root)));
      const Interval root = std::isfinite(square.sup()) ? CGAL::sqrt(square) : square;
      box.upper = (Interval(box.upper) + Interval(m_sign_of_root) * root).sup();
    }
    box.upper = std::isnan(box.upper) ? m_known_bound : (std::min)(box.upper, m_known_bound);
    look_at_corners(box);
    if (m_best && box.upper <= m_best->value.inf())
      return;
    m_boxes.push_back(std::move(box));
    std::push_heap(m_boxes.begin(), m_boxes.end());
  }

  Box pop()
  {
    std::pop_heap(m_boxes.begin(), m_boxes.end());
    Box box = std::move(m_boxes.back());
    m_boxes.pop_back();
    return box;
  }

  void look_at_corners(const Box& box)
  {
    std::vector<std::pair<Point, std::size_t>> places;
    box.for_each_corner(box.arrays[0].degree, [&](const Point& x, std::size_t i) {
      places.emplace_back(x, i);
    });
    for (const auto& [x, i] : places)
    {
      const Ring &a = box.arrays[0].numbers[i], &b = denominator(box.arrays[1], i);
      if (sign_of(b) <= 0)
        continue;
      Interval value = ratio(a, b);
      if (m_has_root)
      {
        const std::optional<Interval> square = square_at(box, x);
        if (!square)
          continue;
        value += Interval(m_sign_of_root) * CGAL::sqrt(nonnegative_part(*square));
      }
      const double magnitude = (std::max)(std::fabs(value.inf()), std::fabs(value.sup()));
      if (std::isfinite(magnitude))
        m_scale = (std::max)(m_scale, magnitude);
      if (!m_best || value.inf() > m_best->value.inf())
        m_best = Best{a, b, value, x};
    }
  }

  static Interval ratio(const Ring& a, const Ring& b)
  {
    const long exponent = exponent_of(std::vector<Ring>{b});
    return scaled_enclosure(a, exponent) / scaled_enclosure(b, exponent);
  }

  // The radicand over the squared denominator at a corner.
  static std::optional<Interval> square_at(const Box& box, const Point& x)
  {
    std::optional<Interval> value;
    box.for_each_corner(box.arrays[2].degree, [&](const Point& y, std::size_t i) {
      const Ring& b = denominator(box.arrays[3], i);
      if (x == y && sign_of(b) > 0)
        value = ratio(box.arrays[2].numbers[i], b);
    });
    return value;
  }

  // Whether rounding may be all that is above the best value, or the limit of the search.
  bool is_near_best(const Box& box) const
  {
    return m_best && std::isfinite(box.upper) &&
           (is_narrow(box) ||
            box.upper - m_best->value.sup() <= 1e-12 * std::fabs(m_best->value.sup()));
  }

  bool is_narrow(const Box& box) const
  {
    return box.upper - m_best->value.inf() <= m_limits.tolerance * m_scale;
  }

  // Exactly. A corner that is above takes the place of the best value.
  bool is_below_best(const Box& box)
  {
    if (m_has_root)
      return false;
    const Array &p = box.arrays[0], &q = box.arrays[1];
    const auto is_above = [&](std::size_t i) {
      return sign_of(Ring(p.numbers[i] * m_best->denominator -
                          denominator(q, i) * m_best->numerator)) > 0;
    };
    box.for_each_corner(p.degree, [&](const Point& x, std::size_t i) {
      const Ring& b = denominator(q, i);
      if (sign_of(b) > 0 && is_above(i))
        m_best = Best{p.numbers[i], b, ratio(p.numbers[i], b), x};
    });
    for (std::size_t i = 0; i < p.numbers.size(); ++i)
      if (is_above(i))
        return false;
    return true;
  }

  // Whether there is nothing to halve.
  static bool is_point(const Box& box)
  {
    for (int k = 0; k < d; ++k)
      if (box.degree(k) > 0)
        return false;
    return true;
  }

  Certified_extreme<NT, d> result(double upper) const
  {
    Certified_extreme<NT, d> extreme;
    extreme.is_attained = m_best && std::isfinite(m_best->value.inf());
    extreme.is_bounded = upper < HUGE_VAL;
    if (!extreme.is_attained)
    {
      extreme.is_bounded = false;
      return extreme;
    }
    extreme.at = m_best->at;
    extreme.lower = m_has_root ? number_cast<NT>(m_best->value.inf())
                               : NT(NT(m_best->numerator) / NT(m_best->denominator));
    extreme.upper = extreme.lower;
    // With a root, what was found is known by its enclosure only.
    if (m_has_root)
      upper = (std::max)(upper, m_best->value.sup());
    if (extreme.is_bounded && std::isfinite(upper))
      extreme.upper = (std::max)(extreme.lower, NT(number_cast<NT>(upper)));
    return extreme;
  }

  Bound_limits m_limits;
  double m_known_bound;
  double m_scale = 0; // the greatest absolute value that was met
  int m_sign_of_root;
  bool m_has_root = false;
  std::vector<Box> m_boxes; // a heap
  std::optional<Best> m_best;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_EXTREME_SEARCH_H
