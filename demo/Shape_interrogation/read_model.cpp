// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Reads the file and the top level of the model.

#include "read_model.h"

#include "Model_error.h"
#include "read_shapes.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace interrogate {

namespace {

std::string read_file(const std::string& file)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw Model_error(printable(file), "this is a directory; the file of a model is expected");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw Model_error(printable(file), std::string("the model cannot be read: ") +
                                         std::strerror(errno ? errno : ENOENT));
  const std::size_t most = Json_limits().bytes + 1;
  std::string text, block(1 << 16, '\0');
  while (text.size() < most && in)
  {
    in.read(&block[0], static_cast<std::streamsize>(block.size()));
    text.append(block, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad())
    throw Model_error(printable(file), "the model cannot be read to its end");
  if (text.find('\0') != std::string::npos)
    throw Model_error(printable(file), "this is not a text file: it has a byte 0");
  return text;
}

std::vector<std::string> files_of(const Task& task)
{
  std::vector<std::string> files;
  if (const Mesh_task* mesh = std::get_if<Mesh_task>(&task.data))
    files = {mesh->file, mesh->folds_file};
  if (const Line_task* line = std::get_if<Line_task>(&task.data))
    files = {line->file};
  files.erase(std::remove(files.begin(), files.end(), std::string()), files.end());
  return files;
}

void check_files(const std::vector<Task>& tasks, const Json_place& place)
{
  std::set<std::string> ids, files;
  for (const Task& task : tasks)
  {
    if (!ids.insert(task.id).second)
      place.fail("two tasks have the id \"" + printable(task.id) + "\"");
    for (const std::string& file : files_of(task))
      if (!files.insert(std::filesystem::path(file).lexically_normal()).second)
        place.fail("two tasks write the file " + printable(file));
  }
}

// Constructions come last, as they are made from other surfaces and from curves.
void read_surfaces(const Json_place& place, Model& model)
{
  for (const auto& [name, surface] : place.fields("an object {name: surface}"))
    if (!is_construction(surface))
      model.surfaces.emplace(name, read_surface(surface));
  std::map<std::string, Surface_model> constructions;
  for (const auto& [name, surface] : place.fields("an object {name: surface}"))
    if (is_construction(surface))
      constructions.emplace(name, read_construction(surface, name, model, place));
  model.surfaces.merge(constructions);
}

} // namespace

Model read_model(std::string_view text)
{
  const Json json = parse_json(text);
  const Json_place root(json);
  root.allow_only({"surfaces", "curves", "tasks"});
  Model model;
  if (const std::optional<Json_place> curves = root.find("curves"))
    for (const auto& [name, curve] : curves->fields("an object {name: curve}"))
      model.curves.emplace(name, read_curve(curve));
  if (const std::optional<Json_place> surfaces = root.find("surfaces"))
    read_surfaces(*surfaces, model);
  const Json_place tasks = root.field("tasks");
  for (const Json_place& task : tasks.elements("an array of tasks"))
  {
    model.tasks.push_back(read_task(task, model));
    if (model.tasks.back().id.empty())
      model.tasks.back().id = std::to_string(model.tasks.size() - 1);
  }
  check_files(model.tasks, tasks);
  return model;
}

Model read_model_file(const std::string& file)
{
  const std::string text = read_file(file);
  try
  {
    return read_model(text);
  }
  catch (const Model_error& error)
  {
    throw Model_error(printable(file), error.what());
  }
}

} // namespace interrogate
