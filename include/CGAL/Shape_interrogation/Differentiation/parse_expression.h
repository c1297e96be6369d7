// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_EXPRESSION_H

// Expressions from text. The only header that includes the grammar: slow to compile, so include it
// where texts are read and nowhere else.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/expression_grammar.h>
#include <CGAL/Shape_interrogation/Differentiation/Parse_error.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

inline void check_variable_names(const std::vector<std::string>& names)
{
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::string& name = names[i];
    if (!is_identifier(name))
      throw Shape_error("the variable name '" + name + "' is not a letter or '_' followed by"
                        " letters, digits and '_'");
    if (is_reserved_name(name))
      throw Shape_error("the variable name '" + name + "' is reserved");
    if (std::find(names.begin(), names.begin() + i, name) != names.begin() + i)
      throw Shape_error("the variable name '" + name + "' occurs twice");
  }
}

// Size, and the depth of parentheses: the parser recurses in these.
inline void check_text(std::string_view text, const Expression_limits& limits)
{
  if (text.size() > limits.text_size)
    throw Parse_error("the text has more than " + std::to_string(limits.text_size) + " characters",
                      text, limits.text_size);
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '(' && ++depth > limits.depth)
      throw Parse_error("parentheses are nested deeper than " + std::to_string(limits.depth), text,
                        i);
    else if (text[i] == ')' && depth > 0)
      --depth;
}

inline std::size_t skip_blanks(std::string_view text, std::size_t i)
{
  while (i < text.size() && grammar::x3::ascii::space.test(text[i], grammar::x3::unused))
    ++i;
  return i;
}

[[noreturn]] inline void fail_expected(const Expression_builder& builder, std::string_view text,
                                       std::size_t place, const std::string& what)
{
  std::string message = "expected " + what;
  if (what == ")")
  {
    const Parse_error opened("", text, builder.innermost_open());
    message = "expected an operator or ')' for the '(' of line " + std::to_string(opened.line()) +
              ", column " + std::to_string(opened.column());
  }
  if (place == text.size())
    message += ", but the text ends here";
  builder.fail(message, place);
}

inline Expression parse(std::string_view text, const std::vector<std::string>& variables,
                        Vocabulary vocabulary, const Expression_limits& limits)
{
  namespace x3 = grammar::x3;
  check_text(text, limits);
  if (skip_blanks(text, 0) == text.size())
    throw Parse_error("the text is empty, expected an expression", text, 0);
  Expression_builder builder(text, variables, vocabulary, limits);
  grammar::Iterator at = text.begin();
  const auto place = [&](grammar::Iterator i) {
    return skip_blanks(text, static_cast<std::size_t>(i - text.begin()));
  };
  try
  {
    const auto rule = x3::with<grammar::Builder_tag>(std::ref(builder))[grammar::expression];
    if (!x3::phrase_parse(at, text.end(), rule, x3::ascii::space))
      fail_expected(builder, text, place(at), "a number, a name or '('");
  }
  catch (const x3::expectation_failure<grammar::Iterator>& failure)
  {
    fail_expected(builder, text, place(failure.where()), failure.which());
  }
  if (at != text.end())
    builder.fail(*at == ')' ? "this ')' closes nothing" : "expected an operator or the end",
                 place(at));
  return builder.result();
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief reads an expression.
 *
 * \details The text may contain decimal numerals (`12`, `0.1`, `1.5e-3`, all exact), the variables,
 * `pi`, `+ - * /`, parentheses, `^` with an integer exponent, and the functions `sqrt exp log sin
 * cos tan asin acos atan`. `^` binds tightest and associates to the right: `-x^2` is
 * \f$ -(x^2) \f$, `2^3^2` is \f$ 2^9 \f$. An exponent is a constant expression with an integer
 * value, such as `2`, `-1` or `(1+1)`. Blanks and line breaks may stand between the parts. The
 * locale has no influence.
 *
 * \param text the expression
 * \param variables the names of the variables; the name with index `i` becomes variable `i`. A name
 *   is a letter or `_` followed by letters, digits and `_`; the names of functions and `pi` are
 *   reserved
 * \param limits the bounds that the text is checked against
 *
 * \exception Parse_error if the text is not an expression, uses an unknown name, divides by the
 *   constant zero or exceeds a limit
 * \exception Shape_error if the names of the variables are not valid
 *
 * Complexity: linear in the text.
 *
 * \sa `to_string()`
 */
inline Expression parse_expression(std::string_view text, const std::vector<std::string>& variables,
                                   const Expression_limits& limits = Expression_limits())
{
  internal::check_variable_names(variables);
  return internal::parse(text, variables, internal::Vocabulary::ALL_FUNCTIONS, limits);
}

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief reads a number that is given as an expression in integers, decimals, `+ - * / ^`,
 * parentheses and `sqrt()`, such as `3/(2*sqrt(17))`.
 *
 * \details The expression has no variables; it is a constant (`Expression::is_constant()`) if it is
 * rational by construction, else an `Expression_tape` evaluates it in the number type wanted.
 *
 * \exception Parse_error as in `parse_expression()`
 */
inline Expression parse_number(std::string_view text,
                               const Expression_limits& limits = Expression_limits())
{
  return internal::parse(text, {}, internal::Vocabulary::SQUARE_ROOT_ONLY, limits);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PARSE_EXPRESSION_H
