// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_BUILDER_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_BUILDER_H

// What the grammar does with the parts it recognises: a stack machine over expressions that knows
// the place of every part, so that each refusal points at the text.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/bit_length.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/function_names.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>
#include <CGAL/Shape_interrogation/Differentiation/Parse_error.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Which functions a text may use.
enum class Vocabulary { ALL_FUNCTIONS, SQUARE_ROOT_ONLY };

class Expression_builder
{
public:
  Expression_builder(std::string_view text, const std::vector<std::string>& variables,
                     Vocabulary vocabulary, const Expression_limits& limits)
    : m_text(text), m_names(variables), m_vocabulary(vocabulary), m_limits(limits)
  {
    for (std::size_t i = 0; i < variables.size(); ++i)
      m_variables.push_back(Expression::variable(static_cast<int>(i)));
  }

  Expression result() const { return m_values.back(); }

  [[noreturn]] void fail(const std::string& message, std::size_t offset) const
  {
    throw Parse_error(message, m_text, offset);
  }

  std::size_t offset(std::string_view part) const
  {
    return static_cast<std::size_t>(part.data() - m_text.data());
  }

  void number(std::string_view part)
  {
    checked(offset(part), [&] { return Expression(*parse_decimal(part, m_limits)); });
  }

  // A name waits until it is clear whether '(' follows.
  void name(std::string_view part) { m_name = part; }

  void variable()
  {
    for (std::size_t i = 0; i < m_names.size(); ++i)
      if (m_names[i] == m_name)
        return m_values.push_back(m_variables[i]);
    if (m_name == "pi" && m_vocabulary == Vocabulary::ALL_FUNCTIONS)
      return m_values.push_back(Expression::pi());
    if (find_function(m_name))
      fail("the function " + quoted(m_name) + " needs an argument in parentheses", offset(m_name));
    fail("unknown name " + quoted(m_name) + "; " + known_names(), offset(m_name));
  }

  void begin_call(std::string_view parenthesis)
  {
    const Named_function* function = find_function(m_name);
    if (!function)
      fail(quoted(m_name) + " is not a function; the functions are " + function_list(),
           offset(m_name));
    m_calls.push_back({function, offset(m_name)});
    open(parenthesis);
  }

  void end_call()
  {
    close();
    const Call call = m_calls.back();
    m_calls.pop_back();
    const Expression x = pop();
    check_domain(call, x);
    checked(call.offset,
            [&] { return Expression(function_of(call.function->operation, x.handle())); });
  }

  void open(std::string_view parenthesis) { m_open.push_back(offset(parenthesis)); }
  void close() { m_open.pop_back(); }

  // The place of the innermost '(' that is not closed yet.
  std::size_t innermost_open() const { return m_open.back(); }

  void begin_factor() { m_signs.push_back(false); }
  void sign(std::string_view part) { m_signs.back() = m_signs.back() != (part.front() == '-'); }
  void end_factor()
  {
    if (m_signs.back())
      m_values.back() = -m_values.back();
    m_signs.pop_back();
  }

  void begin_power() { m_powers.emplace_back(); }
  void caret(std::string_view part) { m_powers.back().push_back({offset(part), false}); }
  void exponent_sign(std::string_view part)
  {
    bool& negative = m_powers.back().back().negative;
    negative = negative != (part.front() == '-');
  }

  // a ^ b ^ c is a ^ (b ^ c).
  void end_power()
  {
    std::vector<Caret>& carets = m_powers.back();
    for (; !carets.empty(); carets.pop_back())
    {
      const Expression exponent = carets.back().negative ? -pop() : pop();
      const Expression base = pop();
      raise(base, exponent, carets.back().offset);
    }
    m_powers.pop_back();
  }

  void binary_operator(std::string_view part) { m_operators.push_back(part); }
  void apply_operator()
  {
    const std::string_view part = m_operators.back();
    m_operators.pop_back();
    const Expression b = pop(), a = pop();
    checked(offset(part), [&] {
      switch (part.front())
      {
      case '+': return a + b;
      case '-': return a - b;
      case '*': return a * b;
      default: return a / b;
      }
    });
  }

private:
  struct Call
  {
    const Named_function* function;
    std::size_t offset;
  };
  struct Caret
  {
    std::size_t offset;
    bool negative;
  };

