// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The waist: its sign and orientation rule, its invariance, and that all representations of a
// surface meet in it. Everything is exact; seeds are fixed.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/compare_principal_curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;
using Shape = Local_shape_3<Q>;
using Point = Coordinates<Q, 3>;

// --- Surfaces of the tests -----------------------------------------------------------------------

struct Torus // radii 2 and 1
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT r = x * x + y * y;
    const NT s = r + z * z + NT(3);
    return s * s - NT(16) * r;
  }
};

// Rational points of it: two points of the unit circle.
Point torus_point(const Q& s, const Q& t)
{
  const Q cs = (1 - s * s) / (1 + s * s), sn = 2 * s / (1 + s * s);
  const Q ct = (1 - t * t) / (1 + t * t), st = 2 * t / (1 + t * t);
  const Q r = 2 + ct;
  return {Q(r * cs), Q(r * sn), st};
}

struct Torus_map
{
  template <class NT>
  std::array<NT, 3> operator()(const NT& s, const NT& t) const
  {
    const NT one(1), two(2);
    const NT cs = (one - s * s) / (one + s * s), sn = two * s / (one + s * s);
    const NT ct = (one - t * t) / (one + t * t), st = two * t / (one + t * t);
    const NT r = two + ct;
    return {r * cs, r * sn, st};
  }
};

struct Sphere // radius 3
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return x * x + y * y + z * z - NT(9);
  }
};

// A cubic without symmetries; its level sets serve where any surface will do.
struct Cubic
{
  std::array<int, 7> c;

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return NT(c[0]) * x * x * y + NT(c[1]) * y * z * z + NT(c[2]) * x * y * z + NT(c[3]) * z * x +
           NT(c[4]) * y * y + NT(c[5]) * x + NT(c[6]) * z;
  }
};

Cubic random_cubic(Random& random)
{
  Cubic f;
  for (int& c : f.c)
    c = random.integer(-6, 6);
  f.c[6] += 20; // no singular points near the origin
  return f;
}

Shape random_shape(Random& random)
{
  return Shape::from_form(random.vector(), random.nonzero_vector(), random.matrix());
}

Q sum_of_principal_minors(const Symmetric_matrix_3<Q>& m)
{
  return m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1) + m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2) +
         m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
}

Q form(const Symmetric_matrix_3<Q>& b, const Point& u, const Point& v)
{
  return internal::dot(u, internal::multiply(b, v));
}

// t has the normal and the matrix of s times mu, and all that follows.
void expect_multiple(const Shape& t, const Shape& s, const Q& mu)
{
  const auto a = s.shape_matrix(), b = t.shape_matrix();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(t.normal()[i], Q(mu * s.normal()[i]));
    for (int j = i; j < 3; ++j)
      EXPECT_EQ(b(i, j), Q(mu * a(i, j)));
  }
  const int sign = CGAL::sign(mu);
  EXPECT_EQ(gaussian_curvature(t), gaussian_curvature(s));
  EXPECT_EQ(squared_mean_curvature(t), squared_mean_curvature(s));
  EXPECT_EQ(squared_curvature_gap(t), squared_curvature_gap(s));
  EXPECT_EQ(int(sign_of_mean_curvature(t)), sign * int(sign_of_mean_curvature(s)));
  EXPECT_EQ(sign_of_gaussian_curvature(t), sign_of_gaussian_curvature(s));
  EXPECT_EQ(is_umbilic(t), is_umbilic(s));
  EXPECT_EQ(is_planar(t), is_planar(s));
  EXPECT_EQ(point_type(t), point_type(s));
  if (sign > 0)
  {
    EXPECT_EQ(compare_principal_curvatures(t, Principal::MIN, s, Principal::MIN), CGAL::EQUAL);
    EXPECT_EQ(compare_principal_curvatures(t, Principal::MAX, s, Principal::MAX), CGAL::EQUAL);
  }
}

// The same with the factor read off the normals, which must be parallel.
Q expect_same_surface(const Shape& t, const Shape& s)
{
  const Q mu = internal::dot(t.normal(), s.normal()) / s.normal_squared_length();
  EXPECT_FALSE(CGAL::is_zero(mu));
  EXPECT_EQ(t.point(), s.point());
  expect_multiple(t, s, mu);
  return mu;
}

// --- The sign rule -------------------------------------------------------------------------------

