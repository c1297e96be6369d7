// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_SEEDS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_SEEDS_H

// Points on the components of an implicit surface that a grid over the box meets: a few spread
// points of each connected set of cells in which the function changes its sign.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

using Mesh_box = std::array<std::array<double, 2>, 3>;

inline double squared_distance(const Coordinates<double, 3>& a, const Coordinates<double, 3>& b)
{
  const Coordinates<double, 3> d{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return dot(d, d);
}

// The point between two points with values of different signs.
template <class Function>
Coordinates<double, 3> bisect(Function& f, Coordinates<double, 3> a, Coordinates<double, 3> b)
{
  const bool a_is_positive = f(a) > 0;
  for (int i = 0; i < 60; ++i)
  {
    const Coordinates<double, 3> m{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    ((f(m) > 0) == a_is_positive ? a : b) = m;
  }
  return a;
}

// At most `count` points, each as far as can be from those before.
inline std::vector<Coordinates<double, 3>>
spread_points(const std::vector<Coordinates<double, 3>>& points, std::size_t count)
{
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  std::vector<Coordinates<double, 3>> chosen;
  std::size_t next = 0;
  while (chosen.size() < count && next < points.size() && distance[next] > 0)
  {
    chosen.push_back(points[next]);
    for (std::size_t i = 0; i < points.size(); ++i)
      distance[i] = (std::min)(distance[i], squared_distance(points[i], chosen.back()));
    next = std::max_element(distance.begin(), distance.end()) - distance.begin();
  }
  return chosen;
}

class Seed_grid
{
public:
  template <class Function>
  Seed_grid(Function& f, const Mesh_box& box, int cells)
    : m_box(box), m_cells(cells), m_positive((cells + 1) * (cells + 1) * (cells + 1))
  {
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j)
        for (int k = 0; k <= cells; ++k)
          m_positive[node(i, j, k)] = f(point(i, j, k)) > 0;
  }

  // Whether the function certainly has both signs: `sign(p)` is 0 where rounding hides it.
  template <class Sign>
  bool has_both_signs(Sign sign) const
  {
    bool found[3] = {false, false, false};
    for (int i = 0; i <= m_cells; ++i)
      for (int j = 0; j <= m_cells; ++j)
        for (int k = 0; k <= m_cells; ++k)
          if (!found[m_positive[node(i, j, k)] ? 2 : 0])
            found[sign(point(i, j, k)) + 1] = true;
    return found[0] && found[2];
  }

  // A few points of each component.
  template <class Function>
  std::vector<Coordinates<double, 3>> seeds(Function& f) const
  {
    std::vector<Coordinates<double, 3>> all;
    std::vector<bool> seen(m_cells * m_cells * m_cells, false);
    for (int i = 0; i < m_cells; ++i)
      for (int j = 0; j < m_cells; ++j)
        for (int k = 0; k < m_cells; ++k)
          if (!seen[cell(i, j, k)] && changes_sign(i, j, k))
            for (const auto& p : spread_points(component(f, {i, j, k}, seen), 20))
              all.push_back(p);
    return all;
  }

private:
  using Index = std::array<int, 3>;

  int node(int i, int j, int k) const { return (i * (m_cells + 1) + j) * (m_cells + 1) + k; }
  int cell(int i, int j, int k) const { return (i * m_cells + j) * m_cells + k; }

  Coordinates<double, 3> point(int i, int j, int k) const
  {
    const Index index{i, j, k};
    Coordinates<double, 3> p;
    for (int d = 0; d < 3; ++d)
      p[d] = m_box[d][0] + (m_box[d][1] - m_box[d][0]) * index[d] / m_cells;
    return p;
  }

  bool changes_sign(int i, int j, int k) const
  {
    for (int c = 1; c < 8; ++c)
      if (m_positive[node(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))] !=
          m_positive[node(i, j, k)])
        return true;
    return false;
  }

  // The points on the grid's edges in the cells that are connected with the first one.
  template <class Function>
  std::vector<Coordinates<double, 3>> component(Function& f, const Index& first,
                                                std::vector<bool>& seen) const
  {
    std::vector<Coordinates<double, 3>> points;
    std::vector<Index> waiting{first};
    seen[cell(first[0], first[1], first[2])] = true;
    while (!waiting.empty())
    {
      const Index c = waiting.back();
      waiting.pop_back();
      add_points(f, c, points);
      for (int n = 0; n < 27; ++n)
      {
        const Index o{c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1};
        const bool inside = std::all_of(o.begin(), o.end(),
                                        [&](int x) { return x >= 0 && x < m_cells; });
        if (!inside || seen[cell(o[0], o[1], o[2])] || !changes_sign(o[0], o[1], o[2]))
          continue;
        seen[cell(o[0], o[1], o[2])] = true;
        waiting.push_back(o);
      }
    }
    return points;
  }

  // On the three edges from the cell's first corner.
  template <class Function>
  void add_points(Function& f, const Index& c, std::vector<Coordinates<double, 3>>& points) const
  {
    for (int d = 0; d < 3; ++d)
    {
      Index e = c;
      ++e[d];
      if (m_positive[node(c[0], c[1], c[2])] != m_positive[node(e[0], e[1], e[2])])
        points.push_back(bisect(f, point(c[0], c[1], c[2]), point(e[0], e[1], e[2])));
    }
  }

  const Mesh_box m_box;
  const int m_cells;
  std::vector<bool> m_positive;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_IMPLICIT_SEEDS_H