  static std::string quoted(std::string_view name)
  {
    constexpr std::size_t longest = 60;
    const std::string shown(name.substr(0, longest));
    return "'" + shown + (name.size() > longest ? "...'" : "'");
  }

  Expression pop()
  {
    Expression e = std::move(m_values.back());
    m_values.pop_back();
    return e;
  }

  // Pushes what `make` returns; what it throws, and what is too large, is reported at the place.
  template <class Make>
  void checked(std::size_t place, Make make)
  {
    try
    {
      m_values.push_back(make());
    }
    catch (const Division_by_zero_error&)
    {
      fail("division by zero", place);
    }
    catch (const Limit_error& error)
    {
      fail(error.what(), place);
    }
    const Expression& e = m_values.back();
    if (e.is_constant() && bit_length(e.constant()) > m_limits.constant_bits)
      fail("a constant has more than " + std::to_string(m_limits.constant_bits) + " bits", place);
    if (e.degree_bound() > m_limits.degree)
      fail("the degree is beyond the limit " + std::to_string(m_limits.degree), place);
  }

  void raise(const Expression& base, const Expression& exponent, std::size_t place)
  {
    if (!exponent.is_constant())
      fail("the exponent must be an integer, not an expression in variables or functions", place);
    const CGAL::Exact_rational limit(static_cast<double>(m_limits.exponent));
    const CGAL::Exact_rational& value = exponent.constant();
    if (CGAL::abs(value) > limit)
      fail("the exponent is beyond the limit " + std::to_string(m_limits.exponent), place);
    const int n = static_cast<int>(CGAL::to_double(value));
    if (value != CGAL::Exact_rational(n))
      fail("the exponent must be an integer", place);
    const bool constant = base.is_constant();
    if (constant && (bit_length(base.constant()) - 1) * std::size_t(n < 0 ? -n : n) >
                      m_limits.constant_bits)
      fail("a constant has more than " + std::to_string(m_limits.constant_bits) + " bits", place);
    checked(place, [&] { return pow(base, n); });
  }

  void check_domain(const Call& call, const Expression& x) const
  {
    if (!x.is_constant())
      return;
    using Op = Expression_operation;
    const CGAL::Exact_rational& c = x.constant();
    const Op op = call.function->operation;
    const CGAL::Exact_rational one(1);
    if (op == Op::SQRT && CGAL::is_negative(c))
      fail("the square root of a negative number", call.offset);
    if (op == Op::LOG && !CGAL::is_positive(c))
      fail("the logarithm of a number that is not positive", call.offset);
    if ((op == Op::ASIN || op == Op::ACOS) && CGAL::abs(c) > one)
      fail(quoted(call.function->name) + " of a number outside [-1, 1]", call.offset);
  }

  const Named_function* find_function(std::string_view name) const
  {
    for (const Named_function& f : named_functions)
      if (name == f.name &&
          (m_vocabulary == Vocabulary::ALL_FUNCTIONS || f.operation == Expression_operation::SQRT))
        return &f;
    return nullptr;
  }

  std::string function_list() const
  {
    std::string list;
    for (const Named_function& f : named_functions)
      if (find_function(f.name))
        list += (list.empty() ? "" : " ") + std::string(f.name);
    return list;
  }

  std::string known_names() const
  {
    std::string list;
    constexpr std::size_t longest = 200;
    for (const std::string& v : m_names)
    {
      list += (list.empty() ? "the variables are " : " ") + v;
      if (list.size() > longest)
      {
        list += " ...";
        break;
      }
    }
    return list.empty() ? "there are no variables here" : list;
  }

  std::string_view m_text, m_name;
  const std::vector<std::string>& m_names;
  std::vector<Expression> m_variables;
  Vocabulary m_vocabulary;
  Expression_limits m_limits;
  std::vector<Expression> m_values;
  std::vector<std::string_view> m_operators;
  std::vector<Call> m_calls;
  std::vector<bool> m_signs;
  std::vector<std::vector<Caret>> m_powers;
  std::vector<std::size_t> m_open;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_BUILDER_H