TEST(Sign_rule, sphere_with_outward_normal_is_positive)
{
  const Implicit_surface_3<Sphere> sphere;
  const Result<Shape> s = sphere(Point{Q(1), Q(2), Q(2)});
  ASSERT_TRUE(s);
  EXPECT_EQ(compare_principal_curvature(*s, Principal::MIN, Q(Q(1) / 3)), CGAL::EQUAL);
  EXPECT_EQ(compare_principal_curvature(*s, Principal::MAX, Q(Q(1) / 3)), CGAL::EQUAL);
  EXPECT_EQ(normal_curvature(*s, Point{Q(2), Q(-1), Q(0)}), Q(Q(1) / 3));
  EXPECT_EQ(sign_of_mean_curvature(*s), CGAL::POSITIVE);
  EXPECT_EQ(mean_curvature(s->opposite()), Q(Q(-1) / 3));
}

// A saddle: min and max are by signed value, and exchange their places with the normal.
TEST(Sign_rule, saddle_and_its_reverse)
{
  const Shape s(Point{}, {Q(0), Q(0), Q(1)}, Symmetric_matrix_3<Q>(-2, 0, 0, 5, 0, 0));
  EXPECT_EQ(principal_curvatures(s), (std::array<Q, 2>{Q(-2), Q(5)}));
  EXPECT_EQ(principal_curvatures(s.opposite()), (std::array<Q, 2>{Q(-5), Q(2)}));
  const auto d = principal_directions(s.cast<double>());
  const auto e = principal_directions(s.opposite().cast<double>());
  ASSERT_TRUE(d && e);
  EXPECT_EQ(std::fabs((*d)[0][0]), 1);
  EXPECT_EQ(std::fabs((*d)[1][1]), 1);
  EXPECT_EQ(std::fabs((*e)[0][1]), 1);
  EXPECT_EQ(std::fabs((*e)[1][0]), 1);
  for (const auto& [directions, z] : {std::make_pair(*d, 1.0), std::make_pair(*e, -1.0)})
    EXPECT_EQ(internal::cross(directions[0], directions[1])[2], z) << "right-handed with N";
}

TEST(Sign_rule, normal_times_factor)
{
  Random random(101);
  for (int i = 0; i < 60; ++i)
  {
    const Shape s = random_shape(random);
    expect_multiple(s.opposite(), s, Q(-1));
    const Q mu = random.nonzero_rational();
    expect_multiple(s.scaled_normal(mu), s, mu);
  }
}

TEST(Sign_rule, opposite_principal_curvatures)
{
  Random random(102);
  for (int i = 0; i < 40; ++i)
  {
    const Shape s = random_shape(random), t = s.opposite();
    for (const Q& bound : {random.rational(), random.rational(), Q(0)})
    {
      EXPECT_EQ(compare_principal_curvature(s, Principal::MIN, bound),
                -compare_principal_curvature(t, Principal::MAX, Q(-bound)));
      EXPECT_EQ(compare_principal_curvature(s, Principal::MAX, bound),
                -compare_principal_curvature(t, Principal::MIN, Q(-bound)));
    }
  }
}

// --- Constructions -------------------------------------------------------------------------------

TEST(Constructions, form_frame_and_matrix_agree)
{
  Random random(201);
  for (int i = 0; i < 60; ++i)
  {
    const Shape s = random_shape(random);
    const auto b = s.shape_matrix();
    const Point bn = internal::multiply(b, s.normal());
    EXPECT_EQ(bn, (Point{Q(0), Q(0), Q(0)})) << "B N = 0";
    expect_multiple(Shape(s.point(), s.normal(), b), s, Q(1));
    // Any tangent frame; its normal is w1 x w2.
    const Point w1 = internal::cross(s.normal(), random.nonzero_vector());
    const Point w2 = internal::cross(s.normal(), random.nonzero_vector());
    const Point n = internal::cross(w1, w2);
    if (CGAL::is_zero(internal::dot(n, n)))
      continue;
    const Q mu = internal::dot(n, s.normal()) / s.normal_squared_length();
    const Q scale = Q(random.integer(1, 9)) / 7;
    const auto h = [&](const Point& u, const Point& v) { return Q(mu * scale * form(b, u, v)); };
    expect_multiple(Shape::from_frame(s.point(), w1, w2, h(w1, w1), h(w1, w2), h(w2, w2), scale),
                    s, mu);
  }
}

