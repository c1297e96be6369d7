// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_RUN_TASKS_H
#define INTERROGATE_RUN_TASKS_H

// Runs the tasks of a model one by one. Whatever a task does, it ends in a result.

#include "Model.h"
#include "Progress_bar.h"
#include "Report.h"

#include <filesystem>
#include <optional>

namespace interrogate {

// Runs a task; files that it asks for go into `directory`. `preferred` is the number type for tasks
// that name none.
Task_result run_task(const Model& model, const Task& task, std::optional<Number_type> preferred,
                     const std::filesystem::path& directory, Progress_bar& progress);

// The kinds of tasks. They fill in status, fields and line of the result.
void run_curvature(const Model& model, const Curvature_task& task,
                   std::optional<Number_type> preferred, Task_result& result);
void run_shape_operator(const Shape_operator_task& task, std::optional<Number_type> preferred,
                        Task_result& result);
void run_mesh(const Model& model, const Mesh_task& task, const std::filesystem::path& directory,
              Progress_bar& progress, Task_result& result);

void run_line(const Model& model, const Line_task& task, const std::filesystem::path& directory,
              Progress_bar& progress, Task_result& result);

void run_property(const Model& model, const Property_task& task,
                  std::optional<Number_type> preferred, const std::filesystem::path& directory,
                  Task_result& result);

// The path of a task's file, in a directory that is made for it; and what became of the file.
std::string path_of(const std::filesystem::path& directory, const std::string& file);
void store_file(const char* field, const std::string& file, const std::string& reason,
                Task_result& result);

} // namespace interrogate

#endif // INTERROGATE_RUN_TASKS_H
