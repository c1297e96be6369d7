// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_NEAR_SEGMENTS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_NEAR_SEGMENTS_H

// Segments in the unit square, to be asked whether a point is near one of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Domain_point = std::array<double, 2>;

class Near_segments
{
public:
  explicit Near_segments(double distance)
    : m_distance(distance),
      m_size(static_cast<int>((std::min)(1000.0, std::ceil(1 / distance)))),
      m_cells(std::size_t(m_size) * m_size)
  {}

  void add(const Domain_point& a, const Domain_point& b)
  {
    const auto low = [&](int k) { return cell((std::min)(a[k], b[k]) - m_distance); };
    const auto high = [&](int k) { return cell((std::max)(a[k], b[k]) + m_distance); };
    for (int i = low(0); i <= high(0); ++i)
      for (int j = low(1); j <= high(1); ++j)
        m_cells[std::size_t(i) * m_size + j].push_back({a, b});
  }

  bool is_near(const Domain_point& p) const
  {
    const auto& segments = m_cells[std::size_t(cell(p[0])) * m_size + cell(p[1])];
    return std::any_of(segments.begin(), segments.end(), [&](const auto& s) {
      return distance(p, s[0], s[1]) < m_distance;
    });
  }

private:
  int cell(double x) const
  {
    return (std::min)(m_size - 1, (std::max)(0, static_cast<int>(std::floor(x * m_size))));
  }

  static double distance(const Domain_point& p, const Domain_point& a, const Domain_point& b)
  {
    const double x = b[0] - a[0], y = b[1] - a[1], s = x * x + y * y;
    double t = s > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / s : 0;
    t = (std::min)(1.0, (std::max)(0.0, t));
    return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
  }

  double m_distance;
  int m_size;
  std::vector<std::vector<std::array<Domain_point, 2>>> m_cells;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_NEAR_SEGMENTS_H
