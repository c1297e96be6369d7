// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#include "oracles.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <stdexcept>

namespace oracles {

namespace {

using Json = nlohmann::json;

void flatten(const Json& value, const std::string& name, Fields& fields);

void flatten_array(const Json& array, const std::string& name, Fields& fields)
{
  for (const Json& element : array)
    if (element.is_object())
      for (const Json& member : element)
        flatten(member, name, fields);
    else
      flatten(element, name, fields);
}

void flatten(const Json& value, const std::string& name, Fields& fields)
{
  if (value.is_array())
    flatten_array(value, name, fields);
  else if (value.is_object())
    for (const auto& [key, member] : value.items())
      flatten(member, name + "." + key, fields);
  else
    fields[name].push_back(value.is_string() ? value.get<std::string>() : value.dump());
}

Fields fields_of(const Json& object)
{
  Fields fields;
  for (const auto& [key, member] : object.items())
    flatten(member, key, fields);
  return fields;
}

Json read_file()
{
  std::ifstream in(SHAPE_INTERROGATION_TEST_DATA "/oracles.json");
  if (!in)
    throw std::runtime_error("cannot read " SHAPE_INTERROGATION_TEST_DATA "/oracles.json");
  return Json::parse(in);
}

} // namespace

const Texts& Fields::texts(const std::string& name) const
{
  const auto found = m_fields.find(name);
  if (found == m_fields.end())
    throw std::runtime_error("the case has no field '" + name + "'");
  return found->second;
}

std::vector<Case> cases(const std::string& kind)
{
  static const Json file = read_file();
  std::vector<Case> result;
  for (const Json& entry : file.at("cases"))
    if (entry.at("kind") == kind)
      result.push_back({entry.at("id"), kind, fields_of(entry.at("inputs")),
                        fields_of(entry.at("expected"))});
  return result;
}

Count::Count(std::string kind, std::string number_type)
  : m_name(std::move(kind) + " in " + std::move(number_type))
{}

Count::~Count()
{
  std::cout << "counts: " << m_name << ": " << m_run << " run, " << m_skipped.size() << " skipped";
  if (m_decided + m_undecided > 0)
    std::cout << "; of their decisions " << m_decided << " decided, " << m_undecided
              << " undecided";
  std::cout << '\n';
  for (const std::string& line : m_skipped)
    std::cout << "counts:   skipped " << line << '\n';
  for (const auto& [reason, number] : m_passed_over)
    std::cout << "counts:   " << number << " values passed over: " << reason << '\n';
  std::cout.flush();
}

void Count::skip(const std::string& id, const std::string& reason)
{
  m_skipped.push_back(id + ": " + reason);
}

Counts::Counts(const std::string& kind)
  : approximate(kind, "double"), filtered(kind, "filtered"), interval(kind, "intervals"),
    real(kind, "exact reals"), one_root(kind, "Q(sqrt c)"), exact(kind, "exact rationals")
{}

void Counts::expect_visited(int cases) const
{
  for (const Count* count : {&approximate, &filtered, &interval, &real, &one_root, &exact})
    EXPECT_EQ(count->visited(), cases);
}

} // namespace oracles
