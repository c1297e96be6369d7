// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The functions are run with the size of a number in place of the number.

#include "exact_cost.h"

#include "evaluate_numbers.h"
#include "functions_of.h"
#include "Number_size.h"

#include <algorithm>

namespace interrogate {

namespace {

// Bits times operations. Some seconds, with the derivatives.
constexpr double highest_cost = 2e8;

void check(double cost)
{
  if (cost > highest_cost)
    throw si::Limit_error("exact values would have too many digits here: use interval, filtered or"
                          " double, or numbers with fewer digits");
}

double bits_of(const Number& number)
{
  return evaluate<Number_size>(number).bits();
}

template <class Points>
double largest_bits(const Points& points)
{
  double largest = 1;
  for (const auto& point : points)
    for (const Number& number : point)
      largest = (std::max)(largest, bits_of(number));
  return largest;
}

// Of the functions.
double cost(const std::vector<Expression>& functions, const std::vector<Number>& at)
{
  const si::Expression_tape tape(functions, static_cast<int>(at.size()),
                                 si::Expression_tape::Derivatives::NONE);
  const std::vector<Number_size> sizes = evaluate<Number_size>(at);
  Number_size::total_bits() = 0;
  tape.evaluate(sizes);
  return Number_size::total_bits();
}

// Of the sums over the control points that a place depends on.
double cost(const Patch_model& patch, const std::vector<Number>& at)
{
  const double powers = patch.degree[0] * bits_of(at[0]) + patch.degree[1] * bits_of(at[1]);
  double largest = 1;
  for (const auto& row : patch.control_points)
    largest = (std::max)(largest, largest_bits(row));
  return (patch.degree[0] + 1.0) * (patch.degree[1] + 1.0) * (powers + largest);
}

double cost(const Spline_model& curve, const std::vector<Number>& at)
{
  const double powers = curve.degree * bits_of(at[0]);
  return (curve.degree + 1.0) * (powers + largest_bits(curve.control_points));
}

} // namespace

void check_exact_cost(const Surface_model& surface, const std::vector<Number>& at)
{
  const auto* patch = std::get_if<Patch_model>(&surface.data);
  check(patch ? cost(*patch, at) : cost(std::visit(Functions_of(), surface.data), at));
}

void check_exact_cost(const Curve_model& curve, const std::vector<Number>& at)
{
  const auto* spline = std::get_if<Spline_model>(&curve);
  check(spline ? cost(*spline, at) : cost(std::visit(Functions_of(), curve), at));
}

} // namespace interrogate
