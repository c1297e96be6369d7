// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BRANCH_DETECTOR_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BRANCH_DETECTOR_H

// Tells whether a step on a curve or surface in n-space passes a point where the equations become
// dependent. At a crossing of two branches, or the apex of a cone, the determinant of the Jacobian,
// completed by the tangent vectors, changes its sign between points on either side, however near to
// each other they are.

#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <Eigen/Dense>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Branch_detector
{
public:
  // Dense matrices are used: for systems with more variables nothing is detected.
  static constexpr int most_variables = 96;

  using Tangents = std::vector<std::vector<double>>;

  // `rank` is the number of independent equations and conditions.
  Branch_detector(const N_space_system& system, std::vector<N_space_condition> fixed, int rank)
    : m_system(system), m_fixed(std::move(fixed)), m_n(system.number_of_variables()), m_rank(rank)
  {}

  bool is_able() const { return m_n <= most_variables; }

  // Whether there are just as many rows as needed: a change of the sign then is no matter of
  // choice.
  bool is_square() const
  {
    return m_system.number_of_equations() + static_cast<int>(m_fixed.size()) == m_rank;
  }

  // Whether the same independent rows have determinants of opposite sign at both points. That
  // happens also where only these rows become dependent: see independence().
  bool may_branch(const std::vector<double>& p, const Tangents& tp, const std::vector<double>& q,
                  const Tangents& tq) const
  {
    const Eigen::VectorXd sizes = row_sizes(p);
    const Eigen::MatrixXd jp = jacobian(p, sizes), jq = jacobian(q, sizes);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jq.transpose());
    return sign(jp, tp, qr.colsPermutation().indices()) * sign(jq, tq,
                                                               qr.colsPermutation().indices()) < 0;
  }

  // The units of the rows at a point: those of the equations shall not matter.
  Eigen::VectorXd row_sizes(const std::vector<double>& p) const
  {
    Eigen::VectorXd sizes =
      jacobian(p, Eigen::VectorXd::Ones(m_system.number_of_equations() +
                                        static_cast<int>(m_fixed.size()))).rowwise().norm();
    for (double& size : sizes)
      size = size > 0 ? size : 1;
    return sizes;
  }

  // The distance of all rows together, in the given units, from lower rank, as a part of their
  // size.
  double independence(const std::vector<double>& p, const Eigen::VectorXd& sizes) const
  {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian(p, sizes));
    const auto& values = svd.singularValues();
    return values.size() < m_rank || !(values(0) > 0) ? 0 : values(m_rank - 1) / values(0);
  }

private:
  Eigen::MatrixXd jacobian(const std::vector<double>& p, const Eigen::VectorXd& sizes) const
  {
    const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
    const std::vector<double> gradient = m_system.tape().gradient(p);
    const int m = m_system.number_of_equations();
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(m + static_cast<int>(m_fixed.size()), m_n);
    for (int k = 0; k < m; ++k)
      for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
        j(k, pattern.columns[e]) = gradient[e] / sizes(k);
    for (std::size_t c = 0; c < m_fixed.size(); ++c)
      for (int i = 0; i < m_n; ++i)
        j(m + static_cast<int>(c), i) =
          m_fixed[c].coefficients[i] / sizes(m + static_cast<int>(c));
    return j;
  }

  template <class Rows>
  int sign(const Eigen::MatrixXd& j, const Tangents& tangents, const Rows& rows) const
  {
    Eigen::MatrixXd square(m_n, m_n);
    for (int k = 0; k < m_rank; ++k)
      square.row(k) = j.row(rows(k)).normalized();
    for (int k = m_rank; k < m_n; ++k)
      square.row(k) = Eigen::Map<const Eigen::RowVectorXd>(tangents[k - m_rank].data(), m_n);
    const double d = square.partialPivLu().determinant();
    return d > 0 ? 1 : d < 0 ? -1 : 0;
  }

  const N_space_system& m_system;
  std::vector<N_space_condition> m_fixed;
  int m_n, m_rank;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_BRANCH_DETECTOR_H
