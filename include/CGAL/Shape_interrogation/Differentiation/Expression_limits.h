// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_LIMITS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_LIMITS_H

// Bounds that keep a hostile or mistaken expression from exhausting the machine.

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief collects the limits that expressions are checked against.
 *
 * A text that exceeds one is refused with a `Parse_error` that shows the place, a recorded
 * expression with a `Limit_error`. Raise a limit by passing a changed copy.
 */
struct Expression_limits
{
  std::size_t text_size = std::size_t(1) << 20; //!< characters of a text
  std::size_t depth = 256;                      //!< nested parentheses of a text
  std::size_t digits = 4096;                    //!< digits of one numeral
  std::size_t decimal_exponent = 4096;          //!< magnitude of the exponent of a numeral
  std::size_t constant_bits = 16384;            //!< bits of a constant folded in a text
  std::size_t exponent = 4096;                  //!< magnitude of an exponent in a text
  std::uint32_t degree = std::uint32_t(1) << 20; //!< `Expression::degree_bound()`
  std::size_t nodes = 4000000;                  //!< distinct operations of a tape
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_LIMITS_H
