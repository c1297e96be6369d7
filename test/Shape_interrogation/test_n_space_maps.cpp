// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Systems in n-space made from surfaces that are known otherwise: 1000 rational maps hidden among
// 4 to 16 variables, implicit surfaces, patches; and what redundancy, order and scale of the
// equations must not change. All answers are compared exactly.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace testing_shapes;
using Shape = Local_shape_3<Q>;
using Expressions = std::vector<Expression>;

Expression variable(int i) { return Expression::variable(i); }

// Equations with a point of their solution.
struct System
{
  Expressions equations;
  std::vector<Q> point;

  int n() const { return static_cast<int>(point.size()); }

  N_space_system compiled() const
  {
    std::vector<std::string> names{"x", "y", "z"};
    for (int i = 3; i < n(); ++i)
      names.push_back("h" + std::to_string(i));
    return N_space_system(names, equations);
  }

  N_space_surface_3 surface() const { return N_space_surface_3(compiled()); }
  Result<Shape> shape() const { return surface()(point); }
};

// The same data for a normal of any length and either sign.
void expect_same_surface(const Result<Shape>& known, const Result<Shape>& of_system)
{
  ASSERT_EQ(known.has_value(), of_system.has_value())
    << (known ? of_system : known).refusal().evidence();
  if (!known)
    return;
  const bool turned =
    CGAL::is_negative(Q(internal::dot(known->normal(), of_system->normal())));
  expect_same_shape(turned ? known->opposite() : *known, *of_system);
}

// --- Rational maps -------------------------------------------------------------------------------

constexpr int max_degree = 4;

// A variable of the system that is a polynomial of the parameters.
struct Hidden
{
  Expression in_system, in_parameters;
  int degree;
};

// The same polynomial of degree at most 4 in the hidden variables and in the parameters. It uses
// products of two variables, or of one with itself up to the fourth power.
std::pair<Expression, Expression> random_polynomial(Random& random, const std::vector<Hidden>& h)
{
  std::pair<Expression, Expression> f{Expression(random.rational(4)), Expression(0)};
  f.second = f.first;
  const int terms = random.integer(1, 4);
  for (int t = 0; t < terms; ++t)
  {
    Expression a(random.nonzero_rational(4));
    Expression b = a;
    for (int degree = 0;;)
    {
      const Hidden& x = h[random.integer(0, static_cast<int>(h.size()) - 1)];
      degree += x.degree;
      if (degree > max_degree || random.integer(0, 4) == 0)
        break;
      a = a * x.in_system;
      b = b * x.in_parameters;
    }
    f.first = f.first + a;
    f.second = f.second + b;
  }
  return f;
}

Q value_of(const Expression& f, const std::vector<Q>& x)
{
  const int n = static_cast<int>(x.size());
  return Expression_tape({f}, n, Expression_tape::Derivatives::NONE).evaluate(x)[0];
}

// A map (u, v) -> P / w and the system in n variables that says the same. For n = 4 the first
// coordinate is a parameter itself.
struct Map_system
{
  Expressions map;
  std::vector<Q> uv;
  System system;

  Map_system(Random& random, int n) : m_random(random), m_n(n)
  {
    uv = {random.rational(5), random.rational(5)};
    add_parameters();
    while (m_next < n)
      add_hidden();
    choose_denominator();
    for (int i = n == 4 ? 1 : 0; i < 3; ++i)
      add_coordinate(i);
    for (int i = 0; i < 3; ++i)
      system.point.insert(system.point.begin() + i, value_of(map[i], uv));
  }

  // An equation that follows from the others to first order and beyond: a combination, or x_i P_j =
  // x_j P_i.
  void add_redundant(Random& random)
  {
    const int i = random.integer(0, last()), j = random.integer(0, last());
    const Expressions& f = m_first;
    const Expression a = random_polynomial(random, m_hidden).first + random.rational();
    if (random.integer(0, 2) == 0)
      system.equations.push_back(m_numerators[1] * variable(2) - m_numerators[2] * variable(1));
    else
      system.equations.push_back(a * f[i] + (variable(random.integer(0, m_n - 1)) - 2) * f[j]);
  }

