// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// What must not depend on the place, the size, the parameters, the orientation or the equations:
// random systems in n-space, patches and plane curves; exactly, in intervals, through the filter.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Curves/Bezier_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Implicit_curve_2.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using Shape = Local_shape_3<Q>;
using Point = Coordinates<Q, 3>;

// A motion followed by a scaling, or the other way round: x -> s R x + t.
struct Similarity
{
  Rotation r;
  Point t;
  Q s;

  explicit Similarity(Random& random)
    : r(random_rotation(random)), t(random.vector()), s(random.fraction(1, 9, 9))
  {}

  Point operator()(const Point& p) const
  {
    Point image;
    for (int i = 0; i < 3; ++i)
      image[i] = s * internal::dot(r[i], p) + t[i];
    return image;
  }
};

// The shape b is a under the map, with a normal of either sign, which is returned.
int expect_image(const Shape& a, const Shape& b, const Similarity& map)
{
  EXPECT_EQ(b.point(), map(a.point()));
  Point n;
  for (int i = 0; i < 3; ++i)
    n[i] = internal::dot(map.r[i], a.normal());
  const Q mu = internal::dot(n, b.normal()) / internal::dot(n, n);
  const auto x = a.shape_matrix(), y = b.shape_matrix();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(b.normal()[i], Q(mu * n[i]));
    for (int j = 0; j < 3; ++j)
    {
      const Q turned = internal::dot(map.r[i], internal::multiply(x, map.r[j]));
      EXPECT_EQ(Q(map.s * y(i, j)), Q(mu * turned));
    }
  }
  const Q square = map.s * map.s;
  EXPECT_EQ(Q(square * gaussian_curvature(b)), gaussian_curvature(a));
  EXPECT_EQ(Q(square * squared_mean_curvature(b)), squared_mean_curvature(a));
  EXPECT_EQ(Q(square * squared_curvature_gap(b)), squared_curvature_gap(a));
  EXPECT_EQ(is_umbilic(a), is_umbilic(b));
  const int sign = CGAL::sign(mu);
  EXPECT_EQ(int(sign_of_mean_curvature(b)), sign * int(sign_of_mean_curvature(a)));
  return sign;
}

// --- Systems in 5-space --------------------------------------------------------------------------

using Expressions = std::vector<Expression>;

Expression random_polynomial(Random& random, const Expressions& x)
{
  Expression f(random.integer(-5, 5));
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    f = f + x[i] * random.integer(-5, 5);
    for (std::size_t j = i; j < x.size(); ++j)
      f = f + x[i] * x[j] * random.integer(-3, 3);
  }
  return f;
}

const std::vector<std::string> names{"x", "y", "z", "u", "v"};

Expressions variables()
{
  Expressions x;
  for (int i = 0; i < 5; ++i)
    x.push_back(Expression::variable(i));
  return x;
}

Result<Shape> shape_of(const Expressions& equations, const std::vector<Q>& p)
{
  return N_space_surface_3(N_space_system(names, equations))(p);
}

// Three equations that hold at a point, recorded again for other variables by the same seed.
struct Random_system
{
  unsigned seed;
  std::vector<Q> p;

  explicit Random_system(unsigned s) : seed(s)
  {
    Random random(1000 + seed);
    for (int i = 0; i < 5; ++i)
      p.push_back(random.rational(4));
  }

  Expressions equations(const Expressions& x) const
  {
    Random random(seed);
    Expressions result;
    for (int k = 0; k < 3; ++k)
    {
      const Expression f = random_polynomial(random, x);
      result.push_back(f - value_at_point(k));
    }
    return result;
  }

private:
  // The value of the polynomial k at the point.
  Q value_at_point(int k) const
  {
    Random random(seed);
    Expression f;
    for (int i = 0; i <= k; ++i)
      f = random_polynomial(random, variables());
    return Expression_tape({f}, 5, Expression_tape::Derivatives::NONE).evaluate(p)[0];
  }
};

// Calls run(system, shape) for systems whose surface is regular at the point.
template <class Run>
void for_each_system(Run run)
{
  int checked = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const Random_system system(seed);
    const auto s = shape_of(system.equations(variables()), system.p);
    if (!s)
      continue;
    SCOPED_TRACE("system of seed " + std::to_string(seed));
    ++checked;
    run(system, *s);
  }
  EXPECT_GE(checked, 10);
}

TEST(Invariance_of_systems, motion_and_scale)
{
  Random random(11);
  for_each_system([&](const Random_system& system, const Shape& s) {
    const Similarity map(random);
    const Expressions x = variables();
    Expressions old = x; // x of the equations in terms of the moved one
    for (int i = 0; i < 3; ++i)
    {
      Expression sum(0);
      for (int j = 0; j < 3; ++j)
        sum = sum + (x[j] - map.t[j]) * Q(map.r[j][i] / map.s);
      old[i] = sum;
    }
    const Point image = map({system.p[0], system.p[1], system.p[2]});
    const auto t = shape_of(system.equations(old),
                            {image[0], image[1], image[2], system.p[3], system.p[4]});
    ASSERT_TRUE(t) << t.refusal().evidence();
    expect_image(s, *t, map);
  });
}

