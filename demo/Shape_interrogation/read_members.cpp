// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Makes the ingredients of constructions out of surfaces and curves of the model.

#include "read_members.h"

#include "read_numbers.h"
#include "read_shapes.h"
#include "surface_shapes.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>

namespace interrogate {

namespace {

std::string described(int allowed)
{
  std::vector<std::string> parts;
  if ((allowed & SURFACE) == SURFACE)
    parts.push_back("a surface (implicit, parametric, bezier, nurbs)");
  else if (allowed & PARAMETRIC)
    parts.push_back("a surface with parameters (parametric, bezier, nurbs)");
  if (allowed & CURVE)
    parts.push_back("a curve in space (parametric_3, bezier_3, nurbs_3)");
  if (allowed & POINT)
    parts.push_back("a point ({\"point\": [x,y,z]})");
  std::string text = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    text += (i + 1 < parts.size() ? ", " : " or ") + parts[i];
  return text;
}

[[noreturn]] void wrong_kind(const Json_place& place, int allowed, const std::string& found)
{
  place.fail("expected " + described(allowed) + ", found " + found);
}

// --- Surfaces and curves as ingredients -------------------------------------------------------

// Constructions have exact coefficients.
template <class Points>
void require_rational(const Json_place& place, const Points& points)
{
  for (const auto& point : points)
    for (const Number& x : point)
      if (!x.is_constant())
        place.fail("a control point has a root, and constructions take rational ones");
}

// A piecewise function is no equation.
void require_one_span(const Json_place& place, int degree, const std::vector<Rational>& knots)
{
  const auto first = knots.begin() + degree, last = knots.end() - degree;
  const auto spans = std::set<Rational>(first, last).size() - 1;
  if (spans > 1)
    place.fail("the spline has " + std::to_string(spans) + " knot spans, and a construction takes"
               " one: give its Bezier pieces, one at a time");
}

Range domain_of(int degree, const std::vector<Rational>& knots)
{
  if (knots.empty())
    return {Number(0), Number(1)};
  return {Number(knots[degree]), Number(knots[knots.size() - 1 - degree])};
}

Member make_member(const Json_place& place, const Patch_model& m, const std::string& name)
{
  for (const auto& row : m.control_points)
    require_rational(place, row);
  const std::vector<Range> domain{domain_of(m.degree[0], m.knots[0]),
                                  domain_of(m.degree[1], m.knots[1])};
  if (m.knots[0].empty())
    return {si::Parametric_entity_3(make_bezier<Rational>(m), name), domain};
  for (int i = 0; i < 2; ++i)
    require_one_span(place, m.degree[i], m.knots[i]);
  return {si::Parametric_entity_3(make_nurbs<Rational>(m), name), domain};
}

// The curve s -> S(s, 0) of a spline surface that does not depend on its second parameter.
si::Curve_entity_3 make_spline_curve(const Space_curve_model::Spline& m, const std::string& name)
{
  std::vector<std::vector<Vector_3<Rational>>> points;
  std::vector<std::vector<Rational>> weights;
  for (const Numbers<4>& p : m.control_points)
  {
    const std::array<Rational, 4> x = evaluate<Rational>(p);
    points.push_back({2, Vector_3<Rational>{x[0], x[1], x[2]}});
    weights.push_back({2, x[3]});
  }
  using Knots = si::Knot_vector<Rational>;
  const si::Nurbs_surface_3<Rational> surface(Knots(m.degree, m.knots), Knots(1, {0, 0, 1, 1}),
                                              points, weights);
  const si::Constraint_point_3 p = si::Parametric_entity_3(surface).point(
    "", {Expression::variable(0), Expression(0)});
  return si::Curve_entity_3(p.coordinates, name, p.weight);
}

Member make_member(const Json_place& place, const Space_curve_model& model,
                   const std::string& name)
{
  if (const auto* m = std::get_if<Parametric_model>(&model.data))
    return {si::Curve_entity_3({m->x[0], m->x[1], m->x[2]}, name),
            m->domain.value_or(std::vector<Range>())};
  const auto& m = std::get<Space_curve_model::Spline>(model.data);
  require_rational(place, m.control_points);
  const std::vector<Range> domain{domain_of(m.degree, m.knots)};
  if (!m.knots.empty())
  {
    require_one_span(place, m.degree, m.knots);
    return {make_spline_curve(m, name), domain};
  }
  std::vector<si::Coordinates<Rational, 4>> points;
  for (const Numbers<4>& p : m.control_points)
  {
    const std::array<Rational, 4> x = evaluate<Rational>(p);
    const Rational X = x[3] * x[0], Y = x[3] * x[1], Z = x[3] * x[2];
    points.push_back({X, Y, Z, x[3]});
  }
  return {si::Curve_entity_3::bezier(points, name), domain};
}

Member make_member(const Json_place& place, const Surface_model& surface, const std::string& name,
                   int allowed)
{
  const bool has_parameters = !std::holds_alternative<Implicit_model>(surface.data);
  if (const auto* unsupported = std::get_if<Unsupported>(&surface.data))
    throw *unsupported;
  if (std::holds_alternative<System_model>(surface.data) ||
      !(allowed & (has_parameters ? PARAMETRIC : IMPLICIT)))
    wrong_kind(place, allowed, "a surface of the kind \"" + surface.kind + "\"");
  if (const auto* m = std::get_if<Implicit_model>(&surface.data))
    return {si::Implicit_entity_3(m->f, name), {}};
  if (const auto* m = std::get_if<Parametric_model>(&surface.data))
    return {si::Parametric_entity_3({m->x[0], m->x[1], m->x[2]}, name),
            m->domain.value_or(std::vector<Range>())};
  return make_member(place, std::get<Patch_model>(surface.data), name);
}

Member make_member(const Json_place& place, const Curve_model& curve, const std::string& name,
                   int allowed)
{
  const auto* m = std::get_if<Space_curve_model>(&curve);
  if (!m)
    wrong_kind(place, allowed, "a planar curve");
  if (!(allowed & CURVE))
    wrong_kind(place, allowed, "a curve of the kind \"" + m->kind + "\"");
  return make_member(place, *m, name);
}

// --- Members by name --------------------------------------------------------------------------

void add_name(const Json_place& place, std::vector<std::string>& names)
{
  if (place.kind() == Json::Kind::STRING)
    names.push_back(place.string(""));
}

// The names in a surface that is made from others.
std::vector<std::string> names_in(const Json_place& surface)
{
  std::vector<std::string> names;
  for (const char* field : {"of", "reference"})
    if (const std::optional<Json_place> place = surface.find(field))
    {
      add_name(*place, names);
      if (place->kind() == Json::Kind::ARRAY)
        for (const Json_place& member : place->elements(""))
          add_name(member, names);
    }
  return names;
}

// The way from a construction over what it is made of to `end`, as text; empty if there is none.
std::string way(const Named_shapes& shapes, const std::string& start, const std::string& end)
{
  std::map<std::string, std::string> from{{start, ""}};
  std::vector<std::string> waiting{start};
  while (!waiting.empty() && from.count(end) == 0)
  {
    const std::string name = waiting.back();
    waiting.pop_back();
    const std::optional<Json_place> surface = shapes.surfaces.find(name);
    if (surface && is_construction(*surface))
      for (const std::string& next : names_in(*surface))
        if (from.emplace(next, name).second)
          waiting.push_back(next);
  }
  if (from.count(end) == 0)
    return "";
  std::string text = printable(end);
  for (std::string name = end; name != start;)
  {
    name = from[name];
    text = printable(name) + ", " + text;
  }
  return text;
}

// The name of a construction, which no other one takes: a circle is told as such.
[[noreturn]] void fail_at_construction(const Json_place& place, const Named_shapes& shapes,
                                       const Json_place& surface, int allowed)
{
  const std::string& name = place.string("");
  if (name == shapes.self)
    place.fail("the surface is made from itself");
  const std::string circle = way(shapes, name, shapes.self);
  if (!circle.empty())
    place.fail("surfaces are made from each other in a circle: " + printable(shapes.self) + ", " +
               circle);
  wrong_kind(place, allowed, "a surface of the kind \"" + surface.field("kind").string("") +
                               "\", which is a system itself");
}

Member named_member(const Json_place& place, const Named_shapes& shapes, int allowed)
{
  const std::string& name = place.string("");
  const auto curve = shapes.model.curves.find(name);
  const auto surface = shapes.model.surfaces.find(name);
  const bool is_curve = curve != shapes.model.curves.end();
  const bool is_surface = surface != shapes.model.surfaces.end();
  if (is_curve && is_surface && (allowed & SURFACE) && (allowed & CURVE))
    place.fail("both a surface and a curve of the model have the name \"" + printable(name) + "\"");
  if (is_surface && ((allowed & SURFACE) || !is_curve))
    return make_member(place, surface->second, name, allowed);
  if (is_curve)
    return make_member(place, curve->second, name, allowed);
  if (const std::optional<Json_place> construction = shapes.surfaces.find(name))
    fail_at_construction(place, shapes, *construction, allowed);
  wrong_kind(place, allowed,
             "the name \"" + printable(name) + "\", which no surface or curve of the model has");
}

} // namespace

Member read_member(const Json_place& place, const Named_shapes& shapes, int allowed)
{
  if (place.kind() == Json::Kind::STRING)
    return named_member(place, shapes, allowed);
  if (place.kind() != Json::Kind::OBJECT)
    place.expected(described(allowed) + ", by its name or as an object");
  if (const std::optional<Json_place> point = place.find("point"))
  {
    place.allow_only({"point"});
    if (!(allowed & POINT))
      wrong_kind(place, allowed, "a point");
    const Numbers<3> p = read_point<3>(*point, "a point of 3 coordinates");
    return {si::Constraint_point_3{"", p}, {}};
  }
  const std::string& kind = place.field("kind").string("the kind of a surface or curve, a string");
  if (is_curve_kind(kind))
    return make_member(place, read_curve(place), "", allowed);
  if (is_construction(place))
    wrong_kind(place, allowed,
               "a surface of the kind \"" + kind + "\", which is a system itself");
  return make_member(place, read_surface(place), "", allowed);
}

std::vector<Member> read_of(const Json_place& place, const Named_shapes& shapes,
                            std::size_t least, std::size_t most, int allowed)
{
  const Json_place of = place.field("of");
  if (most == 1 && of.kind() != Json::Kind::ARRAY)
    return {read_member(of, shapes, allowed)};
  const std::string number = std::to_string(least) +
                             (least < most ? " or " + std::to_string(most) : std::string());
  const std::string what = "an array of " + number + (most == 1 ? " member, " : " members, each ") +
                           described(allowed);
  const std::vector<Json_place> elements = of.elements(what);
  if (elements.size() < least || elements.size() > most)
    of.expected(what);
  std::vector<Member> members;
  for (const Json_place& member : elements)
    members.push_back(read_member(member, shapes, allowed));
  return members;
}

} // namespace interrogate
