// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_SURFACE_SHAPES_H
#define INTERROGATE_SURFACE_SHAPES_H

// The second-order data of a surface of the model at a place, in a number type: the library's
// classes made from the model's fields.

#include "evaluate_numbers.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <string>
#include <vector>

namespace interrogate {

// The data from one side of the knots of both parameters; most places have but one.
template <class NT>
struct Sided_shape
{
  std::vector<std::string> side; // left or right; empty where there is but one
  si::Local_shape_3<NT> shape;
};

template <class NT>
using Shapes = std::vector<Sided_shape<NT>>;

template <class NT>
using Vector_3 = si::Coordinates<NT, 3>;

template <class NT>
si::Result<Shapes<NT>> one_side(const si::Result<si::Local_shape_3<NT>>& shape)
{
  if (!shape)
    return shape.refusal();
  return Shapes<NT>{{{}, *shape}};
}

inline si::Implicit_surface_3<si::Expression_function<3>> make_surface(const Implicit_model& model)
{
  si::Expression_function<3> f(model.f);
  f.set_variable_names(model.variables);
  return si::Implicit_surface_3<si::Expression_function<3>>(f);
}

inline si::Parametric_surface_3<si::Expression_function<2, 3>>
make_surface(const Parametric_model& model)
{
  si::Expression_function<2, 3> x(model.x);
  x.set_variable_names(model.parameters);
  return si::Parametric_surface_3<si::Expression_function<2, 3>>(x);
}

// Control points and weights; no weights if all are 1.
template <class NT>
struct Control_net
{
  explicit Control_net(const Patch_model& model)
  {
    for (const auto& row : model.control_points)
    {
      points.emplace_back();
      if (model.is_rational)
        weights.emplace_back();
      for (const Numbers<4>& p : row)
      {
        const std::array<NT, 4> x = evaluate<NT>(p);
        points.back().push_back({x[0], x[1], x[2]});
        if (model.is_rational)
          weights.back().push_back(x[3]);
      }
    }
  }

  std::vector<std::vector<Vector_3<NT>>> points;
  std::vector<std::vector<NT>> weights;
};

template <class NT>
si::Bezier_surface_3<NT> make_bezier(const Patch_model& model)
{
  const Control_net<NT> net(model);
  return si::Bezier_surface_3<NT>(net.points, net.weights);
}

template <class NT>
si::Nurbs_surface_3<NT> make_nurbs(const Patch_model& model)
{
  const Control_net<NT> net(model);
  using Knots = si::Knot_vector<Rational>; // decides which knots are equal
  return si::Nurbs_surface_3<NT>(
    Knots(model.degree[0], model.knots[0]).template cast<NT>(),
    Knots(model.degree[1], model.knots[1]).template cast<NT>(), net.points, net.weights);
}

inline const char* name_of(si::Side side) { return side == si::Side::LEFT ? "left" : "right"; }

inline si::N_space_surface_3 make_surface(const System_model& model,
                                          const std::optional<std::array<Rational, 3>>& orient)
{
  si::N_space_system system(model.variables, model.equations);
  if (orient)
    system.set_orientation(*orient);
  return si::N_space_surface_3(std::move(system));
}

template <class NT>
si::Result<Shapes<NT>> nurbs_shapes(const Patch_model& model, const std::vector<NT>& at)
{
  const auto sides = make_nurbs<NT>(model).one_sided_shapes(first<2>(at));
  if (!sides)
    return sides.refusal();
  Shapes<NT> shapes;
  for (const auto& s : *sides)
  {
    if (!s.shape)
      return s.shape.refusal();
    if (sides->size() == 1)
      return one_side(s.shape);
    shapes.push_back({{name_of(s.side_u), name_of(s.side_v)}, *s.shape});
  }
  return shapes;
}

// The data of a surface that is not a system, at a point or parameters.
template <class NT>
si::Result<Shapes<NT>> surface_shapes(const Surface_model& surface, const std::vector<NT>& at)
{
  if (const auto* implicit = std::get_if<Implicit_model>(&surface.data))
    return one_side(make_surface(*implicit)(first<3>(at)));
  if (const auto* parametric = std::get_if<Parametric_model>(&surface.data))
    return one_side(make_surface(*parametric)(first<2>(at)));
  const auto& patch = std::get<Patch_model>(surface.data);
  if (patch.knots[0].empty())
    return one_side(make_bezier<NT>(patch)(first<2>(at)));
  return nurbs_shapes<NT>(patch, at);
}

} // namespace interrogate

#endif // INTERROGATE_SURFACE_SHAPES_H
