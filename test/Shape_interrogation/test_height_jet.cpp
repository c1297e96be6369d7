// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The two small concepts beside the waist: higher jets on request, and access.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Surfaces/access.h>
#include <CGAL/Shape_interrogation/Surfaces/height_jet.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

namespace si = CGAL::Shape_interrogation;
using Rational = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<false>;

namespace {

struct Sphere
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return x * x + y * y + z * z - NT(9);
  }
};

// z = u^2 + 2 u v^2 - v^3 - u^4 as zeros of a function and as a map with skew parameters.
struct Graph_function
{
  template <class NT>
  NT operator()(const NT& u, const NT& v, const NT& z) const
  {
    return z - u * u - NT(2) * u * v * v + v * v * v + u * u * u * u;
  }
};

struct Graph_map
{
  template <class NT>
  std::array<NT, 3> operator()(const NT& a, const NT& v) const
  {
    const NT u = a + v * v;
    return {u, v, u * u + NT(2) * u * v * v - v * v * v - u * u * u * u};
  }
};

// The sphere of radius 3 has the height sqrt(9 - r^2) - 3 along the unit normal: in units of the
// frame with |N|^2 = 36 and |t1|^2 = 20, |t2|^2 = 720 the coefficients are exact.
TEST(Height_jet, sphere)
{
  const auto h = si::height_jet<4>(si::Implicit_surface_3<Sphere>(),
                                   si::Coordinates<Rational, 3>{1, 2, 2});
  ASSERT_TRUE(h);
  const Rational l1 = 20, l2 = 720, radius = 3, n = 6;
  const auto height = [&](const std::array<int, 2>& e) { return h->height.coefficient(e); };
  EXPECT_EQ(height({2, 0}), Rational(-l1 / (2 * radius) / n));
  EXPECT_EQ(height({0, 2}), Rational(-l2 / (2 * radius) / n));
  EXPECT_EQ(height({1, 1}), 0);
  EXPECT_EQ(height({2, 1}), 0);
  EXPECT_EQ(height({4, 0}), Rational(-l1 * l1 / (8 * radius * radius * radius) / n));
  EXPECT_EQ(height({2, 2}), Rational(-2 * l1 * l2 / (8 * radius * radius * radius) / n));
}

// Two representations of one surface are the oracle for each other, in all fifteen coefficients.
TEST(Height_jet, implicit_and_parametric_agree)
{
  const Rational u = Rational(1) / 2, v = Rational(1) / 3;
  const Rational z = u * u + 2 * u * v * v - v * v * v - u * u * u * u;
  const Rational a = u - v * v;
  const auto implicit = si::height_jet<4>(si::Implicit_surface_3<Graph_function>(),
                                          si::Coordinates<Rational, 3>{u, v, z});
  const auto parametric = si::height_jet<4>(si::Parametric_surface_3<Graph_map>(),
                                            si::Coordinates<Rational, 2>{a, v});
  ASSERT_TRUE(implicit);
  ASSERT_TRUE(parametric);
  EXPECT_EQ(implicit->normal, parametric->normal);
  for (int k = 0; k < 15; ++k)
    EXPECT_EQ(implicit->height.coefficient(k), parametric->height.coefficient(k)) << k;
  EXPECT_NE(implicit->height.coefficient(6), 0);
}

TEST(Height_jet, refuses_what_the_surface_refuses)
{
  const auto off = si::height_jet<3>(si::Implicit_surface_3<Sphere>(),
                                     si::Coordinates<Rational, 3>{1, 2, 3});
  ASSERT_FALSE(off);
  EXPECT_EQ(off.refusal().code(), si::Refusal_code::NOT_ON_SURFACE);
}

TEST(Access, projects_onto_the_surface)
{
  const auto p = si::project_to_surface(si::Implicit_surface_3<Sphere>(), {1, 5, 2});
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->residual, 0, 1e-14);
  const auto& x = p->point;
  EXPECT_NEAR(x[0] * x[0] + x[1] * x[1] + x[2] * x[2], 9, 1e-14);
  EXPECT_LT(p->iterations, 10);
}

TEST(Access, refuses_without_a_gradient_and_without_a_surface)
{
  const auto center = si::project_to_surface(si::Implicit_surface_3<Sphere>(), {0, 0, 0});
  ASSERT_FALSE(center);
  EXPECT_EQ(center.refusal().code(), si::Refusal_code::SINGULAR_POINT);
  const auto positive = [](const auto& x, const auto& y, const auto& z) {
    return x * x + y * y + z * z + 1;
  };
  const si::Implicit_surface_3<decltype(positive)> empty(positive);
  EXPECT_FALSE(si::project_to_surface(empty, {1, 2, 3}));
}

TEST(Access, encloses_over_a_box)
{
  const si::Coordinates<Interval, 3> box{Interval(0.9, 1.1), Interval(1.9, 2.1),
                                         Interval(1.9, 2.1)};
  const auto s = si::enclose_shape(si::Implicit_surface_3<Sphere>(), box);
  ASSERT_TRUE(s);
  EXPECT_TRUE(CGAL::certainly(si::sign_of_gaussian_curvature(*s) == CGAL::POSITIVE));
  const si::Coordinates<Interval, 3> around_center{Interval(-1, 1), Interval(-1, 1),
                                                   Interval(-1, 1)};
  const auto undecided = si::enclose_shape(si::Implicit_surface_3<Sphere>(), around_center);
  ASSERT_FALSE(undecided);
  EXPECT_EQ(undecided.refusal().code(), si::Refusal_code::UNDECIDED);
}

} // namespace
