// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_JSON_H
#define INTERROGATE_JSON_H

// A JSON text as a tree that keeps every number as it was written: 0.1 stays 1/10.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace interrogate {

struct Json
{
  enum class Kind { NOTHING, BOOLEAN, NUMBER, STRING, ARRAY, OBJECT };

  Kind kind = Kind::NOTHING;
  bool boolean = false;
  std::string text;               // of a number (its digits in the file) or a string
  std::vector<std::string> keys;  // of an object, in the order of the file
  std::vector<Json> items;        // of an array, or the values to the keys
};

// Bounds that keep a hostile file from exhausting the machine.
struct Json_limits
{
  std::size_t bytes = std::size_t(64) << 20;
  std::size_t depth = 64;
  std::size_t values = 2000000;
};

// Reads a JSON text. Throws Model_error with line and column on a syntax error, with the JSON path
// where a key is repeated or a limit exceeded.
Json parse_json(std::string_view text, const Json_limits& limits = Json_limits());

// The path of a member or an element: surfaces.s, surfaces["a b"], point[2].
std::string member_path(const std::string& path, const std::string& key);
std::string element_path(const std::string& path, std::size_t index);

// The text with all but printable characters replaced, shortened to some 200 characters.
std::string printable(const std::string& text);

} // namespace interrogate

#endif // INTERROGATE_JSON_H
