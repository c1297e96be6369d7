// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Recorded expressions: recording, simplification, parsing, printing, tapes and gradients.

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Exact_ring.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<false>;
using Protector = Interval::Protector;
using Strings = std::vector<std::string>;

const Strings xyz{"x", "y", "z"};

Expression parsed(const std::string& text) { return parse_expression(text, xyz); }

template <class NT>
NT value(const Expression& e, const std::vector<NT>& at)
{
  return Expression_tape({e}, static_cast<int>(at.size())).evaluate(at)[0];
}

Q fraction(int p, int q) { return Q(Q(p) / Q(q)); }

// Pads a gradient row with zeros.
template <class NT>
std::vector<NT> full_gradient(const Expression_tape& tape, const std::vector<NT>& at)
{
  std::vector<NT> full(at.size(), NT(0));
  const std::vector<NT> entries = tape.gradient(at);
  for (std::size_t k = 0; k < entries.size(); ++k)
    full[tape.gradient_pattern().columns[k]] = entries[k];
  return full;
}

bool overlap(const Interval& a, const Interval& b)
{
  return a.inf() <= b.sup() && b.inf() <= a.sup();
}

struct Quadric
{
  template <class NT>
  NT operator()(NT x, NT y, NT z) const
  {
    return x * x + 2 * y - NT(3) / NT(4) * z + CGAL::square(x) * y / (z - 1);
  }
};

// --- Recording -----------------------------------------------------------------------------------

TEST(Expression, records_a_functor)
{
  const Expression e = record_expression<3>(Quadric());
  EXPECT_EQ(value<Q>(e, {1, 2, 3}), fraction(15, 4));
  EXPECT_EQ(value<double>(e, {1, 2, 3}), 3.75);
  Protector protector;
  const Interval i = value<Interval>(e, {1, 2, 3});
  EXPECT_TRUE(i.inf() <= 3.75 && 3.75 <= i.sup());
  EXPECT_LT(i.sup() - i.inf(), 1e-14);
}

TEST(Expression, records_maps_and_array_arguments)
{
  const auto sphere = record_expression<2>([](auto u, auto v) {
    return std::array<decltype(u), 3>{2 * u, 2 * v, u * u + v * v - 1};
  });
  static_assert(std::is_same_v<std::decay_t<decltype(sphere)>, std::array<Expression, 3>>);
  EXPECT_EQ(value<Q>(sphere[2], {2, 3}), Q(12));

  const Expression sum = record_expression<4>([](const auto& x) -> Expression {
    if constexpr (std::is_same_v<std::decay_t<decltype(x)>, std::array<Expression, 4>>)
      return x[0] + x[1] * x[2] - x[3];
    else
      return Expression();
  });
  EXPECT_EQ(value<Q>(sum, {1, 2, 3, 4}), Q(3));

  const Expression constant = record_expression<1>([](const Expression&) { return 7; });
  EXPECT_EQ(constant.constant(), Q(7));
}

TEST(Expression, takes_numbers_on_either_side_exactly)
{
  const Expression x = Expression::variable(0);
  const Q a = fraction(1, 3), b(6);
  const Expression e = 2 * x + x * 3L - 0.1 * x + (x - a) / b + (a * b) * x + 1u - 5LL;
  const Q tenth(0.1); // the double next to 1/10
  Q expected = Q(2) + 3 - tenth + (Q(1) - a) / b + 2 + 1 - 5;
  EXPECT_EQ(value<Q>(e, {1}), expected);

  EXPECT_EQ(Expression(std::numeric_limits<long long>::min()).constant(),
            Q("-9223372036854775808"));
  EXPECT_EQ(Expression(std::numeric_limits<unsigned long long>::max()).constant(),
            Q("18446744073709551615"));
  EXPECT_EQ(Expression(-3).constant(), Q(-3));
  EXPECT_THROW(Expression(std::nan("")), Conversion_error);
  EXPECT_THROW(Expression{HUGE_VAL}, Conversion_error);
}

template <class T, class = void> struct Can_compare : std::false_type {};
template <class T>
struct Can_compare<T, std::void_t<decltype(std::declval<T>() < std::declval<T>())>> : std::true_type
{};

TEST(Expression, has_no_order_to_branch_on)
{
  EXPECT_TRUE(Can_compare<double>::value);
  EXPECT_FALSE(Can_compare<Expression>::value);
}

