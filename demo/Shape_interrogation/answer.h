// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_ANSWER_H
#define INTERROGATE_ANSWER_H

// The answers in a number type. They are compiled once for each, in answer_double.cpp,
// answer_interval.cpp and answer_exact.cpp.

#include "Answers.h"
#include "evaluate_numbers.h"
#include "Model.h"

#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <vector>

namespace interrogate {

// More than one answer where the data differ from side to side; the first is that from the right.
template <class NT>
si::Result<std::vector<Surface_answer>> answer(const Surface_model& surface,
                                               const Curvature_task& task);
template <class NT>
si::Result<std::vector<Curve_answer>> answer(const Curve_model& curve,
                                             const Curvature_task& task);
template <class NT>
si::Result<std::vector<Surface_answer>> answer(const Shape_operator_task& task);

// About the proved point of a system, in as many bits as the nearest doubles of the values need.
si::Result<std::vector<Surface_answer>> answer_in_bits(const Surface_model& surface,
                                                       const Curvature_task& task);

} // namespace interrogate

#endif // INTERROGATE_ANSWER_H
