// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The cost of a local shape, of curvatures and of a certified decision, beside hand-written double.

#include "Ratio_reporter.h"
#include "hand_written_kernels.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <vector>

namespace si = CGAL::Shape_interrogation;
using Rational = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<false>;

namespace {

struct Torus
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT s = x * x + y * y + z * z + NT(3);
    return s * s - NT(16) * (x * x + y * y);
  }
};

// x^4 + y^4 + z^4 - 3 has an umbilic at (1, 1, 1), and at (c, c, c) on every level set.
struct Quartic
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT xx = x * x, yy = y * y, zz = z * z;
    return xx * xx + yy * yy + zz * zz - NT(3);
  }
};

// Dyadic points that the compiler cannot foresee.
template <class NT>
std::vector<si::Coordinates<NT, 3>> points()
{
  std::vector<si::Coordinates<NT, 3>> p;
  for (int i = 0; i < 64; ++i)
    p.push_back({NT(1.5625 + i / 1024.), NT(2.078125 - i / 2048.), NT(0.796875 + i / 4096.)});
  return p;
}

template <class NT>
Hand_written all_curvatures(const si::Local_shape_3<NT>& s)
{
  const si::Curvatures<NT> k = si::curvatures(s);
  return {k.gaussian, k.mean, k.min, k.max, si::umbilic_discriminant(s)};
}

const double net[4][4][3] = {
  {{0, 0, 0}, {0, 1, .5}, {0, 2, .25}, {0, 3, 0}},
  {{1, 0, .5}, {1, 1, 1.5}, {1.25, 2, 1}, {1, 3, .25}},
  {{2, 0, .25}, {2, 1, 1.25}, {2, 2.25, 1.5}, {2, 3, .5}},
  {{3, 0, 0}, {3, 1, .25}, {3, 2, .5}, {3.25, 3, .125}}};

