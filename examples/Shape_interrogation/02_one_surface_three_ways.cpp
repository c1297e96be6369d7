// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// One ellipsoid as an implicit surface, a parametric surface and a system of four equations in five
// variables, of which one is redundant: the second-order data are the same.

#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;
using Shape = Local_shape_3<NT>;

// N is unnormalised, so that B is known up to the same factor: N2 = mu N1 and B2 = mu B1.
bool is_same_shape(const Shape& a, const Shape& b)
{
  const NT mu = b.normal()[2] / a.normal()[2]; // the normals are not horizontal here
  const Shape c = a.scaled_normal(mu);
  bool same = c.normal() == b.normal() && c.point() == b.point();
  const auto c_matrix = c.shape_matrix(), b_matrix = b.shape_matrix();
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column)
      same = same && c_matrix(row, column) == b_matrix(row, column);
  return same;
}

void print(const char* name, const Shape& s)
{
  std::cout << name << ": N_z = " << s.normal()[2] << ", K = " << gaussian_curvature(s)
            << ", H^2 = " << squared_mean_curvature(s) << '\n';
}

int main()
{
  const Implicit_surface_3 implicit(
    [](auto x, auto y, auto z) { return x * x / 9 + y * y / 4 + z * z - 1; });
  const Parametric_surface_3 parametric([](auto u, auto v) {
    const auto w = 1 + u * u + v * v;
    return std::array{6 * u / w, 4 * v / w, (w - 2) / w};
  });
  const std::vector<std::string> names{"x", "y", "z", "u", "v"};
  std::vector<Expression> equations;
  for (const char* text : {"x*(1 + u^2 + v^2) - 6*u", "y*(1 + u^2 + v^2) - 4*v",
                           "z*(1 + u^2 + v^2) - (u^2 + v^2 - 1)", "x^2/9 + y^2/4 + z^2 - 1"})
    equations.push_back(parse_expression(text, names));
  const N_space_surface_3 system(N_space_system(names, equations));
  const NT u = NT(1) / 2, v = NT(1) / 3;
  const auto b = parametric(Coordinates<NT, 2>{u, v});
  const auto [x, y, z] = b->point();
  const auto a = implicit(Coordinates<NT, 3>{x, y, z});
  const auto c = system.shape(std::vector<NT>{x, y, z, u, v});
  print("implicit  ", *a);
  print("parametric", *b);
  print("system    ", c->shape);
  std::cout << "equation " << c->redundant_equations.at(0) + 1 << " is redundant\n";
  const bool same = is_same_shape(*a, *b) && is_same_shape(*a, c->shape);
  std::cout << (same ? "the data are the same" : "the data differ") << '\n';
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