TEST(Expression, tells_what_it_uses)
{
  EXPECT_TRUE(parsed("x^2*y/3 - z").is_polynomial());
  EXPECT_EQ(parsed("x^2*y/3 - z").degree_bound(), 3u);
  EXPECT_TRUE(parsed("1/x").uses_division());
  EXPECT_TRUE(parsed("x^-1").uses_division());
  EXPECT_TRUE(parsed("sqrt(x)/y").is_algebraic());
  EXPECT_TRUE(parsed("sqrt(x)").uses_sqrt());
  EXPECT_FALSE(parsed("sqrt(x)").is_polynomial());
  EXPECT_TRUE(parsed("pi*x").uses_transcendental());
  EXPECT_FALSE(parsed("exp(x)").is_algebraic());
  EXPECT_TRUE(parsed("sqrt(4)*x + exp(0)").is_polynomial());
}

// --- Simplification ------------------------------------------------------------------------------

TEST(Expression, simplifies_without_hiding_poles)
{
  const Strings same{"x", "x+0", "0+x", "x*1", "1*x", "x/1", "x^1", "--x", "x-0", "-(0-x)",
                     "(2*x)/2", "(x+3)-3", "x^2^0"};
  for (const std::string& text : same)
    EXPECT_EQ(to_string(parsed(text), xyz), "x") << text;
  const std::vector<std::array<std::string, 2>> cases{
    {"0*x", "0"}, {"x-x", "0"}, {"x^0", "1"}, {"0*(1/x)", "0/x"}, {"(1/x)^0", "(1/x)^0"},
    {"x*x", "x^2"}, {"x/4", "1/4*x"}, {"2*(3*x)", "6*x"}, {"-(x-y)", "y - x"}, {"x+-y", "x - y"},
    {"3/(2*sqrt(17))", "3/2/sqrt(17)"}, {"sqrt(9/4)", "3/2"}, {"cos(0)", "1"}, {"log(1)", "0"},
    {"(x^2)^3", "x^6"}, {"(x^-2)^3", "x^-6"}, {"(x^-2)^-3", "(x^-2)^-3"}, {"(-x)^3", "-x^3"},
    {"(-x)*(-y)", "x*y"}, {"x/(-y)", "-x/y"}, {"2-3*4^2", "-46"}, {"0^0", "1"}};
  for (const auto& c : cases)
    EXPECT_EQ(to_string(parsed(c[0]), xyz), c[1]);

  const Expression x = Expression::variable(0);
  EXPECT_EQ(to_string(x - x), "0");
  EXPECT_EQ(to_string(x * x * pow(x, 3)), "x0^5");
  EXPECT_EQ(to_string(x / x), "x0/x0");
  EXPECT_THROW(value<Q>(parsed("0*(1/x)"), {0}), Division_by_zero_error);
  EXPECT_THROW(value<Q>(parsed("(1/x)^0"), {0}), Division_by_zero_error);
  EXPECT_THROW(value<Q>(parsed("(x^-2)^-3"), {0}), Division_by_zero_error);
  EXPECT_THROW(x / 0, Division_by_zero_error);
  EXPECT_THROW(pow(Expression(0), -2), Division_by_zero_error);
}

TEST(Expression, bounds_constants)
{
  Expression c = 3;
  EXPECT_THROW(
    {
      for (int i = 0; i < 64; ++i)
        c = c * c;
    },
    Limit_error);
  EXPECT_THROW(pow(Expression(3), 2000000000), Limit_error);
  EXPECT_EQ(pow(Expression(-1), 2000000001).constant(), Q(-1));
}

// --- Tapes ---------------------------------------------------------------------------------------

TEST(Expression_tape, shares_subexpressions)
{
  // y+x is x+y; its square is computed once; the tape is s = x+y, s*s, and two uses of the square.
  const Expression_tape tape({parsed("(x+y)*(y+x)*z"), parsed("(y+x)^2/z")}, 3,
                             Expression_tape::Derivatives::NONE);
  EXPECT_EQ(tape.number_of_operations(), 4u);
  EXPECT_FALSE(tape.has_gradient());

  // A recorded y = y + y*y grows by one operation a step, though the text would double.
  Expression y = Expression::variable(0);
  for (int i = 0; i < 10; ++i)
    y = y + y * y;
  const Expression_tape doubling({y}, 1, Expression_tape::Derivatives::NONE);
  EXPECT_LE(doubling.number_of_operations(), 20u);
}

