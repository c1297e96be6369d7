// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_NUMBER_SIZE_H
#define INTERROGATE_NUMBER_SIZE_H

// A number type that knows only how many bits an exact number would have, and adds up the bits of
// all that were made. A model is run with it before it is run exactly.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interrogate {

// Powers of one common denominator meet in a sum without growing. Denominators that come from
// quotients and from constants may all be different, and add up; those of decimals do not.
class Number_size
{
public:
  Number_size() : Number_size(0) {}
  Number_size(int x) : m_powers(1 + std::log2(1 + std::fabs(x))), m_other(0) {}
  explicit Number_size(double x)
    : m_powers(x == std::floor(x) ? 1 + std::log2(1 + std::fabs(x)) : 53), m_other(0)
  {}
  explicit Number_size(const CGAL::Exact_rational& x)
  {
    using Traits = CGAL::Fraction_traits<CGAL::Exact_rational>;
    Traits::Numerator_type numerator, denominator;
    Traits::Decompose()(x, numerator, denominator);
    m_powers = bits_of(numerator) + bits_of(denominator);
    for (const int p : {2, 5})
      while (CGAL::mod(denominator, Traits::Numerator_type(p)) == 0)
        denominator = CGAL::div(denominator, Traits::Numerator_type(p));
    m_other = denominator == 1 ? 0 : bits_of(denominator);
  }

  double bits() const { return m_powers + m_other; }

  static double& total_bits()
  {
    static thread_local double total = 0;
    return total;
  }

  friend Number_size operator-(const Number_size& a) { return a; }
  friend Number_size operator+(const Number_size& a, const Number_size& b)
  {
    return made((std::max)(a.m_powers, b.m_powers) + 1, a.m_other + b.m_other);
  }
  friend Number_size operator-(const Number_size& a, const Number_size& b) { return a + b; }
  friend Number_size operator*(const Number_size& a, const Number_size& b)
  {
    return made(a.m_powers + b.m_powers, a.m_other + b.m_other);
  }
  friend Number_size operator/(const Number_size& a, const Number_size& b)
  {
    return made(a.m_powers, a.m_other + b.bits());
  }
  Number_size& operator+=(const Number_size& b) { return *this = *this + b; }

private:
  template <class Integer>
  static double bits_of(const Integer& n)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << n;
    return 3.33 * static_cast<double>(text.str().size());
  }

  Number_size(double powers, double other) : m_powers(powers), m_other(other) {}

  static Number_size made(double powers, double other)
  {
    const Number_size size(powers, other);
    total_bits() += size.bits();
    return size;
  }

  double m_powers, m_other;
};

} // namespace interrogate

namespace CGAL {
namespace Shape_interrogation {

template <>
struct Number_type_traits<interrogate::Number_size>
{
  using Boolean = Uncertain<bool>;
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = true;
  static Boolean is_zero(const interrogate::Number_size&) { return Boolean::indeterminate(); }
};

// Whether the function exists in the exact type is not asked here.
template <>
struct Elementary_functions<interrogate::Number_size>
{
  using NT = interrogate::Number_size;
  static NT sqrt(const NT& x) { return x; }
  static NT exp(const NT& x) { return x; }
  static NT log(const NT& x) { return x; }
  static NT sin(const NT& x) { return x; }
  static NT cos(const NT& x) { return x; }
  static NT tan(const NT& x) { return x; }
  static NT asin(const NT& x) { return x; }
  static NT acos(const NT& x) { return x; }
  static NT atan(const NT& x) { return x; }
  static NT pi() { return NT(1); }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // INTERROGATE_NUMBER_SIZE_H
