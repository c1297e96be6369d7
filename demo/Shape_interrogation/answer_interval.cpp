// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Answers as enclosures.

#include "answer_in.h"

namespace interrogate {

template si::Result<std::vector<Surface_answer>> answer<Interval>(const Surface_model&,
                                                           const Curvature_task&);
template si::Result<std::vector<Curve_answer>> answer<Interval>(const Curve_model&,
                                                         const Curvature_task&);
template si::Result<std::vector<Surface_answer>> answer<Interval>(const Shape_operator_task&);

} // namespace interrogate