TEST(Expression_tape, has_hand_computed_gradients)
{
  const Expression_tape tape({parsed("x^2*y - z"), parsed("y"), parsed("3"), parsed("x/y + 5*z"),
                              parsed("0*x + y - y*1 + 2*z")}, 3);
  const Sparse_pattern& pattern = tape.gradient_pattern();
  EXPECT_EQ(pattern.row_starts, (std::vector<std::size_t>{0, 3, 4, 4, 7, 8}));
  EXPECT_EQ(pattern.columns, (std::vector<int>{0, 1, 2, 1, 0, 1, 2, 2}));
  EXPECT_EQ(pattern.number_of_rows(), 5u);
  const std::vector<Q> g = tape.gradient<Q>({3, 2, 7});
  const std::vector<Q> expected{12, 9, -1, 1, fraction(1, 2), fraction(-3, 4), 5, 2};
  EXPECT_EQ(g, expected);

  EXPECT_EQ(tape.constant_gradient_entry(2), std::optional<Q>(-1));
  EXPECT_EQ(tape.constant_gradient_entry(3), std::optional<Q>(1));
  EXPECT_EQ(tape.constant_gradient_entry(6), std::optional<Q>(5));
  EXPECT_EQ(tape.constant_gradient_entry(7), std::optional<Q>(2));
  EXPECT_FALSE(tape.constant_gradient_entry(0).has_value());
  EXPECT_FALSE(tape.constant_gradient_entry(4).has_value());

  std::vector<Q> values(5), entries(8), workspace;
  tape.evaluate_with_gradient<Q>(std::vector<Q>{3, 2, 7}.data(), values.data(), entries.data(),
                                 workspace);
  EXPECT_EQ(values, (std::vector<Q>{11, 2, 3, fraction(73, 2), 14}));
  EXPECT_EQ(entries, expected);
}

TEST(Expression_tape, differentiates_every_function)
{
  const Strings texts{"sqrt(x)", "exp(x)", "log(x)", "sin(x)", "cos(x)", "tan(x)", "asin(x)",
                      "acos(x)", "atan(x)", "x^5", "x^-3", "2/x", "x/(1+x)", "pi*x^2",
                      "exp(-x^2)*sin(3*x)", "sqrt(17)*x + sqrt(pi)"};
  Protector protector;
  using Jet_1 = Jet<Interval, 1, 1>;
  for (const std::string& text : texts)
  {
    const Expression_tape tape({parse_expression(text, {"x"})}, 1);
    const Interval at(0.375, 0.375 + 1e-9);
    const Interval slope = tape.gradient<Interval>({at})[0];
    const Jet_1 jet = tape.evaluate<Jet_1>({Jet_1::variable(0, at)})[0];
    EXPECT_TRUE(overlap(slope, jet.derivative(0))) << text;
    EXPECT_LT(slope.sup() - slope.inf(), 1e-5) << text;
    EXPECT_TRUE(overlap(tape.evaluate<Interval>({at})[0], jet.value())) << text;
  }
}

TEST(Expression_tape, has_values_of_functions_in_double)
{
  EXPECT_DOUBLE_EQ(value<double>(parsed("sin(x)+cos(y)+tan(z)"), {1, 2, 3}),
                   std::sin(1.) + std::cos(2.) + std::tan(3.));
  EXPECT_DOUBLE_EQ(value<double>(parsed("exp(x)*log(y)+atan(z)*pi"), {1, 2, 3}),
                   std::exp(1.) * std::log(2.) + std::atan(3.) * std::acos(-1.));
  EXPECT_DOUBLE_EQ(value<double>(parsed("asin(x)-acos(x)*sqrt(y)"), {0.5, 2, 0}),
                   std::asin(.5) - std::acos(.5) * std::sqrt(2.));
}

TEST(Expression_tape, encloses_powers_tightly)
{
  Protector protector;
  const Interval x(-1, 2);
  const auto expect = [&](const char* text, double lo, double hi) {
    const Interval r = value<Interval>(parse_expression(text, {"x"}), {x});
    EXPECT_EQ(r.inf(), lo) << text;
    EXPECT_EQ(r.sup(), hi) << text;
  };
  expect("x*x", 0, 4);
  expect("x^3", -1, 8);
  expect("x^4", 0, 16);
  expect("x^5", -1, 32);
  expect("x^6", 0, 64);
  const Interval r = value<Interval>(parse_expression("1/x", {"x"}), {x});
  EXPECT_LE(r.inf(), -1);
  EXPECT_GE(r.sup(), 1e300);
}

