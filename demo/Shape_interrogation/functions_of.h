// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_FUNCTIONS_OF_H
#define INTERROGATE_FUNCTIONS_OF_H

// The functions that a surface or curve is made of; those made of control points have none.

#include "Model.h"

#include <algorithm>
#include <vector>

namespace interrogate {

struct Functions_of
{
  using Expressions = std::vector<Expression>;

  Expressions operator()(const Implicit_model& m) const { return {m.f}; }
  Expressions operator()(const Parametric_model& m) const { return m.x; }
  Expressions operator()(const System_model& m) const { return m.equations; }
  template <class Other>
  Expressions operator()(const Other&) const { return {}; }
};

inline bool are_algebraic(const std::vector<Expression>& functions)
{
  return std::all_of(functions.begin(), functions.end(),
                     [](const Expression& f) { return f.is_algebraic(); });
}

} // namespace interrogate

#endif // INTERROGATE_FUNCTIONS_OF_H
