// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Jets against exact derivatives of polynomials and known series, and that zeros by structure make
// no difference.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;

// --- Polynomials, differentiated by hand ---------------------------------------------------------

// A polynomial in N variables as a sum of monomials: slow, simple, and not a jet.
template <int N>
class Polynomial
{
public:
  using Exponents = std::array<int, N>;

  Polynomial() = default;
  explicit Polynomial(const Q& c) { m_terms[Exponents{}] = c; }
  static Polynomial variable(int i)
  {
    Polynomial p;
    Exponents e{};
    e[i] = 1;
    p.m_terms[e] = 1;
    return p;
  }

  friend Polynomial operator+(Polynomial a, const Polynomial& b)
  {
    for (const auto& [e, c] : b.m_terms)
      a.m_terms[e] += c;
    return a;
  }
  friend Polynomial operator-(Polynomial a, const Polynomial& b)
  {
    for (const auto& [e, c] : b.m_terms)
      a.m_terms[e] -= c;
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b)
  {
    Polynomial p;
    for (const auto& [e, c] : a.m_terms)
      for (const auto& [f, d] : b.m_terms)
      {
        Exponents g;
        for (int i = 0; i < N; ++i)
          g[i] = e[i] + f[i];
        p.m_terms[g] += c * d;
      }
    return p;
  }

  // The coefficient of (x - at)^e: the derivative over the factorials.
  Q taylor_coefficient(const std::array<Q, N>& at, const Exponents& e) const
  {
    Q sum(0);
    for (const auto& [exponents, c] : m_terms)
    {
      Q term = c;
      for (int i = 0; i < N; ++i)
        term *= binomial(exponents[i], e[i]) * power(at[i], exponents[i] - e[i]);
      sum += term;
    }
    return sum;
  }

private:
  static Q binomial(int n, int k)
  {
    if (k > n)
      return 0;
    Q b(1);
    for (int i = 1; i <= k; ++i)
      b = b * (n - k + i) / i;
    return b;
  }
  static Q power(const Q& x, int n)
  {
    Q p(1);
    for (int i = 0; i < n; ++i)
      p = p * x;
    return p;
  }

  std::map<Exponents, Q> m_terms;
};

// Runs the same random program in polynomials and in jets.
template <int N, int Order>
void expect_taylor_coefficients(unsigned seed)
{
  using J = Jet<Q, N, Order>;
  Random random(seed);
  for (int round = 0; round < 8; ++round)
  {
    std::array<Q, N> at;
    std::vector<Polynomial<N>> p;
    std::vector<J> j;
    for (int i = 0; i < N; ++i)
    {
      at[i] = random.rational();
      p.push_back(Polynomial<N>::variable(i));
      j.push_back(J::variable(i, at[i]));
    }
    p.emplace_back(Q(2) / 3);
    j.emplace_back(Q(Q(2) / 3));
    for (int step = 0; step < 6; ++step)
    {
      const int a = random.integer(0, int(p.size()) - 1), b = random.integer(0, int(p.size()) - 1);
      switch (step % 3)
      {
      case 0: p.push_back(p[a] * p[b]); j.push_back(j[a] * j[b]); break;
      case 1: p.push_back(p[a] - p[b]); j.push_back(j[a] - j[b]); break;
      default: p.push_back(p[a] + p[b]); j.push_back(j[a] + j[b]);
      }
    }
    p.push_back(p.back() * p.back() + p[0]);
    j.push_back(j.back() * j.back() + j[0]);
    for (int k = 0; k < J::size; ++k)
    {
      const auto e = internal::Monomials<N, Order>::table[k];
      EXPECT_EQ(j.back().coefficient(k), p.back().taylor_coefficient(at, e)) << k;
      EXPECT_EQ(j.back().coefficient(e), j.back().coefficient(k));
    }
  }
}

TEST(Jets, polynomials_of_one_variable)
{
  expect_taylor_coefficients<1, 1>(41);
  expect_taylor_coefficients<1, 2>(42);
  expect_taylor_coefficients<1, 3>(43);
  expect_taylor_coefficients<1, 4>(44);
}

TEST(Jets, polynomials_of_two_variables)
{
  expect_taylor_coefficients<2, 1>(45);
  expect_taylor_coefficients<2, 2>(46);
  expect_taylor_coefficients<2, 3>(47);
  expect_taylor_coefficients<2, 4>(48);
}

TEST(Jets, polynomials_of_three_variables)
{
  expect_taylor_coefficients<3, 1>(49);
  expect_taylor_coefficients<3, 2>(50);
  expect_taylor_coefficients<3, 3>(51);
  expect_taylor_coefficients<3, 4>(52); // 35 coefficients
}

TEST(Jets, derivatives_are_coefficients_times_factorials)
{
  using J = Jet<Q, 2, 2>;
  const J x = J::variable(0, 3), y = J::variable(1, 5);
  const J f = x * x * y + 7 * y * y;
  EXPECT_EQ(f.value(), Q(45 + 175));
  EXPECT_EQ(f.derivative(0), Q(30));
  EXPECT_EQ(f.derivative(1), Q(9 + 70));
  EXPECT_EQ(f.derivative(0, 0), Q(10));
  EXPECT_EQ(f.derivative(0, 1), Q(6));
  EXPECT_EQ(f.derivative(1, 0), Q(6));
  EXPECT_EQ(f.derivative(1, 1), Q(14));
}

