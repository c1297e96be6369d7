// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_DECIMAL_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_DECIMAL_H

// Decimal numerals, read exactly: 0.1 is 1/10. Independent of the locale.

#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/simplify_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads digits from the front of `text` and returns them.
inline std::string_view take_digits(std::string_view& text)
{
  std::size_t n = 0;
  while (n < text.size() && is_digit(text[n]))
    ++n;
  const std::string_view digits = text.substr(0, n);
  text.remove_prefix(n);
  return digits;
}

inline bool take_one_of(std::string_view& text, std::string_view characters)
{
  if (text.empty() || characters.find(text.front()) == std::string_view::npos)
    return false;
  text.remove_prefix(1);
  return true;
}

// An integer from its digits, nine at a time.
inline CGAL::Exact_rational integer_from_digits(std::string_view digits)
{
  CGAL::Exact_rational value(0);
  while (!digits.empty())
  {
    const std::string_view part = digits.substr(0, 9);
    int chunk = 0, scale = 1;
    for (const char c : part)
    {
      chunk = 10 * chunk + (c - '0');
      scale *= 10;
    }
    value = CGAL::Exact_rational(value * CGAL::Exact_rational(scale) + CGAL::Exact_rational(chunk));
    digits.remove_prefix(part.size());
  }
  return value;
}

inline int bounded_exponent(std::string_view digits, std::size_t limit)
{
  std::size_t value = 0;
  for (const char c : digits)
  {
    value = 10 * value + static_cast<std::size_t>(c - '0');
    if (value > limit)
      throw Limit_error("the decimal exponent of a number is beyond " + std::to_string(limit));
  }
  return static_cast<int>(value);
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief reads a decimal numeral exactly: digits, with an optional sign, point and exponent.
 *
 * \details `-12`, `0.1` (which is 1/10), `.5`, `1e-9` and `1.5E+3` are numerals; blanks are not
 * allowed. Every JSON number is a numeral.
 *
 * \param text the whole numeral
 * \param limits bounds for the digits and for the exponent
 * \return the number, or nothing if the text is not a numeral
 * \exception Limit_error if a limit is exceeded
 */
inline std::optional<CGAL::Exact_rational>
parse_decimal(std::string_view text, const Expression_limits& limits = Expression_limits())
{
  const bool negative = !text.empty() && text.front() == '-';
  internal::take_one_of(text, "+-");
  const std::string_view whole = internal::take_digits(text);
  const bool point = internal::take_one_of(text, ".");
  const std::string_view fraction = point ? internal::take_digits(text) : std::string_view();
  if (whole.empty() && fraction.empty())
    return std::nullopt;
  if (whole.size() + fraction.size() > limits.digits)
    throw Limit_error("a number has more than " + std::to_string(limits.digits) + " digits");
  int exponent = 0;
  if (internal::take_one_of(text, "eE"))
  {
    const bool down = !text.empty() && text.front() == '-';
    internal::take_one_of(text, "+-");
    const std::string_view digits = internal::take_digits(text);
    if (digits.empty())
      return std::nullopt;
    exponent = internal::bounded_exponent(digits, limits.decimal_exponent);
    exponent = down ? -exponent : exponent;
  }
  if (!text.empty())
    return std::nullopt;
  const CGAL::Exact_rational digits =
    internal::integer_from_digits(std::string(whole) + std::string(fraction));
  const CGAL::Exact_rational scale = internal::constant_power(
    CGAL::Exact_rational(10), exponent - static_cast<int>(fraction.size()));
  const CGAL::Exact_rational value(digits * scale);
  return negative ? CGAL::Exact_rational(-value) : value;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_DECIMAL_H
