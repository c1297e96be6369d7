// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A tour of places where a question has no answer: each is refused, with a code for programs and a
// sentence for people.

#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;
using Point = Coordinates<NT, 3>;
int answers = 0;
template <class T>
void show(const char* what, const Result<T>& result)
{
  answers += bool(result);
  std::cout << what << "\n  "
            << (result ? "an answer" : to_string(result.refusal().code())) << ": "
            << (result ? "" : result.refusal().evidence()) << '\n';
}

auto implicit(const char* f)
{
  return Implicit_surface_3(Expression_function<3>(parse_expression(f, {"x", "y", "z"})));
}

auto system(const std::vector<std::string>& names, const std::vector<const char*>& texts)
{
  std::vector<Expression> equations;
  for (const char* text : texts)
    equations.push_back(parse_expression(text, names));
  return N_space_surface_3(N_space_system(names, equations))(std::vector<NT>(names.size()));
}

int main()
{
  const CGAL::Interval_nt<> near(-1e-9, 1e-9);
  const Point origin{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const auto cone = implicit("x^2 + y^2 - z^2"), sphere = implicit("x^2 + y^2 + z^2 - 1");
  show("the apex of a cone", cone(origin));
  show("the same, somewhere in a small box", cone(std::array{near, near, near}));
  show("a point beside a sphere", sphere(Point{1, 1, 0}));
  show("principal directions of a sphere", principal_directions(*sphere(x)));
  show("an exponential function in the rationals", implicit("exp(x) + y - 1")(x));
  const Bezier_surface_3<NT> collapsed({{origin, origin}, {x, y}});
  show("a patch at an edge that is a point", collapsed({0, NT(1) / 2}));
  show("a patch outside its domain", collapsed({2, NT(1) / 2}));
  const Bezier_surface_3<NT> pole({{origin, x}, {y, z}}, {{1, 1}, {-1, -1}});
  show("a rational patch where its weight vanishes", pole({NT(1) / 2, NT(1) / 2}));
  show("one equation in four variables", system({"x", "y", "z", "t"}, {"x - t"}));
  show("a vanishing gradient", system({"x", "y", "z"}, {"x*y - z^2"}));
  show("two surfaces that only touch", system({"x", "y", "z"}, {"z - x^2", "z - 2*x^2"}));
  show("a cuspidal edge", system({"x", "y", "z", "t"}, {"x - t^2", "y - t^3"}));
  show("curvatures in two directions only",
       shape_from_normal_curvatures<NT>(origin, z, {x, y, Point{0, 2, 0}}, {1, 1, 1}));
  return answers == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
