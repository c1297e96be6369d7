// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The cost of all second-order data of a surface in n-space, and of certified decisions: the ruled
// surface of Chuang and Hoffmann in 16 variables, and chains of n variables for the growth with n.

#include "Ratio_reporter.h"

#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_batch.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <CGAL/Exact_rational.h>

#include <string>
#include <vector>

namespace si = CGAL::Shape_interrogation;
using Rational = CGAL::Exact_rational;

namespace {

const std::vector<std::string> variables = {"x",  "y",  "z",  "u0", "v0", "w0", "u1", "v1",
                                            "w1", "u2", "v2", "w2", "r",  "s",  "t",  "l"};

si::N_space_system make_system(const std::vector<std::string>& names,
                               const std::vector<std::string>& equations)
{
  std::vector<si::Expression> left_hand_sides;
  for (const std::string& text : equations)
    left_hand_sides.push_back(si::parse_expression(text, names));
  return si::N_space_system(names, left_hand_sides);
}

// The directrix comes first; the rest is common.
si::N_space_system ruled_surface(const std::vector<std::string>& directrix)
{
  std::vector<std::string> equations = directrix;
  for (const char* text :
       {"(u1+1)^2+v1^2-1", "u2-3*(1-s^2)/(1+s^2)", "v2-t", "w2-6*s/(1+s^2)", "x-(l*u1+(1-l)*u2)",
        "y-(l*v1+(1-l)*v2)", "z-(l*w1+(1-l)*w2)", "2*(w0-w1)*(u1+1)",
        "-2*(u0-u1)*v1+2*(v0-v1)*(u1+1)", "2*(w0-w1)*v1",
        "-12*s*(u0-u2)+6*(1-s^2)*(w0-w2)", "v0-v2"})
    equations.push_back(text);
  return make_system(variables, equations);
}

template <class NT>
std::vector<NT> numbers(const std::vector<const char*>& texts)
{
  std::vector<NT> p;
  for (const char* text : texts)
    p.push_back(si::Expression_tape({si::parse_number(text)}, 0,
                                    si::Expression_tape::Derivatives::NONE)
                  .evaluate(std::vector<NT>())[0]);
  return p;
}

const std::vector<const char*> rational_point = {
  "197/85", "28/5", "285/136", "2", "4", "15/4", "-2/5", "4/5",
  "15/4",   "24/17", "4",      "45/17", "0", "3/5", "4", "-1/2"};
const std::vector<const char*> appendix_point = {
  "3/34*sqrt(17)", "0", "2+6/17*sqrt(17)", "1", "0", "4", "0", "0", "4",
  "3/17*sqrt(17)", "0", "12/17*sqrt(17)", "0", "-1/4+1/4*sqrt(17)", "0", "1/2"};

template <class NT>
void evaluate(benchmark::State& state, si::N_space_system system, const std::vector<NT>& point)
{
  if (!system.prepare(point))
    state.SkipWithError("the point is not regular");
  si::N_space_evaluator<NT> evaluator(system);
  for (auto _ : state)
    benchmark::DoNotOptimize(evaluator(point));
}

// Many points at once: the time is that of one point.
void evaluate_batch(benchmark::State& state, si::N_space_system system,
                    const std::vector<double>& point)
{
  constexpr int points = 256;
  if (!system.prepare(point))
    state.SkipWithError("the point is not regular");
  std::vector<std::vector<double>> coordinates;
  for (double x : point)
    coordinates.emplace_back(points, x);
  si::N_space_batch evaluate_all(system);
  si::N_space_batch_result result;
  while (state.KeepRunningBatch(points))
  {
    evaluate_all(coordinates, result);
    benchmark::DoNotOptimize(result.shapes.data());
  }
  if (!result.refusals.empty())
    state.SkipWithError("a point was refused");
}

// The certified sign of K at a point that is exactly on the solution.
template <class NT>
void decide(benchmark::State& state, si::N_space_system system, const std::vector<NT>& point)
{
  if (!system.prepare(si::cast_argument<double>(point)))
    state.SkipWithError("the point is not regular");
  const si::N_space_surface_3 surface(system);
  si::Filter_statistics statistics;
  const si::Filtered<si::Shape_chain<si::Sign_of_gaussian_curvature>> sign({}, &statistics);
  if (!sign(surface, point))
    state.SkipWithError("the point was refused");
  for (auto _ : state)
    benchmark::DoNotOptimize(sign(surface, point));
  if (statistics.fallbacks() != 0)
    state.SkipWithError("the enclosure did not decide");
}

si::N_space_system rational_system()
{
  return ruled_surface({"u0-(2-r)", "v0-(4+3*r)", "w0-(15/4+r^2)"});
}

void sixteen_variables_double(benchmark::State& state)
{
  evaluate(state, rational_system(), numbers<double>(rational_point));
}
BENCHMARK(sixteen_variables_double);

void sixteen_variables_batch(benchmark::State& state)
{
  evaluate_batch(state, rational_system(), numbers<double>(rational_point));
}
BENCHMARK(sixteen_variables_batch);

void sixteen_variables_filtered(benchmark::State& state)
{
  decide(state, rational_system(), numbers<Rational>(rational_point));
}
BENCHMARK(sixteen_variables_filtered);

void sixteen_variables_exact(benchmark::State& state)
{
  evaluate(state, rational_system(), numbers<Rational>(rational_point));
}
BENCHMARK(sixteen_variables_exact);

void sixteen_variables_sqrt17(benchmark::State& state)
{
  evaluate(state,
           ruled_surface({"u0-(3*(1-r^2)/(2*(1+r^2))-1/2)", "v0-3*r/(1+r^2)", "w0-4"}),
           numbers<si::Quadratic_field>(appendix_point));
}
BENCHMARK(sixteen_variables_sqrt17);

// x3 = x (2 + y) / 4, x4 = x3 (2 + y) / 4, ..., z = x_{n-1}: a chain with two parameters.
si::N_space_system chain(int n)
{
  std::vector<std::string> names = {"x", "y", "z"};
  for (int i = 3; i < n; ++i)
    names.push_back("a" + std::to_string(i));
  std::vector<si::Expression> equations;
  const auto v = [](int i) { return si::Expression::variable(i); };
  for (int i = 3; i < n; ++i)
  {
    const si::Expression before = i == 3 ? v(0) : v(i - 1);
    equations.push_back(v(i) - before / 2 - v(1) * before / 4);
  }
  equations.push_back(v(2) - (n > 3 ? v(n - 1) : v(0) * v(1)));
  return si::N_space_system(names, equations);
}

// A point at which all numbers of the chain are equal: what grows with n is their number alone.
template <class NT>
std::vector<NT> point_of_chain(int n)
{
  std::vector<NT> p(n);
  for (NT& x : p)
    x = NT(3);
  p[1] = NT(2);
  if (n == 3)
    p[2] = NT(6);
  return p;
}

void chain_double(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  evaluate(state, chain(n), point_of_chain<double>(n));
}
BENCHMARK(chain_double)->Arg(3)->RangeMultiplier(4)->Range(4, 1024);

void chain_batch(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  evaluate_batch(state, chain(n), point_of_chain<double>(n));
}
BENCHMARK(chain_batch)->Arg(3)->RangeMultiplier(4)->Range(4, 1024);

// With coordinates in double, which are exactly on the solution.
void chain_filtered(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  decide(state, chain(n), point_of_chain<double>(n));
}
BENCHMARK(chain_filtered)->Arg(3)->RangeMultiplier(4)->Range(4, 1024);

void chain_exact(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  evaluate(state, chain(n), point_of_chain<Rational>(n));
}
BENCHMARK(chain_exact)->Arg(3)->RangeMultiplier(4)->Range(4, 1024);

// Compiling the equations and choosing the order of elimination, which is done once.
void chain_prepare(benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  const std::vector<double> p = point_of_chain<double>(n);
  for (auto _ : state)
  {
    si::N_space_system system = chain(n);
    benchmark::DoNotOptimize(system.prepare(p));
  }
}
BENCHMARK(chain_prepare)->RangeMultiplier(4)->Range(4, 1024);

} // namespace

int main(int argc, char** argv)
{
  return run_with_ratios(argc, argv,
                         {{"sixteen_variables_double", "", 3000},
                          {"sixteen_variables_batch", "", 1500},
                          {"sixteen_variables_batch", "sixteen_variables_double", 1},
                          {"sixteen_variables_filtered", "", 4000},
                          {"sixteen_variables_exact", "", 150000},
                          {"sixteen_variables_sqrt17", "", 10000000}});
}
