// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_CURVE_SHAPES_H
#define INTERROGATE_CURVE_SHAPES_H

// The second-order data of a planar curve of the model at a place, in a number type.

#include "evaluate_numbers.h"

#include <CGAL/Shape_interrogation/Curves/Bezier_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Implicit_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Nurbs_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Parametric_curve_2.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>

#include <vector>

namespace interrogate {

// The data from the sides of a knot, from the right first; elsewhere one.
template <class NT>
using Curve_shapes = std::vector<si::One_sided_shape_2<NT>>;

template <class NT>
si::Result<Curve_shapes<NT>> one_curve_side(const si::Result<si::Local_shape_2<NT>>& shape)
{
  return Curve_shapes<NT>{{si::Side::RIGHT, shape}};
}

template <class NT>
si::Result<Curve_shapes<NT>> spline_shapes(const Spline_model& model, const NT& t)
{
  std::vector<si::Coordinates<NT, 2>> points;
  std::vector<NT> weights;
  for (const Numbers<3>& p : model.control_points)
  {
    const std::array<NT, 3> x = evaluate<NT>(p);
    points.push_back({x[0], x[1]});
    if (model.is_rational)
      weights.push_back(x[2]);
  }
  if (model.knots.empty())
    return one_curve_side(si::Bezier_curve_2<NT>(points, weights)(t));
  const si::Knot_vector<Rational> knots(model.degree, model.knots); // decides which are equal
  const si::Nurbs_curve_2<NT> curve(knots.template cast<NT>(), points, weights);
  return curve.one_sided_shapes(t);
}

template <class NT>
si::Result<Curve_shapes<NT>> curve_shapes(const Curve_model& curve, const std::vector<NT>& at)
{
  if (const auto* implicit = std::get_if<Implicit_model>(&curve))
  {
    si::Expression_function<2> f(implicit->f);
    f.set_variable_names(implicit->variables);
    const si::Implicit_curve_2<si::Expression_function<2>> zeros(f);
    return one_curve_side(zeros(first<2>(at)));
  }
  if (const auto* parametric = std::get_if<Parametric_model>(&curve))
  {
    si::Expression_function<1, 2> x(parametric->x);
    x.set_variable_names(parametric->parameters);
    const si::Parametric_curve_2<si::Expression_function<1, 2>> path(x);
    return one_curve_side(path(at[0]));
  }
  return spline_shapes(std::get<Spline_model>(curve), at[0]);
}

} // namespace interrogate

#endif // INTERROGATE_CURVE_SHAPES_H
