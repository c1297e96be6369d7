// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_READ_MODEL_H
#define INTERROGATE_READ_MODEL_H

// From the text of a model to the checked model. All throw Model_error.

#include "Json_place.h"
#include "Model.h"

#include <optional>
#include <string>
#include <string_view>

namespace interrogate {

Model read_model(std::string_view text);

// Reads at most as much of the file as a model may have; the messages name the file.
Model read_model_file(const std::string& file);

// Task `place` of a model whose surfaces and curves are known.
Task read_task(const Json_place& place, const Model& model);

std::optional<Number_type> number_type_of(const std::string& name);
const char* name_of(Number_type type);

} // namespace interrogate

#endif // INTERROGATE_READ_MODEL_H
