// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_BENCHMARK_RATIO_REPORTER_H
#define SHAPE_INTERROGATION_BENCHMARK_RATIO_REPORTER_H

// Prints, after the usual table, ratios of benchmarks of the same run: what counts is the quotient,
// which the load of the machine changes less than the times. For benchmarks of several sizes n it
// prints the exponent p of the cost n^p that fits best.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

struct Ratio
{
  std::string numerator, denominator; // names of benchmarks; the denominator may be empty
  double target;                      // the largest ratio (or time in ns) wanted
};

class Ratio_reporter : public benchmark::ConsoleReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override
  {
    benchmark::ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
      {
        const double time = run.GetAdjustedCPUTime();
        auto [it, inserted] = m_times.emplace(run.run_name.function_name, time);
        if (!inserted)
          it->second = std::min(it->second, time);
        if (!run.run_name.args.empty())
          add_size(m_families[run.run_name.function_name], std::atoi(run.run_name.args.c_str()),
                   time);
      }
  }

  // The fastest of the repetitions counts.
  void print(const std::vector<Ratio>& ratios) const
  {
    std::printf("\n%-62s %10s %8s\n", "fastest of the repetitions", "measured", "target");
    for (const Ratio& r : ratios)
    {
      const auto a = m_times.find(r.numerator), b = m_times.find(r.denominator);
      if (a == m_times.end() || (!r.denominator.empty() && b == m_times.end()))
        continue;
      if (r.denominator.empty())
        std::printf("%-62s %7.0f ns %5.0f ns\n", r.numerator.c_str(), a->second, r.target);
      else
        std::printf("%-62s %10.2f %8.2f\n", (r.numerator + " / " + r.denominator).c_str(),
                    a->second / b->second, r.target);
    }
  }

  // Fits a line to the logarithms, by least squares, where fixed costs no longer count.
  void print_growth() const
  {
    for (const auto& [name, times] : m_families)
    {
      double count = 0, x = 0, y = 0, xx = 0, xy = 0;
      for (const auto& [n, time] : times)
        if (n >= smallest_size)
        {
          const double a = std::log(n), b = std::log(time);
          ++count, x += a, y += b, xx += a * a, xy += a * b;
        }
      if (count < 3)
        continue;
      const double exponent = (count * xy - x * y) / (count * xx - x * x);
      const int first = times.lower_bound(smallest_size)->first, last = times.rbegin()->first;
      std::printf("%-30s n^%.2f for n = %d ... %d, %.1f ns for each of %d\n", name.c_str(),
                  exponent, first, last, times.rbegin()->second / last, last);
    }
  }

private:
  static constexpr int smallest_size = 16;
  using Times_of_sizes = std::map<int, double>;

  static void add_size(Times_of_sizes& times, int n, double time)
  {
    const auto [it, inserted] = times.emplace(n, time);
    if (!inserted)
      it->second = std::min(it->second, time);
  }

  std::map<std::string, double> m_times;
  std::map<std::string, Times_of_sizes> m_families;
};

inline int run_with_ratios(int argc, char** argv, const std::vector<Ratio>& ratios)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  Ratio_reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print(ratios);
  reporter.print_growth();
  return 0;
}

#endif // SHAPE_INTERROGATION_BENCHMARK_RATIO_REPORTER_H
