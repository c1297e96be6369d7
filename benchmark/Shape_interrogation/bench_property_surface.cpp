// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Exact property surfaces of a bicubic Bezier patch with control points of 53 bits, and theorems
// about it.

#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>

#include <CGAL/Exact_rational.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace si = CGAL::Shape_interrogation;
using Rational = CGAL::Exact_rational;

namespace {

// Nearly a grid, with all bits of the doubles.
si::Bezier_surface_3<Rational> bicubic()
{
  std::mt19937_64 engine(20260451);
  const auto number = [&](double low) {
    return Rational(low + static_cast<double>(engine() >> 11) / 9007199254740992.0);
  };
  std::vector<std::vector<si::Coordinates<Rational, 3>>> p(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      p[i].push_back({number(i), number(j), number(-0.5)});
  return si::Bezier_surface_3<Rational>(p);
}

// K and the square of H together: wanted in 2 ms.
void gaussian_and_mean_squared(benchmark::State& state)
{
  const auto patch = bicubic();
  for (auto _ : state)
  {
    si::Property_surface_maker<Rational> maker(patch);
    benchmark::DoNotOptimize(maker(si::Property::GAUSSIAN));
    benchmark::DoNotOptimize(maker(si::Property::MEAN_SQUARED));
  }
}
BENCHMARK(gaussian_and_mean_squared)->Unit(benchmark::kMillisecond);

void second_form_determinant(benchmark::State& state)
{
  const auto patch = bicubic();
  for (auto _ : state)
    benchmark::DoNotOptimize(si::property_surface(patch, si::Property::SECOND_FORM_DETERMINANT));
}
BENCHMARK(second_form_determinant)->Unit(benchmark::kMillisecond);

void bounds_of_gaussian(benchmark::State& state)
{
  const auto k = si::property_surface(bicubic(), si::Property::GAUSSIAN);
  for (auto _ : state)
    benchmark::DoNotOptimize(si::bounds(k));
}
BENCHMARK(bounds_of_gaussian)->Unit(benchmark::kMillisecond);

// Whether the patch is nowhere steeper than the supremum that was found, a theorem or a witness.
void decide_slope(benchmark::State& state)
{
  const auto slope = si::property_surface(bicubic(), si::Property::SLOPE);
  const Rational bound = si::bounds(slope).supremum.upper;
  for (auto _ : state)
    benchmark::DoNotOptimize(si::decide_at_most(slope, bound));
}
BENCHMARK(decide_slope)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
