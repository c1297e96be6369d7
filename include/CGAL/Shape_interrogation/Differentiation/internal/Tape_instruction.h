// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_INSTRUCTION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_INSTRUCTION_H

// The instructions of a tape: instruction k writes slot n + k, the variables fill the first n
// slots, and constants are operands of their own instructions.

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// a and b are slots; c is a constant, an exponent, or (in the first group) a slot.
enum class Tape_operation : std::uint32_t
{
  MULTIPLY_ADD,      // a * b + c
  MULTIPLY_SUBTRACT, // a * b - c
  PRODUCT_FROM,      // c - a * b

  ADD,               // a + b
  SUBTRACT,          // a - b
  MULTIPLY,          // a * b
  DIVIDE,            // a / b
  SCALE_ADD,         // constant c * a + b
  SCALE_SUBTRACT,    // constant c * a - b
  SCALED_FROM,       // b - constant c * a

  ADD_CONSTANT,      // a + constant c
  SUBTRACT_FROM,     // constant c - a
  SCALE,             // constant c * a
  DIVIDE_INTO,       // constant c / a
  NEGATE, SQUARE,    // of a
  POWER,             // a to the c
  SQRT, EXP, LOG, SIN, COS, TAN, ASIN, ACOS, ATAN, // of a

  LOAD,              // constant c
  PI
};

constexpr std::size_t number_of_tape_operations = static_cast<std::size_t>(Tape_operation::PI) + 1;

struct Tape_instruction
{
  Tape_operation operation;
  std::uint32_t a, b, c;
};

// Calls f for the operands that are slots.
template <class Instruction, class Function>
void for_each_slot(Instruction& i, Function f)
{
  if (i.operation < Tape_operation::LOAD)
    f(i.a);
  if (i.operation < Tape_operation::ADD_CONSTANT)
    f(i.b);
  if (i.operation < Tape_operation::ADD)
    f(i.c);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_INSTRUCTION_H
