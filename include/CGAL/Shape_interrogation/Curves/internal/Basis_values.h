// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_BASIS_VALUES_H
#define CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_BASIS_VALUES_H

// The values and two derivatives of the basis functions that are not zero at a parameter, and the
// Bernstein basis by its recursion B_i <- s B_i + t B_{i-1}, s = 1 - t, which needs no division.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Degrees as template arguments: a number that is known when compiling, or one of these two, of
// which the first stores its numbers in place, so that no call allocates.
constexpr int up_to_seven = -1;
constexpr int any_degree = -2;

template <int Degree>
using Degree_constant = std::integral_constant<int, Degree>;

// Calls f with the constant that serves both degrees. Unrolled code pays for light numbers only,
// and exact numbers allocate by themselves.
template <class NT, class Function>
auto with_degrees(int m, int n, Function f)
{
  if constexpr (Number_type_traits<NT>::is_light)
    if (m == 3 && n == 3)
      return f(Degree_constant<3>());
  if constexpr (!Number_type_traits<NT>::is_exact)
    if (m < 8 && n < 8)
      return f(Degree_constant<up_to_seven>());
  return f(Degree_constant<any_degree>());
}

// Row k of the table holds the derivatives of order k of the degree + 1 functions.
template <class NT, int Degree>
class Basis_values
{
public:
  explicit Basis_values(int degree) : m_degree(degree)
  {
    if constexpr (Degree == any_degree)
      for (auto& row : m_rows)
        row.assign(degree + 1, NT(0));
  }

  int degree() const { return Degree >= 0 ? Degree : m_degree; }
  NT& operator()(int order, int i) { return m_rows[order][i]; }
  const NT& operator()(int order, int i) const { return m_rows[order][i]; }

private:
  static constexpr int capacity = Degree >= 0 ? Degree + 1 : 8;
  using Row =
    std::conditional_t<Degree == any_degree, std::vector<NT>, std::array<NT, capacity>>;

  int m_degree;
  std::array<Row, 3> m_rows;
};

// y += c x for a point x that is given by its first number.
template <class NT, std::size_t Dim>
void add_multiple(std::array<NT, Dim>& y, const NT& c, const NT* x)
{
  for (std::size_t d = 0; d < Dim; ++d)
    y[d] += c * x[d];
}

// The sums of one coordinate of a row of points, `stride` numbers apart, with the basis and its
// derivatives of the orders 1 and 2.
template <class Row, class NT, int Degree>
std::array<NT, 3> sum_row(Row row, int stride, const Basis_values<NT, Degree>& b)
{
  NT value = b(0, 0) * row[0], first = b(1, 0) * row[0], second = b(2, 0) * row[0];
  for (int i = 1; i <= b.degree(); ++i)
  {
    const NT& x = row[i * stride];
    value += b(0, i) * x;
    first += b(1, i) * x;
    second += b(2, i) * x;
  }
  return {value, first, second};
}

// From the functions of degree n - 1 (n of them) to the derivatives of those of degree n:
// n (b_{i-1} - b_i), where the weight w(i) is n for the Bernstein basis.
template <class NT, int Degree, class Weight>
void differentiate(Basis_values<NT, Degree>& b, int from, int to, int n, Weight weight)
{
  NT before(0);
  for (int i = 0; i < n; ++i)
  {
    const NT next = weight(i) * b(from, i);
    b(to, i) = before - next;
    before = next;
  }
  b(to, n) = before;
}

// The Bernstein polynomials of the given degree >= 1 at t, valid in any ring and for any t.
template <int Degree, class NT>
Basis_values<NT, Degree> bernstein_basis(int degree, const NT& t)
{
  Basis_values<NT, Degree> b(degree);
  const int n = b.degree();
  const NT s = NT(1) - t;
  b(0, 0) = NT(1);
  b(2, 0) = NT(0);
  b(2, 1) = NT(0);
  for (int r = 1; r <= n; ++r)
  {
    const NT w(r);
    const auto weight = [&w](int) -> const NT& { return w; };
    if (r == n - 1)
      differentiate(b, 0, 2, r, weight);
    if (r == n)
    {
      differentiate(b, 0, 1, r, weight);
      if (n > 1)
        differentiate(b, 2, 2, r, weight);
    }
    b(0, r) = t * b(0, r - 1);
    for (int i = r - 1; i > 0; --i)
      b(0, i) = s * b(0, i) + t * b(0, i - 1);
    b(0, 0) = s * b(0, 0);
  }
  return b;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_BASIS_VALUES_H