  // One whose gradient vanishes on the surface.
  void add_without_gradient(Random& random)
  {
    const int i = random.integer(0, last()), j = random.integer(0, last());
    const Expression a = random_polynomial(random, m_hidden).first;
    system.equations.push_back((a + 1) * m_first[i] * m_first[j]);
  }

  void shuffle(Random& random)
  {
    for (int i = static_cast<int>(system.equations.size()) - 1; i > 0; --i)
      std::swap(system.equations[i], system.equations[random.integer(0, i)]);
  }

  void keep() { m_first = system.equations; }

  Result<Shape> shape_of_map() const
  {
    return Parametric_surface_3(Expression_function<2, 3>(map))(Coordinates<Q, 2>{uv[0], uv[1]});
  }

private:
  int last() const { return static_cast<int>(m_first.size()) - 1; }

  void add_parameters()
  {
    if (m_n == 4)
    {
      m_hidden.push_back({variable(0), variable(0), 1});
      map.push_back(variable(0));
      m_numerators.push_back(variable(0));
    }
    for (int i = m_n == 4 ? 1 : 0; i < 2; ++i)
    {
      m_hidden.push_back({variable(m_next++), variable(i), 1});
      system.point.push_back(uv[i]);
    }
  }

  // One more variable, which stands for a polynomial in those before.
  void add_hidden()
  {
    const Hidden a = m_hidden[m_random.integer(0, static_cast<int>(m_hidden.size()) - 1)];
    const Hidden b = m_hidden[m_random.integer(0, static_cast<int>(m_hidden.size()) - 1)];
    const Q s = m_random.nonzero_rational(3), t = m_random.rational(3);
    Hidden h{variable(m_next++), a.in_parameters * s + t, a.degree};
    Expression f = a.in_system * s + t;
    if (a.degree + b.degree <= max_degree)
    {
      f = f + a.in_system * b.in_system;
      h.in_parameters = h.in_parameters + a.in_parameters * b.in_parameters;
      h.degree = a.degree + b.degree;
    }
    system.equations.push_back((f - h.in_system) * m_random.nonzero_rational(3));
    system.point.push_back(value_of(h.in_parameters, uv));
    m_hidden.push_back(h);
  }

  void choose_denominator()
  {
    do
      m_denominator = m_random.integer(0, 2) == 0
                        ? std::pair<Expression, Expression>{Expression(1), Expression(1)}
                        : random_polynomial(m_random, m_hidden);
    while (CGAL::is_zero(value_of(m_denominator.second, uv)));
  }

  void add_coordinate(int i)
  {
    const auto p = random_polynomial(m_random, m_hidden);
    map.push_back(p.second / m_denominator.second);
    m_numerators.push_back(p.first);
    if (m_random.integer(0, 3) == 0)
      system.equations.push_back(variable(i) - p.first / m_denominator.first);
    else
      system.equations.push_back(variable(i) * m_denominator.first - p.first);
  }

  Random& m_random;
  int m_n, m_next = 3;
  std::vector<Hidden> m_hidden;
  std::pair<Expression, Expression> m_denominator;
  Expressions m_numerators, m_first;
};

// 1000 systems in five tests of 200: n = 4 ... 16, none to three redundant equations; where there
// are any, one has no gradient.
class Rational_maps : public testing::TestWithParam<unsigned>
{};

TEST_P(Rational_maps, have_exactly_the_curvature_of_the_map)
{
  int regular = 0, curved = 0, redundant = 0;
  for (unsigned i = 0; i < 200; ++i)
  {
    Random random(GetParam() + i);
    Map_system m(random, 4 + static_cast<int>(i % 13));
    m.keep();
    const int extra = static_cast<int>(i / 13 % 4);
    if (extra > 0)
      m.add_without_gradient(random);
    for (int k = 1; k < extra; ++k)
      m.add_redundant(random);
    m.shuffle(random);
    const auto known = m.shape_of_map();
    const auto s = m.system.surface().shape(m.system.point);
    ASSERT_EQ(known.has_value(), s.has_value()) << "system " << i;
    if (!known)
    {
      expect_refusal(Refusal_code::PROJECTION_SINGULAR, s);
      continue;
    }
    ++regular;
    curved += !CGAL::is_zero(gaussian_curvature(*known));
    redundant += extra;
    expect_same_surface(known, s->shape);
    EXPECT_EQ(s->rank, m.system.n() - 2);
    EXPECT_EQ(static_cast<int>(s->redundant_equations.size()), extra);
  }
  EXPECT_GE(regular, 150);
  EXPECT_GE(curved, 120);
  EXPECT_GE(redundant, 200);
}