// The denominator of the form, and the matrix without division.
TEST(Constructions, common_denominator)
{
  Random random(202);
  for (int i = 0; i < 30; ++i)
  {
    const Q w = Q(random.integer(1, 9)) / 5;
    const Shape s = random_shape(random);
    const Shape t = Shape::from_form(s.point(), s.normal(), s.form(), w);
    const auto a = s.shape_matrix(), b = t.shape_matrix(), c = t.scaled_shape_matrix();
    const Q factor = t.form_denominator() * t.normal_squared_length() * t.normal_squared_length();
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l)
      {
        EXPECT_EQ(Q(w * b(k, l)), a(k, l));
        EXPECT_EQ(c(k, l), Q(factor * b(k, l)));
      }
    EXPECT_EQ(Q(w * w * gaussian_curvature(t)), gaussian_curvature(s));
    EXPECT_EQ(Q(w * w * squared_mean_curvature(t)), squared_mean_curvature(s));
    EXPECT_EQ(is_umbilic(t), is_umbilic(s));
  }
}

TEST(Constructions, numerators_are_those_of_the_matrix)
{
  Random random(203);
  for (int i = 0; i < 30; ++i)
  {
    const Shape s = random_shape(random);
    const auto b = s.shape_matrix();
    const Q cq = s.scale() * s.normal_squared_length();
    EXPECT_EQ(s.trace_numerator(), Q(cq * internal::trace(b)));
    EXPECT_EQ(s.minors_numerator(), Q(s.scale() * cq * sum_of_principal_minors(b)));
    // Cayley and Hamilton in the tangent plane: B^2 = tr B * B - m2 * P.
    const Point v = internal::cross(s.normal(), random.vector());
    const Point bv = internal::multiply(b, v), bbv = internal::multiply(b, bv);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(bbv[k], Q(internal::trace(b) * bv[k] - sum_of_principal_minors(b) * v[k]));
  }
}

TEST(Constructions, at_moves_the_point_only)
{
  Random random(204);
  const Shape s = random_shape(random);
  const Point p{Q(1), Q(2), Q(3)};
  EXPECT_EQ(s.at(p).point(), p);
  expect_multiple(s.at(p), s, Q(1));
}

#ifdef CGAL_CHECK_EXACTNESS
TEST(Constructions, matrix_that_does_not_annihilate_the_normal)
{
  const Symmetric_matrix_3<Q> b(1, 0, 0, 0, 0, 0);
  EXPECT_THROW(Shape(Point{}, {Q(1), Q(1), Q(0)}, b), CGAL::Precondition_exception);
  EXPECT_NO_THROW(Shape(Point{}, {Q(0), Q(1), Q(0)}, b));
}
#endif

// --- Invariance ----------------------------------------------------------------------------------

// f after the inverse of a motion x -> R x + t and a scaling by s.
template <class Function>
struct Moved
{
  Function f;
  testing_shapes::Rotation r;
  Point t;
  Q s = Q(1);

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const std::array<NT, 3> d{x - number_cast<NT>(t[0]), y - number_cast<NT>(t[1]),
                              z - number_cast<NT>(t[2])};
    std::array<NT, 3> e;
    for (int i = 0; i < 3; ++i)
      e[i] = (number_cast<NT>(r[0][i]) * d[0] + number_cast<NT>(r[1][i]) * d[1] +
              number_cast<NT>(r[2][i]) * d[2]) /
             number_cast<NT>(s);
    return f(e[0], e[1], e[2]);
  }

  Point operator()(const Point& p) const
  {
    Point image;
    for (int i = 0; i < 3; ++i)
      image[i] = s * internal::dot(r[i], p) + t[i];
    return image;
  }
};

