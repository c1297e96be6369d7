// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The fields of a model and what is said when they are not as expected.

#include "Json_place.h"
#include "Model_error.h"

#include <algorithm>

namespace interrogate {

void Json_place::fail(const std::string& what) const
{
  throw Model_error(m_path.empty() ? "the model" : m_path, what);
}

void Json_place::expected(const std::string& what) const
{
  fail("expected " + what + ", found " + found());
}

std::string Json_place::found() const
{
  switch (m_value->kind)
  {
  case Json::Kind::NOTHING: return "null";
  case Json::Kind::BOOLEAN: return m_value->boolean ? "true" : "false";
  case Json::Kind::NUMBER: return "the number " + printable(m_value->text);
  case Json::Kind::STRING: return "the string \"" + printable(m_value->text) + "\"";
  case Json::Kind::ARRAY: return "an array of " + std::to_string(m_value->items.size());
  case Json::Kind::OBJECT: break;
  }
  return "an object";
}

void Json_place::require(Json::Kind kind, const std::string& what) const
{
  if (m_value->kind != kind)
    expected(what);
}

const std::string& Json_place::string(const std::string& what) const
{
  require(Json::Kind::STRING, what);
  return m_value->text;
}

bool Json_place::boolean() const
{
  require(Json::Kind::BOOLEAN, "true or false");
  return m_value->boolean;
}

const std::string& Json_place::number_text() const
{
  if (m_value->kind != Json::Kind::NUMBER && m_value->kind != Json::Kind::STRING)
    expected("a number, or a string such as \"1/3\" or \"3/(2*sqrt(17))\"");
  return m_value->text;
}

std::vector<Json_place> Json_place::elements(const std::string& what) const
{
  require(Json::Kind::ARRAY, what);
  std::vector<Json_place> places;
  for (std::size_t i = 0; i < m_value->items.size(); ++i)
    places.push_back(Json_place(m_value->items[i], element_path(m_path, i)));
  return places;
}

std::vector<Json_place> Json_place::elements(std::size_t size, const std::string& what) const
{
  if (m_value->kind != Json::Kind::ARRAY || m_value->items.size() != size)
    expected(what);
  return elements(what);
}

std::optional<Json_place> Json_place::find(const std::string& key) const
{
  require(Json::Kind::OBJECT, "an object");
  const auto at = std::find(m_value->keys.begin(), m_value->keys.end(), key);
  if (at == m_value->keys.end())
    return std::nullopt;
  return Json_place(m_value->items[at - m_value->keys.begin()], member_path(m_path, key));
}

Json_place Json_place::field(const std::string& key) const
{
  const std::optional<Json_place> place = find(key);
  if (!place)
    fail("the field \"" + key + "\" is missing");
  return *place;
}

std::vector<std::pair<std::string, Json_place>> Json_place::fields(const std::string& what) const
{
  require(Json::Kind::OBJECT, what);
  std::vector<std::pair<std::string, Json_place>> places;
  for (std::size_t i = 0; i < m_value->keys.size(); ++i)
    places.emplace_back(m_value->keys[i],
                        Json_place(m_value->items[i], member_path(m_path, m_value->keys[i])));
  return places;
}

void Json_place::allow_only(const std::vector<std::string>& known) const
{
  require(Json::Kind::OBJECT, "an object");
  for (const std::string& key : m_value->keys)
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail("unknown field \"" + printable(key) + "\", the fields are: " + listed(known));
}

std::string listed(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "" : ", ") + printable(name);
  return text;
}

} // namespace interrogate
