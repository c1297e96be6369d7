// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_ANSWERS_H
#define INTERROGATE_ANSWERS_H

// What the tasks find out, free of number types: values and decisions as they go into the report.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace interrogate {

// A value: the nearest double, the exact text where it is known, an enclosure where it is known.
struct Scalar
{
  std::optional<double> approx; // none where the enclosure is unbounded
  std::string exact;
  std::optional<std::pair<double, double>> interval;
};

using Decision = std::optional<bool>;     // none: undecided
using Sign_decision = std::optional<int>; // -1, 0, 1; none: undecided

struct Signed_scalar
{
  Scalar value;
  Sign_decision sign;
  std::optional<Scalar> squared;
};

// The proof of a point of a surface that was asked for by an approximate one.
struct Enclosure_answer
{
  std::vector<Scalar> box;                           // one interval a variable
  std::vector<std::pair<std::string, Scalar>> fixed; // the variables that are held, and where
  std::vector<int> equations;                        // of the proof, counted from 1
  std::vector<int> proved;                           // the others that identities prove
  std::vector<int> others;                           // whose enclosures contain zero
};

// The answer to `curvature` and `shape_operator` about a surface.
struct Surface_answer
{
  std::vector<std::string> side; // of the knots: left or right, where they differ
  std::optional<std::array<Scalar, 3>> point;
  std::array<Scalar, 3> normal;
  Scalar normal_squared_length;
  Signed_scalar gaussian_curvature, mean_curvature;
  std::array<Scalar, 2> principal_curvatures;
  std::optional<std::array<std::array<Scalar, 3>, 2>> principal_directions;
  Decision umbilic, planar;
  std::array<std::array<Scalar, 3>, 3> shape_operator;
  std::optional<Signed_scalar> normal_curvature;
  std::string hessian_case;
  std::optional<Enclosure_answer> enclosure;
};

// The answer to `curvature` about a planar curve.
struct Curve_answer
{
  std::vector<std::string> side;
  std::array<Scalar, 2> point, normal;
  Scalar normal_squared_length;
  Signed_scalar curvature;
  std::array<std::array<Scalar, 2>, 2> hessian;
};

} // namespace interrogate

#endif // INTERROGATE_ANSWERS_H
