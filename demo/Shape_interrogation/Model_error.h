// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_MODEL_ERROR_H
#define INTERROGATE_MODEL_ERROR_H

// What makes a model unusable: the place in the file and what was expected there.

#include <stdexcept>
#include <string>

namespace interrogate {

struct Model_error : std::runtime_error
{
  // `place` is a JSON path such as tasks[0].at, or a line and column; it may be empty.
  Model_error(const std::string& place, const std::string& what)
    : std::runtime_error(place.empty() ? what : place + ": " + what)
  {}
};

} // namespace interrogate

#endif // INTERROGATE_MODEL_ERROR_H
