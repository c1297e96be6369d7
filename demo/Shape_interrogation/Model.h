// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_MODEL_H
#define INTERROGATE_MODEL_H

// A model as it was read and checked: surfaces, curves and tasks, with all numbers still exact.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace interrogate {

namespace si = CGAL::Shape_interrogation;

using si::Expression;

using Number = Expression; // without variables
using Rational = CGAL::Exact_rational;
template <int d>
using Numbers = std::array<Number, d>;
using Range = std::array<Number, 2>;

// f = 0 in the plane or in space.
struct Implicit_model
{
  std::vector<std::string> variables;
  Expression f;
};

// d functions of one or two parameters.
struct Parametric_model
{
  std::vector<std::string> parameters;
  std::vector<Expression> x;
  std::optional<std::vector<Range>> domain; // one range a parameter
};

// A Bezier surface, which has no knots, or a NURBS surface: control_points[i][j], i along the first
// parameter, as coordinates and weight.
struct Patch_model
{
  std::array<int, 2> degree{};
  std::array<std::vector<Rational>, 2> knots;
  std::vector<std::vector<Numbers<4>>> control_points;
  bool is_rational = false;
};

// The same for a planar curve.
struct Spline_model
{
  int degree = 0;
  std::vector<Rational> knots;
  std::vector<Numbers<3>> control_points;
  bool is_rational = false;
};

// A curve in space, which constructions are made of: three functions of one parameter, or control
// points with their weights.
struct Space_curve_model
{
  struct Spline
  {
    int degree = 0;
    std::vector<Rational> knots; // none for a Bezier curve
    std::vector<Numbers<4>> control_points;
  };

  std::string kind;
  std::variant<Parametric_model, Spline> data;
};

// The projection of the common zeros of m functions of n variables onto the first three. Each
// variable has one bound at most, and they are in the order of the variables.
struct System_model
{
  std::vector<std::string> variables;
  std::vector<Expression> equations;
  std::vector<si::N_space_bound> bounds;
  std::optional<si::Constraint_system> constraints; // of a construction
};

// A kind of the format that this version does not offer.
struct Unsupported
{
  std::string kind;
};

struct Surface_model
{
  std::string kind;
  std::variant<Implicit_model, Parametric_model, Patch_model, System_model, Unsupported> data;
  bool flip = false;
  std::optional<std::array<Rational, 3>> orient; // of a system
};

using Curve_model = std::variant<Implicit_model, Parametric_model, Spline_model, Space_curve_model,
                                 Unsupported>;

enum class Number_type { EXACT, INTERVAL, DOUBLE, FILTERED };

// Curvature of a surface or of a planar curve at a place: a point or parameters.
struct Curvature_task
{
  std::string surface, curve; // one of them is empty
  std::vector<Number> at;
  bool enclose = false; // the proved point near `at`
  std::optional<std::vector<Number>> direction;
};

struct Shape_operator_task
{
  Numbers<3> normal;
  std::array<Numbers<3>, 3> directions;
  Numbers<3> curvatures;
};

struct Mesh_task
{
  std::vector<std::string> surfaces;
  std::string file;
  Number edge_length;
  std::optional<Number> tolerance;
  std::optional<std::array<Range, 3>> box;
  std::optional<std::size_t> max_vertices;
  std::string colour; // the property that is shown, or empty
  std::vector<std::vector<double>> starts; // of a system, in n-space
  std::string folds_file;                  // of a system, or empty
};

// The intersection of two surfaces, the solutions of one system, or a section.
struct Line_task
{
  std::vector<std::string> surfaces;
  std::vector<std::vector<double>> starts; // one a surface, or one in the space of both
  std::vector<double> condition;           // of a section: condition . point = value
  double value = 0;
  Number step;
  std::optional<std::array<Range, 3>> box;
  std::optional<std::size_t> max_points;
  std::string file; // or empty
};

// The tasks `property` and `bound`.
struct Property_task
{
  std::string surface;
  si::Property property;
  Numbers<3> up, view, light;
  std::optional<Numbers<3>> eye;
  Number level;
  std::optional<std::vector<Number>> at;
  std::string file; // or empty
  std::optional<Number> bound;
  bool is_upper = true; // the bound is `at_most`
};

// What the format knows and this version does not offer: the sentence that says so.
struct Unsupported_task
{
  std::string what;
};

struct Task
{
  std::string id;
  std::string kind;
  std::optional<Number_type> number_type;
  std::variant<Curvature_task, Shape_operator_task, Mesh_task, Line_task, Property_task,
               Unsupported_task>
    data;
};

struct Model
{
  std::map<std::string, Surface_model> surfaces;
  std::map<std::string, Curve_model> curves;
  std::vector<Task> tasks;
};

} // namespace interrogate

#endif // INTERROGATE_MODEL_H
