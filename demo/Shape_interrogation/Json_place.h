// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_JSON_PLACE_H
#define INTERROGATE_JSON_PLACE_H

// A value of the tree together with its path: whatever is wrong there is said with the place and
// with what was expected.

#include "Json.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace interrogate {

class Json_place
{
public:
  // The whole model. The tree must outlive the place.
  explicit Json_place(const Json& root) : m_value(&root) {}

  const std::string& path() const { return m_path; }
  Json::Kind kind() const { return m_value->kind; }

  // Throws a Model_error for this place.
  [[noreturn]] void fail(const std::string& what) const;
  // Throws "expected ..., found ...".
  [[noreturn]] void expected(const std::string& what) const;

  const std::string& string(const std::string& what) const;
  bool boolean() const;

  // The digits of a number or the text of a string.
  const std::string& number_text() const;

  std::vector<Json_place> elements(const std::string& what) const;
  std::vector<Json_place> elements(std::size_t size, const std::string& what) const;

  // Fields of an object. The first is for one that must be there.
  Json_place field(const std::string& key) const;
  std::optional<Json_place> find(const std::string& key) const;
  std::vector<std::pair<std::string, Json_place>> fields(const std::string& what) const;
  // Fails at the first field that is not among the known ones.
  void allow_only(const std::vector<std::string>& known) const;

private:
  Json_place(const Json& value, std::string path) : m_value(&value), m_path(std::move(path)) {}

  void require(Json::Kind kind, const std::string& what) const;
  std::string found() const;

  const Json* m_value;
  std::string m_path;
};

// The names as one text: a, b, c.
std::string listed(const std::vector<std::string>& names);

} // namespace interrogate

#endif // INTERROGATE_JSON_PLACE_H
