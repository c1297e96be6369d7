// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SIMPLIFY_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SIMPLIFY_EXPRESSION_H

// The operations of expressions: constants are folded exactly, neutral elements vanish, and no rule
// hides a point where the expression has no value. A constant stands first in a product and last
// in a sum.

#include <CGAL/Shape_interrogation/Differentiation/internal/bit_length.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/make_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>

#include <cstdlib>
#include <limits>
#include <string>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

constexpr std::size_t largest_constant_bits = std::size_t(1) << 20;

inline Expression_handle negation(const Expression_handle& a);
inline Expression_handle sum(const Expression_handle& a, const Expression_handle& b);
inline Expression_handle difference(const Expression_handle& a, const Expression_handle& b);
inline Expression_handle product(const Expression_handle& a, const Expression_handle& b);
inline Expression_handle quotient(const Expression_handle& a, const Expression_handle& b);
inline Expression_handle power(const Expression_handle& x, int n);

inline bool is_value(const Expression_handle& e, int value)
{
  return e.is_constant() && e.constant() == CGAL::Exact_rational(value);
}

inline void check_constant_bits(std::size_t bits)
{
  if (bits > largest_constant_bits)
    throw Limit_error("a constant of the expression grows beyond " +
                      std::to_string(largest_constant_bits) + " bits");
}

inline Expression_handle folded(const CGAL::Exact_rational& value)
{
  check_constant_bits(bit_length(value));
  return make_constant(value);
}

// c * x for a constant c.
inline Expression_handle scaled(const CGAL::Exact_rational& c, const Expression_handle& x)
{
  if (x.is_constant())
    return folded(CGAL::Exact_rational(c * x.constant()));
  if (CGAL::is_zero(c) && !x.is_partial())
    return make_constant(c);
  if (c == CGAL::Exact_rational(1))
    return x;
  if (x.is(Expression_operation::MULTIPLY) && x.first().is_constant())
    return scaled(CGAL::Exact_rational(c * x.first().constant()), x.second());
  if (x.is(Expression_operation::NEGATE))
    return scaled(CGAL::Exact_rational(-c), x.first());
  if (x.is(Expression_operation::DIVIDE) && x.first().is_constant())
    return quotient(folded(CGAL::Exact_rational(c * x.first().constant())), x.second());
  if (c == CGAL::Exact_rational(-1))
    return make_operation(Expression_operation::NEGATE, x);
  return make_operation(Expression_operation::MULTIPLY, folded(c), x);
}

// x + c for a constant c.
inline Expression_handle shifted(const Expression_handle& x, const CGAL::Exact_rational& c)
{
  if (x.is_constant())
    return folded(CGAL::Exact_rational(x.constant() + c));
  if (CGAL::is_zero(c))
    return x;
  if (x.is(Expression_operation::ADD) && x.second().is_constant())
    return shifted(x.first(), CGAL::Exact_rational(x.second().constant() + c));
  if (x.is(Expression_operation::SUBTRACT) && x.first().is_constant())
    return difference(folded(CGAL::Exact_rational(x.first().constant() + c)), x.second());
  if (x.is(Expression_operation::NEGATE))
    return make_operation(Expression_operation::SUBTRACT, folded(c), x.first());
  return make_operation(Expression_operation::ADD, x, folded(c));
}

inline Expression_handle negation(const Expression_handle& a)
{
  if (a.is(Expression_operation::SUBTRACT))
    return difference(a.second(), a.first());
  return scaled(CGAL::Exact_rational(-1), a);
}

inline Expression_handle sum(const Expression_handle& a, const Expression_handle& b)
{
  if (b.is_constant())
    return shifted(a, b.constant());
  if (a.is_constant())
    return shifted(b, a.constant());
  if (b.is(Expression_operation::NEGATE))
    return difference(a, b.first());
  if (a.is(Expression_operation::NEGATE))
    return difference(b, a.first());
  if (a.get() == b.get())
    return scaled(CGAL::Exact_rational(2), a);
  return make_operation(Expression_operation::ADD, a, b);
}

inline Expression_handle difference(const Expression_handle& a, const Expression_handle& b)
{
  if (b.is_constant())
    return shifted(a, CGAL::Exact_rational(-b.constant()));
  if (is_value(a, 0))
    return negation(b);
  if (b.is(Expression_operation::NEGATE))
    return sum(a, b.first());
  if (a.get() == b.get() && !a.is_partial())
    return zero_constant();
  return make_operation(Expression_operation::SUBTRACT, a, b);
}

