// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Numbers and functions are read by the library's parser; here its errors get their place in the
// model. The only file that compiles the grammar.

#include "read_numbers.h"

#include "evaluate_numbers.h"

#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>

#include <algorithm>
#include <cmath>

namespace interrogate {

namespace {

// The parser's message is a picture of the text with a caret: it starts on a line of its own.
template <class Parse>
auto parse_at(const Json_place& place, const char* what, Parse parse)
{
  try
  {
    return parse();
  }
  catch (const si::Parse_error& error)
  {
    place.fail(std::string("this is not ") + what + "\n" + error.what());
  }
  catch (const si::Shape_error& error)
  {
    place.fail(error.what());
  }
}

bool is_certainly_less(const Number& a, const Number& b)
{
  if (a.is_constant() && b.is_constant())
    return a.constant() < b.constant();
  return CGAL::certainly(evaluate<Interval>(a) < evaluate<Interval>(b));
}

// The parser knows which names a variable may have.
void check_names(const Json_place& place, const std::vector<std::string>& names)
{
  parse_at(place, "a list of names", [&] { return si::parse_expression("0", names); });
}

} // namespace

Number read_number(const Json_place& place)
{
  const std::string& text = place.number_text();
  return parse_at(place, "a number", [&] { return si::parse_number(text); });
}

Number read_positive(const Json_place& place)
{
  const Number number = read_number(place);
  const bool is_positive =
    parse_at(place, "a number", [&] { return is_certainly_less(Number(0), number); });
  if (!is_positive)
    place.expected("a number greater than 0");
  return number;
}

Number read_nonzero(const Json_place& place)
{
  const Number number = read_number(place);
  const bool is_nonzero = parse_at(place, "a number", [&] {
    return is_certainly_less(Number(0), number) || is_certainly_less(number, Number(0));
  });
  if (!is_nonzero)
    place.expected("a number that is not 0");
  return number;
}

Number read_length(const Json_place& place)
{
  const Number number = read_positive(place);
  const double length = parse_at(place, "a number", [&] { return evaluate<double>(number); });
  if (!(length > 0 && std::isfinite(length)))
    place.fail("a length is used in floating point, where this one is zero or infinite");
  return number;
}

double read_double(const Json_place& place)
{
  const Number number = read_number(place);
  const double x = parse_at(place, "a number", [&] { return evaluate<double>(number); });
  if (!std::isfinite(x))
    place.fail("this number is used in floating point, where it is not finite");
  return x;
}

Rational read_rational(const Json_place& place)
{
  const Number number = read_number(place);
  if (!number.is_constant())
    place.expected("a rational number");
  return number.constant();
}

std::vector<Number> read_numbers(const Json_place& place, std::size_t size,
                                 const std::string& what)
{
  std::vector<Number> numbers;
  for (const Json_place& number : place.elements(size, what))
    numbers.push_back(read_number(number));
  return numbers;
}

Range read_range(const Json_place& place)
{
  const Range range = read_point<2>(place, "a range [lo,hi]");
  const bool is_range =
    parse_at(place, "a range", [&] { return is_certainly_less(range[0], range[1]); });
  if (!is_range)
    place.fail("the first number of a range must be less than the second");
  return range;
}

int read_integer(const Json_place& place, int lowest, int highest)
{
  const std::string what = "an integer from " + std::to_string(lowest) + " to " +
                           std::to_string(highest);
  if (place.kind() != Json::Kind::NUMBER)
    place.expected(what);
  const Rational number = read_rational(place);
  if (number < lowest || number > highest)
    place.expected(what);
  const int integer = static_cast<int>(si::number_cast<double>(number));
  if (number != integer)
    place.expected(what);
  return integer;
}

Expression read_function(const Json_place& place, const std::vector<std::string>& variables)
{
  const std::string& text = place.string("a function of " + listed(variables) + ", as a string");
  return parse_at(place, "a function",
                  [&] { return si::parse_expression(text, variables); });
}

std::vector<Expression> read_functions(const Json_place& place, std::size_t size,
                                       const std::vector<std::string>& variables)
{
  std::vector<Expression> functions;
  for (const Json_place& f : place.elements(size, std::to_string(size) + " functions"))
    functions.push_back(read_function(f, variables));
  return functions;
}

std::string read_name(const Json_place& place, const std::string& what)
{
  const std::string& name = place.string(what);
  check_names(place, {name});
  return name;
}

std::vector<std::string> read_names(const Json_place& place, const std::string& what)
{
  std::vector<std::string> names;
  for (const Json_place& name : place.elements(what))
    names.push_back(read_name(name, "the name of a variable"));
  check_names(place, names);
  return names;
}

std::vector<std::string> read_names(const Json_place& place, std::size_t size,
                                    const std::string& what)
{
  place.elements(size, what);
  return read_names(place, what);
}

} // namespace interrogate
