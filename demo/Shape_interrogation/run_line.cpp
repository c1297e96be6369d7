// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The task line: follows a curve in n-space, writes the file, and reports the polyline.

#include "evaluate_numbers.h"
#include "make_systems.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/IO/write_polylines.h>
#include <CGAL/Shape_interrogation/Meshing/trace_n_space_curve.h>

#include <optional>

namespace interrogate {

namespace {

const char* name_of(si::N_space_curve_end end)
{
  switch (end)
  {
  case si::N_space_curve_end::CLOSED: return "closed";
  case si::N_space_curve_end::BOUND: return "bound";
  case si::N_space_curve_end::SINGULAR: return "singular";
  case si::N_space_curve_end::LIMIT: break;
  }
  return "limit";
}

void store(const si::N_space_curve& curve, const std::vector<std::string>& variables,
           Task_result& result)
{
  Report_json& json = result.fields;
  json["vertices"] = curve.points.size();
  json["closed"] = curve.closed;
  json["ended"] = Report_json::array();
  json["ends"] = Report_json::array();
  for (const si::N_space_curve_end_data& end : curve.ends)
  {
    json["ended"].push_back(name_of(end.reason));
    json["ends"].push_back({{"text", end.evidence}});
    if (!end.box.empty())
    {
      json["ends"].back()["box"] = end.box;
      json["ends"].back()["certified"] = false; // the box is an estimate
    }
  }
  json["max_residual"] = {{"approx", curve.max_residual}, {"certified", false}};
  json["curvature"] = Report_json::array();
  for (const std::optional<double>& k : curve.curvatures)
    json["curvature"].push_back(k ? Report_json(*k) : Report_json(nullptr));
  json["polyline"] = Report_json::array();
  for (std::vector<double> p : curve.points)
    json["polyline"].push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}); // no -0
  if (variables.size() > 3)
  {
    json["variables"] = variables;
    json["points"] = curve.points;
  }
  result.line = std::to_string(curve.points.size()) + " points, " +
                (curve.closed ? curve.ends[0].evidence
                              : "from where " + curve.ends[0].evidence + " to where " +
                                  curve.ends[1].evidence);
}

// The start in the space of the system: the point is that of the first surface.
std::vector<double> start_of(const Line_task& task, const std::vector<const Surface_model*>& of)
{
  if (task.starts.size() < of.size())
    return task.starts.front();
  std::vector<double> start = lifted(*of[0], task.starts[0]);
  if (of.size() == 2)
  {
    const std::vector<double> other = lifted(*of[1], task.starts[1]);
    start.insert(start.end(), other.begin() + 3, other.end());
  }
  return start;
}

std::optional<si::N_space_condition> section_of(const Line_task& task, std::size_t n)
{
  if (task.condition.empty())
    return std::nullopt;
  si::N_space_condition section{task.condition, task.value};
  section.coefficients.resize(n);
  return section;
}

} // namespace

void run_line(const Model& model, const Line_task& task, const std::filesystem::path& directory,
              Progress_bar& progress, Task_result& result)
{
  result.number_type = "double";
  std::vector<const Surface_model*> of;
  for (const std::string& name : task.surfaces)
    of.push_back(&model.surfaces.at(name));
  Bounded_system made = of.size() == 1 ? make_system(*of[0]) : make_system(*of[0], *of[1]);
  if (task.box)
    add_box(*task.box, made.bounds);
  const std::vector<std::string>& variables = made.system.variables();
  si::N_space_curve_options options;
  options.step = evaluate<double>(task.step);
  options.bounds = made.bounds;
  if (task.max_points)
    options.max_points = *task.max_points;
  const si::Result<si::N_space_curve> curve = si::trace_n_space_curve(
    made.system, start_of(task, of), options, section_of(task, variables.size()),
    [&](std::size_t done, std::size_t total) {
      progress.show(done, total);
      return true;
    });
  if (!curve)
  {
    result.status = "refused";
    result.code = si::to_string(curve.refusal().code());
    result.text = curve.refusal().evidence();
    return;
  }
  store(*curve, variables, result);
  if (task.file.empty())
    return;
  std::string reason;
  si::write_polylines(path_of(directory, task.file), {*curve}, variables, reason);
  store_file("file", task.file, reason, result);
}

} // namespace interrogate
