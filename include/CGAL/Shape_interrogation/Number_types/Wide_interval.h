// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_INTERVAL_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_INTERVAL_H

// Intervals with ends of as many bits as are asked for, by MPFI.

#include <CGAL/Shape_interrogation/Number_types/Answer_union.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Number_types/Wide_precision.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Mpfi_functions.h>
#include <CGAL/Shape_interrogation/Number_types/internal/mpfi_helpers.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <mpfi.h>

#include <cmath>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is an interval whose ends have as many bits as the thread has asked for.
 *
 * Every operation encloses its result in the precision that is in force in the thread when it is
 * carried out: see `Wide_precision`. Copies and assignments keep the value and its precision.
 * Conversions enclose; from `int` and `double` they are exact from 53 bits on. It is a field number
 * type that decides as `CGAL::Interval_nt` does, with `Uncertain` decisions, and has all elementary
 * functions. The rounding mode of the processor has no influence on it.
 *
 * What double precision leaves undecided is decided here, if it is not zero, at a cost that grows
 * slowly with the bits. A value that is exactly zero stays undecided in every precision, unless the
 * operations happen to be exact.
 */
class Wide_interval
{
public:
  /// \name Construction
  /// @{
  Wide_interval() : Wide_interval(0) {} //!< constructs zero.
  Wide_interval(int x) : Wide_interval(Uninitialised()) { mpfi_set_si(m_x, x); } //!< encloses `x`.
  //! encloses `x`; one that is not finite by the whole line.
  Wide_interval(double x) : Wide_interval(Uninitialised())
  {
    if (std::isfinite(x))
      mpfi_set_d(m_x, x);
    else
      mpfi_interv_d(m_x, -HUGE_VAL, HUGE_VAL);
  }
  //! encloses the interval; one that is not valid by the whole line.
  template <bool P>
  explicit Wide_interval(const Interval_nt<P>& x) : Wide_interval(Uninitialised())
  {
    const bool is_valid = x.inf() <= x.sup() && x.inf() < HUGE_VAL && x.sup() > -HUGE_VAL;
    mpfi_interv_d(m_x, is_valid ? x.inf() : -HUGE_VAL, is_valid ? x.sup() : HUGE_VAL);
  }
  //! encloses `x`.
  explicit Wide_interval(const CGAL::Exact_rational& x) : Wide_interval(Uninitialised())
  {
    internal::mpfi_set_rational(m_x, x);
  }

  //! copies with all bits.
  Wide_interval(const Wide_interval& x)
  {
    mpfi_init2(m_x, mpfi_get_prec(x.m_x));
    mpfi_set(m_x, x.m_x);
  }
  //! copies with all bits.
  Wide_interval& operator=(const Wide_interval& x)
  {
    if (this != &x)
    {
      if (mpfi_get_prec(m_x) != mpfi_get_prec(x.m_x))
        mpfi_set_prec(m_x, mpfi_get_prec(x.m_x));
      mpfi_set(m_x, x.m_x);
    }
    return *this;
  }
  //! takes the value over.
  Wide_interval(Wide_interval&& x) noexcept
  {
    mpfi_init2(m_x, 2);
    mpfi_swap(m_x, x.m_x);
  }
  //! takes the value over.
  Wide_interval& operator=(Wide_interval&& x) noexcept
  {
    mpfi_swap(m_x, x.m_x);
    return *this;
  }
  ~Wide_interval() { mpfi_clear(m_x); } //!< frees the memory.
  /// @}

  /// \name Arithmetic
  /// @{

  //! adds.
  friend Wide_interval operator+(const Wide_interval& a, const Wide_interval& b)
  { return result([&](mpfi_ptr r) { mpfi_add(r, a.m_x, b.m_x); }); }
  //! subtracts.
  friend Wide_interval operator-(const Wide_interval& a, const Wide_interval& b)
  { return result([&](mpfi_ptr r) { mpfi_sub(r, a.m_x, b.m_x); }); }
  //! multiplies; a square is not negative.
  friend Wide_interval operator*(const Wide_interval& a, const Wide_interval& b)
  {
    return &a == &b ? result([&](mpfi_ptr r) { mpfi_sqr(r, a.m_x); })
                    : result([&](mpfi_ptr r) { mpfi_mul(r, a.m_x, b.m_x); });
  }
  //! divides; a divisor that contains zero gives the whole line.
  friend Wide_interval operator/(const Wide_interval& a, const Wide_interval& b)
  {
    return result([&](mpfi_ptr r) {
      if (mpfi_has_zero(b.m_x))
        mpfi_interv_d(r, -HUGE_VAL, HUGE_VAL);
      else
        mpfi_div(r, a.m_x, b.m_x);
    });
  }
  //! negates.
  Wide_interval operator-() const { return result([this](mpfi_ptr r) { mpfi_neg(r, m_x); }); }
  Wide_interval& operator+=(const Wide_interval& x) { return *this = *this + x; } //!< adds.
  Wide_interval& operator-=(const Wide_interval& x) { return *this = *this - x; } //!< subtracts.
  Wide_interval& operator*=(const Wide_interval& x) { return *this = *this * x; } //!< multiplies.
  Wide_interval& operator/=(const Wide_interval& x) { return *this = *this / x; } //!< divides.
  /// @}

  /// \name Access
  /// @{