INSTANTIATE_TEST_SUITE_P(seeds, Rational_maps, testing::Values(1000u, 2000u, 3000u, 4000u, 5000u));

// --- Other representations -----------------------------------------------------------------------

// A polynomial of degree 4 in space, and the same with products kept in variables of their own.
TEST(Systems, have_the_data_of_implicit_surfaces)
{
  Random random(6001);
  int regular = 0;
  for (int i = 0; i < 60; ++i)
  {
    std::vector<Hidden> h;
    for (int k = 0; k < 3; ++k)
      h.push_back({variable(k), variable(k), 1});
    System system;
    system.point = {random.rational(4), random.rational(4), random.rational(4)};
    const std::vector<Q> p = system.point;
    for (int k = 0, more = i % 4; k < more; ++k)
    {
      const Hidden &a = h[random.integer(0, 2)], &b = h[random.integer(0, 2)];
      const Hidden product{variable(3 + k), a.in_parameters * b.in_parameters, 2};
      system.equations.push_back(product.in_system - a.in_system * b.in_system);
      system.point.push_back(value_of(product.in_parameters, p));
      h.push_back(product);
    }
    const auto f = random_polynomial(random, h), g = random_polynomial(random, h);
    const Q level = value_of(f.second + g.second, p);
    system.equations.push_back(f.first + g.first - level);
    const Expression all = f.second + g.second - level;
    const auto known = Implicit_surface_3(Expression_function<3>(all))(
      Coordinates<Q, 3>{p[0], p[1], p[2]});
    expect_same_surface(known, system.shape());
    regular += known.has_value();
  }
  EXPECT_GE(regular, 45);
}

// All Bernstein polynomials of a degree.
Expressions bernstein(int degree, const Expression& t)
{
  Expressions b{Expression(1)};
  for (int d = 0; d < degree; ++d)
  {
    b.push_back(Expression(0));
    for (int i = d + 1; i > 0; --i)
      b[i] = b[i] * (1 - t) + b[i - 1] * t;
    b[0] = b[0] * (1 - t);
  }
  return b;
}

TEST(Systems, have_the_data_of_rational_patches)
{
  Random random(6002);
  for (int i = 0; i < 20; ++i)
  {
    std::vector<std::vector<Coordinates<Q, 3>>> net(4, std::vector<Coordinates<Q, 3>>(3));
    std::vector<std::vector<Q>> weights(4, std::vector<Q>(3));
    const Expressions bu = bernstein(3, variable(3)), bv = bernstein(2, variable(4));
    Expressions sums(4, Expression(0));
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 3; ++b)
      {
        net[a][b] = {Q(3 * a + random.rational() / 9), Q(3 * b + random.rational() / 9),
                     random.rational()};
        weights[a][b] = random.fraction(1, 9, 5);
        for (int k = 0; k < 4; ++k)
          sums[k] = sums[k] + bu[a] * bv[b] *
                                Q(k < 3 ? Q(weights[a][b] * net[a][b][k]) : weights[a][b]);
      }
    const Coordinates<Q, 2> uv{random.in_unit_interval(), random.in_unit_interval()};
    const auto known = Bezier_surface_3<Q>(net, weights)(uv);
    ASSERT_TRUE(known);
    System system;
    system.point = {known->point()[0], known->point()[1], known->point()[2], uv[0], uv[1]};
    for (int k = 0; k < 3; ++k)
      system.equations.push_back(i % 2 ? variable(k) * sums[3] - sums[k]
                                       : variable(k) - sums[k] / sums[3]);
    expect_same_surface(known, system.shape());
  }
}

// --- Redundancy, order and scale -----------------------------------------------------------------

// A polynomial that does not vanish at the point.
Expression random_unit(Random& random, const System& s)
{
  Expression f;
  do
    f = variable(random.integer(0, s.n() - 1)) * variable(random.integer(0, s.n() - 1)) *
          random.rational(3) +
        random.nonzero_rational(3);
  while (CGAL::is_zero(value_of(f, s.point)));
  return f;
}

