// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_EXACT_COST_H
#define INTERROGATE_EXACT_COST_H

// Keeps exact tasks from running for ages: the cost of exact values is estimated before.

#include "Model.h"

#include <vector>

namespace interrogate {

// Throw Limit_error if exact values at the numbers would have too many digits: x^4096 at a number
// of a thousand digits is one of four million.
void check_exact_cost(const Surface_model& surface, const std::vector<Number>& at);
void check_exact_cost(const Curve_model& curve, const std::vector<Number>& at);

} // namespace interrogate

#endif // INTERROGATE_EXACT_COST_H
