// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_CONTROL_POINTS_H
#define CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_CONTROL_POINTS_H

// Control points with or without weights, as given and as the contiguous numbers that the
// evaluation reads: Dim numbers a point, or (w x, w y, .., w).

#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <CGAL/assertions.h>

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT, class = void>
struct Is_divisible : std::false_type {};
template <class NT>
struct Is_divisible<NT, std::void_t<decltype(std::declval<NT>() / std::declval<NT>())>>
  : std::true_type {};

// Rows of equal length as one sequence.
template <class T>
std::vector<T> in_a_row(const std::vector<std::vector<T>>& rows)
{
  std::vector<T> all;
  for (const std::vector<T>& row : rows)
  {
    CGAL_precondition_msg(row.size() == rows.front().size(),
                          "the rows of control points or weights must have the same length");
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

// Why the rows are not `rows` rows of `columns` items each.
template <class T>
std::optional<std::string> why_no_grid(const char* items, const std::vector<std::vector<T>>& grid,
                                       int rows, int columns)
{
  if (static_cast<int>(grid.size()) != rows)
    return "there are " + std::to_string(grid.size()) + " rows of " + items +
           ", the knots along u need " + std::to_string(rows);
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (static_cast<int>(grid[i].size()) != columns)
      return "row " + std::to_string(i) + " has " + std::to_string(grid[i].size()) + " " + items +
             ", the knots along v need " + std::to_string(columns);
  return std::nullopt;
}

// The point with the given numerators and denominator.
template <class NT, int Dim>
Coordinates<NT, Dim> quotient(const NT* numerators, const NT& denominator)
{
  if constexpr (Is_divisible<NT>::value)
  {
    Coordinates<NT, Dim> p;
    for (int d = 0; d < Dim; ++d)
      p[d] = numerators[d] / denominator;
    return p;
  }
  else
    throw Not_algebraic_error("a rational point needs a division, which this number type lacks");
}

template <class NT, int Dim>
class Control_points
{
public:
  using Point = Coordinates<NT, Dim>;
  using Homogeneous_point = Coordinates<NT, Dim + 1>;

  // Without weights if there are none.
  explicit Control_points(std::vector<Point> points, const std::vector<NT>& weights = {})
    : m_points(std::move(points)), m_rational(!weights.empty())
  {
    CGAL_precondition_msg(weights.empty() || weights.size() == m_points.size(),
                          "there must be as many weights as control points, or none");
    const int dimension = m_rational ? Dim + 1 : Dim;
    m_numbers.reserve(m_points.size() * dimension);
    for (std::size_t k = 0; k < m_points.size(); ++k)
    {
      for (int d = 0; d < Dim; ++d)
        m_numbers.push_back(m_rational ? NT(m_points[k][d] * weights[k]) : m_points[k][d]);
      if (m_rational)
        m_numbers.push_back(weights[k]);
    }
  }

  // With all weights, some of which may be zero.
  explicit Control_points(const std::vector<Homogeneous_point>& points) : m_rational(true)
  {
    m_numbers.reserve(points.size() * (Dim + 1));
    for (const Homogeneous_point& p : points)
      m_numbers.insert(m_numbers.end(), p.begin(), p.end());
  }

  bool is_rational() const { return m_rational; }
  int size() const { return static_cast<int>(m_numbers.size()) / (m_rational ? Dim + 1 : Dim); }
  const NT* numbers() const { return m_numbers.data(); }

  NT weight(int k) const { return m_rational ? m_numbers[k * (Dim + 1) + Dim] : NT(1); }

  // Divides only where the homogeneous point is what was given.
  Point point(int k) const
  {
    if (!m_points.empty())
      return m_points[k];
    return quotient<NT, Dim>(&m_numbers[k * (Dim + 1)], m_numbers[k * (Dim + 1) + Dim]);
  }

  Homogeneous_point homogeneous_point(int k) const
  {
    Homogeneous_point p;
    for (int d = 0; d < Dim; ++d)
      p[d] = m_numbers[k * (m_rational ? Dim + 1 : Dim) + d];
    p[Dim] = weight(k);
    return p;
  }

  // Converts what was given, so that nothing is rounded before.
  template <class To>
  Control_points<To, Dim> cast() const
  {
    if (m_points.empty())
      return Control_points<To, Dim>(converted<To>(all(&Control_points::homogeneous_point)));
    std::vector<To> to;
    for (const NT& w : weights())
      to.push_back(number_cast<To>(w));
    return Control_points<To, Dim>(converted<To>(m_points), to);
  }

  // The points in another order: the new k-th is the old order(k)-th.
  template <class Order>
  Control_points reordered(Order order) const
  {
    const auto pick = [&](const auto& from) {
      auto to = from;
      for (std::size_t k = 0; k < from.size(); ++k)
        to[k] = from[order(static_cast<int>(k))];
      return to;
    };
    if (m_points.empty())
      return Control_points(pick(all(&Control_points::homogeneous_point)));
    return Control_points(pick(m_points), pick(weights()));
  }

private:
  template <class T>
  std::vector<T> all(T (Control_points::*member)(int) const) const
  {
    std::vector<T> items;
    for (int k = 0; k < size(); ++k)
      items.push_back((this->*member)(k));
    return items;
  }

  std::vector<NT> weights() const
  {
    return m_rational ? all(&Control_points::weight) : std::vector<NT>();
  }

  template <class To, std::size_t d>
  static std::vector<std::array<To, d>> converted(const std::vector<std::array<NT, d>>& from)
  {
    std::vector<std::array<To, d>> to(from.size());
    for (std::size_t k = 0; k < from.size(); ++k)
      for (std::size_t i = 0; i < d; ++i)
        to[k][i] = number_cast<To>(from[k][i]);
    return to;
  }

  std::vector<Point> m_points;
  std::vector<NT> m_numbers;
  bool m_rational;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_CONTROL_POINTS_H
