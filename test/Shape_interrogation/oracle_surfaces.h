// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ORACLE_SURFACES_H
#define SHAPE_INTERROGATION_TEST_ORACLE_SURFACES_H

// The implicit and parametric surfaces of the cases.

#include "oracle_checks.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <vector>

namespace oracles {

using Implicit = Implicit_surface_3<Expression_function<3>>;
using Parametric = Parametric_surface_3<Expression_function<2, 3>>;

inline Implicit implicit(const Case& c)
{
  return Implicit(
    Expression_function<3>(parse_expression(c.inputs.text("f"), c.inputs.texts("vars"))));
}

inline Parametric parametric(const Case& c)
{
  std::vector<Expression> s;
  for (const std::string& x : c.inputs.texts("S"))
    s.push_back(parse_expression(x, c.inputs.texts("params")));
  return Parametric(Expression_function<2, 3>(s));
}

// The first and second fundamental forms before they are combined.
inline void expect_forms(const Surface_derivatives_3<Q>& d, const Fields& e)
{
  const auto n = internal::cross(d.u, d.v);
  expect_equal(internal::dot(d.u, d.u), e, "E");
  expect_equal(internal::dot(d.u, d.v), e, "F");
  expect_equal(internal::dot(d.v, d.v), e, "G");
  const Q l = internal::dot(n, d.uu), m = internal::dot(n, d.uv), k = internal::dot(n, d.vv);
  expect_equal(l, e, "Lhat");
  expect_equal(m, e, "Mhat");
  expect_equal(k, e, "Nhat");
  expect_equal(Q(l * k - m * m), e, "det_Lhat");
}

} // namespace oracles

#endif // SHAPE_INTERROGATION_TEST_ORACLE_SURFACES_H