TEST(Expression_tape, refuses_with_a_typed_sentence)
{
  Expression_tape tape({parsed("1 + z/(x - y)")}, 3);
  const auto sentence = [&] {
    try
    {
      tape.evaluate<double>({2, 2, 1});
    }
    catch (const Division_by_zero_error& error)
    {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(sentence(), "division by an expression that is zero at this point: x0 - x1");
  tape.set_variable_names(xyz);
  EXPECT_EQ(sentence(), "division by an expression that is zero at this point: x - y");
  EXPECT_THROW(tape.evaluate<Q>({2, 2, 1}), Division_by_zero_error);
  {
    Protector protector;
    EXPECT_THROW(tape.evaluate<Interval>({2, 2, 1}), Division_by_zero_error);
    EXPECT_NO_THROW(tape.evaluate<Interval>({Interval(1, 3), 2, 1}));
  }
  EXPECT_THROW(value<Q>(parsed("x^-2"), {0}), Division_by_zero_error);
  EXPECT_THROW(value<Q>(parsed("exp(x)"), {1}), Not_algebraic_error);
  EXPECT_THROW(value<Q>(parsed("sqrt(x)"), {2}), Not_algebraic_error);
  EXPECT_EQ(value<Q>(parsed("sqrt(x)"), {fraction(4, 9)}), fraction(2, 3));
  EXPECT_THROW(value<double>(parsed("log(x)"), {-1}), Domain_error);
  EXPECT_THROW(Expression_tape({parsed("sqrt(x)")}, 1).gradient<double>({0}),
               Division_by_zero_error);
  EXPECT_THROW(Expression_tape({parsed("x + z")}, 2), Shape_error);
}

TEST(Expression_tape, evaluates_in_quadratic_fields_and_exact_reals)
{
  const Expression root = parse_number("3/(2*sqrt(17)) - (1+sqrt(17))^2/34");
  const CORE::Expr exact = value<CORE::Expr>(root, {});
  EXPECT_EQ(CGAL::sign(CORE::Expr(exact * 34 + 18 - CGAL::sqrt(CORE::Expr(17)))), CGAL::ZERO);

  const Quadratic_field r(Q(0), Q(1), Q(17));
  const Expression_tape tape({parse_expression("3/(2*r) - (1+r)^2/34", {"r"})}, 1);
  EXPECT_EQ(tape.evaluate<Quadratic_field>({r})[0],
            Quadratic_field(fraction(-9, 17), fraction(1, 34), Q(17)));
  EXPECT_EQ(value<Quadratic_field>(root, {}), tape.evaluate<Quadratic_field>({r})[0]);
  EXPECT_THROW(value<Quadratic_field>(parse_number("sqrt(2)+sqrt(3)"), {}), Mixed_roots_error);
  EXPECT_EQ(tape.gradient<Quadratic_field>({r})[0],
            Quadratic_field(fraction(-5, 34), fraction(-1, 17), Q(17)));
}

TEST(Expression_tape, takes_rings_where_constants_are_dyadic)
{
  using Ring = internal::Exact_ring;
  const Expression_tape dyadic({parsed("x*y/4 - 0.5*z^3")}, 3), third({parsed("x/3")}, 3);
  EXPECT_TRUE(dyadic.has_double_constants());
  EXPECT_FALSE(third.has_double_constants());
  const Ring r = dyadic.evaluate<Ring>({Ring(3), Ring(5), Ring(1)})[0];
  EXPECT_EQ(CGAL::to_double(r.mpzf()), 3.25);
  EXPECT_THROW(third.evaluate<Ring>({Ring(3), Ring(5), Ring(1)}), Conversion_error);
}

// A ring that has no operator/ at all.
struct Integer_ring
{
  int n = 0;
  Integer_ring() = default;
  Integer_ring(int i) : n(i) {}
  friend Integer_ring operator-(Integer_ring a) { return -a.n; }
  friend Integer_ring operator+(Integer_ring a, Integer_ring b) { return a.n + b.n; }
  friend Integer_ring operator-(Integer_ring a, Integer_ring b) { return a.n - b.n; }
  friend Integer_ring operator*(Integer_ring a, Integer_ring b) { return a.n * b.n; }
};

} // namespace

namespace CGAL {
namespace Shape_interrogation {
template <>
struct Number_type_traits<Integer_ring>
{
  using Boolean = bool;
  static Boolean is_zero(Integer_ring x) { return x.n == 0; }
};
template <class From>
struct Number_cast<Integer_ring, From>
{
  static Integer_ring cast(const From& x) { return static_cast<int>(CGAL::to_double(x)); }
};
template <>
struct Elementary_functions<Integer_ring> : internal::No_ring_functions<Integer_ring>
{};
} // namespace Shape_interrogation
} // namespace CGAL

namespace {

TEST(Expression_tape, takes_rings_without_division)
{
  EXPECT_EQ((value<Integer_ring>(parsed("(x-y)^3*z + 7"), {4, 2, 5}).n), 47);
  EXPECT_THROW((value<Integer_ring>(parsed("x/y"), {4, 2, 0})), Not_algebraic_error);
}

TEST(Expression_tape, has_second_order_jets_along_directions)
{
  // f = x^2 y + z/x at (1,2,3) along a = (1,0,2), b = (0,1,-1); H by hand.
  const Expression_tape tape({parsed("x^2*y + z/x")}, 3);
  using Jet_2 = Jet<Q, 2, 2>;
  const std::vector<Q> p{1, 2, 3}, a{1, 0, 2}, b{0, 1, -1};
  std::vector<Jet_2> moving;
  for (int i = 0; i < 3; ++i)
    moving.push_back(Jet_2::along(p[i], {a[i], b[i]}));
  const Jet_2 f = tape.evaluate(moving)[0];
  // H = (2y + 2z/x^3, 2x, -1/x^2; 2x, 0, 0; -1/x^2, 0, 0) = (10, 2, -1; 2, 0, 0; -1, 0, 0)
  EXPECT_EQ(f.value(), Q(5));
  EXPECT_EQ(f.derivative(0), Q(3));    // gradient (1, 1, 1) . a
  EXPECT_EQ(f.derivative(1), Q(0));
  EXPECT_EQ(f.derivative(0, 0), Q(6)); // 10 - 2*2
  EXPECT_EQ(f.derivative(0, 1), Q(3)); // 2 + 1
  EXPECT_EQ(f.derivative(1, 1), Q(0));
}

TEST(Expression_tape, substitutes_expressions)
{
  const Expression_tape tape({parsed("x^2 + y")}, 2);
  const std::vector<Expression> r = tape.evaluate<Expression>({parsed("y+1"), parsed("3*z")});
  EXPECT_EQ(value<Q>(r[0], {100, 4, 5}), Q(40));
}

TEST(Expression_tape, reuses_its_workspace_and_is_shared_by_threads)
{
  const Expression_tape tape({record_expression<3>(Quadric()), parsed("sin(x*y)")}, 3);
  const std::vector<double> x{0.25, 2, 3};
  const std::vector<double> expected = tape.evaluate(x);
  std::vector<int> failures(4, 0);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      std::vector<double> values(2), gradient(tape.gradient_pattern().number_of_entries());
      std::vector<double> workspace;
      tape.evaluate_with_gradient(x.data(), values.data(), gradient.data(), workspace);
      const double* memory = workspace.data();
      for (int i = 0; i < 1000; ++i)
      {
        tape.evaluate(x.data(), values.data(), workspace);
        tape.evaluate_with_gradient<double>(x.data(), nullptr, gradient.data(), workspace);
        failures[t] += values != expected || workspace.data() != memory;
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(failures, std::vector<int>(4, 0));
}

TEST(Expression_tape, treats_chains_in_linear_cost)
{
  const auto operations = [](int n) {
    std::vector<Expression> chain;
    for (int i = 0; i + 1 < n; ++i)
    {
      const Expression a = Expression::variable(i), b = Expression::variable(i + 1);
      chain.push_back(a * a + 3 * a * b - b + i);
    }
    const Expression_tape tape(chain, n);
    EXPECT_EQ(tape.gradient_pattern().number_of_entries(), 2u * (n - 1));
    return tape.number_of_all_operations();
  };
  EXPECT_LE(operations(10000), 10 * operations(1000) + 100);
  EXPECT_LE(operations(1000), 10000u);
}

TEST(Expression_tape, takes_a_million_operations)
{
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  Expression sum = x;
  for (int i = 0; i < 100000; ++i)
    sum = sum * y + x;
  Expression linear = x;
  for (int i = 0; i < 1000000; ++i)
    linear = linear + (i % 2 ? x : y);
  const Expression_tape tape({linear, sum}, 2, Expression_tape::Derivatives::NONE);
  EXPECT_EQ(tape.evaluate<double>({1, 0.5}), (std::vector<double>{750001, 2}));
  EXPECT_EQ(to_string(linear, {}, 10).size(), 13u);

  Expression short_sum = x;
  for (int i = 0; i < 100000; ++i)
    short_sum = short_sum + (i % 2 ? x : y) * x;
  EXPECT_EQ(Expression_tape({short_sum}, 2).gradient<double>({1, 3}),
            (std::vector<double>{250001, 50000}));
}

TEST(Expression_tape, checks_limits)
{
  Expression_limits limits;
  limits.nodes = 5;
  EXPECT_THROW(Expression_tape({parsed("x+y*z+x^2+y^2+z^2")}, 3,
                               Expression_tape::Derivatives::NONE, limits), Limit_error);
  limits = Expression_limits();
  limits.degree = 10;
  EXPECT_THROW(Expression_tape({parsed("x^11")}, 3, Expression_tape::Derivatives::NONE, limits),
               Limit_error);
  Expression power = Expression::variable(0);
  for (int i = 0; i < 40; ++i)
    power = power * power + 1;
  EXPECT_THROW(Expression_tape({power}, 1), Limit_error);
}

// --- Text ----------------------------------------------------------------------------------------

TEST(parse_expression, reads_constants_exactly)
{
  const std::vector<std::pair<std::string, Q>> cases{
    {"12", 12}, {"0.1", fraction(1, 10)}, {"007", 7}, {"1e-3", fraction(1, 1000)},
    {"1.5E+3", 1500}, {".5", fraction(1, 2)}, {"5.", 5}, {"-2^2", -4}, {"(-2)^2", 4},
    {"2^3^2", 512}, {"2^-1", fraction(1, 2)}, {"2^(1+1)", 4}, {"2^-2^2", fraction(1, 16)},
    {"2^--2", 4}, {"1-2-3", -4}, {"12/2/3", 2}, {"2*-3", -6}, {"- - 3", 3}, {"+3", 3},
    {"1/3 + 1/6", fraction(1, 2)}, {" 1\n+\t2 ", 3}, {"((((7))))", 7},
    {"sqrt(16)/3", fraction(4, 3)},
    {"123456789012345678901234567890", Q("123456789012345678901234567890")}};
  for (const auto& c : cases)
  {
    EXPECT_EQ(parse_number(c.first).constant(), c.second) << c.first;
    EXPECT_EQ(parsed(c.first).constant(), c.second) << c.first;
  }
}

TEST(parse_expression, reads_functions_of_variables)
{
  const std::vector<Q> at{2, 3, 5};
  const std::vector<std::pair<std::string, Q>> cases{
    {"x", 2}, {"-x^2", -4}, {"x^-1", fraction(1, 2)}, {"x^(2)", 4}, {"2*x*y-z/x", fraction(19, 2)},
    {"x-y-z", -6}, {"z/x/y", fraction(5, 6)}, {"-x*-y", 6}, {"(x+y)*(x-y)", -5},
    {"sqrt(x+x)", 2}, {"z*x^2^2", 80}, {"x--y", 5}};
  for (const auto& c : cases)
    EXPECT_EQ(value<Q>(parsed(c.first), at), c.second) << c.first;
  EXPECT_EQ(value<Q>(parse_expression("x_1*_a + xx", {"x_1", "_a", "xx"}), at), Q(11));
}

struct Bad_text
{
  std::string text;
  std::size_t offset, line, column;
  std::string message; // a part of it
};

TEST(parse_expression, points_at_errors)
{
  const std::vector<Bad_text> cases{
    {"x^2 + * y", 6, 1, 7, "expected a number, a name or '('"},
    {"x^2 +", 5, 1, 6, "the text ends here"},
    {"", 0, 1, 1, "the text is empty"},
    {" \n ", 0, 1, 1, "the text is empty"},
    {"x +\n  y + $", 10, 2, 7, "expected a number"},
    {"(x + y", 6, 1, 7, "')' for the '(' of line 1, column 1"},
    {"(x +\n(y + 1) z", 13, 2, 9, "')' for the '(' of line 1, column 1"},
    {"x)", 1, 1, 2, "this ')' closes nothing"},
    {"2x", 1, 1, 2, "expected an operator"},
    {"x y", 2, 1, 3, "expected an operator"},
    {"1 + w*2", 4, 1, 5, "unknown name 'w'; the variables are x y z"},
    {"sin x", 0, 1, 1, "'sin' needs an argument in parentheses"},
    {"1 + y(3)", 4, 1, 5, "'y' is not a function; the functions are sqrt exp"},
    {"foo(3)", 0, 1, 1, "'foo' is not a function"},
    {"x/(2-2)", 1, 1, 2, "division by zero"},
    {"0^-1", 1, 1, 2, "division by zero"},
    {"x^y", 1, 1, 2, "exponent must be an integer"},
    {"x^0.5", 1, 1, 2, "exponent must be an integer"},
    {"x^", 2, 1, 3, "expected an integer exponent"},
    {"x^*2", 2, 1, 3, "expected an integer exponent"},
    {"sqrt(1-3)", 0, 1, 1, "square root of a negative"},
    {"x + log(0)", 4, 1, 5, "logarithm"},
    {"asin(2)", 0, 1, 1, "outside [-1, 1]"},
    {"\xC3\xA9 + x", 0, 1, 1, "expected a number"},
    {"x + \xC3\xA9", 4, 1, 5, "expected a number"},
    {"1..2", 2, 1, 3, "expected an operator"},
    {"x = 0", 2, 1, 3, "expected an operator"},
    {std::string("x\0y", 3), 1, 1, 2, "expected an operator"}};
  for (const Bad_text& c : cases)
  {
    try
    {
      parsed(c.text);
      ADD_FAILURE() << "no error for " << c.text;
    }
    catch (const Parse_error& error)
    {
      EXPECT_EQ(error.offset(), c.offset) << c.text;
      EXPECT_EQ(error.line(), c.line) << c.text;
      EXPECT_EQ(error.column(), c.column) << c.text;
      EXPECT_NE(error.message().find(c.message), std::string::npos) << error.message();
    }
  }
  EXPECT_THROW(parse_number("1 + pi"), Parse_error);
  EXPECT_THROW(parse_number("sin(0)"), Parse_error);
  EXPECT_THROW(parse_number("x"), Parse_error);
}

std::string picture_of(const std::string& text)
{
  try
  {
    parsed(text);
  }
  catch (const Parse_error& error)
  {
    return error.what();
  }
  return "no error";
}

TEST(parse_expression, draws_a_caret)
{
  EXPECT_EQ(picture_of("x^2 + * y"), "x^2 + * y\n"
                                     "      ^ expected a number, a name or '(' (line 1, column 7)");
  EXPECT_EQ(picture_of("x +\n\ty )\n+ 1"), " y )\n"
                                           "   ^ this ')' closes nothing (line 2, column 4)");
  const std::string long_line = std::string(500, ' ') + "? + " + std::string(500, ' ');
  EXPECT_LT(picture_of(long_line).size(), 250u);
}

TEST(parse_expression, checks_the_names_of_variables)
{
  for (const Strings& names : {Strings{"sin"}, Strings{"pi"}, Strings{"x", "y", "x"}, Strings{""},
                               Strings{"2x"}, Strings{"a b"}, Strings{"\xC3\xA9"}})
    EXPECT_THROW(parse_expression("1", names), Shape_error);
}

TEST(parse_expression, checks_limits)
{
  const auto nested = [](std::size_t n) { return std::string(n, '(') + "x" + std::string(n, ')'); };
  EXPECT_NO_THROW(parsed(nested(256)));
  EXPECT_THROW(parsed(nested(257)), Parse_error);
  EXPECT_THROW(parsed(nested(500000)), Parse_error);
  EXPECT_THROW(parsed(std::string(2 << 20, ' ') + "x"), Parse_error);
  EXPECT_NO_THROW(parsed(std::string(100000, '-') + "x"));
  EXPECT_NO_THROW(parsed(std::string(4096, '7')));
  EXPECT_THROW(parsed("1" + std::string(5000, '0')), Parse_error);
  EXPECT_THROW(parsed("1e999999999"), Parse_error);
  EXPECT_THROW(parsed("1e99999999999999999999999999"), Parse_error);
  EXPECT_THROW(parsed("1e-4097"), Parse_error);
  EXPECT_NO_THROW(parsed("1e-4096"));
  EXPECT_THROW(parsed("x^4097"), Parse_error);
  EXPECT_THROW(parsed("x^-4097"), Parse_error);
  EXPECT_THROW(parsed("x^99999999999999999999999"), Parse_error);
  EXPECT_THROW(parsed("99999^4000"), Parse_error);
  EXPECT_THROW(parsed("((3^4000)^4000)^4000"), Parse_error);
  EXPECT_THROW(parsed("((x^4096)^4096)^4096"), Parse_error);
  std::string tower = "2";
  for (int i = 0; i < 10000; ++i)
    tower += "^2";
  EXPECT_THROW(parsed(tower), Parse_error);
  std::string sum = "x";
  for (int i = 0; i < 20000; ++i)
    sum += "+" + std::to_string(i) + "*y^2";
  EXPECT_EQ(value<Q>(parsed(sum), {1, 1, 0}), Q(199990001));
}

// Texts made of random pieces are refused by a Parse_error or can be printed and read again.
TEST(parse_expression, survives_random_texts)
{
  const Strings pieces{"x", "y", "z", "w", "1", "0", "2.5", "1e3", ".", "e", "+", "-", "*", "/",
                       "^", "^2", "^-1", "(", ")", "(", ")", "sqrt(", "sin", "log(", "pi", " ",
                       "\n", "\t", "\xC3", "#", ",", "1e", std::string(1, '\0')};
  const unsigned seed = 20260101;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  int good = 0, refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    std::string text;
    for (unsigned n = random() % 12; n > 0; --n)
      text += pieces[random() % pieces.size()];
    try
    {
      const std::string printed = to_string(parsed(text), xyz);
      EXPECT_EQ(to_string(parsed(printed), xyz), printed) << text;
      ++good;
    }
    catch (const Parse_error& error)
    {
      EXPECT_LE(error.offset(), text.size()) << text;
      ++refused;
    }
  }
  EXPECT_GT(good, 500);
  EXPECT_GT(refused, 500);
}

struct Comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(parse_expression, is_independent_of_the_locale)
{
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const Expression e = parsed("1234567.5*x");
  const std::string text = to_string(e, xyz);
  std::locale::global(before);
  EXPECT_EQ(value<Q>(e, {2, 0, 0}), Q(2469135));
  EXPECT_EQ(text, "2469135/2*x");
}

TEST(parse_decimal, reads_numerals_only)
{
  EXPECT_EQ(parse_decimal("-0.25e1"), std::optional<Q>(fraction(-5, 2)));
  EXPECT_EQ(parse_decimal("010"), std::optional<Q>(10));
  EXPECT_EQ(parse_decimal("+3"), std::optional<Q>(3));
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1 ", " 1", "1/2", "0x10", "inf", "nan",
                           "--1", "1,5", "1e5.0"})
    EXPECT_FALSE(parse_decimal(text).has_value()) << text;
  EXPECT_THROW(parse_decimal("1e5000"), Limit_error);
}

