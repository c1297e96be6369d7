// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ORACLES_H
#define SHAPE_INTERROGATION_TEST_ORACLES_H

// The exact cases of data/oracles.json, as texts, and the book-keeping of a table-driven test.

#include <map>
#include <string>
#include <vector>

namespace oracles {

using Texts = std::vector<std::string>;

// The fields of one JSON object. Arrays, also nested ones, are flattened; a member of an inner
// object is called "outer.inner".
class Fields
{
public:
  bool has(const std::string& name) const { return m_fields.count(name) > 0; }
  const Texts& texts(const std::string& name) const;
  const std::string& text(const std::string& name) const { return texts(name).at(0); }
  bool flag(const std::string& name) const { return text(name) == "true"; }
  int integer(const std::string& name) const { return std::stoi(text(name)); }
  Texts& operator[](const std::string& name) { return m_fields[name]; }

private:
  std::map<std::string, Texts> m_fields;
};

struct Case
{
  std::string id, kind;
  Fields inputs, expected;

  bool is_refused() const { return expected.text("status") == "refuse"; }
};

// The cases of one kind, in the order of the file.
std::vector<Case> cases(const std::string& kind);

// Counts what one test did with the cases of a kind, and prints it at the end. A case is run, or it
// is skipped for a reason; a test asserts that the sum is what it expects.
class Count
{
public:
  Count(std::string kind, std::string number_type);
  ~Count();

  void run() { ++m_run; }
  void skip(const std::string& id, const std::string& reason);
  // What an enclosure or a filter could tell.
  void decide(bool decided) { ++(decided ? m_decided : m_undecided); }
  // A single value that is left out of a case that runs.
  void pass_over(const std::string& reason) { ++m_passed_over[reason]; }

  int visited() const { return m_run + static_cast<int>(m_skipped.size()); }
  int decided() const { return m_decided; }
  int undecided() const { return m_undecided; }

private:
  std::string m_name;
  int m_run = 0, m_decided = 0, m_undecided = 0;
  std::vector<std::string> m_skipped;
  std::map<std::string, int> m_passed_over;
};

// The counts of a test that runs each case in all number types.
struct Counts
{
  Count approximate, filtered, interval, real, one_root, exact;

  explicit Counts(const std::string& kind);

  // Expects that each number type has met this many cases.
  void expect_visited(int cases) const;
};

} // namespace oracles

#endif // SHAPE_INTERROGATION_TEST_ORACLES_H