template <class NT>
si::Bezier_surface_3<NT> bicubic()
{
  std::vector<std::vector<si::Coordinates<NT, 3>>> p(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      p[i].push_back({NT(net[i][j][0]), NT(net[i][j][1]), NT(net[i][j][2])});
  return si::Bezier_surface_3<NT>(p);
}

void torus_hand_written(benchmark::State& state)
{
  const auto p = points<double>();
  std::size_t i = 0;
  for (auto _ : state)
  {
    const auto& x = p[i++ % 64];
    benchmark::DoNotOptimize(hand_written_torus(x[0], x[1], x[2]));
  }
}
BENCHMARK(torus_hand_written);

// Asks for something of the local shapes of the torus.
template <class NT, class Question>
void ask_torus(benchmark::State& state, Question question)
{
  const auto p = points<NT>();
  const si::Implicit_surface_3<Torus> surface;
  std::size_t i = 0;
  for (auto _ : state)
  {
    const auto s = surface.level_set_shape(p[i++ % 64]);
    if (s)
      benchmark::DoNotOptimize(question(*s));
  }
}

void torus_double(benchmark::State& state)
{
  ask_torus<double>(state, [](const auto& s) { return all_curvatures(s); });
}
BENCHMARK(torus_double);

void torus_interval(benchmark::State& state)
{
  const Interval::Protector protector;
  ask_torus<Interval>(state, si::Is_umbilic());
}
BENCHMARK(torus_interval);

void torus_exact(benchmark::State& state) { ask_torus<Rational>(state, si::Is_umbilic()); }
BENCHMARK(torus_exact);

// Asks a certified question at the points in double.
template <class Torus_question>
void ask_torus_filtered(benchmark::State& state, Torus_question question)
{
  const auto p = points<double>();
  const si::Interrogation_3 torus{si::Implicit_surface_3<Torus>()};
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(question(torus, p[i++ % 64]));
}

void torus_umbilic_filtered(benchmark::State& state)
{
  ask_torus_filtered(state, [](const auto& torus, const auto& p) { return torus.is_umbilic(p); });
}
BENCHMARK(torus_umbilic_filtered);

void torus_sign_of_gaussian_filtered(benchmark::State& state)
{
  ask_torus_filtered(
    state, [](const auto& torus, const auto& p) { return torus.sign_of_gaussian_curvature(p); });
}
BENCHMARK(torus_sign_of_gaussian_filtered);

// At c = 1 + i 2^-30 the interval leaves the umbilic undecided, and the exact ring decides.
void exact_umbilic_filtered(benchmark::State& state)
{
  const si::Interrogation_3 quartic{si::Implicit_surface_3<Quartic>()};
  double i = 0;
  for (auto _ : state)
  {
    const double c = 1 + (i += 1) / (1 << 30);
    benchmark::DoNotOptimize(quartic.is_umbilic(si::Coordinates<double, 3>{c, c, c}));
  }
}
BENCHMARK(exact_umbilic_filtered);

// The same at thirds, which are no doubles: interval, then rationals.
void exact_umbilic_filtered_rational(benchmark::State& state)
{
  const si::Filtered<si::Shape_chain<si::Is_umbilic>> filtered;
  const si::Implicit_surface_3<Quartic> surface;
  int i = 0;
  for (auto _ : state)
  {
    const Rational c = Rational(++i) / Rational(3);
    benchmark::DoNotOptimize(filtered(surface, si::Coordinates<Rational, 3>{c, c, c}));
  }
}
BENCHMARK(exact_umbilic_filtered_rational);

void bicubic_hand_written(benchmark::State& state)
{
  double u = 0.25;
  for (auto _ : state)
  {
    u = u < 0.75 ? u + 1. / 1024 : 0.25;
    benchmark::DoNotOptimize(hand_written_bicubic(net, u, 1 - u * u));
  }
}
BENCHMARK(bicubic_hand_written);

void bicubic_double(benchmark::State& state)
{
  const si::Bezier_surface_3<double> patch = bicubic<double>();
  double u = 0.25;
  for (auto _ : state)
  {
    u = u < 0.75 ? u + 1. / 1024 : 0.25;
    const auto s = patch(si::Coordinates<double, 2>{u, 1 - u * u});
    if (s)
      benchmark::DoNotOptimize(all_curvatures(*s));
  }
}
BENCHMARK(bicubic_double);

void bicubic_umbilic_filtered(benchmark::State& state)
{
  const si::Interrogation_3 patch{bicubic<double>()};
  double u = 0.25;
  for (auto _ : state)
  {
    u = u < 0.75 ? u + 1. / 1024 : 0.25;
    benchmark::DoNotOptimize(patch.is_umbilic(si::Coordinates<double, 2>{u, 1 - u * u}));
  }
}
BENCHMARK(bicubic_umbilic_filtered);

void bicubic_exact(benchmark::State& state)
{
  const si::Bezier_surface_3<Rational> patch = bicubic<Rational>();
  int i = 0;
  for (auto _ : state)
  {
    const Rational u = Rational(i++ % 512) / Rational(1024);
    const auto s = patch(si::Coordinates<Rational, 2>{u, Rational(1 - u)});
    if (s)
      benchmark::DoNotOptimize(si::is_umbilic(*s));
  }
}
BENCHMARK(bicubic_exact);

} // namespace

int main(int argc, char** argv)
{
  return run_with_ratios(argc, argv,
                         {{"torus_hand_written", "", 57},
                          {"torus_double", "torus_hand_written", 1.5},
                          {"torus_umbilic_filtered", "torus_double", 2.2},
                          {"torus_sign_of_gaussian_filtered", "torus_double", 2.2},
                          {"exact_umbilic_filtered", "", 10000},
                          {"exact_umbilic_filtered_rational", "", 100000},
                          {"bicubic_hand_written", "", 45},
                          {"bicubic_double", "bicubic_hand_written", 1.5},
                          {"bicubic_umbilic_filtered", "bicubic_double", 2.2}});
}