// The exponent of x as a positive power of `base`, or 0 if it is not recorded as one.
inline std::int64_t exponent_over(const Expression_handle& x, const Expression_node* base)
{
  if (x.get() == base)
    return 1;
  return x.is(Expression_operation::POWER) && x->first == base && x->argument > 0 ? x->argument : 0;
}

inline Expression_handle product(const Expression_handle& a, const Expression_handle& b)
{
  if (a.is_constant())
    return scaled(a.constant(), b);
  if (b.is_constant())
    return scaled(b.constant(), a);
  if (a.is(Expression_operation::NEGATE))
    return negation(product(a.first(), b));
  if (b.is(Expression_operation::NEGATE))
    return negation(product(a, b.first()));
  const bool a_is_power = a.is(Expression_operation::POWER) && a->argument > 0;
  const Expression_handle base = a_is_power ? a.first() : a;
  const std::int64_t m = exponent_over(a, base.get()), n = exponent_over(b, base.get());
  if (m > 0 && n > 0 && m + n <= std::numeric_limits<std::int32_t>::max())
    return power(base, static_cast<int>(m + n));
  return make_operation(Expression_operation::MULTIPLY, a, b);
}

inline Expression_handle quotient(const Expression_handle& a, const Expression_handle& b)
{
  if (b.is_constant())
  {
    if (CGAL::is_zero(b.constant()))
      throw Division_by_zero_error("an expression is divided by the constant zero");
    return scaled(CGAL::Exact_rational(CGAL::Exact_rational(1) / b.constant()), a);
  }
  if (a.is(Expression_operation::NEGATE))
    return negation(quotient(a.first(), b));
  if (b.is(Expression_operation::NEGATE))
    return negation(quotient(a, b.first()));
  const bool scaled_divisor = b.is(Expression_operation::MULTIPLY) && b.first().is_constant();
  if (a.is_constant() && scaled_divisor && !is_value(b.first(), 0))
    return quotient(quotient(a, b.first()), b.second());
  return make_operation(Expression_operation::DIVIDE, a, b);
}

inline CGAL::Exact_rational constant_power(const CGAL::Exact_rational& x, int n)
{
  if (n < 0 && CGAL::is_zero(x))
    throw Division_by_zero_error("a negative power of the constant zero");
  const std::uint64_t m = static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(n)));
  check_constant_bits(static_cast<std::size_t>(m * (bit_length(x) - 1)));
  CGAL::Exact_rational result(1), factor(x);
  for (std::uint64_t k = m; k > 0; k /= 2)
  {
    if (k % 2 == 1)
      result = CGAL::Exact_rational(result * factor);
    if (k > 1)
      factor = CGAL::Exact_rational(factor * factor);
  }
  return n < 0 ? CGAL::Exact_rational(CGAL::Exact_rational(1) / result) : result;
}

inline Expression_handle power(const Expression_handle& x, int n)
{
  if (n == 1)
    return x;
  if (x.is_constant())
    return folded(constant_power(x.constant(), n));
  if (n == 0 && !x.is_partial())
    return make_constant(CGAL::Exact_rational(1));
  if (x.is(Expression_operation::NEGATE))
    return n % 2 == 0 ? power(x.first(), n) : negation(power(x.first(), n));
  const std::int64_t inner = x.is(Expression_operation::POWER) ? x->argument : 0;
  const std::int64_t both = inner * n;
  if (both != 0 && (inner > 0 || n > 0) && both == static_cast<std::int32_t>(both))
    return power(x.first(), static_cast<int>(both));
  return make_operation(Expression_operation::POWER, x, n);
}

// The value of a function at a constant where it is rational.
inline bool fold_function(Expression_operation op, const CGAL::Exact_rational& x,
                          CGAL::Exact_rational& value)
{
  using Op = Expression_operation;
  if (op == Expression_operation::SQRT)
    return !CGAL::is_negative(x) && has_rational_root(x, value);
  const bool at_one = op == Op::LOG || op == Op::ACOS; // vanish at 1; the others are known at 0
  if (x != CGAL::Exact_rational(at_one ? 1 : 0))
    return false;
  value = CGAL::Exact_rational(op == Op::EXP || op == Op::COS ? 1 : 0);
  return true;
}

inline Expression_handle function_of(Expression_operation op, const Expression_handle& x)
{
  if (x.is_constant())
  {
    CGAL::Exact_rational value(0);
    if (fold_function(op, x.constant(), value))
      return make_constant(value);
  }
  return make_operation(op, x);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SIMPLIFY_EXPRESSION_H