// The equation with each variable `i` replaced by x[i], through a tape over expressions.
Expression substituted(const Expression& f, const Expressions& x)
{
  const int n = static_cast<int>(x.size());
  return Expression_tape({f}, n, Expression_tape::Derivatives::NONE).evaluate(x)[0];
}

using Change = void (*)(Random&, System&);

void add_dependent_equations(Random& random, System& s)
{
  const int m = static_cast<int>(s.equations.size());
  for (int k = random.integer(1, 3); k > 0; --k)
    s.equations.push_back(random_unit(random, s) * s.equations[random.integer(0, m - 1)] -
                          s.equations[random.integer(0, m - 1)] * random_unit(random, s));
}

void add_equations_without_gradient(Random& random, System& s)
{
  const int m = static_cast<int>(s.equations.size());
  const Expression f = s.equations[random.integer(0, m - 1)];
  s.equations.push_back(f * f * random_unit(random, s));
  s.equations.push_back(f * s.equations[random.integer(0, m - 1)]);
  s.equations.push_back(Expression(0));
}

void permute_equations(Random& random, System& s)
{
  for (int i = static_cast<int>(s.equations.size()) - 1; i > 0; --i)
    std::swap(s.equations[i], s.equations[random.integer(0, i)]);
}

void permute_hidden_variables(Random& random, System& s)
{
  std::vector<int> place;
  for (int i = 0; i < s.n(); ++i)
    place.push_back(i);
  for (int i = s.n() - 1; i > 3; --i)
    std::swap(place[i], place[random.integer(3, i)]);
  Expressions x;
  std::vector<Q> p(s.n());
  for (int i = 0; i < s.n(); ++i)
  {
    x.push_back(variable(place[i]));
    p[place[i]] = s.point[i];
  }
  for (Expression& f : s.equations)
    f = substituted(f, x);
  s.point = p;
}

void rescale_equations(Random& random, System& s)
{
  for (Expression& f : s.equations)
    f = f * random.nonzero_rational();
}

void multiply_equations_by_functions(Random& random, System& s)
{
  for (Expression& f : s.equations)
    f = f * random_unit(random, s);
}

// (Combinations of combinations would have no numerical rank.)
void replace_equations_by_combinations(Random& random, System& s)
{
  for (std::size_t i = 1; i < s.equations.size(); i += 2)
    s.equations[i] = s.equations[i] + s.equations[i - 1] * random_unit(random, s);
}

void change_everything(Random& random, System& s)
{
  for (Change change : {rescale_equations, add_dependent_equations, permute_equations,
                        add_equations_without_gradient, permute_hidden_variables,
                        permute_equations})
    change(random, s);
}

const std::vector<Change> changes{
  add_dependent_equations, add_equations_without_gradient, permute_equations,
  permute_hidden_variables, rescale_equations, multiply_equations_by_functions,
  replace_equations_by_combinations, change_everything};

System regular_system(Random& random, int n)
{
  for (;;)
  {
    const Map_system m(random, n);
    if (m.shape_of_map())
      return m.system;
  }
}

class Changes_of_equations : public testing::TestWithParam<int>
{};

TEST_P(Changes_of_equations, leave_every_exact_answer_unchanged)
{
  Random random(7000 + GetParam());
  for (int n = 4; n <= 16; ++n)
  {
    const System system = regular_system(random, n);
    const auto s = system.shape();
    System changed = system;
    changes[GetParam()](random, changed);
    const auto t = changed.shape();
    SCOPED_TRACE(n);
    expect_same_result(s, t);
    ASSERT_TRUE(s && t);
    EXPECT_EQ(sign_of_gaussian_curvature(*s), sign_of_gaussian_curvature(*t));
    EXPECT_EQ(is_umbilic(*s), is_umbilic(*t));
    // A prepared order of elimination, even one found at another point, changes nothing.
    N_space_system prepared = changed.compiled();
    ASSERT_TRUE(prepared.prepare(changed.point));
    expect_same_result(s, N_space_surface_3(prepared)(changed.point));
  }
}

