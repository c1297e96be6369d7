// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases about property surfaces: coefficients, developable patches and their twins,
// values at points, theorems about whole patches, and the algebra of Bezier and spline functions.

#include "oracle_surfaces.h"

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/patch_of_expressions.h>
#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>
#include <CGAL/Shape_interrogation/Splines/Spline_function.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace {

using namespace oracles;

Bezier_surface_3<Q> bezier(const Case& c)
{
  const std::vector<Q> x = numbers<Q>(c.inputs.texts("control_points"));
  const std::vector<Q> degree = numbers<Q>(c.inputs.texts("degree"));
  std::vector<Coordinates<Q, 3>> points;
  for (std::size_t i = 0; i < x.size(); i += 3)
    points.push_back({x[i], x[i + 1], x[i + 2]});
  return Bezier_surface_3<Q>(static_cast<int>(CGAL::to_double(degree[0])),
                             static_cast<int>(CGAL::to_double(degree[1])), points);
}

void expect_coefficients(Property_surface_maker<Q>& maker, Property property, const Fields& e,
                         const std::string& name)
{
  if (!e.has(name + ".coefficients"))
    return;
  const auto p = maker(property);
  const std::vector<Q> degree = numbers<Q>(e.texts(name + ".degree"));
  EXPECT_EQ(degree, (std::vector<Q>{Q(p.numerator().degree()[0]), Q(p.numerator().degree()[1])}));
  EXPECT_EQ(numbers<Q>(e.texts(name + ".coefficients")), p.numerator().coefficients());
  EXPECT_EQ((std::array<int, 2>{0, 0}), p.denominator().degree());
  EXPECT_EQ(Q(1), p.denominator().coefficient({0, 0}));
}

void check_patch(const Case& c)
{
  Property_surface_maker<Q> maker(bezier(c));
  const Fields& e = c.expected;
  expect_coefficients(maker, Property::NORMAL_Z, e, "nz_hat");
  expect_coefficients(maker, Property::SPEED, e, "speed_sq_E_plus_G");
  expect_coefficients(maker, Property::SECOND_FORM_DETERMINANT, e, "det_Lhat");
  const auto determinant = maker(Property::SECOND_FORM_DETERMINANT);
  if (e.has("developable"))
  {
    EXPECT_EQ(e.flag("developable"), bool(determinant.is_identically_zero()));
  }
  if (e.has("det_Lhat_max_abs_coefficient"))
  {
    Q largest(0);
    for (const Q& b : determinant.numerator().coefficients())
      largest = (std::max)(largest, Q(CGAL::abs(b)));
    expect_equal(largest, e, "det_Lhat_max_abs_coefficient");
  }
  if (e.has("regular_on_patch") && e.flag("regular_on_patch"))
  {
    EXPECT_GT(infimum(maker.normal_squared()).lower, 0);
  }
}

void expect_value(const Surface_derivatives_3<Q>& d, Property property, const Fields& e,
                  const std::string& name)
{
  if (!e.has(name))
    return;
  const Result<Q> value = property_value(d, property);
  if (e.text(name) == "null")
    EXPECT_FALSE(value) << name;
  else
    expect_equal(*value, e, name);
}

// The oracle is for the unit normal, with a root.
void expect_normal_twist(const Surface_derivatives_3<Q>& d, const Fields& e)
{
  if (!e.has("twist_normal_component_l12"))
    return;
  const auto n = internal::cross(d.u, d.v);
  const Q twist = *property_value(d, Property::NORMAL_TWIST);
  const Quadratic_field expected =
    number<Quadratic_field>(e.text("twist_normal_component_l12"));
  EXPECT_EQ(CGAL::sign(expected), CGAL::sign(twist));
  EXPECT_EQ(Quadratic_field(expected * expected),
            Quadratic_field(Q(twist * twist / internal::dot(n, n))));
}

