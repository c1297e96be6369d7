// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Builds the tree from the events of nlohmann's reader, which also checks the syntax and UTF-8.

#include "Json.h"
#include "Model_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <set>

namespace interrogate {

namespace {

std::string line_and_column(std::string_view text, std::size_t offset)
{
  offset = (std::min)(offset, text.size());
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1; // 0 where there is no line end
  return "line " + std::to_string(line) + ", column " + std::to_string(offset - line_start + 1);
}

class Tree_builder final : public nlohmann::json_sax<nlohmann::json>
{
public:
  Tree_builder(std::string_view text, const Json_limits& limits) : m_text(text), m_limits(limits) {}

  Json take() { return std::move(m_root); }

  bool null() override { return bool(add(Json::Kind::NOTHING)); }
  bool boolean(bool value) override
  {
    add(Json::Kind::BOOLEAN)->boolean = value;
    return true;
  }
  bool number_integer(number_integer_t value) override { return number(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& digits) override
  {
    // The reader writes the decimal point of the locale.
    std::string text = digits;
    for (char& c : text)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '-')
        c = '.';
    return number(std::move(text));
  }
  bool string(string_t& value) override
  {
    add(Json::Kind::STRING)->text = std::move(value);
    return true;
  }
  bool binary(binary_t&) override { return false; } // not in JSON

  bool start_object(std::size_t) override { return open(Json::Kind::OBJECT); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::Kind::ARRAY); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override
  {
    Open& object = m_open.back();
    if (!object.keys.insert(name).second)
      throw Model_error(path(), "the key \"" + printable(name) + "\" occurs twice");
    object.value->keys.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& error) override
  {
    const std::string place = line_and_column(m_text, position == 0 ? 0 : position - 1);
    if (error.id == 406)
      throw Model_error(place, "the number " + printable(token) +
                                 " is too large for a JSON number: write it as a string");
    std::string what = error.what();
    const std::size_t start = what.find("syntax error");
    throw Model_error(place, printable(start == std::string::npos ? what : what.substr(start)));
  }

private:
  struct Open
  {
    Json* value;
    std::set<std::string> keys;
  };

  // The place where the next value goes. Only the innermost open value grows, so pointers stay.
  Json* add(Json::Kind kind)
  {
    if (++m_values > m_limits.values)
      throw Model_error(path(), "the model has more than " + std::to_string(m_limits.values) +
                                  " values");
    Json* value = &m_root;
    if (!m_open.empty())
    {
      m_open.back().value->items.emplace_back();
      value = &m_open.back().value->items.back();
    }
    value->kind = kind;
    return value;
  }

  bool number(std::string digits)
  {
    add(Json::Kind::NUMBER)->text = std::move(digits);
    return true;
  }

  bool open(Json::Kind kind)
  {
    if (m_open.size() == m_limits.depth)
      throw Model_error(path(), "arrays and objects are nested more than " +
                                  std::to_string(m_limits.depth) + " deep");
    m_open.push_back(Open{add(kind), {}});
    return true;
  }

  bool close()
  {
    m_open.pop_back();
    return true;
  }

  // Of the value that is being read.
  std::string path() const
  {
    std::string text;
    for (const Open& open : m_open)
    {
      const Json& value = *open.value;
      const bool last = &open == &m_open.back();
      if (value.kind == Json::Kind::ARRAY)
        text = element_path(text, value.items.size() - (last ? 0 : 1));
      else if (!last || value.keys.size() > value.items.size())
        text = member_path(text, value.keys.back());
    }
    return text;
  }

  std::string_view m_text;
  Json_limits m_limits;
  Json m_root;
  std::vector<Open> m_open;
  std::size_t m_values = 0;
};

} // namespace

Json parse_json(std::string_view text, const Json_limits& limits)
{
  if (text.size() > limits.bytes)
    throw Model_error("", "the model has more than " + std::to_string(limits.bytes) + " bytes");
  Tree_builder builder(text, limits);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

std::string member_path(const std::string& path, const std::string& key)
{
  const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  if (!plain)
    return path + "[\"" + printable(key) + "\"]";
  return path.empty() ? key : path + "." + key;
}

std::string element_path(const std::string& path, std::size_t index)
{
  return path + "[" + std::to_string(index) + "]";
}

std::string printable(const std::string& text)
{
  const std::size_t longest = 200;
  std::string out;
  for (const unsigned char c : text.substr(0, longest))
    out += c < 0x20 || c == 0x7f ? '?' : static_cast<char>(c);
  if (text.size() <= longest)
    return out;
  while (!out.empty() && (out.back() & 0x80)) // no character is cut in two
    out.pop_back();
  return out + "...";
}

} // namespace interrogate
