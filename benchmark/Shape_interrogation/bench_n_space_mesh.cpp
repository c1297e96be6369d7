// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes of surfaces in n-space with all curvatures: Chuang and Hoffmann's ruled surface from its
// 15 equations in 16 variables, and an offset of an ellipsoid that has cuspidal edges.

#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_n_space_surface.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace si = CGAL::Shape_interrogation;

namespace {

void mesh(benchmark::State& state, const si::N_space_system& system,
          const std::vector<double>& start, const std::vector<si::N_space_bound>& bounds)
{
  si::N_space_mesh_options options;
  options.edge_length = 1. / static_cast<double>(state.range(0));
  options.bounds = bounds;
  std::size_t vertices = 0, steps = 0;
  const auto count = [&](std::size_t, std::size_t) {
    ++steps;
    return true;
  };
  for (auto _ : state)
  {
    const auto result = si::mesh_n_space_surface(system, {start}, options, count);
    if (!result)
    {
      state.SkipWithError(result.refusal().evidence().c_str());
      return;
    }
    vertices = result->report.vertices;
  }
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["vertices_per_second"] = benchmark::Counter(
    static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}

void ruled_surface(benchmark::State& state)
{
  const si::Curve_entity_3 circle([](auto r) {
    using T = decltype(r);
    return std::array<T, 4>{3 * (1 - r * r) - (1 + r * r), 6 * r, 8 * (1 + r * r), 2 * (1 + r * r)};
  });
  const si::Implicit_entity_3 f([](auto x, auto y, auto) { return (x + 1) * (x + 1) + y * y - 1; });
  const si::Parametric_entity_3 g([](auto s, auto t) {
    using T = decltype(s);
    return std::array<T, 4>{3 * (1 - s * s), t * (1 + s * s), 6 * s, 1 + s * s};
  });
  const double s = (std::sqrt(17.) - 1) / 4;
  const double x = 3 * (1 - s * s) / (1 + s * s), z = 6 * s / (1 + s * s);
  mesh(state, si::ruled_by_projection(circle, f, g).n_space_system(),
       {x / 2, 0, (4 + z) / 2, 1, 0, 4, 0, 0, 4, x, 0, z, 0, s, 0, 0.5},
       {{12, -1, 1}, {15, 0, 1}}); // r and lambda
}
BENCHMARK(ruled_surface)->Arg(10)->Arg(32)->Arg(65)->Unit(benchmark::kMillisecond);

void inner_offset(benchmark::State& state)
{
  const si::Implicit_entity_3 ellipsoid([](auto x, auto y, auto z) {
    return 4 * x * x + 9 * y * y + 36 * z * z - 36;
  });
  mesh(state, si::offset_system(ellipsoid, 1).n_space_system(), {2, 0, 0, 3, 0, 0}, {});
}
BENCHMARK(inner_offset)->Arg(10)->Arg(32)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
