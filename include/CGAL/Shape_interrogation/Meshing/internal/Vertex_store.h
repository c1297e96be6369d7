// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_STORE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_STORE_H

// Vertices of a mesh of patches: exact points of the patches, rounded to the nearest doubles.

#include <CGAL/Shape_interrogation/Meshing/internal/Exact_net.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Double_point = Coordinates<double, 3>;

class Vertex_store
{
public:
  // Adds a vertex, or finds the one that was added for the same corner point.
  std::size_t add(const Exact_point& p)
  {
    Double_point rounded;
    for (int k = 0; k < 3; ++k)
      rounded[k] = number_cast<double>(p[k]);
    m_distance = (std::max)(m_distance, upper_distance(p, rounded));
    m_points.push_back(rounded);
    return m_points.size() - 1;
  }

  std::size_t add_corner(const Exact_point& p)
  {
    const auto found = m_corners.find(p);
    if (found != m_corners.end())
      return found->second;
    return m_corners[p] = add(p);
  }

  std::size_t size() const { return m_points.size(); }
  const Double_point& operator[](std::size_t i) const { return m_points[i]; }

  // An upper bound of the distance of all vertices from their exact points.
  double max_distance() const { return m_distance; }

private:
  static double upper_distance(const Exact_point& p, const Double_point& rounded)
  {
    Interval_nt<true> s(0);
    for (int k = 0; k < 3; ++k)
    {
      if (!std::isfinite(rounded[k]))
        return std::numeric_limits<double>::infinity();
      const Exact_rational error = p[k] - Exact_rational(rounded[k]);
      s += CGAL::square(number_cast<Interval_nt<true>>(error));
    }
    return CGAL::sqrt(s).sup();
  }

  std::vector<Double_point> m_points;
  std::map<Exact_point, std::size_t> m_corners;
  double m_distance = 0;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_STORE_H
