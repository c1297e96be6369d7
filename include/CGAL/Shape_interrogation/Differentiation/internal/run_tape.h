// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_RUN_TAPE_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_RUN_TAPE_H

// The interpreter of tapes: one loop for all number types.

#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_constants.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_instruction.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>
#include <CGAL/Uncertain.h>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class A, class B, class = void> struct Has_division : std::false_type {};
template <class A, class B>
struct Has_division<A, B, std::void_t<decltype(std::declval<A>() / std::declval<B>())>>
  : std::true_type
{};

template <class A, class NT>
void divide(const A& a, const NT& b, NT& result)
{
  if constexpr (Has_division<const A&, const NT&>::value)
    result = a / b;
  else
    throw Not_algebraic_error("the expression divides, but the number type is a ring without"
                              " division");
}

template <class NT>
NT square_of(const NT& x)
{
  if constexpr (Is_interval<NT>::value)
    return CGAL::square(x); // knows that both factors are the same number
  else
    return x * x;
}

// x to the n for n >= 1, by repeated squaring.
template <class NT>
NT positive_power(const NT& x, std::uint32_t n)
{
  NT base = x;
  for (; n % 2 == 0; n /= 2)
    base = square_of(base);
  NT result = base;
  while ((n /= 2) > 0)
  {
    base = square_of(base);
    if (n % 2 == 1)
      result = result * base;
  }
  return result;
}

// An odd power is monotone: the ends of an interval around zero are mapped to the ends.
template <bool P>
Interval_nt<P> positive_power(const Interval_nt<P>& x, std::uint32_t n)
{
  using NT = Interval_nt<P>;
  if (n % 2 == 1 && n > 1 && x.inf() < 0 && x.sup() > 0)
  {
    const NT low = -positive_power<NT>(NT(-x.inf()), n), high = positive_power<NT>(NT(x.sup()), n);
    return NT(low.inf(), high.sup());
  }
  return positive_power<NT>(x, n);
}

// x to the n into `result`; false if this divides by zero.
template <class NT>
bool raise(const NT& x, std::int32_t n, NT& result)
{
  if (n == 0)
    result = NT(1);
  else if (n > 0)
    result = positive_power(x, static_cast<std::uint32_t>(n));
  else
  {
    if (CGAL::certainly(is_zero_decision(x)))
      return false;
    divide(NT(1), positive_power(x, std::uint32_t(0) - static_cast<std::uint32_t>(n)), result);
  }
  return true;
}

// A position in a tape and the slot that it writes.
template <class NT>
struct Tape_cursor
{
  const Tape_instruction* i;
  const Tape_instruction* end;
  NT* result;

  // Executes instructions as long as the operation stays the same.
  template <class Step>
  void run(Step step)
  {
    const Tape_operation operation = i->operation;
    do
    {
      step(*i, *result);
      ++result;
      ++i;
    } while (i != end && i->operation == operation);
  }

  // The same for a step that can fail; false, with `i` at the failure, if it did.
  template <class Step>
  bool try_run(Step step)
  {
    const Tape_operation operation = i->operation;
    do
    {
      if (!step(*i, *result))
        return false;
      ++result;
      ++i;
    } while (i != end && i->operation == operation);
    return true;
  }
};

template <class A, class NT>
bool try_divide(const A& a, const NT& b, NT& result)
{
  if (CGAL::certainly(is_zero_decision(b)))
    return false;
  divide(a, b, result);
  return true;
}

// Executes a run of an elementary function. These are never many.
template <class NT>
void run_function(Tape_cursor<NT>& cursor, const NT* w)
{
  using Code = Tape_operation;
  using Functions = Elementary_functions<NT>;
  cursor.run([w](const Tape_instruction& i, NT& r) {
    switch (i.operation)
    {
    case Code::SQRT: r = Functions::sqrt(w[i.a]); break;
    case Code::EXP: r = Functions::exp(w[i.a]); break;
    case Code::LOG: r = Functions::log(w[i.a]); break;
    case Code::SIN: r = Functions::sin(w[i.a]); break;
    case Code::COS: r = Functions::cos(w[i.a]); break;
    case Code::TAN: r = Functions::tan(w[i.a]); break;
    case Code::ASIN: r = Functions::asin(w[i.a]); break;
    case Code::ACOS: r = Functions::acos(w[i.a]); break;
    case Code::ATAN: r = Functions::atan(w[i.a]); break;
    default: r = Functions::pi(); break;
    }
  });
}

// Executes the instructions; w holds all slots, result is the slot of the first instruction.
// Returns the instruction that divides by (certainly) zero, or null when all went well.
template <class NT>
const Tape_instruction* run_tape(const Tape_instruction* begin, const Tape_instruction* end, NT* w,
                                 NT* result, const Tape_constants& constants)
{
  using Code = Tape_operation;
  using I = const Tape_instruction&;
  const Constants_view<NT> k(constants);
  Tape_cursor<NT> at{begin, end, result};
  bool good = true;
  // Captured by value: a store to a vector type could alias anything that is captured by reference.
  while (good && at.i != end)
    switch (at.i->operation)
    {
    case Code::MULTIPLY_ADD: at.run([=](I i, NT& r) { r = w[i.a] * w[i.b] + w[i.c]; }); break;
    case Code::MULTIPLY_SUBTRACT: at.run([=](I i, NT& r) { r = w[i.a] * w[i.b] - w[i.c]; }); break;
    case Code::PRODUCT_FROM: at.run([=](I i, NT& r) { r = w[i.c] - w[i.a] * w[i.b]; }); break;
    case Code::ADD: at.run([=](I i, NT& r) { r = w[i.a] + w[i.b]; }); break;
    case Code::SUBTRACT: at.run([=](I i, NT& r) { r = w[i.a] - w[i.b]; }); break;
    case Code::MULTIPLY: at.run([=](I i, NT& r) { r = w[i.a] * w[i.b]; }); break;
    case Code::SCALE_ADD: at.run([=](I i, NT& r) { r = k[i.c] * w[i.a] + w[i.b]; }); break;
    case Code::SCALE_SUBTRACT: at.run([=](I i, NT& r) { r = k[i.c] * w[i.a] - w[i.b]; }); break;
    case Code::SCALED_FROM: at.run([=](I i, NT& r) { r = w[i.b] - k[i.c] * w[i.a]; }); break;
    case Code::ADD_CONSTANT: at.run([=](I i, NT& r) { r = w[i.a] + k[i.c]; }); break;
    case Code::SUBTRACT_FROM: at.run([=](I i, NT& r) { r = k[i.c] - w[i.a]; }); break;
    case Code::SCALE: at.run([=](I i, NT& r) { r = k[i.c] * w[i.a]; }); break;
    case Code::NEGATE: at.run([=](I i, NT& r) { r = -w[i.a]; }); break;
    case Code::SQUARE: at.run([=](I i, NT& r) { r = square_of(w[i.a]); }); break;
    case Code::LOAD: at.run([=](I i, NT& r) { r = NT(k[i.c]); }); break;
    case Code::DIVIDE:
      good = at.try_run([=](I i, NT& r) { return try_divide(w[i.a], w[i.b], r); });
      break;
    case Code::DIVIDE_INTO:
      good = at.try_run([=](I i, NT& r) { return try_divide(k[i.c], w[i.a], r); });
      break;
    case Code::POWER:
      good = at.try_run([=](I i, NT& r) { return raise(w[i.a], std::int32_t(i.c), r); });
      break;
    default: run_function(at, w);
    }
  return good ? nullptr : at.i;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_RUN_TAPE_H
