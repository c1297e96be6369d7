// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The tasks about curvature at a place: chooses the number type and stores what it answers.

#include "answer.h"
#include "functions_of.h"
#include "read_model.h"
#include "run_tasks.h"

namespace interrogate {

namespace {

// The last answer is that from the right; where there are several, all are listed.
template <class Answer>
void fill(Task_result& result, const si::Result<std::vector<Answer>>& answers)
{
  if (!answers)
  {
    result.code = si::to_string(answers.refusal().code());
    result.status = result.code == "undecided" ? "undecided" : "refused";
    result.text = answers.refusal().evidence();
    return;
  }
  Report_json sides = Report_json::array();
  for (const Answer& answer : *answers)
  {
    result.fields = Report_json::object();
    store(answer, result);
    sides.push_back({{"side", answer.side}});
    sides.back().update(result.fields);
  }
  if (sides.size() > 1)
  {
    result.fields["one_sided"] = sides;
    result.line += " (differs from side to side)";
  }
}

// The values of filtered and of floating point answers are without a claim; a proof stays one.
void drop_claims(Report_json& json)
{
  if (json.is_object() && json.contains("approx"))
  {
    json.erase("exact");
    json.erase("interval");
  }
  for (const auto& item : json.items())
    if (item.value().is_structured() && item.key() != "enclosure")
      drop_claims(item.value());
}

// Intervals first, exact where they do not decide. At a point that is only near the surface there
// is no exact answer: the decisions stay open.
template <class Ask_in>
void fill_filtered(Task_result& result, bool algebraic, Ask_in ask_in)
{
  const Task_result empty = result;
  fill(result, ask_in(Interval()));
  if (result.status == "undecided" && algebraic)
  {
    Task_result exact = empty;
    fill(exact, ask_in(Quadratic()));
    if (exact.status == "ok" || result.fields.empty())
      result = exact;
    else
      result.text += " (" + exact.text + ")";
  }
  drop_claims(result.fields);
}

// Asks in the number type that is preferred, or else in the one that suits the functions.
template <class Ask_in>
void ask(Task_result& result, std::optional<Number_type> preferred, bool algebraic, Ask_in ask_in)
{
  const Number_type type =
    preferred.value_or(algebraic ? Number_type::EXACT : Number_type::FILTERED);
  result.number_type = name_of(type);
  switch (type)
  {
  case Number_type::EXACT: return fill(result, ask_in(Quadratic()));
  case Number_type::INTERVAL: return fill(result, ask_in(Interval()));
  case Number_type::DOUBLE:
    fill(result, ask_in(double()));
    return drop_claims(result.fields);
  case Number_type::FILTERED: return fill_filtered(result, algebraic, ask_in);
  }
}

} // namespace

void run_curvature(const Model& model, const Curvature_task& task,
                   std::optional<Number_type> preferred, Task_result& result)
{
  if (!task.curve.empty())
  {
    const Curve_model& curve = model.curves.at(task.curve);
    ask(result, preferred, are_algebraic(std::visit(Functions_of(), curve)),
        [&](auto x) { return answer<decltype(x)>(curve, task); });
    return;
  }
  const Surface_model& surface = model.surfaces.at(task.surface);
  const bool algebraic = are_algebraic(std::visit(Functions_of(), surface.data));
  if (task.enclose && !algebraic && !preferred)
    preferred = Number_type::FILTERED;
  // What an enclosed point leaves open is decided in more bits, whatever the functions.
  ask(result, preferred, algebraic || task.enclose,
      [&](auto x) { return answer<decltype(x)>(surface, task); });
}

void run_shape_operator(const Shape_operator_task& task, std::optional<Number_type> preferred,
                        Task_result& result)
{
  ask(result, preferred, true, [&](auto x) { return answer<decltype(x)>(task); });
}

} // namespace interrogate
