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

#include <CGAL/Shape_interrogation/Number_types/Wide_interval.h>
#include <CGAL/Shape_interrogation/Number_types/reduced_square_root.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace interrogate {

// For values that have roots outside the exact field. Exact reals would do as well, but take
// minutes to tell a nested root from zero; here a value that is zero is enclosed.
using Wide = si::Wide_interval;

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
  return Scalar{x + 0.0, "", {}}; // no -0
}

inline Scalar make_scalar(const Interval& x)
{
  Scalar s;
  s.interval = std::make_pair(x.inf(), x.sup());
  if (std::isfinite(x.inf()) && std::isfinite(x.sup()))
    s.approx = x.inf() / 2 + x.sup() / 2 + 0.0; // no -0
  return s;
}

// Without `approx` where the ends have different nearest doubles.
inline Scalar make_scalar(const Wide& x)
{
  const std::pair<double, double> ends = si::number_cast<Interval>(x).pair();
  const auto [low, high] = x.ends(MPFR_RNDN, MPFR_RNDN);
  if (ends.first == ends.second)
    return Scalar{low + 0.0, exact_text(Rational(low)), {}}; // no -0
  if (low != high || !std::isfinite(low))
    return Scalar{{}, "", ends};
  return Scalar{low + 0.0, "", ends};
}

inline bool is_sharp(const Scalar& s) { return s.approx.has_value(); }
template <class T, std::size_t n>
bool is_sharp(const std::array<T, n>& values)
{
  return std::all_of(values.begin(), values.end(), [](const T& x) { return is_sharp(x); });
}
template <class T>
bool is_sharp(const std::optional<T>& value) { return value && is_sharp(*value); }

// Approximates what could not be made sharp: zeros, which no enclosure can tell.
inline void approximate(Scalar& s)
{
  if (s.approx || !std::isfinite(s.interval->first) || !std::isfinite(s.interval->second))
    return;
  const bool has_zero = s.interval->first <= 0 && s.interval->second >= 0;
  s.approx = has_zero ? 0.0 : s.interval->first / 2 + s.interval->second / 2;
}
template <class T, std::size_t n>
void approximate(std::array<T, n>& values)
{
  for (T& x : values)
    approximate(x);
}
template <class T>
void approximate(std::optional<T>& value)
{
  if (value)
    approximate(*value);
}

// The answer in intervals of as many digits as the nearest doubles need.
template <class Ask>
auto ask_sharply(Ask ask)
{
  const int most_bits = 2176;
  for (int bits = 136;; bits *= 2)
  {
    const si::Wide_precision precision(bits);
    auto answer = ask();
    if (bits < most_bits && !is_sharp(answer))
      continue;
    approximate(answer);
    return answer;
  }
}

// Exact texts have a size that a reader can still take.
constexpr std::size_t longest_text = 100000;

inline Scalar make_scalar(const Rational& x)
{
  const double approx = si::number_cast<double>(x) + 0.0; // no -0
  std::string text = exact_text(x);
  if (text.size() > longest_text)
    return Scalar{approx, "", CGAL::to_interval(x)};
  return Scalar{approx, std::move(text), {}};
}

inline Scalar make_scalar(const Quadratic& x)
{
  if (x.is_rational())
    return make_scalar(x.rational_part());
  const Scalar s = ask_sharply([&x] { return make_scalar(si::number_cast<Wide>(x)); });
  std::string text = exact_text(x);
  if (!text.empty() && text.size() <= longest_text)
    return Scalar{s.approx, std::move(text), {}};
  return s;
}

// f(shape), values that may have roots: in the field if they are there, else as intervals.
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
  return ask_sharply([&] { return f(shape.template cast<Wide>()); });
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
