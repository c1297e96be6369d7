// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_MAKE_SCALAR_H
#define INTERROGATE_MAKE_SCALAR_H

// From a number of any type to the scalar of the report, and from its decisions to the report's.

#include "Answers.h"
#include "evaluate_numbers.h"

#include <CGAL/Shape_interrogation/Number_types/reduced_square_root.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace interrogate {

inline std::string exact_text(const Rational& x)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << x;
  return out.str();
}

// a+b*sqrt(c), or the rational number. Empty where c is not proved to be square-free.
inline std::string exact_text(const Quadratic& x)
{
  const std::string a = exact_text(x.rational_part());
  if (x.is_rational())
    return a;
  if (!si::reduced_square_root(x.root()).square_free)
    return "";
  const Rational b = x.root_coefficient();
  const std::string root = exact_text(b) + "*sqrt(" + exact_text(x.root()) + ")";
  if (CGAL::is_zero(x.rational_part()))
    return root;
  return a + (CGAL::is_positive(b) ? "+" : "") + root;
}

inline Scalar make_scalar(double x)
{
  if (!std::isfinite(x))
    throw si::Limit_error("a value overflows in double");
  return Scalar{x, "", {}};
}

inline Scalar make_scalar(const Interval& x)
{
  Scalar s;
  s.interval = std::make_pair(x.inf(), x.sup());
  if (std::isfinite(x.inf()) && std::isfinite(x.sup()))
    s.approx = x.inf() / 2 + x.sup() / 2;
  return s;
}

// The two doubles around an exact real, or the one that it is.
inline std::pair<double, double> enclose(const Real& x)
{
  std::pair<double, double> ends = CGAL::to_interval(x);
  if (!std::isfinite(ends.first) || !std::isfinite(ends.second))
    return ends;
  if (x == Real(ends.first))
    return {ends.first, ends.first};
  if (x == Real(ends.second))
    return {ends.second, ends.second};
  while (std::nextafter(ends.first, ends.second) < ends.second)
  {
    const double middle = ends.first / 2 + ends.second / 2;
    const CGAL::Comparison_result side = CGAL::compare(x, Real(middle));
    if (side == CGAL::EQUAL)
      return {middle, middle};
    (side == CGAL::LARGER ? ends.first : ends.second) = middle;
  }
  return ends;
}

inline Scalar make_scalar(const Real& x)
{
  const std::pair<double, double> ends = enclose(x);
  if (ends.first == ends.second)
    return Scalar{ends.first, exact_text(Rational(ends.first)), {}};
  if (!std::isfinite(ends.first) || !std::isfinite(ends.second))
    return Scalar{{}, "", ends};
  const bool is_low = x + x < Real(ends.first) + Real(ends.second);
  return Scalar{is_low ? ends.first : ends.second, "", ends};
}

// Exact texts have a size that a reader can still take.
template <class Exact>
Scalar make_exact_scalar(const Exact& x)
{
  std::string text = exact_text(x);
  if (text.empty() || text.size() > 100000)
    return make_scalar(si::number_cast<Real>(x));
  return Scalar{si::number_cast<double>(x), std::move(text), {}};
}

inline Scalar make_scalar(const Rational& x) { return make_exact_scalar(x); }
inline Scalar make_scalar(const Quadratic& x) { return make_exact_scalar(x); }

// f(shape), a value that may have a root: in the field if it is there, else as an exact real.
template <class Shape, class F>
auto rooted(const Shape& shape, F f)
{
  return f(shape);
}

template <template <class> class Shape, class F>
auto rooted(const Shape<Quadratic>& shape, F f) -> decltype(f(shape))
{
  try
  {
    return f(shape);
  }
  catch (const si::Not_algebraic_error&) {}
  catch (const si::Mixed_roots_error&) {}
  return f(shape.template cast<Real>());
}

inline Sign_decision sign_of(CGAL::Sign sign) { return static_cast<int>(sign); }
inline Sign_decision sign_of(const CGAL::Uncertain<CGAL::Sign>& sign)
{
  return sign.is_certain() ? sign_of(sign.make_certain()) : std::nullopt;
}

inline Decision decision_of(bool b) { return b; }
inline Decision decision_of(const CGAL::Uncertain<bool>& b)
{
  return b.is_certain() ? Decision(b.make_certain()) : std::nullopt;
}

} // namespace interrogate

#endif // INTERROGATE_MAKE_SCALAR_H