// The hidden variables u, v replaced by others: u = a u' + v', v = u' - b v' + c u'^2.
TEST(Invariance_of_systems, other_hidden_variables)
{
  Random random(12);
  for_each_system([&](const Random_system& system, const Shape& s) {
    const Q a = random.fraction(1, 9, 9), b = random.fraction(1, 9, 9), c = random.rational();
    const Q u = random.rational(), v = random.rational();
    Expressions x = variables();
    const Expression new_u = x[3], new_v = x[4];
    // Moved so that the point has the new coordinates u, v.
    x[3] = system.p[3] + a * (new_u - u) + (new_v - v);
    x[4] = system.p[4] + (new_u - u) - b * (new_v - v) + c * (new_u - u) * (new_u - u);
    const auto t = shape_of(system.equations(x), {system.p[0], system.p[1], system.p[2], u, v});
    ASSERT_TRUE(t) << t.refusal().evidence();
    expect_same_shape(s, *t);
  });
}

// Other equations with the same solutions, in another order, some of them redundant.
TEST(Invariance_of_systems, other_and_redundant_equations)
{
  Random random(13);
  for_each_system([&](const Random_system& system, const Shape& s) {
    const Expressions x = variables(), f = system.equations(x);
    const Expression sum = f[0] * random_polynomial(random, x) +
                           f[1] * random_polynomial(random, x);
    const Q factor = random.nonzero_rational();
    Expressions g{f[2], sum, f[1] * factor, f[0] - f[2] * random.integer(-5, 5), sum * sum};
    for (int i = 4; i > 0; --i)
      std::swap(g[i], g[random.integer(0, i)]);
    const auto t = shape_of(g, system.p);
    ASSERT_TRUE(t) << t.refusal().evidence();
    expect_same_shape(s, *t);
    // One more equation that holds at the point alone leaves no surface.
    g.push_back(f[0] + random_polynomial(random, x) * (x[0] - system.p[0]));
    EXPECT_FALSE(shape_of(g, system.p));
  });
}

// The order and the names of the first three variables are those of space.
TEST(Invariance_of_systems, exchange_of_two_axes)
{
  for_each_system([&](const Random_system& system, const Shape& s) {
    Expressions x = variables();
    std::swap(x[0], x[1]);
    const auto t = shape_of(system.equations(x),
                            {system.p[1], system.p[0], system.p[2], system.p[3], system.p[4]});
    ASSERT_TRUE(t) << t.refusal().evidence();
    EXPECT_EQ(gaussian_curvature(s), gaussian_curvature(*t));
    EXPECT_EQ(squared_mean_curvature(s), squared_mean_curvature(*t));
  });
}

// --- The same in intervals and through the filter ------------------------------------------------

TEST(Invariance_of_systems, intervals_contain_and_the_filter_agrees)
{
  using Protected = CGAL::Interval_nt<false>;
  int decided = 0, of = 0;
  for_each_system([&](const Random_system& system, const Shape& s) {
    const N_space_surface_3 surface(N_space_system(names, system.equations(variables())));
    const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign_k;
    const Filtered<Shape_chain<Sign_of_mean_curvature>> sign_h;
    const auto k = sign_k(surface, system.p), h = sign_h(surface, system.p);
    ASSERT_TRUE(k && h);
    EXPECT_EQ(*k, sign_of_gaussian_curvature(s));
    EXPECT_EQ(*h, sign_of_mean_curvature(s));
    const Protected::Protector protector;
    const auto t = surface(cast_argument<Protected>(system.p));
    ++of;
    if (!t)
    {
      EXPECT_EQ(t.refusal().code(), Refusal_code::UNDECIDED) << t.refusal().evidence();
      return;
    }
    ++decided;
    const Protected enclosed = gaussian_curvature(*t), squared = squared_mean_curvature(*t);
    expect_contains({enclosed.inf(), enclosed.sup()}, gaussian_curvature(s));
    expect_contains({squared.inf(), squared.sup()}, squared_mean_curvature(s));
  });
  EXPECT_GE(2 * decided, of);
}

// --- Patches -------------------------------------------------------------------------------------

using Net = std::vector<std::vector<Point>>;

struct Random_patch
{
  Net points;
  std::vector<std::vector<Q>> weights;
  Coordinates<Q, 2> uv;

  explicit Random_patch(Random& random)
    : points(4, std::vector<Point>(3)), weights(4, std::vector<Q>(3))
  {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
      {
        points[i][j] = {Q(3 * i + random.rational() / 9), Q(3 * j + random.rational() / 9),
                        random.rational()};
        weights[i][j] = random.fraction(1, 9, 5);
      }
    uv = {random.in_unit_interval(), random.in_unit_interval()};
  }

