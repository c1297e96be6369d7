// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_TEST_N_SPACE_MESHES_H
#define CGAL_SHAPE_INTERROGATION_TEST_N_SPACE_MESHES_H

// Systems that several tests mesh and trace.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace testing_shapes {

using namespace CGAL::Shape_interrogation;
using Point = std::vector<double>;

inline N_space_system make_n_space_system(const std::vector<std::string>& variables,
                                          const std::vector<std::string>& equations)
{
  std::vector<Expression> expressions;
  for (const std::string& text : equations)
    expressions.push_back(parse_expression(text, variables));
  return N_space_system(variables, expressions);
}

// Chuang and Hoffmann's example: x y z, p0, p1, p2, r, s, t, lambda.
inline N_space_system ruled_surface_of_the_paper()
{
  const Curve_entity_3 circle([](auto r) {
    using T = decltype(r);
    return std::array<T, 4>{3 * (1 - r * r) - (1 + r * r), 6 * r, 8 * (1 + r * r), 2 * (1 + r * r)};
  });
  const Implicit_entity_3 f([](auto x, auto y, auto) { return (x + 1) * (x + 1) + y * y - 1; });
  const Parametric_entity_3 g([](auto s, auto t) {
    using T = decltype(s);
    return std::array<T, 4>{3 * (1 - s * s), t * (1 + s * s), 6 * s, 1 + s * s};
  });
  return ruled_by_projection(circle, f, g).n_space_system();
}

// lambda = 1/2, r = 0, in the order of the variables.
inline Point start_of_ruled_surface()
{
  const double s = (std::sqrt(17.) - 1) / 4, c = 3 * (1 - s * s) / (1 + s * s),
               w = 6 * s / (1 + s * s);
  return {c / 2, 0, (4 + w) / 2, 1, 0, 4, 0, 0, 4, c, 0, w, 0, s, 0, 0.5};
}

} // namespace testing_shapes

#endif // CGAL_SHAPE_INTERROGATION_TEST_N_SPACE_MESHES_H
