// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_WIDE_INTERVAL_H
#define INTERROGATE_WIDE_INTERVAL_H

// Intervals of many digits for values that have roots outside the exact field. Exact reals would do
// as well, but take minutes to tell a nested root from zero; here a value that is zero is enclosed.

#include "evaluate_numbers.h"

#include <boost/multiprecision/mpfi.hpp>

#include <sstream>
#include <string>

namespace interrogate {

using Wide = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<0>,
                                           boost::multiprecision::et_off>;

// The ends, rounded to double in the given direction.
inline double lower_end(const Wide& x, mpfr_rnd_t rounding)
{
  return mpfr_get_d(&x.backend().data()[0].left, rounding);
}
inline double upper_end(const Wide& x, mpfr_rnd_t rounding)
{
  return mpfr_get_d(&x.backend().data()[0].right, rounding);
}

// A decimal integer, enclosed in the digits that numbers have at present.
template <class Integer>
Wide wide_integer(const Integer& n)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << n;
  return Wide(text.str().c_str());
}

inline Wide wide_rational(const Rational& x)
{
  using Traits = CGAL::Fraction_traits<Rational>;
  Traits::Numerator_type numerator;
  Traits::Denominator_type denominator;
  Traits::Decompose()(x, numerator, denominator);
  return wide_integer(numerator) / wide_integer(denominator);
}

} // namespace interrogate

namespace CGAL {
namespace Shape_interrogation {

template <>
struct Number_type_traits<interrogate::Wide>
{
  using Sign = Uncertain<CGAL::Sign>;
  using Boolean = Uncertain<bool>;
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = true;

  static Sign sign(const interrogate::Wide& x)
  {
    const double low = interrogate::lower_end(x, MPFR_RNDA);
    const double high = interrogate::upper_end(x, MPFR_RNDA); // away from zero: 0 is zero only
    if (low > 0)
      return POSITIVE;
    if (high < 0)
      return NEGATIVE;
    return low == 0 && high == 0 ? Sign(ZERO) : Sign(NEGATIVE, POSITIVE);
  }
  static Boolean is_zero(const interrogate::Wide& x)
  {
    const Sign s = sign(x);
    return s.is_certain() ? Boolean(s.make_certain() == ZERO) : Boolean::indeterminate();
  }
};

template <>
struct Number_cast<interrogate::Wide, interrogate::Quadratic>
{
  static interrogate::Wide cast(const interrogate::Quadratic& x)
  {
    const interrogate::Wide a = interrogate::wide_rational(x.rational_part());
    if (x.is_rational())
      return a;
    return a + interrogate::wide_rational(x.root_coefficient()) *
                 boost::multiprecision::sqrt(interrogate::wide_rational(x.root()));
  }
};

// Square roots of what is known not to be negative.
template <>
struct Elementary_functions<interrogate::Wide>
{
  static interrogate::Wide sqrt(interrogate::Wide x)
  {
    if (interrogate::lower_end(x, MPFR_RNDA) < 0)
      mpfr_set_zero(&x.backend().data()[0].left, 1);
    return boost::multiprecision::sqrt(x);
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // INTERROGATE_WIDE_INTERVAL_H