  Result<Shape> shape() const { return Bezier_surface_3<Q>(points, weights)(uv); }
};

TEST(Invariance_of_patches, motion_and_scale)
{
  Random random(21);
  for (int i = 0; i < 20; ++i)
  {
    Random_patch patch(random);
    const auto s = patch.shape();
    ASSERT_TRUE(s);
    const Similarity map(random);
    for (auto& row : patch.points)
      for (Point& p : row)
        p = map(p);
    const auto t = patch.shape();
    ASSERT_TRUE(t);
    EXPECT_EQ(expect_image(*s, *t, map), 1) << "a motion keeps the orientation";
  }
}

TEST(Invariance_of_patches, reversal_and_projective_change_of_the_parameters)
{
  Random random(22);
  for (int i = 0; i < 20; ++i)
  {
    const Random_patch patch(random);
    const auto s = patch.shape();
    ASSERT_TRUE(s);
    // u -> 1 - u turns the normal.
    Random_patch reversed = patch;
    std::reverse(reversed.points.begin(), reversed.points.end());
    std::reverse(reversed.weights.begin(), reversed.weights.end());
    reversed.uv[0] = 1 - patch.uv[0];
    const auto r = reversed.shape();
    ASSERT_TRUE(r);
    expect_same_shape(s->opposite(), *r);
    // Weights times c^i are the parameter u = c u' / (1 - u' + c u').
    Random_patch changed = patch;
    const Q c = random.fraction(1, 9, 9);
    Q power = 1;
    for (auto& row : changed.weights)
    {
      for (Q& w : row)
        w *= power;
      power *= c;
    }
    const Q u = patch.uv[0];
    changed.uv[0] = u / (u + c * (1 - u));
    const auto t = changed.shape();
    ASSERT_TRUE(t);
    expect_same_shape(*s, *t);
  }
}

// --- Plane curves --------------------------------------------------------------------------------

TEST(Invariance_of_curves, motion_scale_and_orientation)
{
  Random random(31);
  for (int i = 0; i < 20; ++i)
  {
    std::vector<Coordinates<Q, 2>> p, moved;
    const Q t = random.rational(), w = 1 + t * t, factor = random.fraction(1, 9, 9);
    const Q cosine = (1 - t * t) / w, sine = 2 * t / w;
    const Q x = random.rational(), y = random.rational();
    for (int k = 0; k < 4; ++k)
    {
      p.push_back({random.rational(), random.rational()});
      moved.push_back({Q(factor * (cosine * p[k][0] - sine * p[k][1]) + x),
                       Q(factor * (sine * p[k][0] + cosine * p[k][1]) + y)});
    }
    const Q at = random.in_unit_interval();
    const auto s = Bezier_curve_2<Q>(p)(at), m = Bezier_curve_2<Q>(moved)(at);
    ASSERT_TRUE(s && m);
    const auto squared = [](const Local_shape_2<Q>& shape) {
      return Q(shape.shape_number() * shape.shape_number() / shape.normal_squared_length());
    };
    EXPECT_EQ(Q(factor * factor * squared(*m)), squared(*s));
    EXPECT_EQ(CGAL::sign(m->numerator()), CGAL::sign(s->numerator()));
    EXPECT_EQ(s->opposite().numerator(), Q(-s->numerator()));
    EXPECT_EQ(squared(s->opposite()), squared(*s));
  }
}

// f and h f have the same zeros where h has none; the normal gets the factor h(p).
TEST(Invariance_of_curves, equation_times_function)
{
  Random random(32);
  int checked = 0;
  for (int i = 0; i < 20; ++i)
  {
    const Coordinates<Q, 2> p{random.rational(), random.rational()};
    const Q a = random.rational(), b = random.rational(), c = random.rational();
    const int sign = i % 2 ? 1 : -1;
    const auto f = [=](const auto& x, const auto& y) {
      using NT = std::decay_t<decltype(x)>;
      const NT dx = x - NT(p[0]), dy = y - NT(p[1]);
      return NT(NT(a) * dx + NT(b) * dy + NT(c) * dx * dy + dx * dx * dx - dy * dy);
    };
    const auto g = [=](const auto& x, const auto& y) {
      using NT = std::decay_t<decltype(x)>;
      return NT(f(x, y) * NT(sign) * (NT(1) + x * x + y * y));
    };
    const auto s = Implicit_curve_2(f)(p), t = Implicit_curve_2(g)(p);
    if (!s)
      continue;
    ++checked;
    ASSERT_TRUE(t);
    expect_same_shape(sign > 0 ? *s : s->opposite(), *t);
  }
  EXPECT_GE(checked, 15);
}

} // namespace
