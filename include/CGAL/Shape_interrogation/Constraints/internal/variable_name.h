// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_VARIABLE_NAME_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_VARIABLE_NAME_H

// Which names variables may have: those that the parser of expressions reads.

#include <CGAL/Shape_interrogation/Differentiation/internal/function_names.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

inline void check_new_variable(const std::string& name, const std::vector<std::string>& others)
{
  if (!is_identifier(name) || is_reserved_name(name))
    throw Shape_error("'" + name + "' is no name for a variable: expected a letter or '_' followed"
                      " by letters, digits and '_', not 'pi' and not the name of a function");
  if (std::find(others.begin(), others.end(), name) != others.end())
    throw Shape_error("the system already has a variable '" + name + "'");
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_VARIABLE_NAME_H
