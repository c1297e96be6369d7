// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads control points, weights and knots, and checks that they belong together.

#include "read_shapes.h"

#include "read_numbers.h"

#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>

namespace interrogate {

namespace {

// Evaluation takes time with the square of the degree and more.
constexpr int highest_degree = 64;

// Coordinates and weight; the weight 1 where none is given.
template <std::size_t d>
std::array<Number, d + 1> read_control_point(const Json_place& place, bool& is_rational)
{
  const std::string n = std::to_string(d);
  const std::string what = "a control point of " + n + " coordinates, or of " + n +
                           " and a weight";
  const std::size_t size = place.elements(what).size();
  if (size != d && size != d + 1)
    place.expected(what);
  const std::vector<Number> numbers = read_numbers(place, size, what);
  std::array<Number, d + 1> point;
  point[d] = Number(1);
  std::copy(numbers.begin(), numbers.end(), point.begin());
  is_rational = is_rational || size == d + 1;
  return point;
}

std::vector<Json_place> at_least_two(const Json_place& place, const std::string& what)
{
  const std::vector<Json_place> elements = place.elements(what);
  if (elements.size() < 2)
    place.expected(what);
  return elements;
}

void read_control_net(const Json_place& place, Patch_model& model)
{
  for (const Json_place& row : at_least_two(place, "two or more rows of control points"))
  {
    model.control_points.emplace_back();
    for (const Json_place& point : at_least_two(row, "a row of two or more control points"))
      model.control_points.back().push_back(read_control_point<3>(point, model.is_rational));
    if (model.control_points.back().size() != model.control_points.front().size())
      row.fail("this row has " + std::to_string(model.control_points.back().size()) +
               " control points, the first one has " +
               std::to_string(model.control_points.front().size()));
  }
}

template <std::size_t d>
std::vector<Numbers<d + 1>> read_control_polygon(const Json_place& place, bool& is_rational)
{
  std::vector<Numbers<d + 1>> points;
  for (const Json_place& point : at_least_two(place, "an array of two or more control points"))
    points.push_back(read_control_point<d>(point, is_rational));
  return points;
}

int bezier_degree(const Json_place& place, std::size_t points)
{
  if (points > highest_degree + 1)
    place.fail("the degree is " + std::to_string(points - 1) + ", the highest is " +
               std::to_string(highest_degree));
  return static_cast<int>(points) - 1;
}

int read_degree(const Json_place& place, std::size_t points)
{
  const int degree = read_integer(place, 1, highest_degree);
  if (static_cast<std::size_t>(degree) >= points)
    place.fail("a degree of " + std::to_string(degree) + " needs " + std::to_string(degree + 1) +
               " control points or more in this direction, there are " + std::to_string(points));
  return degree;
}

std::vector<Rational> read_knots(const Json_place& place, int degree, std::size_t points)
{
  const std::size_t size = points + degree + 1;
  const std::string what = "an array of " + std::to_string(size) + " knots (" +
                           std::to_string(points) + " control points + the degree " +
                           std::to_string(degree) + " + 1)";
  std::vector<Rational> knots;
  for (const Json_place& knot : place.elements(size, what))
    knots.push_back(read_rational(knot));
  using Knot_vector = CGAL::Shape_interrogation::Knot_vector<Rational>;
  if (const std::optional<std::string> reason = Knot_vector::why_invalid(degree, knots))
    place.fail(*reason);
  return knots;
}

} // namespace

Patch_model read_bezier_surface(const Json_place& place)
{
  place.allow_only({"kind", "control_points", "flip"});
  const Json_place points = place.field("control_points");
  Patch_model model;
  read_control_net(points, model);
  model.degree = {bezier_degree(points, model.control_points.size()),
                  bezier_degree(points, model.control_points.front().size())};
  return model;
}

Patch_model read_nurbs_surface(const Json_place& place)
{
  place.allow_only({"kind", "degree", "knots", "control_points", "flip"});
  Patch_model model;
  read_control_net(place.field("control_points"), model);
  const std::vector<Json_place> degrees = place.field("degree").elements(2, "two degrees [p,q]");
  const std::vector<Json_place> knots = place.field("knots").elements(2, "two knot vectors");
  const std::array<std::size_t, 2> points = {model.control_points.size(),
                                             model.control_points.front().size()};
  for (int i = 0; i < 2; ++i)
  {
    model.degree[i] = read_degree(degrees[i], points[i]);
    model.knots[i] = read_knots(knots[i], model.degree[i], points[i]);
  }
  return model;
}

Spline_model read_bezier_curve(const Json_place& place)
{
  place.allow_only({"kind", "control_points"});
  const Json_place points = place.field("control_points");
  Spline_model model;
  model.control_points = read_control_polygon<2>(points, model.is_rational);
  model.degree = bezier_degree(points, model.control_points.size());
  return model;
}

Spline_model read_nurbs_curve(const Json_place& place)
{
  place.allow_only({"kind", "degree", "knots", "control_points"});
  Spline_model model;
  model.control_points = read_control_polygon<2>(place.field("control_points"), model.is_rational);
  model.degree = read_degree(place.field("degree"), model.control_points.size());
  model.knots = read_knots(place.field("knots"), model.degree, model.control_points.size());
  return model;
}

Space_curve_model::Spline read_space_spline(const Json_place& place, bool has_knots)
{
  if (has_knots)
    place.allow_only({"kind", "degree", "knots", "control_points"});
  else
    place.allow_only({"kind", "control_points"});
  const Json_place points = place.field("control_points");
  Space_curve_model::Spline model;
  bool is_rational = false;
  model.control_points = read_control_polygon<3>(points, is_rational);
  const std::size_t size = model.control_points.size();
  if (!has_knots)
  {
    model.degree = bezier_degree(points, size);
    return model;
  }
  model.degree = read_degree(place.field("degree"), size);
  model.knots = read_knots(place.field("knots"), model.degree, size);
  return model;
}

} // namespace interrogate
