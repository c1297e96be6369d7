// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_CAST_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_CAST_H

// Conversions between number types that are exact, or enclose, or (to double) approximate.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <class T> struct Is_interval : std::false_type {};
template <bool P> struct Is_interval<Interval_nt<P>> : std::true_type {};

// The double nearest to an exact number (ties to the even neighbour are not broken: either may
// come); infinite beyond the largest double. The enclosure of the library is narrowed by exact
// comparisons until it is one step wide; it may be as wide as the line.
template <class Exact>
double nearest_double(const Exact& x)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  const std::pair<double, double> enclosure = CGAL::to_interval(x);
  if (enclosure.first == enclosure.second)
    return enclosure.first;
  double lo = (std::max)(enclosure.first, -largest), hi = (std::min)(enclosure.second, largest);
  if (Exact(hi) < x || x < Exact(lo))
    return Exact(hi) < x ? HUGE_VAL : -HUGE_VAL;
  while (std::nextafter(lo, hi) < hi)
  {
    const double middle = lo / 2 + hi / 2;
    const bool between = lo < middle && middle < hi; // not so among the smallest numbers
    const double cut = between ? middle : std::nextafter(lo, hi);
    (Exact(cut) <= x ? lo : hi) = cut;
  }
  const Exact twice = x + x;
  const Exact sum = Exact(lo) + Exact(hi);
  return twice < sum ? lo : hi;
}

// The rational as GMP has it, for the types that show it.
template <class T>
auto gmp_rational(const T& x) -> decltype(x.get_mpq_t()) { return x.get_mpq_t(); }
template <class T>
auto gmp_rational(const T& x) -> decltype(x.mpq()) { return x.mpq(); }

// The narrowest interval around the quotient of two integers that are doubles. The remainder of a
// quotient is a double, whatever the rounding mode, and its sign tells on which side the quotient
// is.
inline bool enclose_small_quotient(mpq_srcptr x, double& lo, double& hi)
{
  if (mpz_sizeinbase(mpq_numref(x), 2) > 53 || mpz_sizeinbase(mpq_denref(x), 2) > 53)
    return false;
  const double n = mpz_get_d(mpq_numref(x)), d = mpz_get_d(mpq_denref(x));
  lo = hi = n / d;
  const double remainder = d == 1 ? 0 : std::fma(lo, d, -n);
  if (remainder > 0)
    lo = std::nextafter(hi, -HUGE_VAL);
  else if (remainder < 0)
    hi = std::nextafter(lo, HUGE_VAL);
  return true;
}

template <class Exact, class = void> struct Is_gmp_rational : std::false_type {};
template <class Exact>
struct Is_gmp_rational<Exact, std::void_t<decltype(gmp_rational(std::declval<const Exact&>()))>>
  : std::true_type
{};