TEST(Invariance, motions_and_scaling)
{
  int checked = 0;
  Random random(301);
  for (int i = 0; i < 30; ++i)
  {
    const Q factor = Q(random.integer(1, 9)) / random.integer(1, 9);
    const Moved<Cubic> g{random_cubic(random), testing_shapes::random_rotation(random),
                         random.vector(), factor};
    const Point p = random.vector();
    const Result<Shape> s = Implicit_surface_3(g.f).level_set_shape(p);
    if (!s)
      continue;
    ++checked;
    const Result<Shape> t = Implicit_surface_3(g).level_set_shape(g(p));
    ASSERT_TRUE(t);
    const auto b = s->shape_matrix(), c = t->shape_matrix();
    const Q square = factor * factor;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(Q(factor * t->normal()[k]), internal::dot(g.r[k], s->normal()));
      for (int l = k; l < 3; ++l)
        EXPECT_EQ(Q(square * c(k, l)), form(b, g.r[k], g.r[l]));
    }
    EXPECT_EQ(Q(square * gaussian_curvature(*t)), gaussian_curvature(*s));
    EXPECT_EQ(Q(square * squared_mean_curvature(*t)), squared_mean_curvature(*s));
    EXPECT_EQ(Q(square * squared_curvature_gap(*t)), squared_curvature_gap(*s));
    EXPECT_EQ(sign_of_mean_curvature(*t), sign_of_mean_curvature(*s));
  }
  EXPECT_GE(checked, 25);
}

// The surface of f is also that of f h where h has no zero; the normal gets the factor h(p).
struct Torus_times_function
{
  int sign;

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return Torus()(x, y, z) * (NT(sign) * (NT(40) + x * y * z + x * x - z));
  }
};

TEST(Invariance, equation_times_function)
{
  Random random(303);
  for (int i = 0; i < 20; ++i)
  {
    const Point p = torus_point(random.rational(), random.rational());
    const Result<Shape> s = Implicit_surface_3<Torus>()(p);
    const int sign = i % 2 ? 1 : -1;
    const Result<Shape> t = Implicit_surface_3(Torus_times_function{sign})(p);
    ASSERT_TRUE(s && t);
    EXPECT_EQ(int(CGAL::sign(expect_same_surface(*t, *s))), sign);
  }
}

// The torus after a rational change of its parameters with a determinant of either sign.
struct Torus_in_other_parameters
{
  template <class NT>
  std::array<NT, 3> operator()(const NT& s, const NT& t) const
  {
    return Torus_map()(inner(s, t)[0], inner(s, t)[1]);
  }
  template <class NT>
  static std::array<NT, 2> inner(const NT& s, const NT& t)
  {
    return {s * t + t / (NT(1) + s * s), s - t * t};
  }
};

TEST(Invariance, reparametrisation)
{
  int checked = 0;
  Random random(304);
  int positive = 0, negative = 0;
  for (int i = 0; i < 20; ++i)
  {
    const Coordinates<Q, 2> st{random.rational(), random.rational()};
    const Result<Shape> t = Parametric_surface_3<Torus_in_other_parameters>()(st);
    if (!t)
      continue;
    ++checked;
    const auto inner = Torus_in_other_parameters::inner(st[0], st[1]);
    const Result<Shape> s = Parametric_surface_3<Torus_map>()(inner);
    ASSERT_TRUE(s);
    ++(CGAL::is_positive(expect_same_surface(*t, *s)) ? positive : negative);
  }
  EXPECT_GE(checked, 15);
  EXPECT_GT(positive, 0);
  EXPECT_GT(negative, 0);
}

// --- One surface in several representations ------------------------------------------------------

Q gaussian_of_torus(const Q& t)
{
  const Q c = (1 - t * t) / (1 + t * t);
  return c / (2 + c);
}

// The parametrisation as a system in 5-space.
N_space_surface_3 torus_in_5_space()
{
  const auto f = record_expression<5>([](const auto& x, const auto& y, const auto& z,
                                         const auto& s, const auto& t) {
    const auto p = Torus_map()(s, t);
    return std::array{x - p[0], y - p[1], z - p[2]};
  });
  return N_space_surface_3(
    N_space_system({"x", "y", "z", "s", "t"}, {f.begin(), f.end()}));
}

// Points at distance 1 from a circle of radius 2, with the centre as a further unknown, and with
// redundant equations.
N_space_surface_3 torus_as_pipe(Random& random, int redundant)
{
  const auto f = record_expression<5>([](const auto& x, const auto& y, const auto& z,
                                         const auto& u, const auto& v) {
    return std::array{u * u + v * v - 4, (x - u) * (x - u) + (y - v) * (y - v) + z * z - 1,
                      (x - u) * v - (y - v) * u};
  });
  std::vector<Expression> equations(f.begin(), f.end());
  const auto variable = [](int i) { return Expression::variable(i); };
  for (int k = 0; k < redundant; ++k)
  {
    Expression sum(0);
    for (const Expression& g : f)
      sum = sum + g * (Expression(random.integer(-5, 5)) + variable(k) * random.integer(-5, 5));
    equations.push_back(k == 2 ? sum * sum : sum); // a square has no gradient there
  }
  return N_space_surface_3(N_space_system({"x", "y", "z", "u", "v"}, equations));
}

