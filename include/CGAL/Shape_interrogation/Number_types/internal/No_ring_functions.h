// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_NO_RING_FUNCTIONS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_NO_RING_FUNCTIONS_H

// A stage of the filter that is a ring has no functions: it says so, and the next stage takes over.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
struct No_ring_functions
{
  static NT sqrt(const NT&) { return pass_on(); }
  static NT exp(const NT&) { return pass_on(); }
  static NT log(const NT&) { return pass_on(); }
  static NT sin(const NT&) { return pass_on(); }
  static NT cos(const NT&) { return pass_on(); }
  static NT tan(const NT&) { return pass_on(); }
  static NT asin(const NT&) { return pass_on(); }
  static NT acos(const NT&) { return pass_on(); }
  static NT atan(const NT&) { return pass_on(); }
  static NT pi() { return pass_on(); }

private:
  [[noreturn]] static NT pass_on() { throw Conversion_error("this filter stage is a ring"); }
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_NO_RING_FUNCTIONS_H
