// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_WITH_PROGRESS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_WITH_PROGRESS_H

// Runs a computation that asks a progress callback at each of its steps, and turns what it throws
// into a refusal.

#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// `compute(go_on)` calls `go_on()`, which is true or throws.
template <class T, class Progress, class Computation>
Result<T> mesh_with_progress(Progress& progress, Computation compute)
{
  std::size_t steps = 0;
  const auto go_on = [&] {
    if (!progress(++steps, std::size_t(0)))
      refuse_mesh(Refusal_code::CANCELLED, "the caller asked to stop");
    return true;
  };
  try
  {
    return refuse_errors<T>([&]() -> Result<T> { return compute(go_on); });
  }
  catch (const Mesh_refused& refused)
  {
    return refused.refusal;
  }
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_MESH_WITH_PROGRESS_H
