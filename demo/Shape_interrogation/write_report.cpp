// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Writes the report: to a temporary file beside it first, so that no reader sees half of one.

#include "Report.h"

#include "Json.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace interrogate {

namespace {

Report_json to_json(const Task_result& result)
{
  Report_json json;
  json["id"] = result.id;
  json["task"] = result.task;
  json["status"] = result.status;
  if (result.status != "ok")
    json["reason"] = {{"code", result.code}, {"text", result.text}};
  json["number_type"] = result.number_type;
  json["seconds"] = result.seconds;
  json.update(result.fields);
  return json;
}

// Texts of the system may not be UTF-8: what is not is replaced.
std::string dump(const Report_json& json)
{
  return json.dump(1, ' ', false, Report_json::error_handler_t::replace) + "\n";
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what, int error)
{
  throw std::runtime_error(printable(file.string()) + ": " + what +
                           (error ? std::string(": ") + std::strerror(error) : ""));
}

} // namespace

void make_directory(const std::filesystem::path& directory)
{
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!std::filesystem::is_directory(directory))
    fail(directory, "the directory of the report cannot be made", error.value());
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    fail(directory, "the directory of the report cannot be written to", errno);
}

void write_report(const std::filesystem::path& directory, const std::string& version,
                  const std::string& model, const std::vector<Task_result>& results)
{
  Report_json json;
  json["program"] = "interrogate " + version;
  json["model"] = model;
  json["tasks"] = Report_json::array();
  for (const Task_result& result : results)
    json["tasks"].push_back(to_json(result));

  write_json(directory / "report.json", json);
}

void write_json(const std::filesystem::path& file, const Report_json& json)
{
  const std::filesystem::path temporary =
    file.parent_path() / ("." + file.filename().string() + "." + std::to_string(getpid()));
  errno = 0;
  std::ofstream out(temporary, std::ios::binary);
  out << dump(json);
  out.close();
  const int written = out ? 0 : (errno ? errno : EIO);
  std::error_code renamed, ignored;
  if (!written)
    std::filesystem::rename(temporary, file, renamed);
  if (written || renamed)
  {
    std::filesystem::remove(temporary, ignored);
    fail(file, "the file cannot be written", written ? written : renamed.value());
  }
}

} // namespace interrogate
