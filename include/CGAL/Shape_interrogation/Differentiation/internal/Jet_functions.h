// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_JET_FUNCTIONS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_JET_FUNCTIONS_H

// Elementary functions of jets: the Taylor coefficients of g at x0, then composition.
// A function known by its derivative (asin, acos, atan) is integrated from the series of it.
// Included by Jet.h at its end.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <array>

namespace CGAL {
namespace Shape_interrogation {

template <class NT, int N, int Order>
class Jet;

#ifndef DOXYGEN_RUNNING

template <class NT, int N, int Order>
struct Elementary_functions<Jet<NT, N, Order>>
{
  using J = Jet<NT, N, Order>;
  using Base = Elementary_functions<NT>;
  using Series = std::array<NT, Order + 1>;

  static J sqrt(const J& x)
  {
    const NT x0 = x.value();
    if (x.is_constant())
      return J(Base::sqrt(x0));
    if (CGAL::certainly(is_zero_decision(x0)))
      throw Domain_error("sqrt is not differentiable at zero");
    Series t;
    t[0] = Base::sqrt(x0);
    for (int k = 1; k <= Order; ++k) // t_k = t_{k-1} (3 - 2k) / (2k x0)
      t[k] = t[k - 1] * NT(3 - 2 * k) / (NT(2 * k) * x0);
    return x.compose(t);
  }
  static J exp(const J& x)
  {
    Series t;
    t[0] = Base::exp(x.value());
    for (int k = 1; k <= Order; ++k)
      t[k] = t[k - 1] / NT(k);
    return x.compose(t);
  }
  static J log(const J& x)
  {
    Series t;
    t[0] = Base::log(x.value());
    NT power = NT(1);
    for (int k = 1; k <= Order; ++k)
    {
      power = power / x.value();
      t[k] = power / NT(k % 2 ? k : -k);
    }
    return x.compose(t);
  }
  static J sin(const J& x) { return periodic(x, Base::sin(x.value()), Base::cos(x.value())); }
  static J cos(const J& x) { return periodic(x, Base::cos(x.value()), -Base::sin(x.value())); }
  static J tan(const J& x) { return sin(x) / cos(x); }
  // At the ends of the interval the functions have values but no derivatives.
  static J asin(const J& x)
  {
    const NT value = Base::asin(x.value());
    return x.is_constant() ? J(value) : integrate(x, value, arc_slope(x));
  }
  static J acos(const J& x)
  {
    const NT value = Base::acos(x.value());
    return x.is_constant() ? J(value) : integrate(x, value, -arc_slope(x));
  }
  static J atan(const J& x)
  {
    const Univariate u = Univariate::variable(0, x.value());
    const Univariate slope = (Univariate(NT(1)) + u * u).reciprocal();
    return integrate(x, Base::atan(x.value()), slope);
  }
  static J pi() { return J(Base::pi()); }

private:
  using Univariate = Jet<NT, 1, Order>;

  // a, b: the function and its derivative at x0; the series repeats with alternating signs.
  static J periodic(const J& x, const NT& a, const NT& b)
  {
    Series t;
    NT factorial = NT(1);
    for (int k = 0; k <= Order; ++k)
    {
      if (k > 0)
        factorial = factorial * NT(k);
      const NT c = k % 2 ? b : a;
      t[k] = (k / 2 % 2 ? NT(-c) : c) / factorial;
    }
    return x.compose(t);
  }

  static J integrate(const J& x, const NT& value, const Univariate& slope)
  {
    Series t;
    t[0] = value;
    for (int k = 1; k <= Order; ++k)
      t[k] = slope.coefficient(k - 1) / NT(k);
    return x.compose(t);
  }
  // 1 / sqrt(1 - u^2), the derivative of asin
  static Univariate arc_slope(const J& x)
  {
    const Univariate u = Univariate::variable(0, x.value());
    const Univariate one(NT(1));
    return Elementary_functions<Univariate>::sqrt(one - u * u).reciprocal();
  }
};

// Unqualified calls in a user's functor find these by the type of the argument.
template <class NT, int N, int O>
Jet<NT, N, O> sqrt(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::sqrt(x); }
template <class NT, int N, int O>
Jet<NT, N, O> exp(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::exp(x); }
template <class NT, int N, int O>
Jet<NT, N, O> log(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::log(x); }
template <class NT, int N, int O>
Jet<NT, N, O> sin(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::sin(x); }
template <class NT, int N, int O>
Jet<NT, N, O> cos(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::cos(x); }
template <class NT, int N, int O>
Jet<NT, N, O> tan(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::tan(x); }
template <class NT, int N, int O>
Jet<NT, N, O> asin(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::asin(x); }
template <class NT, int N, int O>
Jet<NT, N, O> acos(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::acos(x); }
template <class NT, int N, int O>
Jet<NT, N, O> atan(const Jet<NT, N, O>& x) { return Elementary_functions<Jet<NT, N, O>>::atan(x); }
template <class NT, int N, int O>
Jet<NT, N, O> square(const Jet<NT, N, O>& x) { return x * x; }
template <class NT, int N, int O>
Jet<NT, N, O> pow(const Jet<NT, N, O>& x, int n)
{
  Jet<NT, N, O> power(NT(1)), square = x;
  for (unsigned k = n < 0 ? 0u - static_cast<unsigned>(n) : n; k != 0; k /= 2, square *= square)
    if (k % 2 != 0)
      power *= square;
  return n < 0 ? power.reciprocal() : power;
}

// A jet decides like its value; only structural questions are asked of it.
template <class NT, int N, int Order>
struct Number_type_traits<Jet<NT, N, Order>>
{
  using Sign = typename Number_type_traits<NT>::Sign;
  using Boolean = typename Number_type_traits<NT>::Boolean;
  static constexpr bool is_exact = Number_type_traits<NT>::is_exact;
  static constexpr bool is_enclosure = Number_type_traits<NT>::is_enclosure;
  static constexpr bool is_light = Number_type_traits<NT>::is_light;
  static Sign sign(const Jet<NT, N, Order>& x) { return sign_decision(x.value()); }
  static Boolean is_zero(const Jet<NT, N, Order>& x) { return is_zero_decision(x.value()); }
  static bool is_finite(const Jet<NT, N, Order>& x)
  {
    return Number_type_traits<NT>::is_finite(x.value());
  }
};

template <class NT, int N, int Order, class From>
struct Number_cast<Jet<NT, N, Order>, From>
{
  static Jet<NT, N, Order> cast(const From& x)
  {
    return Jet<NT, N, Order>(number_cast<NT>(x));
  }
};

#endif // DOXYGEN_RUNNING

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_JET_FUNCTIONS_H