// --- Random functions ----------------------------------------------------------------------------

// The same random program in every number type; divisors are 1 + a square.
struct Random_function
{
  unsigned seed;
  int steps;

  template <class NT>
  NT operator()(NT x, NT y, NT z) const
  {
    std::mt19937 random(seed);
    std::vector<NT> values{x, y, z, NT(1), NT(0)};
    const auto pick = [&]() -> NT { return values[random() % values.size()]; };
    for (int i = 0; i < steps; ++i)
    {
      const unsigned operation = random() % 8;
      const NT a = pick(), b = pick();
      const int n = static_cast<int>(random() % 7) - 3;
      NT r = a;
      switch (operation)
      {
      case 0: r = a + b; break;
      case 1: r = a - b; break;
      case 2: r = a * b; break;
      case 3: r = a / (b * b + NT(1)); break;
      case 4: r = -a; break;
      case 5: r = NT(n) * a; break;
      case 6: r = NT(n) / NT(4) - b; break;
      default: r = a * a + NT(n) / NT(3); break;
      }
      values.push_back(r);
    }
    NT sum = values[5];
    for (std::size_t i = 6; i < values.size(); ++i)
      sum = sum + values[i];
    return sum;
  }
};

class Random_expressions : public testing::TestWithParam<unsigned>
{};