TEST(Representations, torus_in_four_ways)
{
  Random random(401);
  const Implicit_surface_3<Torus> implicit;
  const Parametric_surface_3<Torus_map> parametric;
  const N_space_surface_3 system = torus_in_5_space();
  for (int i = 0; i < 12; ++i)
  {
    const Q s = random.rational(), t = random.rational();
    const Point p = torus_point(s, t);
    const Result<Shape> a = implicit(p);
    ASSERT_TRUE(a);
    EXPECT_EQ(gaussian_curvature(*a), gaussian_of_torus(t));
    const Result<Shape> b = parametric(Coordinates<Q, 2>{s, t});
    const Result<Shape> c = system(std::vector<Q>{p[0], p[1], p[2], s, t});
    const Q u = 2 * (1 - s * s) / (1 + s * s), v = 4 * s / (1 + s * s);
    const N_space_surface_3 pipe = torus_as_pipe(random, i % 4);
    const Result<Shape> d = pipe(std::vector<Q>{p[0], p[1], p[2], u, v});
    ASSERT_TRUE(b && c && d) << (d ? "" : d.refusal().evidence());
    for (const Result<Shape>* other : {&b, &c, &d})
      expect_same_surface(**other, *a);
  }
}

// Points from outside: the wrong number of coordinates, and places where an equation has no value.
TEST(Representations, points_that_do_not_fit_a_system)
{
  N_space_system system = torus_in_5_space().system();
  const N_space_surface_3 surface(system);
  for (const std::size_t n : {0, 3, 6})
  {
    const auto refused = surface(std::vector<double>(n, 0.5));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().code(), Refusal_code::NOT_ON_SOLUTION);
    EXPECT_NE(refused.refusal().evidence().find("coordinate"), std::string::npos);
    EXPECT_FALSE(surface.shape(std::vector<Q>(n, Q(1))));
    EXPECT_FALSE(system.prepare(std::vector<Q>(n, Q(1))));
  }
  const auto [x, y, z, u] = std::array{Expression::variable(0), Expression::variable(1),
                                       Expression::variable(2), Expression::variable(3)};
  N_space_system reciprocal({"x", "y", "z", "u"}, {z - x * y, u - 1 / x});
  EXPECT_FALSE(reciprocal.prepare(std::vector<Q>(4, Q(0)))) << "division by zero";
  EXPECT_EQ(reciprocal.elimination_plan(), nullptr);
  EXPECT_TRUE(reciprocal.prepare(std::vector<Q>(4, Q(1))));
}

// --- Enclosures ----------------------------------------------------------------------------------

bool contains(const Interval& x, const Q& value)
{
  return (std::isinf(x.inf()) || Q(x.inf()) <= value) &&
         (std::isinf(x.sup()) || Q(x.sup()) >= value);
}

struct Interval_numbers
{
  Local_shape_3<Interval> shape;
  Symmetric_matrix_3<Interval> b;
  Interval k, h_squared, gap_squared, kappa_squared;
  CGAL::Uncertain<bool> umbilic;
};

Interval_numbers enclosures(const Implicit_surface_3<Cubic>& surface, const Point& p,
                            const Point& v)
{
  const Interval::Protector protector;
  const auto s = surface.level_set_shape(cast_argument<Interval>(p));
  return {*s,
          s->shape_matrix(),
          gaussian_curvature(*s),
          squared_mean_curvature(*s),
          squared_curvature_gap(*s),
          squared_normal_curvature(*s, cast_argument<Interval>(v)),
          is_umbilic(*s)};
}

