// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_READ_NUMBERS_H
#define INTERROGATE_READ_NUMBERS_H

// Numbers, functions and names of a model. All throw Model_error with the place.

#include "Json_place.h"
#include "Model.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace interrogate {

// A JSON number or a string expression, exactly.
Number read_number(const Json_place& place);

Number read_positive(const Json_place& place);
Number read_nonzero(const Json_place& place);

// A positive number that is one in floating point, too.
Number read_length(const Json_place& place);

// The nearest double of a number that is used in floating point.
double read_double(const Json_place& place);

// A number without roots.
Rational read_rational(const Json_place& place);

std::vector<Number> read_numbers(const Json_place& place, std::size_t size,
                                 const std::string& what);

template <std::size_t d>
std::array<Number, d> read_point(const Json_place& place, const std::string& what)
{
  const std::vector<Number> numbers = read_numbers(place, d, what);
  std::array<Number, d> point;
  std::copy(numbers.begin(), numbers.end(), point.begin());
  return point;
}

// [lo, hi] with lo < hi.
Range read_range(const Json_place& place);

int read_integer(const Json_place& place, int lowest, int highest);

// A function of the variables, as text.
Expression read_function(const Json_place& place, const std::vector<std::string>& variables);
std::vector<Expression> read_functions(const Json_place& place, std::size_t size,
                                       const std::vector<std::string>& variables);

// Names of variables, which are distinct.
std::string read_name(const Json_place& place, const std::string& what);
std::vector<std::string> read_names(const Json_place& place, const std::string& what);
std::vector<std::string> read_names(const Json_place& place, std::size_t size,
                                    const std::string& what);

} // namespace interrogate

#endif // INTERROGATE_READ_NUMBERS_H
