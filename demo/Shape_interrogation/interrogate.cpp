// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The program interrogate: reads a model, runs its tasks, writes the report.
// Exit status: 0 all tasks ok, 1 some are not, 2 the model or the command cannot be used.

#include "Json.h"
#include "Model_error.h"
#include "Progress_bar.h"
#include "read_model.h"
#include "Report.h"
#include "run_tasks.h"

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace {

using namespace interrogate;

constexpr int unusable = 2;

struct Options
{
  std::string model;
  std::string out;
  std::string number_type;
  bool quiet = false;
};

// What a task found, or why it found nothing, on one line.
void print_line(const Task_result& result)
{
  std::string text = result.line;
  if (result.status != "ok")
    text = result.code + ": " + result.text;
  std::printf("[%s] %s: %s: %s\n", result.status.c_str(), printable(result.id).c_str(),
              result.task.c_str(), printable(text).c_str());
  std::fflush(stdout);
}

int run(const Options& options)
{
  const Model model = read_model_file(options.model);
  const std::filesystem::path file(options.model);
  const std::filesystem::path directory =
    options.out.empty() ? file.parent_path() / file.stem() : std::filesystem::path(options.out);
  if (std::filesystem::exists(directory) && !std::filesystem::is_directory(directory) &&
      options.out.empty())
    throw Model_error(printable(options.model),
                      "the name has no extension to leave out for a directory: give --out");
  make_directory(directory);
  std::optional<Number_type> preferred;
  if (!options.number_type.empty())
    preferred = number_type_of(options.number_type);
  Progress_bar progress(!options.quiet && isatty(STDERR_FILENO));
  std::vector<Task_result> results;
  for (const Task& task : model.tasks)
  {
    results.push_back(run_task(model, task, preferred, directory, progress));
    if (!options.quiet)
      print_line(results.back());
  }
  write_report(directory, INTERROGATE_VERSION, file.filename().string(), results);
  const bool all_ok = std::all_of(results.begin(), results.end(), [](const Task_result& result) {
    return result.status == "ok";
  });
  return all_ok ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Interrogates the curves and surfaces of a model.\n"
               "Exit status: 0 all tasks are ok, 1 some task is not, 2 the model cannot be used.",
               "interrogate");
  app.add_option("MODEL", options.model, "the model, a JSON file")->required();
  app.add_option("--out", options.out,
                 "the directory of report.json and the files that tasks ask for\n"
                 "(default: named like the model, beside it)");
  app.add_option("--number-type", options.number_type,
                 "for the tasks that name none (default: exact where the data are\n"
                 "algebraic, else filtered)")
    ->check(CLI::IsMember({"exact", "interval", "double", "filtered"}));
  app.add_flag("--quiet", options.quiet, "print no lines about the tasks");
  app.set_version_flag("--version", "interrogate " INTERROGATE_VERSION);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : unusable;
  }
  try
  {
    return run(options);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "interrogate: %s\n", error.what());
    return unusable;
  }
}
