// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_GRID_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_GRID_H

// Finds the vertices near a point of n-space while vertices are added. (The search structures of
// CGAL are built once for all points.) Cells are looked up by the three coordinates along which the
// vertices spread most, with one grid for each power of two of their units.


#include <Eigen/Dense>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Vertex_grid
{
public:
  explicit Vertex_grid(int n) : m_n(n), m_axes(3, std::vector<double>(n, 0.))
  {
    for (int k = 0; k < 3; ++k)
      m_axes[k][k] = 1;
  }

  // Vertices are numbered as they come.
  void insert(const std::vector<double>& x, double unit)
  {
    m_points.insert(m_points.end(), x.begin(), x.end());
    m_levels_of.push_back(static_cast<int>(std::ceil(std::log2(unit))));
    const std::size_t size = m_levels_of.size();
    if (size == m_next_turn)
    {
      m_next_turn *= 4;
      turn_axes();
    }
    else
      store(static_cast<int>(size) - 1);
  }

  // Calls f for all vertices within `radius` times the mean of their unit and the given one, and
  // for some that are farther.
  template <class Function>
  void for_each_near(const std::vector<double>& x, double unit, double radius, Function f) const
  {
    const Place q = place(x.data());
    for (const auto& [level, cells] : m_levels)
    {
      const double other = std::ldexp(1., level), reach = radius * (unit + other) / 2;
      const double width = cell_width(level);
      Cell low, high;
      double count = 1;
      for (int k = 0; k < 3; ++k)
      {
        low[k] = index((q[k] - reach) / width);
        high[k] = index((q[k] + reach) / width);
        count *= static_cast<double>(high[k] - low[k] + 1);
      }
      const auto visit = [&](const std::vector<Entry>& entries) {
        for (const Entry& e : entries)
          if (is_within(e, q, x, reach * reach))
            f(e.vertex);
      };
      if (count > static_cast<double>(cells.size()))
      {
        for (const auto& cell : cells)
          visit(cell.second);
        continue;
      }
      Cell c;
      for (c[0] = low[0]; c[0] <= high[0]; ++c[0])
        for (c[1] = low[1]; c[1] <= high[1]; ++c[1])
          for (c[2] = low[2]; c[2] <= high[2]; ++c[2])
          {
            const auto found = cells.find(c);
            if (found != cells.end())
              visit(found->second);
          }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  using Place = std::array<double, 3>;

  struct Entry
  {
    int vertex;
    Place place;
  };

  static double cell_width(int level) { return std::ldexp(2.5, level); }

  static std::int64_t index(double x)
  {
    return static_cast<std::int64_t>(std::floor((std::min)((std::max)(x, -1e15), 1e15)));
  }

  Place place(const double* x) const
  {
    Place q{0, 0, 0};
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < m_n; ++i)
        q[k] += m_axes[k][i] * x[i];
    return q;
  }

  bool is_within(const Entry& e, const Place& q, const std::vector<double>& x, double square) const
  {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += (e.place[k] - q[k]) * (e.place[k] - q[k]);
    if (sum > square)
      return false;
    const double* y = &m_points[static_cast<std::size_t>(e.vertex) * m_n];
    sum = 0;
    for (int i = 0; i < m_n; ++i)
      sum += (y[i] - x[i]) * (y[i] - x[i]);
    return sum <= square;
  }

  void store(int vertex)
  {
    const int level = m_levels_of[vertex];
    const Place q = place(&m_points[static_cast<std::size_t>(vertex) * m_n]);
    const double width = cell_width(level);
    m_levels[level][{index(q[0] / width), index(q[1] / width), index(q[2] / width)}].push_back(
      {vertex, q});
  }

  // Takes the principal axes of the vertices so far, and stores all of them anew.
  void turn_axes()
  {
    const Eigen::Map<const Eigen::MatrixXd> points(m_points.data(), m_n,
                                                   static_cast<Eigen::Index>(m_levels_of.size()));
    const Eigen::MatrixXd centred = points.colwise() - points.rowwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(centred * centred.transpose());
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < m_n; ++i)
        m_axes[k][i] = solver.eigenvectors()(i, m_n - 1 - k);
    m_levels.clear();
    for (std::size_t v = 0; v < m_levels_of.size(); ++v)
      store(static_cast<int>(v));
  }

  int m_n;
  std::vector<std::vector<double>> m_axes; // orthonormal, so that distances do not grow
  std::size_t m_next_turn = 64;
  std::vector<double> m_points;
  std::vector<int> m_levels_of;
  std::map<int, std::unordered_map<Cell, std::vector<Entry>, boost::hash<Cell>>> m_levels;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_VERTEX_GRID_H