TEST_P(Random_expressions, agree_with_direct_evaluation)
{
  for (unsigned k = 0; k < 25; ++k)
  {
    const Random_function f{1000 * GetParam() + k, 9};
    SCOPED_TRACE("seed " + std::to_string(f.seed));
    const Expression e = record_expression<3>(f);
    const std::vector<Q> at{fraction(2, 3), fraction(-1, 2), fraction(5, 7)};
    const Expression_tape tape({e}, 3);
    const Q exact = f(at[0], at[1], at[2]);
    EXPECT_EQ(tape.evaluate(at)[0], exact);

    using Jet_3 = Jet<Q, 3, 1>;
    const Jet_3 jet =
      f(Jet_3::variable(0, at[0]), Jet_3::variable(1, at[1]), Jet_3::variable(2, at[2]));
    const std::vector<Q> gradient = full_gradient(tape, at);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(gradient[i], jet.derivative(i));

    const std::string text = to_string(e, xyz);
    const Expression again = parsed(text);
    EXPECT_EQ(value<Q>(again, at), exact) << text;
    EXPECT_EQ(to_string(parsed(to_string(again, xyz)), xyz), to_string(again, xyz));

    std::vector<Interval> boxes;
    for (const Q& x : at)
      boxes.push_back(number_cast<Interval>(x));
    Protector protector;
    const Interval enclosure = tape.evaluate(boxes)[0];
    const std::vector<Interval> slopes = full_gradient(tape, boxes);
    CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    EXPECT_TRUE(Q(enclosure.inf()) <= exact && exact <= Q(enclosure.sup()));
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(Q(slopes[i].inf()) <= gradient[i] && gradient[i] <= Q(slopes[i].sup()));
  }
}

INSTANTIATE_TEST_SUITE_P(seeds, Random_expressions, testing::Range(1u, 9u));

} // namespace
