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
// which the load of the machine changes less than the times.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
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

private:
  std::map<std::string, double> m_times;
};

inline int run_with_ratios(int argc, char** argv, const std::vector<Ratio>& ratios)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  Ratio_reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print(ratios);
  return 0;
}

#endif // SHAPE_INTERROGATION_BENCHMARK_RATIO_REPORTER_H