TEST(Jets, point_moving_along_directions)
{
  // f(p + s v + t w) has the gradient products and v'Hw as derivatives.
  using J = Jet<Q, 2, 2>;
  const J x = J::along(Q(1), {Q(2), Q(3)}), y = J::along(Q(4), {Q(-1), Q(5)});
  const J f = x * y * y;
  EXPECT_EQ(f.derivative(0), Q(16 * 2 + 8 * -1));
  EXPECT_EQ(f.derivative(1), Q(16 * 3 + 8 * 5));
  EXPECT_EQ(f.derivative(0, 1), Q(8 * (2 * 5 + 3 * -1) + 2 * -1 * 5));
}

// --- Quotients -----------------------------------------------------------------------------------

template <int N, int Order>
void expect_quotients(unsigned seed)
{
  using J = Jet<Q, N, Order>;
  Random random(seed);
  for (int round = 0; round < 10; ++round)
  {
    J a(random.rational()), b(Q(random.integer(1, 9)));
    for (int i = 0; i < N; ++i)
    {
      const J x = J::variable(i, random.rational());
      a = a * x + x;
      b = b + x * x * Q(random.integer(1, 5)) + x * x * x * x;
    }
    const J back = (a / b) * b, inverse = (1 / b) * b;
    for (int k = 0; k < J::size; ++k)
    {
      EXPECT_EQ(back.coefficient(k), a.coefficient(k));
      EXPECT_EQ(inverse.coefficient(k), Q(k == 0 ? 1 : 0));
    }
  }
}

TEST(Jets, quotients)
{
  expect_quotients<1, 4>(61);
  expect_quotients<2, 3>(62);
  expect_quotients<3, 2>(63);
  expect_quotients<3, 4>(64);
}

template <class NT>
void expect_division_by_zero()
{
  using J = Jet<NT, 2, 2>;
  const J x = J::variable(0, NT(2));
  const NT zero(0);
  EXPECT_THROW(x / (x - J(NT(2))), Division_by_zero_error);
  EXPECT_THROW(x / J(zero), Division_by_zero_error);
  EXPECT_THROW(x / J(), Division_by_zero_error);
  EXPECT_THROW(x / zero, Division_by_zero_error);
  EXPECT_THROW(x / 0, Division_by_zero_error);
  EXPECT_THROW(NT(1) / (x - x), Division_by_zero_error);
  EXPECT_THROW(1 / J(zero), Division_by_zero_error);
}

TEST(Jets, division_by_zero_in_every_form)
{
  expect_division_by_zero<Q>();
  expect_division_by_zero<double>();
  const Interval::Protector protector;
  expect_division_by_zero<Interval>();
}

// --- Elementary functions ------------------------------------------------------------------------

bool contains(const Interval& x, const Q& value)
{
  return (std::isinf(x.inf()) || Q(x.inf()) <= value) &&
         (std::isinf(x.sup()) || Q(x.sup()) >= value);
}

using J1 = Jet<Interval, 1, 4>;

void expect_series(const char* name, const J1& f, const std::array<Q, 5>& expected)
{
  for (int k = 0; k <= 4; ++k)
  {
    const Interval c = f.coefficient(k);
    EXPECT_TRUE(contains(c, expected[k])) << name << ", coefficient " << k << ": " << c;
    EXPECT_LE(c.sup() - c.inf(), 1e-14) << name;
  }
}

TEST(Jet_functions, known_series)
{
  const Interval::Protector protector;
  const J1 x = J1::variable(0, Interval(0)), one = J1::variable(0, Interval(1));
  const auto q = [](int a, int b) { return Q(Q(a) / b); };
  expect_series("exp", exp(x), {q(1, 1), q(1, 1), q(1, 2), q(1, 6), q(1, 24)});
  expect_series("sin", sin(x), {q(0, 1), q(1, 1), q(0, 1), q(-1, 6), q(0, 1)});
  expect_series("cos", cos(x), {q(1, 1), q(0, 1), q(-1, 2), q(0, 1), q(1, 24)});
  expect_series("tan", tan(x), {q(0, 1), q(1, 1), q(0, 1), q(1, 3), q(0, 1)});
  expect_series("asin", asin(x), {q(0, 1), q(1, 1), q(0, 1), q(1, 6), q(0, 1)});
  expect_series("atan", atan(x), {q(0, 1), q(1, 1), q(0, 1), q(-1, 3), q(0, 1)});
  expect_series("log", log(one), {q(0, 1), q(1, 1), q(-1, 2), q(1, 3), q(-1, 4)});
  expect_series("sqrt", sqrt(one), {q(1, 1), q(1, 2), q(-1, 8), q(1, 16), q(-5, 128)});
  expect_series("asin + acos", asin(x) + acos(x) - J1::Number_type(1.5707963267948966),
                {q(0, 1), q(0, 1), q(0, 1), q(0, 1), q(0, 1)});
}