TEST_P(Changes_of_equations, leave_filtered_decisions_and_enclosures_right)
{
  using Protected = CGAL::Interval_nt<false>;
  Random random(7100 + GetParam());
  int decided = 0;
  for (int n = 4; n <= 16; ++n)
  {
    System changed = regular_system(random, n);
    const auto s = changed.shape();
    ASSERT_TRUE(s);
    changes[GetParam()](random, changed);
    const N_space_surface_3 surface = changed.surface();
    const auto k = Filtered<Shape_chain<Sign_of_gaussian_curvature>>()(surface, changed.point);
    ASSERT_TRUE(k) << k.refusal().evidence();
    EXPECT_EQ(*k, sign_of_gaussian_curvature(*s));
    const Protected::Protector protector;
    const auto t = surface(cast_argument<Protected>(changed.point));
    if (!t)
    {
      EXPECT_EQ(t.refusal().code(), Refusal_code::UNDECIDED) << t.refusal().evidence();
      continue;
    }
    ++decided;
    const Protected enclosed = gaussian_curvature(*t);
    expect_contains({enclosed.inf(), enclosed.sup()}, gaussian_curvature(*s));
  }
  EXPECT_GE(decided, 6);
}

// Redundant equations whose gradients are rounding noise, or whose second forms are, are no reason
// to refuse a point in floating point, and no reason for other numbers.
TEST_P(Changes_of_equations, leave_answers_in_double_right)
{
  Random random(7300 + GetParam());
  int close = 0, of = 0;
  for (int i = 0; i < 5; ++i)
    for (int n = 4; n <= 16; ++n)
    {
      System changed = regular_system(random, n);
      const auto s = changed.shape();
      ASSERT_TRUE(s);
      changes[GetParam()](random, changed);
      const auto t = changed.surface()(cast_argument<double>(changed.point));
      SCOPED_TRACE(n);
      ++of;
      EXPECT_TRUE(t) << t.refusal().evidence();
      const double k = number_cast<double>(gaussian_curvature(*s));
      const double h = number_cast<double>(squared_mean_curvature(*s));
      if (t)
        close += std::fabs(gaussian_curvature(*t) - k) <= 1e-7 * (std::fabs(k) + h);
    }
  EXPECT_GE(close, of - 3) << "but for points that are nearly singular";
}

// A point off the solution, a lost rank, a projected plane that is a line, a redundant equation
// that holds to first order only: each is refused for the same reason after every change.
TEST_P(Changes_of_equations, leave_refusals_unchanged)
{
  Random random(7200 + GetParam());
  const auto expect_refused = [&](System s, Refusal_code code) {
    expect_refusal(code, s.shape());
    changes[GetParam()](random, s);
    expect_refusal(code, s.shape());
  };
  for (int n = 5; n <= 16; ++n)
  {
    SCOPED_TRACE(n);
    const System system = regular_system(random, n);
    System off = system;
    off.equations[0] = off.equations[0] + 1;
    expect_refused(off, Refusal_code::NOT_ON_SOLUTION);
    System lost = system;
    lost.equations.back() = lost.equations.back() * lost.equations[0];
    expect_refused(lost, Refusal_code::RANK_DEFICIENT);
    System folded = system; // (x, y, z) on a line, along which the first parameter runs
    for (int k = 0; k < 3; ++k)
      folded.equations.pop_back();
    for (int k = 0; k < 3; ++k)
      folded.equations.push_back(variable(k) - folded.point[k] -
                                 variable(3) * variable(3) * variable(3) * (k + 1));
    for (int k = 0; k < 3; ++k)
      folded.point[k] = folded.point[k] + folded.point[3] * folded.point[3] * folded.point[3] *
                                            (k + 1);
    expect_refused(folded, Refusal_code::PROJECTION_SINGULAR);
    System contradicting = system;
    const Expression dx = variable(0) - Q(system.point[0]);
    const Expression dy = variable(1) - Q(system.point[1]);
    const Expression dz = variable(2) - Q(system.point[2]);
    contradicting.equations.push_back(system.equations[0] + dx * dx + dy * dy + dz * dz);
    expect_refused(contradicting, Refusal_code::INCONSISTENT_REDUNDANCY);
  }
}

INSTANTIATE_TEST_SUITE_P(all, Changes_of_equations,
                         testing::Range(0, static_cast<int>(changes.size())));

} // namespace
