// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H

// The functions of expressions by name, for the parser and the printer.

#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_node.h>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Named_function
{
  const char* name;
  Expression_operation operation;
};

inline constexpr Named_function named_functions[] = {
  {"sqrt", Expression_operation::SQRT}, {"exp", Expression_operation::EXP},
  {"log", Expression_operation::LOG},   {"sin", Expression_operation::SIN},
  {"cos", Expression_operation::COS},   {"tan", Expression_operation::TAN},
  {"asin", Expression_operation::ASIN}, {"acos", Expression_operation::ACOS},
  {"atan", Expression_operation::ATAN}};

// The name of a function; empty for other operations.
inline const char* function_name(Expression_operation operation)
{
  for (const Named_function& f : named_functions)
    if (f.operation == operation)
      return f.name;
  return "";
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H
