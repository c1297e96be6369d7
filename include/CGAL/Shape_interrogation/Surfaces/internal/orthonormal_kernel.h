// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORTHONORMAL_KERNEL_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORTHONORMAL_KERNEL_H

// An orthonormal basis of the kernel of a Jacobian, and the steps that it allows.

#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Sparse_elimination.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline double dot_product(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

inline void add_multiple(std::vector<double>& y, double c, const std::vector<double>& x)
{
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += c * x[i];
}

// That of the largest absolute value or of the last one that is no number; -1 if there is none.
inline int index_of_largest(const std::vector<double>& v)
{
  int index = -1;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (index < 0 || !(std::fabs(v[i]) <= std::fabs(v[index])))
      index = static_cast<int>(i);
  return index;
}

inline double largest(const std::vector<double>& v)
{
  return v.empty() ? 0 : std::fabs(v[index_of_largest(v)]);
}

// The shortest step meets contradictory conditions as well as it can.
inline bool are_met(const std::vector<N_space_condition>& conditions,
                    const std::vector<double>& excess, double size)
{
  for (std::size_t c = 0; c < conditions.size(); ++c)
  {
    const std::vector<double>& a = conditions[c].coefficients;
    const double length = std::sqrt(dot_product(a, a));
    if (!(std::fabs(excess[c]) <= 1e-9 * (length * size + std::fabs(conditions[c].value))))
      return false;
  }
  return true;
}

class Orthonormal_kernel
{
public:
  // Gram and Schmidt twice: the second time removes what the first has left by cancellation.
  void compute(const Sparse_elimination<double>& elimination, int dimension)
  {
    m_basis.resize(dimension);
    for (int i = 0; i < dimension; ++i)
    {
      std::vector<double>& v = m_basis[i];
      elimination.kernel_vector(i, v);
      for (int pass = 0; pass < 2; ++pass)
      {
        for (int j = 0; j < i; ++j)
          add_multiple(v, -dot_product(v, m_basis[j]), m_basis[j]);
        const double length = std::sqrt(dot_product(v, v));
        for (double& x : v)
          x /= length;
      }
    }
  }

  const std::vector<std::vector<double>>& basis() const { return m_basis; }

  // Leaves the shortest step to the same tangent plane.
  void remove_from(std::vector<double>& step) const
  {
    for (const std::vector<double>& v : m_basis)
      add_multiple(step, -dot_product(step, v), v);
  }

  // Moves the step along the kernel, as little as possible, so that a.step + excess = 0 for all
  // conditions a.
  void satisfy(const std::vector<N_space_condition>& conditions, const std::vector<double>& excess,
               std::vector<double>& step) const
  {
    if (conditions.empty())
      return;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;
    Matrix a(conditions.size(), m_basis.size());
    Vector b(conditions.size());
    for (std::size_t c = 0; c < conditions.size(); ++c)
    {
      for (std::size_t i = 0; i < m_basis.size(); ++i)
        a(c, i) = dot_product(conditions[c].coefficients, m_basis[i]);
      b(c) = -excess[c] - dot_product(conditions[c].coefficients, step);
    }
    const Vector z = a.completeOrthogonalDecomposition().solve(b);
    for (std::size_t i = 0; i < m_basis.size(); ++i)
      add_multiple(step, z(i), m_basis[i]);
  }

private:
  std::vector<std::vector<double>> m_basis;
};

inline std::string coordinates_text(const std::vector<double>& p)
{
  std::string text;
  for (std::size_t i = 0; i < p.size() && i < 8; ++i)
    text += (i ? ", " : "") + text_of(p[i]);
  return p.size() > 8 ? text + ", ..." : text;
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORTHONORMAL_KERNEL_H
