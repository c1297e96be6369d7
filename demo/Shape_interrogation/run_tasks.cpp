// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Runs one task, measures its time and turns what it throws into a status.

#include "run_tasks.h"

#include "read_model.h"

#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <chrono>
#include <new>

namespace interrogate {

namespace {

namespace si = CGAL::Shape_interrogation;

void set_status(Task_result& result, const char* status, const char* code,
                const std::string& text)
{
  result.status = status;
  result.code = code;
  result.text = text;
}

void dispatch(const Model& model, const Task& task, std::optional<Number_type> preferred,
              const std::filesystem::path& directory, Progress_bar& progress,
              Task_result& result)
{
  if (const auto* curvature = std::get_if<Curvature_task>(&task.data))
    run_curvature(model, *curvature, preferred, result);
  else if (const auto* shape_operator = std::get_if<Shape_operator_task>(&task.data))
    run_shape_operator(*shape_operator, preferred, result);
  else if (const auto* mesh = std::get_if<Mesh_task>(&task.data))
    run_mesh(model, *mesh, directory, progress, result);
  else if (const auto* line = std::get_if<Line_task>(&task.data))
    run_line(model, *line, directory, progress, result);
  else if (const auto* property = std::get_if<Property_task>(&task.data))
    run_property(model, *property, preferred, directory, result);
  else
    set_status(result, "error", "unsupported", std::get<Unsupported_task>(task.data).what);
}

} // namespace

Task_result run_task(const Model& model, const Task& task, std::optional<Number_type> preferred,
                     const std::filesystem::path& directory, Progress_bar& progress)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Task_result result;
  result.id = task.id;
  result.task = task.kind;
  if (task.number_type)
    preferred = task.number_type;
  result.number_type = preferred ? name_of(*preferred) : "exact";
  progress.start(task.id);
  try
  {
    dispatch(model, task, preferred, directory, progress, result);
  }
  catch (const si::Not_algebraic_error& e)
  {
    set_status(result, "refused", "not_algebraic", e.what());
  }
  catch (const si::Mixed_roots_error& e)
  {
    set_status(result, "refused", "not_algebraic", e.what());
  }
  catch (const si::Division_by_zero_error& e)
  {
    set_status(result, "refused", "pole", e.what());
  }
  catch (const si::Domain_error& e)
  {
    set_status(result, "refused", "outside_domain", e.what());
  }
  catch (const si::Limit_error& e)
  {
    set_status(result, "refused", "limit_exceeded", e.what());
  }
  catch (const std::bad_alloc&)
  {
    set_status(result, "error", "out_of_memory", "the task needs more memory than there is");
  }
  catch (const std::exception& e)
  {
    set_status(result, "error", "failure", e.what());
  }
  progress.clear();
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

} // namespace interrogate
