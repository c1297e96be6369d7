// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_REFUSE_H
#define CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_REFUSE_H

// The common ways to a refusal: a number that must not be zero, one that must be, an exception of
// the number type. All representations phrase them here.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <cstddef>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A number as evidence: shortened, because exact numbers can have thousands of digits.
template <class NT>
std::string text_of(const NT& x)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << x;
  std::string text = out.str();
  if (text.size() > 80)
    text = text.substr(0, 40) + "... (" + std::to_string(text.size()) + " characters)";
  return text;
}

// The slow sides are kept out of line, so that the evaluation around them stays small.
template <class NT>
[[gnu::noinline, gnu::cold]] Refusal zero_refusal(const NT& x, Refusal_code code, const char* what)
{
  const auto zero = is_zero_decision(x);
  if (CGAL::certainly(zero))
    return Refusal(code, std::string(what) + " is zero");
  if (CGAL::certainly(!zero))
    return Refusal(Refusal_code::LIMIT_EXCEEDED, std::string(what) + " overflows");
  return Refusal(Refusal_code::UNDECIDED,
                 std::string("it is undecided whether ") + what + " is zero: " + text_of(x));
}

template <class NT>
[[gnu::noinline, gnu::cold]] Refusal nonzero_refusal(const NT& x, Refusal_code code,
                                                     const char* what)
{
  if (!Number_type_traits<NT>::is_finite(x))
    return Refusal(Refusal_code::LIMIT_EXCEEDED, std::string(what) + " overflows");
  return Refusal(code, std::string(what) + " is " + text_of(x) + ", not 0");
}

// Refuses when x is zero, or when that is undecided.
template <class NT>
std::optional<Refusal> refuse_zero(const NT& x, Refusal_code code, const char* what)
{
  if (CGAL::certainly(!is_zero_decision(x)) && Number_type_traits<NT>::is_finite(x))
    return std::nullopt;
  return zero_refusal(x, code, what);
}

// Refuses when x is certainly not zero. Only enclosures and exact types can claim that.
template <class NT>
std::optional<Refusal> refuse_nonzero(const NT& x, Refusal_code code, const char* what)
{
  if constexpr (Number_type_traits<NT>::is_exact || Number_type_traits<NT>::is_enclosure)
  {
    if (CGAL::possibly(is_zero_decision(x)))
      return std::nullopt;
  }
  else if (Number_type_traits<NT>::is_finite(x))
    return std::nullopt;
  return nonzero_refusal(x, code, what);
}

// Refuses coordinates in floating point that are no numbers: equations that do not depend on them
// would not tell.
template <class NT>
std::optional<Refusal> refuse_not_finite(const std::vector<NT>& point,
                                         const std::vector<std::string>& names)
{
  if constexpr (std::is_floating_point_v<NT>)
    for (std::size_t i = 0; i < point.size(); ++i)
      if (!Number_type_traits<NT>::is_finite(point[i]))
        return Refusal(Refusal_code::LIMIT_EXCEEDED,
                       "the coordinate " + names[i] + " of the point is not finite");
  return std::nullopt;
}

// Runs an evaluation whose number type may throw, and turns what it throws into a refusal.
template <class T, class Evaluation>
Result<T> refuse_errors(Evaluation evaluation)
{
  try
  {
    return evaluation();
  }
  catch (const Not_algebraic_error& e) { return Refusal(Refusal_code::NOT_ALGEBRAIC, e.what()); }
  catch (const Mixed_roots_error& e) { return Refusal(Refusal_code::NOT_ALGEBRAIC, e.what()); }
  catch (const Division_by_zero_error& e) { return Refusal(Refusal_code::POLE, e.what()); }
  catch (const Domain_error& e) { return Refusal(Refusal_code::OUTSIDE_DOMAIN, e.what()); }
  catch (const Limit_error& e) { return Refusal(Refusal_code::LIMIT_EXCEEDED, e.what()); }
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_REFUSE_H
