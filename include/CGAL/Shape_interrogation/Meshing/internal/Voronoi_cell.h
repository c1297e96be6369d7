// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VORONOI_CELL_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VORONOI_CELL_H

// The Voronoi cell of the origin among points of a plane, whose corners are the centres of the
// Delaunay triangles at the origin.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Voronoi_cell
{
public:
  struct Corner
  {
    double x, y;
    int before, after; // the points of the edges that meet here counterclockwise, -1 for the frame
  };

  // The cell of the origin alone, in a square frame.
  explicit Voronoi_cell(double half_width)
    : m_corners{{-half_width, -half_width, -1, -1},
                {half_width, -half_width, -1, -1},
                {half_width, half_width, -1, -1},
                {-half_width, half_width, -1, -1}}
  {}

  const std::vector<Corner>& corners() const { return m_corners; }

  // Cuts the cell by the bisector of the origin and the point with the given index.
  void add(double x, double y, int index)
  {
    const double limit = (x * x + y * y) / 2;
    const auto excess = [&](const Corner& c) { return c.x * x + c.y * y - limit; };
    m_next.clear();
    bool is_cut = false;
    for (std::size_t i = 0; i < m_corners.size(); ++i)
    {
      const Corner &a = m_corners[i], &b = m_corners[(i + 1) % m_corners.size()];
      const double ea = excess(a), eb = excess(b);
      if (ea <= 0)
        m_next.push_back(a);
      else
        is_cut = true;
      if ((ea <= 0) != (eb <= 0))
      {
        const double t = ea / (ea - eb);
        Corner c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.after, index};
        if (ea > 0) // the bisector ends here
          c = {c.x, c.y, index, a.after};
        m_next.push_back(c);
      }
    }
    if (is_cut)
      m_corners.swap(m_next);
  }

  // The square of the largest distance of a corner.
  double squared_radius() const
  {
    double r = 0;
    for (const Corner& c : m_corners)
      r = (std::fmax)(r, c.x * c.x + c.y * c.y);
    return r;
  }

private:
  std::vector<Corner> m_corners, m_next;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VORONOI_CELL_H
