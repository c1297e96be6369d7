// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_ERROR_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_ERROR_H

// An error in a text, with its place and a picture of it.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief is thrown when a text is not an expression, or exceeds a limit.
 *
 * \details `what()` shows the line with a caret under the place, and the message:
 * \code
 * x^2 + * y
 *       ^ expected a number, a name or '(' (line 1, column 7)
 * \endcode
 */
class Parse_error : public Shape_error
{
public:
  //! constructs the error for the place `offset` of `text`.
  Parse_error(const std::string& message, std::string_view text, std::size_t offset)
    : Parse_error(message, text, offset, place_of(text, offset))
  {}

  //! returns what is wrong, without the place.
  const std::string& message() const { return m_message; }
  //! returns the place as a number of bytes from the beginning.
  std::size_t offset() const { return m_offset; }
  //! returns the line of the place, counted from 1.
  std::size_t line() const { return m_line; }
  //! returns the column of the place in characters (of UTF-8), counted from 1.
  std::size_t column() const { return m_column; }

private:
  struct Place
  {
    std::size_t line, column, line_begin, line_end;
  };

  Parse_error(const std::string& message, std::string_view text, std::size_t offset,
              const Place& place)
    : Shape_error(picture(message, text, offset, place)), m_message(message), m_offset(offset),
      m_line(place.line), m_column(place.column)
  {}

  // Bytes after the first one of a character do not count.
  static bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }

  static std::size_t count_characters(std::string_view text)
  {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
  }

  static Place place_of(std::string_view text, std::size_t offset)
  {
    const std::string_view before = text.substr(0, offset);
    const std::size_t newline = before.rfind('\n');
    const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    const auto lines = std::count(before.begin(), before.end(), '\n');
    return Place{static_cast<std::size_t>(lines) + 1,
                 count_characters(text.substr(begin, offset - begin)) + 1, begin, end};
  }

  // The line, or the part of a long one around the place, and the caret below it.
  static std::string picture(const std::string& message, std::string_view text, std::size_t offset,
                             const Place& place)
  {
    constexpr std::size_t reach = 60;
    std::size_t begin = place.line_begin, end = place.line_end;
    if (offset - begin > reach)
      begin = offset - reach;
    if (end - offset > reach)
      end = offset + reach;
    while (begin < offset && !begins_character(text[begin]))
      ++begin;
    while (end > offset && end < place.line_end && !begins_character(text[end]))
      --end;
    const std::string left = begin > place.line_begin ? "..." : "";
    const std::string right = end < place.line_end ? "..." : "";
    const std::size_t indent = left.size() + count_characters(text.substr(begin, offset - begin));
    return left + printable(text.substr(begin, end - begin)) + right + "\n" +
           std::string(indent, ' ') + "^ " + message + " (line " + std::to_string(place.line) +
           ", column " + std::to_string(place.column) + ")";
  }

  static std::string printable(std::string_view text)
  {
    std::string result(text);
    for (char& c : result)
      if (static_cast<unsigned char>(c) < 0x20u || c == 0x7F)
        c = ' ';
    return result;
  }

  std::string m_message;
  std::size_t m_offset, m_line, m_column;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_ERROR_H
