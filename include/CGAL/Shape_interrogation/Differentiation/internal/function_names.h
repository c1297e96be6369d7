// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H

// The functions of expressions by name, for the parser and the printer, and which names are left
// for variables.

#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_node.h>

#include <string_view>

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

// What a variable may be called: a letter or '_', then letters, digits and '_'.
inline bool is_identifier(std::string_view name)
{
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  for (const char c : name)
    if (!is_letter(c) && !is_digit(c))
      return false;
  return !name.empty() && !is_digit(name.front());
}

// Identifiers that are no names of variables.
inline bool is_reserved_name(std::string_view name)
{
  for (const Named_function& f : named_functions)
    if (name == f.name)
      return true;
  return name == "pi";
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_FUNCTION_NAMES_H
