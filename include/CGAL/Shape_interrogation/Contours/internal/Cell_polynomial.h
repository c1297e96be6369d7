// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_POLYNOMIAL_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_POLYNOMIAL_H

// A polynomial on a cell in floating point: its Bernstein coefficients with one bound of their
// error, so that a sign read from them is certain.

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The unit of rounding, with room for the second order.
constexpr double rounding_unit = 1.2e-16;

// The sign of numbers known up to `error`; ZERO where it is not certain or not the same.
inline CGAL::Sign common_sign(const double* b, std::size_t size, double error)
{
  double low = b[0], high = b[0];
  for (std::size_t i = 1; i < size; ++i)
  {
    low = (std::min)(low, b[i]);
    high = (std::max)(high, b[i]);
  }
  return low > error ? POSITIVE : high < -error ? NEGATIVE : ZERO;
}

// One variable: coefficients and error.
struct Edge_coefficients
{
  std::vector<double> b;
  double error;

  // The value at t in [0, 1], up to value_error().
  double value(double t) const
  {
    const std::size_t n = b.size() - 1;
    const double w = 1 - t;
    double sum = b[0] * w, power = 1, choose = 1;
    for (std::size_t i = 1; i < n; ++i)
    {
      power *= t;
      choose *= double(n - i + 1) / i;
      sum = (sum + power * choose * b[i]) * w;
    }
    return n == 0 ? b[0] : sum + power * t * b[n];
  }

  double value_error() const { return error + 8 * rounding_unit * b.size() * greatest(); }

  // The changes of sign, where no error can change their number.
  std::optional<int> certain_variations() const
  {
    int variations = 0;
    CGAL::Sign last = common_sign(b.data(), 1, error);
    bool is_open = false;
    if (last == ZERO)
      return std::nullopt;
    for (std::size_t i = 1; i < b.size(); ++i)
    {
      const CGAL::Sign sign = common_sign(&b[i], 1, error);
      // One uncertain sign between different ones changes nothing.
      if ((sign == ZERO && is_open) || (is_open && sign == last))
        return std::nullopt;
      is_open = sign == ZERO;
      if (is_open)
        continue;
      variations += sign != last;
      last = sign;
    }
    return is_open ? std::nullopt : std::optional<int>(variations);
  }

  double greatest() const
  {
    double m = 0;
    for (double x : b)
      m = (std::max)(m, std::fabs(x));
    return m;
  }

  // The part on [s, t], 0 <= s < t <= 1.
  Edge_coefficients restricted(double s, double t) const
  {
    if (s > 0)
      return split(s)[1].restricted(0, (t - s) / (1 - s));
    return t < 1 ? split(t)[0] : *this;
  }

  // The parts on [0, t] and [t, 1], t in [0, 1].
  std::array<Edge_coefficients, 2> split(double t) const
  {
    const std::size_t n = b.size() - 1;
    const double e = error + 4 * rounding_unit * n * greatest();
    std::array<Edge_coefficients, 2> parts{Edge_coefficients{b, e}, Edge_coefficients{b, e}};
    std::vector<double>& row = parts[1].b;
    for (std::size_t k = 1; k <= n; ++k)
    {
      for (std::size_t i = 0; i + k <= n; ++i)
        row[i] = (1 - t) * row[i] + t * row[i + 1];
      parts[0].b[k] = row[0];
    }
    return parts;
  }
};

// Two variables, on a cell: element i (n + 1) + j, i along u.
class Cell_polynomial
{
public:
  Cell_polynomial(const std::array<int, 2>& degree, std::vector<double> b, double error)
    : m_degree(degree), m_b(std::move(b)), m_error(error)
  {}

  const std::array<int, 2>& degree() const { return m_degree; }

  double greatest() const
  {
    double m = 0;
    for (double x : m_b)
      m = (std::max)(m, std::fabs(x));
    return m;
  }

  // Whether the error leaves nothing of the signs.
  bool is_worn_out() const { return greatest() < 256 * m_error; }

  CGAL::Sign sign() const { return common_sign(m_b.data(), m_b.size(), m_error); }

  CGAL::Sign sign_at_corner(int i, int j) const
  {
    return common_sign(&m_b[i * m_degree[0] * columns() + j * m_degree[1]], 1, m_error);
  }

  // The sign of the partial derivative on the whole cell, if it has one, and how much the
  // polynomial varies in that variable.
  CGAL::Sign derivative_sign(int axis, double& variation) const
  {
    double low = HUGE_VAL, high = -HUGE_VAL;
    const int rows = m_degree[0] + (axis == 0 ? 0 : 1), row = columns();
    const int inner = m_degree[1] + (axis == 1 ? 0 : 1), step = axis == 0 ? row : 1;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < inner; ++j)
      {
        const double difference = m_b[i * row + j + step] - m_b[i * row + j];
        low = (std::min)(low, difference);
        high = (std::max)(high, difference);
      }
    if (m_degree[axis] == 0)
      low = high = 0;
    variation = (std::max)(std::fabs(low), std::fabs(high));
    const double e = 2 * m_error + rounding_unit * variation;
    return low > e ? POSITIVE : high < -e ? NEGATIVE : ZERO;
  }

  // The polynomials on the two parts of the cell, cut at t in (0, 1) across the axis.
  std::array<Cell_polynomial, 2> split(int axis, double t) const
  {
    std::array<Cell_polynomial, 2> parts{*this, *this};
    const double e = m_error + 4 * rounding_unit * m_degree[axis] * greatest();
    parts[0].m_error = parts[1].m_error = e;
    if (axis == 0)
      cut_rows(parts, t);
    else
      cut_columns(parts, t);
    return parts;
  }

  // The polynomial on an edge of the cell: where the variable `axis` is at its end.
  Edge_coefficients edge(int axis, int end) const
  {
    Edge_coefficients edge{{}, m_error};
    const int n = columns();
    if (axis == 0)
      edge.b.assign(m_b.begin() + end * m_degree[0] * n, m_b.begin() + (end * m_degree[0] + 1) * n);
    else
      for (int i = 0; i <= m_degree[0]; ++i)
        edge.b.push_back(m_b[i * n + end * m_degree[1]]);
    return edge;
  }

  // The polynomial on the line where the variable `axis` has the local value t.
  Edge_coefficients line(int axis, double t) const { return split(axis, t)[1].edge(axis, 0); }

private:
  int columns() const { return m_degree[1] + 1; }

  void cut_rows(std::array<Cell_polynomial, 2>& parts, double t) const
  {
    const int m = m_degree[0], n = columns();
    double* row = parts[1].m_b.data();
    for (int k = 1; k <= m; ++k)
    {
      for (int x = 0; x < (m - k + 1) * n; ++x)
        row[x] = (1 - t) * row[x] + t * row[x + n];
      std::copy_n(row, n, parts[0].m_b.data() + k * n);
    }
  }

  void cut_columns(std::array<Cell_polynomial, 2>& parts, double t) const
  {
    const int m = m_degree[0], n = m_degree[1];
    for (int i = 0; i <= m; ++i)
    {
      double* row = parts[1].m_b.data() + i * (n + 1);
      for (int k = 1; k <= n; ++k)
      {
        for (int j = 0; j + k <= n; ++j)
          row[j] = (1 - t) * row[j] + t * row[j + 1];
        parts[0].m_b[i * (n + 1) + k] = row[0];
      }
    }
  }

  std::array<int, 2> m_degree;
  std::vector<double> m_b;
  double m_error;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_CELL_POLYNOMIAL_H
