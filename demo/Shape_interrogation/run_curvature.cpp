// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The tasks about curvature at a place: chooses the number type and stores what it answers.

#include "answer.h"
#include "read_model.h"
#include "run_tasks.h"

namespace interrogate {

namespace {

using Expressions = std::vector<Expression>;

// The functions that a task evaluates.
struct Functions_of
{
  Expressions operator()(const Implicit_model& m) const { return {m.f}; }
  Expressions operator()(const Parametric_model& m) const { return m.x; }
  Expressions operator()(const System_model& m) const { return m.equations; }
  template <class Other>
  Expressions operator()(const Other&) const { return {}; }
};

bool are_algebraic(const Expressions& functions)
{
  for (const Expression& f : functions)
    if (!f.is_algebraic())
      return false;
  return true;
}

template <class Answer>
bool is_decided(const std::vector<Answer>& answers)
{
  for (const Answer& a : answers)
    if (!is_decided(a))
      return false;
  return true;
}

// Filtered answers claim their decisions; the values are doubles.
Scalar without_claim(const Scalar& s) { return Scalar{s.approx, "", {}}; }

// Interval first, exact where the interval does not decide. The exact answer stands only if there is
// one: at an approximate point there is none, and the decisions stay open.
template <class Ask_interval, class Ask_exact>
auto ask_filtered(bool algebraic, Ask_interval ask_interval, Ask_exact ask_exact)
{
  const auto first = ask_interval();
  const bool open = first ? !is_decided(*first)
                          : first.refusal().code() == si::Refusal_code::UNDECIDED;
  if (!open || !algebraic)
    return first;
  const auto exact = ask_exact();
  if (exact || !first)
    return exact;
  return first;
}

template <class Ask>
auto ask(Number_type type, bool algebraic, Ask ask_in)
{
  switch (type)
  {
  case Number_type::DOUBLE: return ask_in(double());
  case Number_type::INTERVAL: return ask_in(Interval());
  case Number_type::EXACT: return ask_in(Quadratic());
  case Number_type::FILTERED: break;
  }
  return ask_filtered(algebraic, [&] { return ask_in(Interval()); },
                      [&] { return ask_in(Quadratic()); });
}

} // namespace

} // namespace interrogate
