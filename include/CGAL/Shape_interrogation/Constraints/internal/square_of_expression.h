// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_SQUARE_OF_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_SQUARE_OF_EXPRESSION_H

// The square of an expression, in which square roots that are factors vanish; distances that are
// no numbers or zero.

#include <CGAL/Shape_interrogation/Constraints/internal/constant_parts.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <string>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// The depth limits the recursion into products: shared factors are visited once for each use.
inline Expression square_of_expression(const Expression& x, int depth = 12)
{
  using Op = Expression_operation;
  const Expression_handle& handle = x.handle();
  const auto first = [&] { return Expression(handle.first()); };
  const auto second = [&] { return Expression(handle.second()); };
  const auto squared = [&](const Expression& y) { return square_of_expression(y, depth - 1); };
  if (!x.uses_sqrt() || depth == 0)
    return square(x);
  switch (handle->operation)
  {
  case Op::SQRT: return first();
  case Op::NEGATE: return squared(first());
  case Op::MULTIPLY: return squared(first()) * squared(second());
  case Op::DIVIDE: return squared(first()) / squared(second());
  default: return square(x);
  }
}

inline void check_distance(const Expression& x, const std::string& what)
{
  check_real(x, what);
  if (x.is_constant() && CGAL::is_zero(x.constant()))
    throw Shape_error(what + " is zero: expected another number");
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_SQUARE_OF_EXPRESSION_H