// A double between the ends; infinite ends count as the largest double.
inline double middle(double lo, double hi)
{
  constexpr double largest = (std::numeric_limits<double>::max)();
  lo = (std::max)(lo, -largest);
  hi = (std::min)(hi, largest);
  // The width of large intervals overflows, and half of the smallest numbers is not exact.
  const bool is_large = lo < -largest / 2 || hi > largest / 2;
  const double between = is_large ? lo / 2 + hi / 2 : lo + (hi - lo) / 2;
  return (std::min)(between, hi); // when rounding upward
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief converts one number type to another; a number type joins by specialising it.
 *
 * The static member `cast()` must return the exact value, or an enclosure of it when `To` is an
 * enclosure. To `double` it returns a nearest double for `Exact_rational`, `CORE::Expr` and
 * `Quadratic_field`, the middle of an interval (with the largest double in place of infinite ends),
 * and what `CGAL::to_double()` returns for other types, exact ones too.
 *
 * \tparam To the target
 * \tparam From the source
 */
template <class To, class From, class Enable = void>
struct Number_cast
{
  //! converts.
  static To cast(const From& x) { return To(x); }
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief returns `x` as a number of type `To`: exactly, enclosed, or (to `double`) approximately,
 * see `Number_cast`.
 * \exception Conversion_error if `To` has no such number
 */
template <class To, class From>
inline To number_cast(const From& x)
{
  if constexpr (std::is_same_v<To, From>)
    return x;
  else
    return Number_cast<To, From>::cast(x);
}

#ifndef DOXYGEN_RUNNING

// Anything to double.
template <class From>
struct Number_cast<double, From, std::enable_if_t<!std::is_arithmetic_v<From>>>
{
  static double cast(const From& x)
  {
    if constexpr (internal::Is_interval<From>::value)
      return internal::middle(x.inf(), x.sup());
    else if constexpr (std::is_same_v<From, CGAL::Exact_rational> ||
                       std::is_same_v<From, CORE::Expr>)
      return internal::nearest_double(x);
    else
      return CGAL::to_double(x);
  }
};

// Exact numbers to an interval; doubles and ints are points.
template <bool P, class From>
struct Number_cast<Interval_nt<P>, From, std::enable_if_t<!std::is_arithmetic_v<From>>>
{
  static Interval_nt<P> cast(const From& x)
  {
    if constexpr (internal::Is_gmp_rational<From>::value)
    {
      double lo, hi;
      if (internal::enclose_small_quotient(internal::gmp_rational(x), lo, hi))
        return Interval_nt<P>(lo, hi);
    }
    return Interval_nt<P>(CGAL::to_interval(x));
  }
};

// There is no enclosure of what is not a number, and the library asserts that there is none of the
// infinite.
template <bool P, class Real>
struct Number_cast<Interval_nt<P>, Real, std::enable_if_t<std::is_floating_point_v<Real>>>
{
  static Interval_nt<P> cast(Real x)
  {
    if (!std::isfinite(x))
      throw Conversion_error("a number is not finite: coordinates and coefficients must be");
    return Interval_nt<P>(x);
  }
};

// Not every rational has constructors for the widest integers: they enter as two halves.
template <class Integer>
struct Number_cast<CGAL::Exact_rational, Integer, std::enable_if_t<std::is_integral_v<Integer>>>
{
  static CGAL::Exact_rational cast(Integer x)
  {
    static_assert(std::numeric_limits<Integer>::digits <= 64, "an integer of at most 64 bits");
    if constexpr (std::numeric_limits<Integer>::digits <= std::numeric_limits<int>::digits)
      return CGAL::Exact_rational(static_cast<int>(x));
    else if constexpr (std::numeric_limits<Integer>::digits <= 53)
      return CGAL::Exact_rational(static_cast<double>(x));
    else
    {
      constexpr Integer half = Integer(1) << 32;
      const CGAL::Exact_rational high(static_cast<double>(x / half));
      const CGAL::Exact_rational low(static_cast<double>(x % half));
      return high * CGAL::Exact_rational(static_cast<double>(half)) + low;
    }
  }
};

// GMP aborts the program for values that are not finite.
template <>
struct Number_cast<CGAL::Exact_rational, double>
{
  static CGAL::Exact_rational cast(double x)
  {
    if (!std::isfinite(x))
      throw Conversion_error("a number is not finite: coordinates and coefficients must be");
    return CGAL::Exact_rational(x);
  }
};

template <>
struct Number_cast<CORE::Expr, double>
{
  static CORE::Expr cast(double x)
  {
    if (!std::isfinite(x))
      throw Conversion_error("a number is not finite: coordinates and coefficients must be");
    return CORE::Expr(x);
  }
};

// The exact real reads a rational through its decimal text: its own constructors know no GMP types.
template <>
struct Number_cast<CORE::Expr, CGAL::Exact_rational>
{
  static CORE::Expr cast(const CGAL::Exact_rational& x)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << x;
    return CORE::Expr(CORE::BigRat(text.str()));
  }
};

// Wide integers do not fit a double, and the constructors of the interval enclose them only while
// rounding upward.
template <bool P, class Integer>
struct Number_cast<Interval_nt<P>, Integer,
                   std::enable_if_t<std::is_integral_v<Integer> &&
                                    (std::numeric_limits<Integer>::digits > 53)>>
{
  static Interval_nt<P> cast(Integer x)
  {
    return Interval_nt<P>(CGAL::to_interval(number_cast<CGAL::Exact_rational>(x)));
  }
};

#endif // DOXYGEN_RUNNING

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_CAST_H
