// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ELEMENTARY_FUNCTIONS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ELEMENTARY_FUNCTIONS_H

// sqrt, exp, log and the trigonometric functions where a number type has them.
// Intervals go through MPFI, which encloses correctly and knows the extrema of sin, cos, tan.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <mpfi.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

[[noreturn]] inline void refuse_function(const char* name)
{
  throw Not_algebraic_error(std::string("the function ") + name +
                            " has no value in this exact number type: use interval, filtered or"
                            " double");
}

// The functions of a number type that has none.
template <class NT>
struct No_functions
{
  static NT sqrt(const NT&) { refuse_function("sqrt"); }
  static NT exp(const NT&) { refuse_function("exp"); }
  static NT log(const NT&) { refuse_function("log"); }
  static NT sin(const NT&) { refuse_function("sin"); }
  static NT cos(const NT&) { refuse_function("cos"); }
  static NT tan(const NT&) { refuse_function("tan"); }
  static NT asin(const NT&) { refuse_function("asin"); }
  static NT acos(const NT&) { refuse_function("acos"); }
  static NT atan(const NT&) { refuse_function("atan"); }
  static NT pi() { refuse_function("pi"); }
};

// Whether x is the square of a rational number.
template <class Rational>
bool has_rational_root(const Rational& x, Rational& root)
{
  using Traits = Fraction_traits<Rational>;
  using Integer = typename Traits::Numerator_type;
  Integer numerator, denominator;
  typename Traits::Decompose()(x, numerator, denominator);
  typename Algebraic_structure_traits<Integer>::Sqrt isqrt;
  const Integer a = isqrt(numerator), b = isqrt(denominator);
  if (Integer(a * a) != numerator || Integer(b * b) != denominator)
    return false;
  root = typename Traits::Compose()(a, b);
  return true;
}

// One MPFI function on an interval: the doubles around it are exact ends again.
template <bool P, class Function>
Interval_nt<P> enclose(const Interval_nt<P>& x, Function function)
{
  mpfi_t y;
  mpfi_init2(y, 53);
  mpfi_interv_d(y, x.inf(), x.sup());
  function(y, y);
  mpfr_t end;
  mpfr_init2(end, 53);
  mpfi_get_left(end, y);
  const double lo = mpfr_get_d(end, MPFR_RNDD);
  mpfi_get_right(end, y);
  const double hi = mpfr_get_d(end, MPFR_RNDU);
  mpfr_clear(end);
  mpfi_clear(y);
  if (!(lo <= hi))
    return Interval_nt<P>::largest();
  return Interval_nt<P>(lo, hi);
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief provides the elementary functions of a number type.
 *
 * The static members are `sqrt`, `exp`, `log`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan` (each
 * takes and returns an `NT`) and `pi()`. The primary template is for exact fields: `sqrt()` answers
 * where the root is rational, and every other function throws `Not_algebraic_error`. There are
 * specialisations for floating point, `Interval_nt`, `CORE::Expr`, `Quadratic_field` and jets.
 *
 * The functions of intervals are those of MPFI, which encloses correctly. All headers of jets,
 * surfaces and questions therefore need MPFI to compile, also where a program computes in `double`
 * only; such a program need not be linked with it.
 *
 * \exception Not_algebraic_error where the value does not exist in `NT`
 * \exception Domain_error where the argument is certainly outside the domain
 *
 * \tparam NT a number type
 */
template <class NT>
struct Elementary_functions : internal::No_functions<NT>
{
  //! returns the square root of `x` if it is in the field.
  static NT sqrt(const NT& x)
  {
    if (CGAL::is_negative(x))
      throw Domain_error("sqrt of a negative number");
    NT root(0);
    if (!internal::has_rational_root(x, root))
      throw Not_algebraic_error("sqrt has no rational value here: name the root once in the model,"
                                " or use interval, filtered or double");
    return root;
  }
};

#ifndef DOXYGEN_RUNNING

namespace internal {

template <class FT>
struct Floating_point_functions
{
  static FT sqrt(FT x)
  {
    if (x < FT(0))
      throw Domain_error("sqrt of a negative number");
    return std::sqrt(x);
  }
  static FT exp(FT x) { return std::exp(x); }
  static FT log(FT x)
  {
    if (x <= FT(0))
      throw Domain_error("log of a number that is not positive");
    return std::log(x);
  }
  static FT sin(FT x) { return std::sin(x); }
  static FT cos(FT x) { return std::cos(x); }
  static FT tan(FT x) { return std::tan(x); }
  static FT asin(FT x) { return std::asin(unit(x, "asin")); }
  static FT acos(FT x) { return std::acos(unit(x, "acos")); }
  static FT atan(FT x) { return std::atan(x); }
  static FT pi() { return FT(3.14159265358979323846264338327950288L); }

private:
  static FT unit(FT x, const char* name)
  {
    if (x < FT(-1) || x > FT(1))
      throw Domain_error(std::string(name) + " of a number outside [-1, 1]");
    return x;
  }
};

} // namespace internal

template <> struct Elementary_functions<float> : internal::Floating_point_functions<float> {};
template <> struct Elementary_functions<double> : internal::Floating_point_functions<double> {};
template <>
struct Elementary_functions<long double> : internal::Floating_point_functions<long double> {};

template <bool P>
struct Elementary_functions<Interval_nt<P>>
{
  using NT = Interval_nt<P>;
  static NT sqrt(const NT& x)
  {
    if (x.sup() < 0)
      throw Domain_error("sqrt of a number that is certainly negative");
    return x.inf() < 0 ? NT::largest() : internal::enclose(x, mpfi_sqrt);
  }
  static NT exp(const NT& x) { return internal::enclose(x, mpfi_exp); }
  static NT log(const NT& x)
  {
    if (x.sup() <= 0)
      throw Domain_error("log of a number that is certainly not positive");
    return x.inf() <= 0 ? NT::largest() : internal::enclose(x, mpfi_log);
  }
  static NT sin(const NT& x) { return internal::enclose(x, mpfi_sin); }
  static NT cos(const NT& x) { return internal::enclose(x, mpfi_cos); }
  static NT tan(const NT& x) { return internal::enclose(x, mpfi_tan); }
  static NT asin(const NT& x) { return on_unit(x, mpfi_asin, "asin"); }
  static NT acos(const NT& x) { return on_unit(x, mpfi_acos, "acos"); }
  static NT atan(const NT& x) { return internal::enclose(x, mpfi_atan); }
  static NT pi() { return NT(3.141592653589793, 3.1415926535897936); }

private:
  template <class Function>
  static NT on_unit(const NT& x, Function function, const char* name)
  {
    if (x.sup() < -1 || x.inf() > 1)
      throw Domain_error(std::string(name) + " of a number that is certainly outside [-1, 1]");
    return x.inf() < -1 || x.sup() > 1 ? NT::largest() : internal::enclose(x, function);
  }
};

template <>
struct Elementary_functions<CORE::Expr> : internal::No_functions<CORE::Expr>
{
  static CORE::Expr sqrt(const CORE::Expr& x)
  {
    if (CGAL::is_negative(x))
      throw Domain_error("sqrt of a negative number");
    return CGAL::sqrt(x);
  }
};

#endif // DOXYGEN_RUNNING

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ELEMENTARY_FUNCTIONS_H
