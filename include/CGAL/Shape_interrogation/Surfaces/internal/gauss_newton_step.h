// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_GAUSS_NEWTON_STEP_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_GAUSS_NEWTON_STEP_H

// The shortest least-squares step of all linearised equations, dependent or contradictory ones
// included.

#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline void gauss_newton_step(const Sparse_pattern& pattern, const std::vector<double>& gradient,
                              const std::vector<double>& values,
                              const std::vector<N_space_condition>& conditions,
                              const std::vector<double>& excess, int n, std::vector<double>& step)
{
  const int m = static_cast<int>(values.size());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(m + conditions.size(), n);
  Eigen::VectorXd right_hand_side(m + conditions.size());
  for (int k = 0; k < m; ++k)
  {
    for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
      jacobian(k, pattern.columns[e]) = gradient[e];
    right_hand_side(k) = -values[k];
  }
  for (std::size_t c = 0; c < conditions.size(); ++c)
  {
    for (int i = 0; i < n; ++i)
      jacobian(m + c, i) = conditions[c].coefficients[i];
    right_hand_side(m + c) = -excess[c];
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-9); // of small singular values a step would be long and useless
  const Eigen::VectorXd x = decomposition.compute(jacobian).solve(right_hand_side);
  step.assign(x.data(), x.data() + n);
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_GAUSS_NEWTON_STEP_H
