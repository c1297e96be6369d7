// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_CONSTANT_PARTS_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_CONSTANT_PARTS_H

// What is given by numbers: whether an expression has variables, whether its numbers are real, and
// whether two lists of expressions record the same operations.

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_graph.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

inline bool has_variables(const Expression& x)
{
  Expression_graph graph{Expression_limits()};
  return graph[graph.insert(x)].depends;
}

// Refuses roots of negative numbers and other numbers that do not exist, wherever they occur in
// the expression.
inline void check_real(const Expression& x, const std::string& what)
{
  Expression_graph graph{Expression_limits()};
  graph.insert(x);
  std::vector<Expression> numbers;
  for (int i = 0; i < graph.size(); ++i)
    if (!graph[i].depends)
      numbers.push_back(graph.expression(i));
  const Expression_tape tape(numbers, 0, Expression_tape::Derivatives::NONE);
  std::string evidence;
  try
  {
    Interval_nt<false>::Protector protector;
    tape.evaluate(std::vector<Interval_nt<false>>());
  }
  catch (const Domain_error& error) { evidence = error.what(); }
  catch (const Division_by_zero_error& error) { evidence = error.what(); }
  if (!evidence.empty())
    throw Shape_error(what + " is not a real number: " + evidence);
}

inline bool are_same(const std::vector<Expression>& a, const std::vector<Expression>& b)
{
  const auto identical = [](const Expression& x, const Expression& y) { return x.is_identical(y); };
  if (std::equal(a.begin(), a.end(), b.begin(), b.end(), identical))
    return true;
  Expression_graph graph{Expression_limits()};
  const auto same = [&](const Expression& x, const Expression& y) {
    return graph.insert(x) == graph.insert(y);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_CONSTANT_PARTS_H