void check_values(const Case& c)
{
  const Coordinates<Q, 2> at{numbers<Q>(c.inputs.texts("at"))[0],
                             numbers<Q>(c.inputs.texts("at"))[1]};
  const auto d = c.inputs.text("form") == "bezier" ? *bezier(c).derivatives(at)
                                                   : parametric(c).derivatives(at);
  const Fields& e = c.expected;
  expect_value(d, Property::SPEED, e, "speed_bound_sq_E_plus_G");
  expect_value(d, Property::NORMAL_Z_SQUARED, e, "nz_sq");
  expect_value(d, Property::SLOPE, e, "tan_slope_sq");
  expect_value(d, Property::SECOND_FORM_DETERMINANT, e, "det_Lhat");
  expect_value(d, Property::GAUSSIAN, e, "K");
  expect_value(d, Property::CURVATURE_BOUND, e, "xi_sum_of_squares");
  expect_normal_twist(d, e);
  const auto speed = property_at(d, Property::SPEED_SUPREMUM);
  const double supremum = number<double>(e.text("true_max_speed_sq"));
  const auto enclosure = *speed.enclosure({Q(0), Q(0)});
  EXPECT_NEAR(supremum, enclosure.inf(), 1e-13 * supremum);
  EXPECT_NEAR(supremum, enclosure.sup(), 1e-13 * supremum);
  // E + G is the supremum where the surface is not regular, and nowhere else.
  const Q sum = *property_value(d, Property::SPEED), zero(0);
  EXPECT_EQ(e.flag("bound_attained"), Q(sum * sum) == (*speed.radicand())({zero, zero}));
}

void check_theorem(const Case& c)
{
  std::vector<Expression> x;
  for (const std::string& text : c.inputs.texts("S"))
    x.push_back(parse_expression(text, c.inputs.texts("params")));
  const std::vector<Q> domain = numbers<Q>(c.inputs.texts("domain"));
  const auto pieces = patch_of_expressions(x, {domain[0], domain[1]}, {domain[2], domain[3]});
  ASSERT_TRUE(pieces);
  const std::string question = c.inputs.text("question");
  Q bound = numbers<Q>({c.inputs.text("bound")})[0];
  Property property = Property::SPEED;
  if (question == "tan_slope_le")
  {
    property = Property::SLOPE;
    bound = bound * bound;
  }
  else if (question == "det_Lhat_negative")
    property = Property::SECOND_FORM_DETERMINANT;
  else
    ASSERT_EQ("speed_bound_sq_le", question);
  const auto surface = Property_surface_maker<Q>(pieces->front())(property);
  const auto decided = decide_at_most(surface, bound);
  EXPECT_EQ(c.expected.flag("answer") ? Verdict::YES : Verdict::NO, decided->verdict);
  if (question == "det_Lhat_negative")
    expect_equal(Q(-decided->extreme.upper), c.expected, "extreme_margin");
  if (question == "speed_bound_sq_le")
    expect_equal(Q(bound - decided->extreme.upper), c.expected, "extreme_margin");
  EXPECT_EQ(decided->extreme.lower, decided->extreme.upper);
}

void check_spline(const Case& c)
{
  const Spline_function_1<Q> f({Knot_vector<Q>(c.inputs.integer("order") - 1,
                                               numbers<Q>(c.inputs.texts("knots")))},
                               numbers<Q>(c.inputs.texts("control_values")));
  const auto derivative = f.derivative(0);
  EXPECT_EQ(numbers<Q>(c.expected.texts("derivative_control_points")), derivative.coefficients());
  EXPECT_EQ(numbers<Q>(c.expected.texts("derivative_knots")), derivative.knots(0).knots());
}

void check_functions(const Case& c)
{
  const auto polynomial = [&](const char* name) {
    const std::vector<Q> b = numbers<Q>(c.inputs.texts(name));
    return Bernstein_polynomial_1<Q>::from_coefficients({static_cast<int>(b.size()) - 1}, b);
  };
  const auto p = polynomial("P"), q = polynomial("Q");
  EXPECT_EQ(numbers<Q>(c.expected.texts("product")), (p * q).coefficients());
  EXPECT_EQ(numbers<Q>(c.expected.texts("sum_degree_raised")), (p + q).coefficients());
}

TEST(Oracles, property_surface)
{
  Count count("property_surface", "exact rationals");
  for (const Case& c : cases("property_surface"))
  {
    SCOPED_TRACE(c.id);
    count.run();
    const std::string form = c.inputs.text("form");
    if (form == "bspline_curve_derivative")
      check_spline(c);
    else if (form == "bezier_curve_product_sum")
      check_functions(c);
    else if (form == "polynomial")
      check_theorem(c);
    else if (c.inputs.has("at"))
      check_values(c);
    else
      check_patch(c);
  }
  EXPECT_EQ(20, count.visited());
}

} // namespace
