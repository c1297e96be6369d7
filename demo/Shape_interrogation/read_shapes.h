// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_READ_SHAPES_H
#define INTERROGATE_READ_SHAPES_H

// Surfaces and curves of a model. All throw Model_error with the place.

#include "Json_place.h"
#include "Model.h"

namespace interrogate {

Surface_model read_surface(const Json_place& place);
Curve_model read_curve(const Json_place& place);

// Control points and knots, in read_patches.cpp.
Patch_model read_bezier_surface(const Json_place& place);
Patch_model read_nurbs_surface(const Json_place& place);
Spline_model read_bezier_curve(const Json_place& place);
Spline_model read_nurbs_curve(const Json_place& place);

} // namespace interrogate

#endif // INTERROGATE_READ_SHAPES_H
