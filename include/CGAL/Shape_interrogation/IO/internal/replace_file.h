// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_INTERNAL_REPLACE_FILE_H
#define CGAL_SHAPE_INTERROGATION_IO_INTERNAL_REPLACE_FILE_H

// Writes a file whole or not at all: into a temporary file beside it, which then takes its name.

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// What the system says about the last failure.
inline std::string last_system_error(const char* otherwise)
{
  return errno != 0 ? std::generic_category().message(errno) : std::string(otherwise);
}

// A name beside the file that nobody else uses.
inline std::filesystem::path temporary_name(const std::filesystem::path& file)
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  for (unsigned long long i = static_cast<unsigned long long>(now);; ++i)
  {
    std::filesystem::path name = file;
    name += "." + std::to_string(i % 1000000007) + ".part";
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored))
      return name;
  }
}

// Removes the temporary file on every path that does not keep it.
class Temporary_file
{
public:
  explicit Temporary_file(const std::filesystem::path& file) : m_name(temporary_name(file)) {}
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_name, ignored);
  }
  const std::filesystem::path& name() const { return m_name; }

private:
  std::filesystem::path m_name;
};

// Writes `file` with `write(stream)`, which returns a reason why it fails or an empty string.
// Returns such a reason with the file's name, or an empty string.
template <class Write>
std::string replace_file(const std::string& file, Write write)
{
  const std::string cannot = "cannot write " + file + ": ";
  const std::filesystem::path path(file);
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return cannot + "it is a directory";
  if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path(), error))
    return cannot + "there is no directory " + path.parent_path().string();
  const Temporary_file temporary(path);
  errno = 0;
  std::ofstream out(temporary.name(), std::ios::binary);
  if (!out)
    return cannot + last_system_error("the directory cannot be written to");
  const std::string reason = write(out);
  if (!reason.empty())
    return cannot + reason;
  errno = 0;
  out.close();
  if (!out)
    return cannot + last_system_error("the disk may be full");
  std::filesystem::rename(temporary.name(), path, error);
  return error ? cannot + error.message() : std::string();
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_INTERNAL_REPLACE_FILE_H
