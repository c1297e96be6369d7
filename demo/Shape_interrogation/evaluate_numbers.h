// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_EVALUATE_NUMBERS_H
#define INTERROGATE_EVALUATE_NUMBERS_H

// The numbers of a model in a number type: exactly, enclosed, or as the nearest double.

#include "Model.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>

#include <array>
#include <vector>

namespace interrogate {

namespace si = CGAL::Shape_interrogation;

using Interval = CGAL::Interval_nt<true>;
using Quadratic = si::Quadratic_field; // the exact type of the program

template <class NT>
NT evaluate(const Number& number)
{
  if (number.is_constant())
    return si::number_cast<NT>(number.constant());
  const si::Expression_tape tape({number}, 0, si::Expression_tape::Derivatives::NONE);
  return tape.evaluate(std::vector<NT>()).front();
}

template <class NT>
std::vector<NT> evaluate(const std::vector<Number>& numbers)
{
  std::vector<NT> values;
  for (const Number& number : numbers)
    values.push_back(evaluate<NT>(number));
  return values;
}

template <class NT, std::size_t d>
std::array<NT, d> evaluate(const std::array<Number, d>& numbers)
{
  std::array<NT, d> values;
  for (std::size_t i = 0; i < d; ++i)
    values[i] = evaluate<NT>(numbers[i]);
  return values;
}

template <std::size_t d, class NT>
std::array<NT, d> first(const std::vector<NT>& numbers)
{
  std::array<NT, d> values;
  for (std::size_t i = 0; i < d; ++i)
    values[i] = numbers[i];
  return values;
}

} // namespace interrogate

#endif // INTERROGATE_EVALUATE_NUMBERS_H
