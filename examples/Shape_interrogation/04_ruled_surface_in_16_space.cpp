// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The appendix of Chuang and Hoffmann: a ruled surface without a closed form, as 15 equations in 16
// variables, of which one has no gradient at the point. Everything is exact in Q(sqrt(17)).

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_cross_checks.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <iomanip>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = Quadratic_field;
using Texts = std::vector<std::string>;

std::vector<Expression> parse(const Texts& texts, const Texts& variables = {})
{
  std::vector<Expression> expressions;
  for (const std::string& text : texts)
    expressions.push_back(parse_expression(text, variables));
  return expressions;
}

int main()
{
  const Texts variables{"x",  "y",  "z",  "u0", "v0", "w0", "u1", "v1",
                        "w1", "u2", "v2", "w2", "r",  "s",  "t",  "l"};
  // A point p0 of a circle, its projections p1 and p2 to two cylinders, and q on the line p1 p2.
  // The denominators 1 + r^2 and 1 + s^2 are cleared.
  const N_space_surface_3 surface(N_space_system(variables, parse(
    {"2*u0*(1+r^2) - 3*(1-r^2) + (1+r^2)", "v0*(1+r^2) - 3*r", "w0 - 4", "(u1+1)^2 + v1^2 - 1",
     "u2*(1+s^2) - 3*(1-s^2)", "v2 - t", "w2*(1+s^2) - 6*s", "x - (l*u1 + (1-l)*u2)",
     "y - (l*v1 + (1-l)*v2)", "z - (l*w1 + (1-l)*w2)", "2*(w0-w1)*(u1+1)",
     "-2*(u0-u1)*v1 + 2*(v0-v1)*(u1+1)", "2*(w0-w1)*v1", "-12*s*(u0-u2) + 6*(1-s^2)*(w0-w2)",
     "v0 - v2"}, variables)));
  const Texts p_text{"3/34*sqrt(17)", "0", "2 + 6/17*sqrt(17)", "1", "0", "4", "0", "0", "4",
                     "3/17*sqrt(17)", "0", "12/17*sqrt(17)", "0", "(sqrt(17)-1)/4", "0", "1/2"};
  const auto p = Expression_tape(parse(p_text), 0).evaluate(std::vector<NT>());
  const Coordinates<NT, 3> ruling{p[6] - p[9], p[7] - p[10], p[8] - p[11]}; // p1 - p2

  const auto answer = surface.shape(p);
  const Local_shape_3<NT>& shape = answer->shape;
  const auto h = mean_curvature(shape.cast<CGAL::Interval_nt<>>());
  std::cout << std::setprecision(9) << "rank " << answer->rank << ", redundant: equation "
            << answer->redundant_equations.at(0) + 1 << "\nK = " << gaussian_curvature(shape)
            << ", sign of the normal curvature along the ruling = "
            << sign_of_normal_curvature(shape, ruling) << "\nH^2 = "
            << squared_mean_curvature(shape) << ", H is in " << h << "\nentries of H_0:";

  // The table of the paper: the combined Hessian for the unit normal, which no curvature needs.
  const Combined_hessian<NT> h0(surface.system(), p, answer->multipliers);
  const double length = std::sqrt(number_cast<double>(shape.normal_squared_length()));
  const int table[][2] = {{6, 8},   {3, 13}, {5, 13},  {6, 6},   {9, 15},
                          {11, 15}, {9, 13}, {11, 13}, {12, 12}, {13, 13}};
  for (const auto& [row, column] : table)
    std::cout << ' ' << std::setprecision(7) << number_cast<double>(h0(row, column)) / length;
  std::cout << '\n';
  return sign_of_normal_curvature(shape, ruling) == CGAL::ZERO ? EXIT_SUCCESS : EXIT_FAILURE;
}
