// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MAKE_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MAKE_EXPRESSION_H

// Construction of nodes and of exact constants; nothing is simplified here.

#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_node.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// What an operation adds to the properties of its operands.
inline std::uint8_t own_properties(Expression_operation op, std::int32_t argument)
{
  using Op = Expression_operation;
  switch (op)
  {
  case Op::DIVIDE:
    return USES_DIVISION | IS_PARTIAL;
  case Op::POWER:
    return argument < 0 ? USES_DIVISION | IS_PARTIAL : 0;
  case Op::SQRT:
    return USES_SQRT | IS_PARTIAL;
  case Op::PI: case Op::EXP: case Op::SIN: case Op::COS: case Op::ATAN:
    return USES_TRANSCENDENTAL;
  case Op::LOG: case Op::TAN: case Op::ASIN: case Op::ACOS:
    return USES_TRANSCENDENTAL | IS_PARTIAL;
  default:
    return 0;
  }
}

inline std::uint32_t own_degree(Expression_operation op, std::int32_t argument, std::uint64_t first,
                                std::uint64_t second)
{
  using Op = Expression_operation;
  std::uint64_t degree = std::max(first, second);
  if (op == Op::VARIABLE)
    degree = 1;
  else if (op == Op::MULTIPLY || op == Op::DIVIDE)
    degree = first + second;
  else if (op == Op::POWER)
    degree = first * static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(argument)));
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(degree, most));
}

inline Expression_handle make_leaf(Expression_operation op, std::int32_t argument)
{
  auto* node = new Expression_node(op, argument);
  node->properties = own_properties(op, argument);
  node->degree = own_degree(op, argument, 0, 0);
  return Expression_handle::adopt(node);
}

inline Expression_handle make_constant(const CGAL::Exact_rational& value)
{
  return Expression_handle::adopt(new Constant_node(value));
}

inline Expression_handle zero_constant()
{
  static const Expression_handle zero = make_constant(CGAL::Exact_rational(0));
  return zero;
}

inline Expression_handle make_operation(Expression_operation op, const Expression_handle& a,
                                        std::int32_t argument = 0)
{
  const Expression_node* first = a.get();
  auto* node = new Expression_node(op, argument);
  node->properties = first->properties | own_properties(op, argument);
  node->degree = own_degree(op, argument, first->degree, 0);
  acquire(node->first = first);
  return Expression_handle::adopt(node);
}

inline Expression_handle make_operation(Expression_operation op, const Expression_handle& a,
                                        const Expression_handle& b)
{
  const Expression_node *first = a.get(), *second = b.get();
  auto* node = new Expression_node(op, 0);
  node->properties = first->properties | second->properties | own_properties(op, 0);
  node->degree = own_degree(op, 0, first->degree, second->degree);
  acquire(node->first = first);
  acquire(node->second = second);
  return Expression_handle::adopt(node);
}

template <class Number>
CGAL::Exact_rational exact_number(const Number& number)
{
  if constexpr (std::is_floating_point_v<Number>)
  {
    if (!std::isfinite(number))
      throw Conversion_error("an expression takes finite numbers only, not infinity or NaN");
    return CGAL::Exact_rational(static_cast<double>(number));
  }
  else if constexpr (std::is_integral_v<Number>)
  {
    // Two halves that are exact as double: not every rational type has all integer constructors.
    constexpr Number half = sizeof(Number) > 4 ? Number(1) << (4 * sizeof(Number)) : Number(0);
    if constexpr (half == 0)
      return CGAL::Exact_rational(static_cast<double>(number));
    else
    {
      const CGAL::Exact_rational high(static_cast<double>(number / half));
      const CGAL::Exact_rational low(static_cast<double>(number % half));
      return CGAL::Exact_rational(high * CGAL::Exact_rational(static_cast<double>(half)) + low);
    }
  }
  else
    return CGAL::Exact_rational(number);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MAKE_EXPRESSION_H
