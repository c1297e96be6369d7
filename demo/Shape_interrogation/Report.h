// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_REPORT_H
#define INTERROGATE_REPORT_H

// The report: one result a task, and the file that they go into.

#include "Answers.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace interrogate {

using Report_json = nlohmann::ordered_json;

struct Task_result
{
  std::string id, task;
  std::string status = "ok"; // ok, refused, undecided, error
  std::string code, text;    // the reason, where not ok
  std::string number_type;
  double seconds = 0;
  Report_json fields = Report_json::object();
  std::string line; // what the task found, for people
};

// Fields of the report.
Report_json to_json(const Scalar& s);
Report_json to_json(const Signed_scalar& s);
Report_json to_json(const Decision& d);
Report_json sign_to_json(const Sign_decision& s);
template <class T, std::size_t n>
Report_json to_json(const std::array<T, n>& values)
{
  Report_json json = Report_json::array();
  for (const T& value : values)
    json.push_back(to_json(value));
  return json;
}

// Stores the answer: its fields, the line, and the status "undecided" where a decision is missing.
void store(const Surface_answer& answer, Task_result& result);
void store(const Curve_answer& answer, Task_result& result);

// Writes a file of JSON, all or nothing. Throws std::runtime_error with one sentence, as do those
// that follow.
void write_json(const std::filesystem::path& file, const Report_json& json);

// Makes the directory, and writes report.json into it, all or nothing.
void make_directory(const std::filesystem::path& directory);
void write_report(const std::filesystem::path& directory, const std::string& version,
                  const std::string& model, const std::vector<Task_result>& results);

} // namespace interrogate

#endif // INTERROGATE_REPORT_H
