// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_MAKE_SYSTEMS_H
#define INTERROGATE_MAKE_SYSTEMS_H

// Surfaces of all kinds as systems in n-space, for the tasks that work there.

#include "Model.h"

#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace interrogate {

// A system, and the ranges of its variables.
struct Bounded_system
{
  si::N_space_system system;
  std::vector<si::N_space_bound> bounds;
};

// The surface itself, its function, or its graph. A spline must be a single piece.
Bounded_system make_system(const Surface_model& surface);
// Both at the same point of space: see intersection_system().
Bounded_system make_system(const Surface_model& a, const Surface_model& b);

std::size_t number_of_pieces(const Patch_model& patch);

// The names of the variables of these systems, and those of a surface's parameters.
std::vector<std::string> variables_of(const Surface_model& surface);
std::vector<std::string> joint_variables(const Surface_model& a, const Surface_model& b);
std::vector<std::string> parameters_of(const Surface_model& surface);

// From the coordinates in a locator of the surface to those in n-space.
std::vector<double> lifted(const Surface_model& surface, const std::vector<double>& start);

// Adds a box for the three first variables. Each variable keeps one range.
void add_box(const std::array<Range, 3>& box, std::vector<si::N_space_bound>& bounds);

} // namespace interrogate

#endif // INTERROGATE_MAKE_SYSTEMS_H
