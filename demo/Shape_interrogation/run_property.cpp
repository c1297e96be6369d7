// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Runs the tasks property and bound.

#include "functions_of.h"
#include "make_scalar.h"
#include "property_pieces.h"
#include "read_model.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>

namespace interrogate {

namespace {

std::string brief(const Scalar& s)
{
  if (!s.exact.empty() && s.exact.size() <= 24)
    return s.exact;
  return s.approx ? Report_json(*s.approx).dump() : "?";
}

// --- At parameters -------------------------------------------------------------------------------

si::Result<Scalar> value_of(const si::Property_surface<Quadratic>& p)
{
  const std::array<Quadratic, 2> nowhere{Quadratic(0), Quadratic(0)};
  const auto value = p.value(nowhere);
  if (value)
    return make_scalar(*value);
  if (value.refusal().code() != si::Refusal_code::NOT_ALGEBRAIC)
    return value.refusal();
  try
  {
    const Quadratic root = si::Elementary_functions<Quadratic>::sqrt((*p.radicand())(nowhere));
    return make_scalar(Quadratic((p.numerator()(nowhere) + root) / p.denominator()(nowhere)));
  }
  catch (const si::Not_algebraic_error&) {}
  catch (const si::Mixed_roots_error&) {}
  return make_scalar(*p.enclosure(nowhere));
}

si::Result<Scalar> value_of(const si::Property_surface<Interval>& p)
{
  const auto value = p.enclosure({Interval(0), Interval(0)});
  if (!value)
    return value.refusal();
  return make_scalar(*value);
}

si::Result<Scalar> value_of(const si::Property_surface<double>& p)
{
  const auto value = p.enclosure({0, 0});
  if (!value)
    return value.refusal();
  return make_scalar(si::number_cast<double>(*value));
}

template <class NT>
void fill_value(const Surface_model& surface, const Property_task& task, Task_result& result)
{
  const auto properties = property_at<NT>(surface, task);
  if (!properties)
    return refuse(properties.refusal(), result);
  Report_json sides = Report_json::array();
  for (const Sided_property<NT>& one : *properties)
  {
    const si::Result<Scalar> value = value_of(one.property);
    if (!value)
      return refuse(value.refusal(), result);
    result.fields["value"] = to_json(*value); // at last from the right
    result.line = std::string(si::to_string(task.property)) + " = " + brief(*value);
    sides.push_back({{"side", one.side}, {"value", to_json(*value)}});
  }
  if (sides.size() > 1)
  {
    result.fields["one_sided"] = sides;
    result.line += " (differs from side to side)";
  }
}

void drop_claims(Report_json& value)
{
  value.erase("exact");
  value.erase("interval");
}

void fill_value(const Surface_model& surface, const Property_task& task, bool algebraic,
                Number_type type, Task_result& result)
{
  if (type == Number_type::DOUBLE)
    return fill_value<double>(surface, task, result);
  if (type == Number_type::EXACT || (type == Number_type::FILTERED && algebraic))
    fill_value<Quadratic>(surface, task, result);
  else
    fill_value<Interval>(surface, task, result);
  if (type != Number_type::FILTERED || !result.fields.contains("value"))
    return;
  drop_claims(result.fields["value"]);
  if (result.fields.contains("one_sided"))
    for (Report_json& side : result.fields["one_sided"])
      drop_claims(side["value"]);
}

// --- On the whole surface ------------------------------------------------------------------------

template <class NT>
Report_json to_json(const si::Bernstein_polynomial_2<NT>& p)
{
  const std::vector<NT> b = p.coefficients();
  Report_json rows = Report_json::array();
  const std::size_t columns = p.degree()[1] + 1;
  for (std::size_t k = 0; k < b.size(); ++k)
  {
    if (k % columns == 0)
      rows.push_back(Report_json::array());
    rows.back().push_back(to_json(make_scalar(b[k])));
  }
  return {{"degree", p.degree()}, {"coefficients", rows}};
}

template <class NT>
Report_json to_json(const si::Property_surface<NT>& p)
{
  Report_json json;
  json["degree"] = p.numerator().degree();
  json["numerator"] = to_json(p.numerator());
  json["denominator"] = to_json(p.denominator());
  if (p.radicand())
    json["radicand"] = to_json(*p.radicand());
  return json;
}

template <class NT>
Report_json scalars(const std::array<NT, 2>& x)
{
  return {to_json(make_scalar(x[0])), to_json(make_scalar(x[1]))};
}

// The interval, exact where it is a single number; unbounded where no bound was found.
template <class NT>
Scalar scalar_of(const si::Certified_extreme<NT, 2>& e, bool is_supremum)
{
  if (e.is_bounded && e.lower == e.upper)
    return make_scalar(e.lower);
  constexpr double infinite = HUGE_VAL;
  const bool has_lower = is_supremum ? e.is_attained : e.is_bounded;
  const bool has_upper = is_supremum ? e.is_bounded : e.is_attained;
  const double low = has_lower ? si::number_cast<Interval>(e.lower).inf() : -infinite;
  const double high = has_upper ? si::number_cast<Interval>(e.upper).sup() : infinite;
  return make_scalar(Interval(low, high));
}

template <class NT>
Report_json place_of(const si::Certified_extreme<NT, 2>& e)
{
  return e.is_attained ? scalars(e.at) : Report_json(nullptr);
}

template <class NT>
void fill_whole(const std::vector<si::Property_surface_piece<NT>>& pieces,
                const Property_task& task, Task_result& result)
{
  bool is_zero = true, has_value = true;
  for (const auto& piece : pieces)
  {
    is_zero = is_zero && piece.surface.is_identically_zero();
    has_value = has_value && !piece.surface.denominator().is_zero();
  }
  if (!has_value)
    return refuse(si::Refusal(si::Refusal_code::IRREGULAR_PARAMETRISATION,
                              "the property has no value anywhere: its denominator is zero"),
                  result);
  result.fields["identically_zero"] = is_zero;
  {
    const auto range = si::bounds(pieces, si::Bound_limits{1e-9, 200});
    const Scalar low = scalar_of(range.infimum, false), high = scalar_of(range.supremum, true);
    result.fields["bounds"] = {to_json(low), to_json(high)};
    result.fields["bounds_at"] = {place_of(range.infimum), place_of(range.supremum)};
    if (result.line.empty())
      result.line = std::string(si::to_string(task.property)) + " between " + brief(low) +
                    " and " + brief(high) + (is_zero ? " (proved to be zero everywhere)" : "");
  }
  if (pieces.size() == 1)
    return result.fields.update(to_json(pieces.front().surface));
  Report_json spans = Report_json::array();
  for (const auto& piece : pieces)
  {
    spans.push_back({{"u", scalars(piece.u)}, {"v", scalars(piece.v)}});
    spans.back()["identically_zero"] = piece.surface.is_identically_zero();
    spans.back().update(to_json(piece.surface));
  }
  result.fields["degree"] = spans.front()["degree"];
  result.fields["spans"] = spans;
}

template <class NT>
void fill_bound(const std::vector<si::Property_surface_piece<NT>>& pieces,
                const Property_task& task, Task_result& result)
{
  const NT bound = evaluate<NT>(*task.bound);
  const auto decided = task.is_upper ? si::decide_at_most(pieces, bound)
                                     : si::decide_at_least(pieces, bound);
  if (!decided)
    return refuse(decided.refusal(), result);
  const Scalar extreme = scalar_of(decided->extreme, task.is_upper);
  result.fields["verdict"] = si::to_string(decided->verdict);
  result.fields["extreme"] = to_json(extreme);
  if (decided->at)
    result.fields["at"] = {{"parameters", scalars(*decided->at)}};
  result.line = std::string(si::to_string(decided->verdict)) + ", the " +
                (task.is_upper ? "supremum" : "infimum") + " is " + brief(extreme);
  if (decided->verdict != si::Verdict::UNDECIDED)
    return;
  result.status = result.code = "undecided";
  result.text = "neither a proof nor a witness was found: the bound is attained inside of the"
                " domain, or nearly";
}

// In the exact number type NT. False if the data are not in it.
template <class NT>
bool run_whole(const Surface_model& surface, const Property_task& task, Task_result& result)
{
  std::vector<si::Property_surface_piece<NT>> pieces;
  try
  {
    auto made = property_pieces<NT>(surface, task);
    if (!made)
    {
      refuse(made.refusal(), result);
      return true;
    }
    pieces = *std::move(made);
    if (task.bound)
      evaluate<NT>(*task.bound);
  }
  catch (const si::Not_algebraic_error&)
  {
    return false;
  }
  if (task.bound)
    fill_bound(pieces, task, result);
  else
    fill_whole(pieces, task, result);
  return true;
}

bool has_patches(const Surface_model& surface, bool algebraic)
{
  const auto* parametric = std::get_if<Parametric_model>(&surface.data);
  return !parametric || (parametric->domain && algebraic);
}

} // namespace

void run_property(const Model& model, const Property_task& task,
                  std::optional<Number_type> preferred, const std::filesystem::path& directory,
                  Task_result& result)
{
  const Surface_model& surface = model.surfaces.at(task.surface);
  const bool algebraic = are_algebraic(std::visit(Functions_of(), surface.data));
  if (task.at)
  {
    const Number_type type =
      preferred.value_or(algebraic ? Number_type::EXACT : Number_type::FILTERED);
    result.number_type = name_of(type);
    fill_value(surface, task, algebraic, type, result);
    if (result.status != "ok" || !has_patches(surface, algebraic))
      return;
  }
  else
    result.number_type = name_of(Number_type::EXACT);
  Task_result whole = result;
  if (!run_whole<Rational>(surface, task, whole) && !run_whole<Quadratic>(surface, task, whole))
    throw si::Not_algebraic_error("the data have roots of several numbers");
  if (task.at && whole.status != "ok")
    return; // the value stands
  result = whole;
  if (task.file.empty() || result.status != "ok")
    return;
  std::string reason;
  try
  {
    write_json(path_of(directory, task.file), result.fields);
  }
  catch (const std::runtime_error& e)
  {
    reason = e.what();
  }
  store_file("file", task.file, reason, result);
}

} // namespace interrogate
