// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHECKED_FUNCTION_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHECKED_FUNCTION_H

// A function of three variables for meshers that know no refusals: it throws when the value is not
// a number, and when the caller wants to stop.

#include <CGAL/Shape_interrogation/Meshing/internal/Mesh_refused.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Function, class Go_on>
class Checked_function
{
public:
  Checked_function(const Function& function, Go_on go_on)
    : m_function(function), m_go_on(std::move(go_on))
  {}

  double operator()(const Coordinates<double, 3>& p)
  {
    if (++m_calls % 4096 == 0 && !m_go_on())
      refuse_mesh(Refusal_code::CANCELLED, "the meshing was cancelled");
    const double value = m_function(p[0], p[1], p[2]);
    if (!std::isfinite(value))
      refuse_mesh(Refusal_code::LIMIT_EXCEEDED,
                  "the function has no finite value at (" + std::to_string(p[0]) + ", " +
                    std::to_string(p[1]) + ", " + std::to_string(p[2]) + ")");
    return value;
  }

private:
  const Function& m_function;
  Go_on m_go_on;
  std::size_t m_calls = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CHECKED_FUNCTION_H
