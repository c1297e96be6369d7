// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MAGNITUDE_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MAGNITUDE_H

// Floating point with a running magnitude: a value v, a bound m on all that was added up to make
// it, and the number k of roundings on the longest way. |v - exact| <= k u m (1 + small), u =
// 2^-53. No rounding modes and no branches: the first stage of the filter.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/internal/No_ring_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/FPU.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Magnitude
{
public:
  [[gnu::always_inline]] Magnitude() : m_v(0), m_m(floor_()), m_k(0) {}
  [[gnu::always_inline]] Magnitude(int v) : Magnitude(static_cast<double>(v)) {}
  [[gnu::always_inline]] Magnitude(double v) : m_v(v), m_m(std::fabs(v) + floor_()), m_k(0) {}

  // An integer of any other type; one that is wider than a double is rounded.
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  [[gnu::always_inline]] Magnitude(Integer v)
    : m_v(static_cast<double>(v)), m_m(std::fabs(m_v) + floor_()),
      m_k(std::numeric_limits<Integer>::digits > 53)
  {}

  // Whether an overflow shows: a caller who rounds downward or towards zero gets the largest double
  // in place of infinity, which later steps could make a small one.
  static bool is_safe_in_rounding_mode()
  {
    const FPU_CW_t mode = FPU_get_cw();
    return mode == CGAL_FE_TONEAREST || mode == CGAL_FE_UPWARD;
  }

  double value() const { return m_v; }

  // A value with its bound and count, for sums of products that are bounded as a whole. Where the
  // value overflows, so does the bound.
  [[gnu::always_inline]] static Magnitude bounded(double value, double bound, int roundings)
  {
    const double v = std::fabs(value);
    return Magnitude(value, (bound > v ? bound : v) + floor_(), roundings);
  }
  [[gnu::always_inline]] double bound() const { return m_m; }
  [[gnu::always_inline]] int roundings() const { return m_k; }

  // A bound on the error: k roundings of at most u m each (2u when the caller rounds upward), and
  // as many of m itself. The factor 4 covers both as long as k u is small; beyond, nothing is
  // certified.
  double error() const
  {
    return m_k < cap ? m_k * (4 * unit()) * m_m : HUGE_VAL;
  }

  [[gnu::always_inline]] friend Magnitude operator-(const Magnitude& a)
  {
    return Magnitude(-a.m_v, a.m_m, a.m_k);
  }
  [[gnu::always_inline]] friend Magnitude operator+(const Magnitude& a) { return a; }
  [[gnu::always_inline]] friend Magnitude operator+(const Magnitude& a, const Magnitude& b)
  {
    return rounded_sum(a.m_v + b.m_v, a, b);
  }
  [[gnu::always_inline]] friend Magnitude operator-(const Magnitude& a, const Magnitude& b)
  {
    return rounded_sum(a.m_v - b.m_v, a, b);
  }
  [[gnu::always_inline]] friend Magnitude operator*(const Magnitude& a, const Magnitude& b)
  {
    // The floor keeps m above the underflow threshold, where u m still covers a lost product.
    return Magnitude(a.m_v * b.m_v, a.m_m * b.m_m + floor_(), capped(a.m_k + b.m_k + 1));
  }
  // With |B| >= beta > 0: |a/b - A/B| <= (ka u ma + |a/b| kb u mb) / beta, and a last rounding.
  friend Magnitude operator/(const Magnitude& a, const Magnitude& b)
  {
    const double v = a.m_v / b.m_v;
    const double beta = (std::fabs(b.m_v) - b.error()) * (1 - 4 * unit());
    const double m = beta > 0 ? (a.m_m + std::fabs(v) * b.m_m) / beta + floor_() : HUGE_VAL;
    return Magnitude(v, m, capped(longest(a.m_k, b.m_k) + 4));
  }
  [[gnu::always_inline]] Magnitude& operator+=(const Magnitude& b) { return *this = *this + b; }
  [[gnu::always_inline]] Magnitude& operator-=(const Magnitude& b) { return *this = *this - b; }
  [[gnu::always_inline]] Magnitude& operator*=(const Magnitude& b) { return *this = *this * b; }
  Magnitude& operator/=(const Magnitude& b) { return *this = *this / b; }

  friend std::ostream& operator<<(std::ostream& out, const Magnitude& x)
  {
    return out << x.m_v << " +- " << x.error();
  }

private:
  [[gnu::always_inline]] Magnitude(double v, double m, int k) : m_v(v), m_m(m), m_k(k) {}

  static constexpr double unit() { return 1.1102230246251565e-16; }  // 2^-53
  static constexpr double floor_() { return 1e-270; } // u times it is above the smallest double
  // A sum of two exact numbers has one rounding, of its own size: 1 - t is small near t = 1.
  [[gnu::always_inline]] static Magnitude rounded_sum(double v, const Magnitude& a,
                                                      const Magnitude& b)
  {
    const int k = longest(a.m_k, b.m_k);
    return Magnitude(v, k == 0 ? std::fabs(v) + floor_() : a.m_m + b.m_m, capped(k + 1));
  }

  // Saturates. Where everything is inlined, counts are compile-time constants.
  static constexpr int cap = 1 << 20;
  [[gnu::always_inline]] static int capped(int k) { return k < cap ? k : cap; }
  [[gnu::always_inline]] static int longest(int a, int b) { return a > b ? a : b; }

  double m_v, m_m;
  int m_k;
};

} // namespace internal

template <>
struct Number_type_traits<internal::Magnitude>
{
  using Sign = Uncertain<CGAL::Sign>;
  using Boolean = Uncertain<bool>;
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = true;
  static constexpr bool is_light = true;

  // Comparisons with NaN are false, so an overflow stays undecided.
  [[gnu::always_inline]] static Sign sign(const internal::Magnitude& x)
  {
    const double e = x.error();
    if (x.value() > e)
      return POSITIVE;
    if (x.value() < -e)
      return NEGATIVE;
    return Sign(NEGATIVE, POSITIVE);
  }
  [[gnu::always_inline]] static Boolean is_zero(const internal::Magnitude& x)
  {
    return std::fabs(x.value()) > x.error() ? Boolean(false) : Boolean::indeterminate();
  }
  static bool is_finite(const internal::Magnitude& x) { return std::isfinite(x.error()); }
};

template <>
struct Number_cast<double, internal::Magnitude>
{
  static double cast(const internal::Magnitude& x) { return x.value(); }
};

// Only doubles enter: a rational would carry a rounding of its own, which the interval stage takes.
template <class From>
struct Number_cast<internal::Magnitude, From, std::enable_if_t<!std::is_arithmetic_v<From>>>
{
  static internal::Magnitude cast(const From& x)
  {
    const std::pair<double, double> bounds = CGAL::to_interval(x);
    if (bounds.first != bounds.second)
      throw Conversion_error("the number is not a double");
    return internal::Magnitude(bounds.first);
  }
};

template <>
struct Elementary_functions<internal::Magnitude> : internal::No_ring_functions<internal::Magnitude>
{};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MAGNITUDE_H