// Identities between functions at random places, in all coefficients.
using J2 = Jet<Interval, 2, 3>;

void expect_equal(const char* name, const J2& f, const J2& g)
{
  for (int k = 0; k < J2::size; ++k)
  {
    const Interval d = f.coefficient(k) - g.coefficient(k);
    EXPECT_TRUE(d.inf() <= 0 && 0 <= d.sup()) << name << ", coefficient " << k << ": " << d;
    EXPECT_LE(d.sup() - d.inf(), 1e-9) << name;
  }
}

TEST(Jet_functions, identities)
{
  Random random(71);
  const Interval::Protector protector;
  for (int i = 0; i < 20; ++i)
  {
    const J2 x = J2::variable(0, Interval(random.real(0.1, 0.6)));
    const J2 y = J2::variable(1, Interval(random.real(0.1, 0.6)));
    const J2 u = x * y + x * x, one(Interval(1));
    expect_equal("exp of a sum", exp(x + y), exp(x) * exp(y));
    expect_equal("exp and log", log(exp(u)), u);
    expect_equal("log of a product", log(x * y), log(x) + log(y));
    expect_equal("Pythagoras", sin(u) * sin(u) + cos(u) * cos(u), one);
    expect_equal("sin of a sum", sin(x + y), sin(x) * cos(y) + cos(x) * sin(y));
    expect_equal("tan", tan(u) * cos(u), sin(u));
    expect_equal("tan and atan", tan(atan(u)), u);
    expect_equal("sin and asin", sin(asin(u)), u);
    expect_equal("cos and acos", cos(acos(u)), u);
    expect_equal("sqrt", sqrt(u) * sqrt(u), u);
    expect_equal("square", square(u), u * u);
  }
}

TEST(Jet_functions, exact_roots)
{
  using J = Jet<Q, 2, 3>;
  const J x = J::variable(0, Q(2)), y = J::variable(1, Q(1));
  const J u = x * x + 4 * x * y + 4 * y * y; // (x + 2 y)^2
  const J root = sqrt(u), expected = x + 2 * y;
  for (int k = 0; k < J::size; ++k)
    EXPECT_EQ(root.coefficient(k), expected.coefficient(k));
  EXPECT_THROW(sqrt(x), Not_algebraic_error);
  EXPECT_THROW(exp(x), Not_algebraic_error);
  EXPECT_THROW(sqrt(x - J(Q(2))), Domain_error) << "no derivative";
  EXPECT_EQ(sqrt(J(Q(0))).value(), Q(0)) << "a constant";
}

// --- Zeros by structure --------------------------------------------------------------------------

// All coefficients there, as explicit zeros.
template <class J>
J explicit_zeros()
{
  std::array<typename J::Number_type, J::variables> steps;
  steps.fill(typename J::Number_type(0));
  const J linear = J::along(typename J::Number_type(0), steps);
  J zeros = linear, power = linear;
  for (int k = 1; k < J::order; ++k)
  {
    power = power * linear;
    zeros = zeros + power;
  }
  return zeros;
}

template <class J>
J program(const J& x, const J& y, const J& z)
{
  const J a = x * y - 3 * z + x / (2 + y * y);
  const J b = (a - z) * (a + 1) / (4 + z * z * z * z);
  return b * b - (-a) * x + 5 - (2 - y) * 7 + 1 / (1 + a * a);
}

TEST(Jet_masks, explicit_zeros_give_the_same)
{
  using J = Jet<Q, 3, 4>;
  const J zeros = explicit_zeros<J>();
  for (int k = 0; k < J::size; ++k)
  {
    ASSERT_FALSE(zeros.is_structurally_zero(k)) << k;
    ASSERT_EQ(zeros.coefficient(k), Q(0));
  }
  Random random(81);
  for (int i = 0; i < 6; ++i)
  {
    const J x = J::variable(0, random.rational()), y = J::variable(1, random.rational()),
            z = J::variable(2, random.rational());
    const J sparse = program(x, y, z), dense = program(x + zeros, y + zeros, z + zeros);
    for (int k = 0; k < J::size; ++k)
      EXPECT_EQ(sparse.coefficient(k), dense.coefficient(k)) << k;
  }
}

TEST(Jet_masks, what_cannot_be_there_is_marked)
{
  using J = Jet<Q, 2, 2>; // 1, x, y, xx, xy, yy
  const J x = J::variable(0, Q(0)), y = J::variable(1, Q(7));
  EXPECT_TRUE(J().is_structurally_zero(0));
  EXPECT_FALSE(x.is_structurally_zero(0)) << "a value of zero is a value";
  EXPECT_TRUE(x.is_structurally_zero(2));
  EXPECT_TRUE((x + y).is_structurally_zero(3));
  EXPECT_TRUE((x * y).is_structurally_zero(3));
  EXPECT_FALSE((x * y).is_structurally_zero(4));
  EXPECT_TRUE((x * 3).is_structurally_zero(5));
  EXPECT_EQ((x - x).coefficient(1), Q(0));
}

} // namespace