TEST(Enclosures, interval_twin_contains_the_exact_shape)
{
  int checked = 0;
  Random random(501);
  for (int i = 0; i < 40; ++i)
  {
    const Implicit_surface_3<Cubic> surface(random_cubic(random));
    const Point p = random.vector();
    const Result<Shape> s = surface.level_set_shape(p);
    if (!s)
      continue;
    ++checked;
    const Point v = internal::cross(s->normal(), random.nonzero_vector());
    const Interval_numbers x = enclosures(surface, p, v);
    const auto b = s->shape_matrix();
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(contains(x.shape.point()[k], s->point()[k]));
      EXPECT_TRUE(contains(x.shape.normal()[k], s->normal()[k]));
      for (int l = k; l < 3; ++l)
        EXPECT_TRUE(contains(x.b(k, l), b(k, l)));
    }
    EXPECT_TRUE(contains(x.shape.trace_numerator(), s->trace_numerator()));
    EXPECT_TRUE(contains(x.shape.minors_numerator(), s->minors_numerator()));
    EXPECT_TRUE(contains(x.k, gaussian_curvature(*s)));
    EXPECT_TRUE(contains(x.h_squared, squared_mean_curvature(*s)));
    EXPECT_TRUE(contains(x.gap_squared, squared_curvature_gap(*s)));
    EXPECT_TRUE(contains(x.kappa_squared, squared_normal_curvature(*s, v)));
    EXPECT_TRUE(x.umbilic.is_certain() ? x.umbilic.make_certain() == is_umbilic(*s) : true);
  }
  EXPECT_GE(checked, 30);
}

TEST(Enclosures, cast_encloses)
{
  Random random(502);
  for (int i = 0; i < 20; ++i)
  {
    const Shape s = random_shape(random);
    const auto t = s.cast<Interval>();
    EXPECT_TRUE(contains(t.normal_squared_length(), s.normal_squared_length()));
    EXPECT_TRUE(contains(t.trace_numerator(), s.trace_numerator()));
    EXPECT_TRUE(contains(t.minors_numerator(), s.minors_numerator()));
  }
}

// --- Values in floating point and Euler's formula ------------------------------------------------

TEST(Values, directions_are_orthonormal_and_right_handed)
{
  Random random(601);
  for (int i = 0; i < 40; ++i)
  {
    const auto s = random_shape(random).cast<double>();
    const auto k = principal_curvatures(s);
    EXPECT_LE(k[0], k[1]);
    const auto d = principal_directions(s);
    ASSERT_TRUE(d) << d.refusal().evidence();
    const auto& [low, high] = *d;
    const double length = std::sqrt(s.normal_squared_length());
    EXPECT_NEAR(internal::dot(low, low), 1, 1e-12);
    EXPECT_NEAR(internal::dot(high, high), 1, 1e-12);
    EXPECT_NEAR(internal::determinant(low, high, s.normal()) / length, 1, 1e-12);
    const double size = std::fabs(k[0]) + std::fabs(k[1]) + 1e-30;
    EXPECT_NEAR(normal_curvature(s, low) / size, k[0] / size, 1e-9);
    EXPECT_NEAR(normal_curvature(s, high) / size, k[1] / size, 1e-9);
    const double c = random.real(-1, 1), e = random.real(-1, 1);
    Coordinates<double, 3> v;
    for (int j = 0; j < 3; ++j)
      v[j] = c * low[j] + e * high[j];
    EXPECT_NEAR(normal_curvature(s, v) / size, normal_curvature_by_euler(k, c, e) / size, 1e-9);
  }
}

// Rounding must not exchange the two where they are equal.
TEST(Values, principal_curvatures_are_in_order_at_umbilics)
{
  Random random(602);
  for (int i = 0; i < 20000; ++i)
  {
    const double k = random.real(-1, 1), noise = i % 3 ? 0 : 1e-16 * random.real(-1, 1);
    const Symmetric_matrix_3<double> t(k, noise, 0, k, 0, k);
    const auto s = Local_shape_3<double>::from_form(
      {0, 0, 0}, {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}, t);
    const auto principal = principal_curvatures(s);
    ASSERT_LE(principal[0], principal[1]) << "round " << i;
  }
}

