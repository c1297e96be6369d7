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

#include <string>
#include <vector>

namespace interrogate {

// All surfaces but the constructions.
Surface_model read_surface(const Json_place& place);
Curve_model read_curve(const Json_place& place);

// Whether the kind is one that is given for curves only.
bool is_curve_kind(const std::string& kind);

// Systems, in read_systems.cpp: one that is written down, the bounds of variables, and what all
// systems may have beside, "orient" and "flip".
System_model read_system(const Json_place& place);
std::vector<si::N_space_bound> read_bounds(const Json_place& place,
                                           const std::vector<std::string>& variables);
void read_orientation(const Json_place& place, Surface_model& surface);

// Surfaces that are made from others, in read_constructions.cpp. The other surfaces and all curves
// of the model have been read; `surfaces` are all surfaces as they are written.
bool is_construction(const Json_place& place);
Surface_model read_construction(const Json_place& place, const std::string& name,
                                const Model& model, const Json_place& surfaces);

// Control points and knots, in read_patches.cpp.
Patch_model read_bezier_surface(const Json_place& place);
Patch_model read_nurbs_surface(const Json_place& place);
Spline_model read_bezier_curve(const Json_place& place);
Spline_model read_nurbs_curve(const Json_place& place);
Space_curve_model::Spline read_space_spline(const Json_place& place, bool has_knots);

} // namespace interrogate

#endif // INTERROGATE_READ_SHAPES_H
