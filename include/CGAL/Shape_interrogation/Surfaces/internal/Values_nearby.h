// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_VALUES_NEARBY_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_VALUES_NEARBY_H

// Whether all equations of a system can vanish in a cube around a point.

#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Keeps its memory from call to call.
class Values_nearby
{
public:
  bool may_vanish(const N_space_system& system, const std::vector<double>& p, double radius)
  {
    const Interval::Protector protector;
    m_box.resize(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
      m_box[i] = Interval(p[i]) + Interval(-radius, radius);
    m_values.resize(system.number_of_equations());
    system.tape().evaluate(m_box.data(), m_values.data(), m_workspace);
    return std::all_of(m_values.begin(), m_values.end(),
                       [](const Interval& x) { return x.inf() <= 0 && x.sup() >= 0; });
  }

private:
  using Interval = Interval_nt<false>;

  std::vector<Interval> m_box, m_values, m_workspace;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_VALUES_NEARBY_H