TEST(Values, types_of_points)
{
  const auto shape = [](int xx, int xy, int yy) {
    return Shape(Point{}, {Q(0), Q(0), Q(2)}, Symmetric_matrix_3<Q>(xx, xy, 0, yy, 0, 0));
  };
  EXPECT_EQ(point_type(shape(2, 1, 3)), Point_type::ELLIPTIC);
  EXPECT_EQ(point_type(shape(-2, 1, -3)), Point_type::ELLIPTIC);
  EXPECT_EQ(point_type(shape(1, 2, 3)), Point_type::HYPERBOLIC);
  EXPECT_EQ(point_type(shape(1, 2, 4)), Point_type::PARABOLIC);
  EXPECT_EQ(point_type(shape(0, 0, 0)), Point_type::PLANAR);
  EXPECT_TRUE(is_umbilic(shape(3, 0, 3)) && !is_planar(shape(3, 0, 3)));
  EXPECT_TRUE(is_umbilic(shape(0, 0, 0)) && is_planar(shape(0, 0, 0)));
  EXPECT_FALSE(is_umbilic(shape(3, 1, 3)));
  EXPECT_TRUE(is_parabolic(shape(1, 2, 4)));
  EXPECT_FALSE(is_parabolic(shape(0, 0, 0)));
}

TEST(Values, principal_curvatures_of_two_points)
{
  Random random(603);
  int compared = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Shape s = random_shape(random), t = random_shape(random);
    const auto k = principal_curvatures(s.cast<double>());
    const auto l = principal_curvatures(t.cast<double>());
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
      {
        if (std::fabs(k[a] - l[b]) <= 1e-9 * (std::fabs(k[a]) + std::fabs(l[b])))
          continue;
        ++compared;
        EXPECT_EQ(compare_principal_curvatures(s, Principal(a), t, Principal(b)),
                  k[a] < l[b] ? CGAL::SMALLER : CGAL::LARGER);
      }
  }
  EXPECT_GT(compared, 700);
}

// --- The waist in the plane ----------------------------------------------------------------------

TEST(Local_shape_2, circle_and_its_reverse)
{
  // The circle of radius 5 at (3, 4), gradient 2 (3, 4): q b = 2 q.
  const Local_shape_2<Q> s({Q(3), Q(4)}, {Q(6), Q(8)}, Q(200));
  EXPECT_EQ(s.shape_number(), Q(2)); // curvature 2 / 10
  EXPECT_EQ(s.normal_squared_length(), Q(100));
  EXPECT_EQ(s.shape_matrix(), (std::array<Q, 3>{Q(32) / 25, Q(-24) / 25, Q(18) / 25}));
  const auto t = s.opposite();
  EXPECT_EQ(t.shape_number(), Q(-2));
  EXPECT_EQ(t.normal(), (Coordinates<Q, 2>{Q(-6), Q(-8)}));
  EXPECT_EQ(t.point(), s.point());
  EXPECT_EQ(s.cast<double>().shape_number(), 2);
  const Interval::Protector protector; // the cast squares the normal
  EXPECT_TRUE(contains(s.cast<Interval>().numerator(), Q(200)));
}

TEST(Local_shape_2, normal_that_is_zero)
{
  using Plane_shape = Local_shape_2<Q>;
  const auto make = [](const Q& y) {
    return Plane_shape::make({Q(0), Q(0)}, {Q(0), y}, Q(3), Refusal_code::SINGULAR_POINT, "this");
  };
  EXPECT_EQ(make(Q(2))->shape_number(), Q(Q(3) / 4));
  const auto refused = make(Q(0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.refusal().code(), Refusal_code::SINGULAR_POINT);
  EXPECT_EQ(refused.refusal().evidence(), "this is zero");
#if !defined(CGAL_NO_PRECONDITIONS) && !defined(NDEBUG)
  EXPECT_THROW(Plane_shape({Q(0), Q(0)}, {Q(0), Q(0)}, Q(1)), CGAL::Precondition_exception);
#endif
  // What is too small for the other number type is not the caller's fault.
  const Plane_shape tiny({Q(0), Q(0)}, {Q(1e-200), Q(0)}, Q(1));
  EXPECT_NO_THROW(tiny.cast<double>());
}

TEST(Local_shape_2, matrix_annihilates_the_normal)
{
  Random random(701);
  for (int i = 0; i < 20; ++i)
  {
    const Local_shape_2<Q> s({Q(0), Q(0)}, {random.rational(), random.nonzero_rational()},
                             random.rational());
    const auto m = s.shape_matrix();
    EXPECT_EQ(Q(m[0] * s.normal()[0] + m[1] * s.normal()[1]), Q(0));
    EXPECT_EQ(Q(m[1] * s.normal()[0] + m[2] * s.normal()[1]), Q(0));
    EXPECT_EQ(Q(m[0] + m[2]), s.shape_number()) << "the trace";
  }
}

} // namespace
