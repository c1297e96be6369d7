// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Surfaces of all kinds as systems in n-space.

#include "make_systems.h"

#include "surface_shapes.h"

#include <CGAL/Shape_interrogation/Constraints/parametric_graph.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Surfaces/intersection_system.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace interrogate {

namespace {

bool has_parameters(const Surface_model& surface)
{
  return std::holds_alternative<Parametric_model>(surface.data) ||
         std::holds_alternative<Patch_model>(surface.data);
}

si::Parametric_entity_3 entity_of(const Surface_model& surface)
{
  if (const auto* m = std::get_if<Parametric_model>(&surface.data))
    return si::Parametric_entity_3({m->x[0], m->x[1], m->x[2]});
  const Patch_model& patch = std::get<Patch_model>(surface.data);
  return patch.knots[0].empty() ? si::Parametric_entity_3(make_bezier<Rational>(patch))
                                : si::Parametric_entity_3(make_nurbs<Rational>(patch));
}

// A bound is rational: a root is rounded.
Rational exact_or_rounded(const Number& x)
{
  if (x.is_constant())
    return x.constant();
  const double rounded = evaluate<double>(x);
  if (!std::isfinite(rounded))
    throw si::Limit_error("the end of a range is not finite in floating point");
  return Rational(rounded);
}

si::N_space_bound bound_of(int variable, const Range& range)
{
  return {variable, exact_or_rounded(range[0]), exact_or_rounded(range[1])};
}

// The domain as the bounds of the variables s and t.
std::vector<si::N_space_bound> domain_of(const Surface_model& surface)
{
  std::vector<si::N_space_bound> bounds;
  if (const auto* m = std::get_if<Parametric_model>(&surface.data))
    for (int i = 0; m->domain && i < 2; ++i)
      bounds.push_back(bound_of(3 + i, (*m->domain)[i]));
  if (const auto* m = std::get_if<Patch_model>(&surface.data))
    for (int i = 0; i < 2; ++i)
    {
      const std::vector<Rational>& knots = m->knots[i];
      const std::size_t p = m->degree[i];
      bounds.push_back(knots.empty() ? si::N_space_bound{3 + i, 0, 1}
                                     : si::N_space_bound{3 + i, knots[p],
                                                         knots[knots.size() - 1 - p]});
    }
  return bounds;
}

void add(const si::N_space_bound& bound, std::vector<si::N_space_bound>& bounds)
{
  for (si::N_space_bound& b : bounds)
    if (b.variable == bound.variable)
    {
      b.lower = (std::max)(b.lower, bound.lower);
      b.upper = (std::min)(b.upper, bound.upper);
      return;
    }
  bounds.push_back(bound);
}

} // namespace

Bounded_system make_system(const Surface_model& surface)
{
  if (const auto* m = std::get_if<System_model>(&surface.data))
    return {si::N_space_system(m->variables, m->equations), m->bounds};
  if (const auto* m = std::get_if<Implicit_model>(&surface.data))
    return {si::N_space_system(m->variables, {m->f}), {}};
  return {si::parametric_graph(entity_of(surface)).n_space_system(), domain_of(surface)};
}

Bounded_system make_system(const Surface_model& a, const Surface_model& b)
{
  const Bounded_system first = make_system(a), second = make_system(b);
  Bounded_system both{si::intersection_system(first.system, second.system), first.bounds};
  for (si::N_space_bound bound : second.bounds)
  {
    if (bound.variable >= 3)
      bound.variable += first.system.number_of_variables() - 3;
    add(bound, both.bounds);
  }
  return both;
}

std::size_t number_of_pieces(const Patch_model& patch)
{
  std::size_t pieces = 1;
  for (int i = 0; i < 2 && !patch.knots[i].empty(); ++i)
    pieces *= std::set<Rational>(patch.knots[i].begin() + patch.degree[i],
                                 patch.knots[i].end() - patch.degree[i]).size() - 1;
  return pieces;
}

std::vector<std::string> variables_of(const Surface_model& surface)
{
  if (const auto* m = std::get_if<System_model>(&surface.data))
    return m->variables;
  if (const auto* m = std::get_if<Implicit_model>(&surface.data))
    return m->variables;
  return {"x", "y", "z", "s", "t"};
}

std::vector<std::string> joint_variables(const Surface_model& a, const Surface_model& b)
{
  const auto names_only = [](const Surface_model& surface) {
    return si::N_space_system(variables_of(surface), {Expression::variable(0)});
  };
  return si::intersection_system(names_only(a), names_only(b)).variables();
}

std::vector<std::string> parameters_of(const Surface_model& surface)
{
  const auto* m = std::get_if<Parametric_model>(&surface.data);
  return m ? m->parameters : std::vector<std::string>{"u", "v"};
}

std::vector<double> lifted(const Surface_model& surface, const std::vector<double>& start)
{
  if (!has_parameters(surface))
    return start;
  const si::Constraint_point_3 p = entity_of(surface).point(
    "", {Expression(Rational(start[0])), Expression(Rational(start[1]))});
  const double w = evaluate<double>(p.weight);
  std::vector<double> point;
  for (const Expression& x : p.coordinates)
    point.push_back(evaluate<double>(x) / w);
  point.insert(point.end(), start.begin(), start.end());
  return point;
}

void add_box(const std::array<Range, 3>& box, std::vector<si::N_space_bound>& bounds)
{
  for (int i = 0; i < 3; ++i)
    add(bound_of(i, box[i]), bounds);
}

} // namespace interrogate
