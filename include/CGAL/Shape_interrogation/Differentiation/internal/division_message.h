// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIVISION_MESSAGE_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIVISION_MESSAGE_H

// The sentence for a division by zero: the divisor is recorded again by running the tape over
// expressions, and printed.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/run_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline std::string division_message(const Tape_instruction* begin, const Tape_instruction* failed,
                                    const Tape_constants& constants, int number_of_variables,
                                    const std::vector<std::string>& names)
{
  const std::string sentence = "division by an expression that is zero at this point";
  constexpr std::ptrdiff_t longest_replay = 10000;
  if (failed - begin > longest_replay)
    return sentence;
  const std::size_t n = static_cast<std::size_t>(number_of_variables);
  std::vector<Expression> slots(n + static_cast<std::size_t>(failed - begin));
  for (int i = 0; i < number_of_variables; ++i)
    slots[i] = Expression::variable(i);
  if (run_tape(begin, failed, slots.data(), slots.data() + n, constants))
    return sentence;
  const bool second = failed->operation == Tape_operation::DIVIDE;
  const std::uint32_t divisor = second ? failed->b : failed->a;
  return sentence + ": " + to_string(slots[divisor], names, 120);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIVISION_MESSAGE_H