  //! returns the sign, which is uncertain if the interval contains zero and more.
  Uncertain<CGAL::Sign> sign() const
  {
    if (mpfi_nan_p(m_x))
      return {CGAL::NEGATIVE, CGAL::POSITIVE};
    return {CGAL::sign(mpfr_sgn(&m_x->left)), CGAL::sign(mpfr_sgn(&m_x->right))};
  }
  //! tells whether both ends are finite.
  bool is_finite() const { return mpfi_bounded_p(m_x) != 0; }
  //! returns the ends as doubles in the given direction of rounding, outward by default.
  std::pair<double, double> ends(mpfr_rnd_t low = MPFR_RNDD, mpfr_rnd_t high = MPFR_RNDU) const
  {
    return {mpfr_get_d(&m_x->left, low), mpfr_get_d(&m_x->right, high)};
  }
  //! returns a point of the interval near its middle, without width, in the precision of the
  //! interval; of one without a lower or an upper bound some point of it.
  Wide_interval middle() const { return point(internal::mpfi_middle, mpfi_get_prec(m_x)); }
  //! returns the width, rounded up, as an interval without width; infinite without bounds.
  Wide_interval width() const { return point(mpfi_diam_abs, Wide_precision::bits()); }
  //! returns the hull of both intervals.
  friend Wide_interval hull(const Wide_interval& a, const Wide_interval& b)
  { return result([&](mpfi_ptr r) { mpfi_union(r, a.m_x, b.m_x); }); }
  //! takes the common part with `x`; returns false, without a meaningful value, if there is none.
  bool intersect(const Wide_interval& x)
  {
    Wide_interval common{Uninitialised()};
    mpfi_intersect(common.m_x, m_x, x.m_x);
    *this = std::move(common);
    return mpfi_is_empty(m_x) == 0;
  }
  //! returns `f` of the interval, where `f` is a function of MPFI.
  template <class Function>
  Wide_interval apply(Function f) const { return result([&](mpfi_ptr r) { f(r, m_x); }); }
  //! prints the ends.
  friend std::ostream& operator<<(std::ostream& out, const Wide_interval& x)
  {
    const std::pair<double, double> e = x.ends();
    return out << '[' << e.first << ';' << e.second << ']';
  }
  /// @}

private:
  struct Uninitialised {};
  explicit Wide_interval(Uninitialised, mpfr_prec_t bits = Wide_precision::bits())
  {
    mpfi_init2(m_x, bits);
  }

  // What has no value is enclosed by the whole line.
  template <class Operation>
  static Wide_interval result(Operation operation)
  {
    Wide_interval r{Uninitialised()};
    operation(r.m_x);
    if (mpfi_nan_p(r.m_x))
      mpfi_interv_d(r.m_x, -HUGE_VAL, HUGE_VAL);
    return r;
  }

  // The number that f makes of this interval.
  template <class Function>
  Wide_interval point(Function f, mpfr_prec_t bits) const
  {
    Wide_interval p(Uninitialised(), bits);
    f(&p.m_x->left, m_x);
    mpfr_set(&p.m_x->right, &p.m_x->left, MPFR_RNDN);
    return p;
  }

  mpfi_t m_x;
};

#ifndef DOXYGEN_RUNNING

template <>
struct Number_type_traits<Wide_interval>
{
  using Sign = Uncertain<CGAL::Sign>;
  using Boolean = Uncertain<bool>;
  static constexpr bool is_exact = false;
  static constexpr bool is_light = false;
  static constexpr bool is_enclosure = true;

  static Sign sign(const Wide_interval& x) { return x.sign(); }
  static Boolean is_zero(const Wide_interval& x) { return x.sign() == CGAL::ZERO; }
  static bool is_finite(const Wide_interval& x) { return x.is_finite(); }
};

template <>
struct Answer_union<Wide_interval>
{
  static Wide_interval of(const Wide_interval& a, const Wide_interval& b) { return hull(a, b); }
};

template <>
struct Number_cast<double, Wide_interval>
{
  static double cast(const Wide_interval& x)
  {
    const std::pair<double, double> e = x.ends();
    return std::isfinite(e.first) && std::isfinite(e.second)
      ? x.middle().ends(MPFR_RNDN).first
      : internal::middle(e.first, e.second);
  }
};

template <bool P>
struct Number_cast<Interval_nt<P>, Wide_interval>
{
  static Interval_nt<P> cast(const Wide_interval& x)
  {
    const std::pair<double, double> e = x.ends();
    return e.first <= e.second ? Interval_nt<P>(e) : Interval_nt<P>::largest();
  }
};

template <>
struct Number_cast<Wide_interval, Quadratic_field>
{
  static Wide_interval cast(const Quadratic_field& x)
  {
    const Wide_interval a(x.rational_part());
    if (x.is_rational())
      return a;
    return a + Wide_interval(x.root_coefficient()) * Wide_interval(x.root()).apply(mpfi_sqrt);
  }
};

template <>
struct Elementary_functions<Wide_interval> : internal::Mpfi_functions<Wide_interval> {};

#endif // DOXYGEN_RUNNING

namespace internal {

// What rounding put below zero is cut off.
template <>
inline Wide_interval nonnegative_part(const Wide_interval& x)
{
  Wide_interval cut = x;
  return cut.intersect(Wide_interval(Interval_nt<false>(0, HUGE_VAL))) ? cut : Wide_interval(0);
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_INTERVAL_H
