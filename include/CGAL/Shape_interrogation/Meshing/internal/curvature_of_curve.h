// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CURVATURE_OF_CURVE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CURVATURE_OF_CURVE_H

// The curvature of the projection of a curve in n-space at one of its points: with a tangent t of
// the solution, J t = 0, the second derivative a along the curve satisfies J a + (t'H_k t)_k = 0.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// None where the curve or its projection is singular. A section is one row more, without second
// derivatives.
inline std::optional<double> curvature_of_curve(const N_space_system& system,
                                                const std::optional<N_space_condition>& section,
                                                const std::vector<double>& p)
{
  using J = Jet<double, 1, 2>;
  const int n = system.number_of_variables(), m = system.number_of_equations();
  const Sparse_pattern& pattern = system.tape().gradient_pattern();
  const std::vector<double> gradient = system.tape().gradient(p);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(m + (section ? 1 : 0), n);
  for (int k = 0; k < m; ++k)
    for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
      jacobian(k, pattern.columns[e]) = gradient[e];
  for (int i = 0; section && i < n; ++i)
    jacobian(m, i) = section->coefficients[i];
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullV | Eigen::ComputeThinU);
  const auto& values = svd.singularValues();
  if (values.size() < n - 1 || !(values(n - 2) > 1e-10 * values(0)))
    return std::nullopt;
  const Eigen::VectorXd t = svd.matrixV().col(n - 1);
  std::vector<J> moving(n);
  for (int i = 0; i < n; ++i)
    moving[i] = J::along(p[i], {t(i)});
  const std::vector<J> bent = system.tape().evaluate(moving);
  Eigen::VectorXd forms = Eigen::VectorXd::Zero(jacobian.rows());
  for (int k = 0; k < m; ++k)
    forms(k) = bent[k].derivative(0, 0);
  // The least solution of the independent rows; the tangent is no part of it.
  Eigen::VectorXd a = Eigen::VectorXd::Zero(n);
  const Eigen::VectorXd right_hand_side = svd.matrixU().transpose() * forms;
  for (int k = 0; k < n - 1; ++k)
    a -= right_hand_side(k) / values(k) * svd.matrixV().col(k);
  const Coordinates<double, 3> x{t(0), t(1), t(2)}, y{a(0), a(1), a(2)};
  const Coordinates<double, 3> c = cross(x, y);
  const double speed = std::sqrt(dot(x, x));
  if (!(speed > 1e-8))
    return std::nullopt;
  return std::sqrt(dot(c, c)) / (speed * speed * speed);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_CURVATURE_OF_CURVE_H
