// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_EXACT_RING_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_EXACT_RING_H

// The exact ring of dyadic numbers: CGAL::Mpzf where the platform has it. It has no division, so a
// quotient throws and the filter goes on to the rationals.

#include <CGAL/Shape_interrogation/Number_types/internal/No_ring_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Mpzf.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <type_traits>
#include <utility>

#ifdef CGAL_HAS_MPZF

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Exact_ring
{
public:
  Exact_ring() : m_x(0) {}
  Exact_ring(int x) : m_x(x) {}
  Exact_ring(double x) : m_x(finite(x)) {}
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  Exact_ring(Integer x) : m_x(from_integer(x)) {}
  explicit Exact_ring(Mpzf x) : m_x(std::move(x)) {}

  const Mpzf& mpzf() const { return m_x; }
  CGAL::Sign sign() const { return CGAL::sign(m_x); }

  friend Exact_ring operator+(const Exact_ring& a) { return a; }
  friend Exact_ring operator-(const Exact_ring& a) { return Exact_ring(-a.m_x); }
  friend Exact_ring operator+(const Exact_ring& a, const Exact_ring& b)
  {
    return Exact_ring(a.m_x + b.m_x);
  }
  friend Exact_ring operator-(const Exact_ring& a, const Exact_ring& b)
  {
    return Exact_ring(a.m_x - b.m_x);
  }
  friend Exact_ring operator*(const Exact_ring& a, const Exact_ring& b)
  {
    return Exact_ring(a.m_x * b.m_x);
  }
  // Only powers of two divide, if their reciprocal is a double.
  friend Exact_ring operator/(const Exact_ring& a, const Exact_ring& b)
  {
    const double d = CGAL::to_double(b.m_x), r = 1 / d;
    int exponent;
    if (std::fabs(std::frexp(d, &exponent)) != 0.5 || !std::isfinite(r) || Mpzf(d) != b.m_x)
      throw Conversion_error("the exact ring has no such quotient");
    return Exact_ring(a.m_x * Mpzf(r));
  }
  Exact_ring& operator+=(const Exact_ring& b) { return *this = *this + b; }
  Exact_ring& operator-=(const Exact_ring& b) { return *this = *this - b; }
  Exact_ring& operator*=(const Exact_ring& b) { return *this = *this * b; }
  Exact_ring& operator/=(const Exact_ring& b) { return *this = *this / b; }
  friend std::ostream& operator<<(std::ostream& out, const Exact_ring& a) { return out << a.m_x; }

private:
  static double finite(double x)
  {
    if (!std::isfinite(x))
      throw Conversion_error("a number that is not finite has no exact value");
    return x;
  }

  // Wide integers do not fit a double: they enter as two halves.
  template <class Integer>
  static Mpzf from_integer(Integer x)
  {
    if constexpr (std::numeric_limits<Integer>::digits <= 53)
      return Mpzf(static_cast<double>(x));
    else
    {
      constexpr Integer half = Integer(1) << 32;
      return Mpzf(static_cast<double>(x / half)) * Mpzf(static_cast<double>(half)) +
             Mpzf(static_cast<double>(x % half));
    }
  }

  Mpzf m_x;
};

} // namespace internal

template <>
struct Number_type_traits<internal::Exact_ring>
{
  using Sign = CGAL::Sign;
  using Boolean = bool;
  static constexpr bool is_exact = true;
  static constexpr bool is_enclosure = false;
  static constexpr bool is_light = false;
  static Sign sign(const internal::Exact_ring& x) { return x.sign(); }
  static Boolean is_zero(const internal::Exact_ring& x) { return x.sign() == ZERO; }
  static bool is_finite(const internal::Exact_ring&) { return true; }
};

// A rational enters only if it is a double: the enclosure of the library is then a point.
template <class From>
struct Number_cast<internal::Exact_ring, From, std::enable_if_t<!std::is_arithmetic_v<From>>>
{
  static internal::Exact_ring cast(const From& x)
  {
    const std::pair<double, double> bounds = CGAL::to_interval(x);
    if (bounds.first != bounds.second)
      throw Conversion_error("the number is not a double");
    return internal::Exact_ring(bounds.first);
  }
};

template <>
struct Elementary_functions<internal::Exact_ring>
  : internal::No_ring_functions<internal::Exact_ring>
{};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_HAS_MPZF

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_EXACT_RING_H
