// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CROSS_CHECKS_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CROSS_CHECKS_H

// Chuang and Hoffmann's own ways to a normal curvature, Theorem 3 and Corollary 5, step by step.
// They cost more than N_space_evaluator and share nothing with it but the compiled equations.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/null_vectors.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <class NT>
NT projected_squared_length(const std::vector<NT>& v)
{
  NT length = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  return length;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is the combined Hessian \f$ H_0 = \sum \alpha_k H_k \f$ of a system in n-space, an
 * \f$ n \times n \f$ matrix that no curvature needs.
 *
 * With \f$ \sum \alpha_k \nabla f_k = (N, 0, \ldots, 0) \f$ (the multipliers of `N_space_shape_3`)
 * the normal curvature of the projection in the direction of a tangent vector \f$ v \f$ of n-space
 * is \f$ v^T H_0 v / (|N| \, |\pi v|^2) \f$ in the sign of `Local_shape_3`. (The paper has the
 * opposite sign.) The form on tangent vectors does not depend on the choice of the multipliers or
 * of the equations; single entries do.
 *
 * \tparam NT a number type
 *
 * Complexity: \f$ n (n - 1) / 2 \f$ evaluations of the equations over second-order jets.
 *
 * Source: Chuang and Hoffmann, Corollary 5; the gradients are not normalised (their Lemma 4).
 * \sa `N_space_evaluator`
 */
template <class NT>
class Combined_hessian
{
public:
  /*!
   * \brief computes the matrix at `point` by jets along pairs of axes.
   * \pre `point` has a coordinate for each variable, `multipliers` a number for each equation
   */
  Combined_hessian(const N_space_system& system, const std::vector<NT>& point,
                   const std::vector<NT>& multipliers)
    : m_n(system.number_of_variables()), m_entries(m_n * m_n, NT(0))
  {
    CGAL_precondition_msg(static_cast<int>(point.size()) == m_n,
                          "the point needs one coordinate for each variable");
    CGAL_precondition_msg(static_cast<int>(multipliers.size()) == system.number_of_equations(),
                          "one multiplier is needed for each equation");
    std::vector<J> moving(point.begin(), point.end()), values(multipliers.size()), workspace;
    for (int i = 0; i < m_n; ++i)
      for (int j = i + 1; j < m_n; ++j)
      {
        moving[i] = J::variable(0, point[i]);
        moving[j] = J::variable(1, point[j]);
        system.tape().evaluate(moving.data(), values.data(), workspace);
        combine(values, multipliers, i, j);
        moving[i] = J(point[i]);
        moving[j] = J(point[j]);
      }
  }

  //! returns the number `n` of rows and columns.
  int dimension() const { return m_n; }

  //! returns the entry in row `i` and column `j`, counted from 0.
  const NT& operator()(int i, int j) const { return m_entries[i * m_n + j]; }

  //! returns \f$ v^T H_0 v \f$.
  NT form(const std::vector<NT>& v) const
  {
    NT sum(0);
    for (int i = 0; i < m_n; ++i)
      for (int j = 0; j < m_n; ++j)
        sum += v[i] * (*this)(i, j) * v[j];
    return sum;
  }

  /*!
   * \brief returns \f$ v^T H_0 v / |\pi v|^2 \f$: the normal curvature in the direction
   * \f$ \pi v \f$ times the length of \f$ N \f$, so that no root is needed. Needs a field.
   * \pre `v` is tangent to the solution, and its projection is not zero
   */
  NT scaled_normal_curvature(const std::vector<NT>& v) const
  {
    NT k = form(v) / internal::projected_squared_length(v);
    return k;
  }

private:
  using J = Jet<NT, 2, 2>;

  void combine(const std::vector<J>& values, const std::vector<NT>& multipliers, int i, int j)
  {
    std::array<NT, 3> h{NT(0), NT(0), NT(0)};
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      h[0] += multipliers[k] * values[k].derivative(0, 0);
      h[1] += multipliers[k] * values[k].derivative(0, 1);
      h[2] += multipliers[k] * values[k].derivative(1, 1);
    }
    m_entries[i * m_n + i] = h[0];
    m_entries[i * m_n + j] = m_entries[j * m_n + i] = h[1];
    m_entries[j * m_n + j] = h[2];
  }

  int m_n;
  std::vector<NT> m_entries;
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a normal of the projected surface and a normal curvature for it.
 */
template <class NT>
struct N_space_normal_curvature
{
  Coordinates<NT, 3> normal; //!< a normal \f$ N \f$, of either orientation and any length
  NT scaled_curvature;       //!< the normal curvature for it, times the length of \f$ N \f$
};

namespace internal {

// The hypersurfaces at a point: gradients as rows, and the numbers L_k(v).v = -v' H_k v of their
// shape operators for the normals grad f_k (Lemma 4).
template <class NT>
struct Hypersurfaces
{
  std::vector<std::vector<NT>> gradients;
  std::vector<NT> shape_operators;

  // L_k(v) is minus the derivative of the normal field along v: one sweep over jets of order 1.
  Hypersurfaces(const N_space_system& system, const std::vector<NT>& point,
                const std::vector<NT>& v)
    : gradients(system.number_of_equations(), std::vector<NT>(point.size(), NT(0))),
      shape_operators(system.number_of_equations(), NT(0))
  {
    using J = Jet<NT, 1, 1>;
    const Sparse_pattern& pattern = system.tape().gradient_pattern();
    std::vector<J> moving, entries(pattern.number_of_entries()), workspace;
    for (std::size_t i = 0; i < point.size(); ++i)
      moving.push_back(J::along(point[i], {v[i]}));
    system.tape().template evaluate_with_gradient<J>(moving.data(), nullptr, entries.data(),
                                                     workspace);
    for (std::size_t k = 0; k < gradients.size(); ++k)
      for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
      {
        gradients[k][pattern.columns[e]] = entries[e].value();
        shape_operators[k] -= entries[e].derivative(0) * v[pattern.columns[e]];
      }
  }
};

// Multipliers with sum alpha_k grad f_k = (n_0, 0, ..., 0) and n_0 not zero, and that n_0. Pure
// syzygies, n_0 = 0, which redundant equations bring, are passed over (MATH: CH-03).
template <class NT>
std::optional<std::pair<std::vector<NT>, Coordinates<NT, 3>>>
normal_combination(const std::vector<std::vector<NT>>& gradients)
{
  const int m = static_cast<int>(gradients.size()), n = static_cast<int>(gradients[0].size());
  std::vector<std::vector<NT>> rows(n - 3, std::vector<NT>(m));
  for (int i = 3; i < n; ++i)
    for (int k = 0; k < m; ++k)
      rows[i - 3][k] = gradients[k][i];
  for (std::vector<NT>& alpha : null_vectors(std::move(rows), m))
  {
    Coordinates<NT, 3> normal{NT(0), NT(0), NT(0)};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < m; ++k)
        normal[i] += alpha[k] * gradients[k][i];
    if (!CGAL::is_zero(dot(normal, normal)))
      return std::make_pair(std::move(alpha), normal);
  }
  return std::nullopt;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief computes a normal curvature of the projected surface from the shape operators of the
 * single hypersurfaces \f$ f_k = 0 \f$.
 *
 * The steps are those of the paper, without its two normalisations, which need roots: the
 * gradients; multipliers whose combination of gradients has only three components, the normal; the
 * numbers \f$ L_k(v) \cdot v \f$; their combination with the multipliers over \f$ |\pi v|^2 \f$.
 * A hypersurface with vanishing gradient, which has no shape operator, gets the multiplier 0.
 *
 * Refused are vectors that are not tangent (`NOT_TANGENT`) or whose projection vanishes
 * (`DEPENDENT_DIRECTIONS`), and points where no combination is normal (`PROJECTION_SINGULAR`).
 * \pre `N_space_surface_3` has an answer at `point`: neither rank nor redundancy is looked at here
 *
 * \tparam NT an exact field number type
 *
 * Complexity: one pass over the equations and their gradients, and a dense elimination.
 *
 * Source: Chuang and Hoffmann, Theorem 3, in the sign of `Local_shape_3`. The normals of the
 * hypersurfaces are gradients of any length throughout; unit normals, as their Lemma 2 has them,
 * would need \f$ L_k(v) \cdot v \f$ divided by the lengths.
 */
template <class NT>
Result<N_space_normal_curvature<NT>>
normal_curvature_by_shape_operators(const N_space_system& system, const std::vector<NT>& point,
                                    const std::vector<NT>& v)
{
  static_assert(Number_type_traits<NT>::is_exact,
                "shape operators of hypersurfaces are combined in exact number types only");
  const internal::Hypersurfaces<NT> surfaces(system, point, v);
  for (const std::vector<NT>& gradient : surfaces.gradients)
  {
    NT slope(0);
    for (std::size_t i = 0; i < v.size(); ++i)
      slope += gradient[i] * v[i];
    if (auto refusal = internal::refuse_nonzero(slope, Refusal_code::NOT_TANGENT,
                                                "the product of a gradient and the direction"))
      return *refusal;
  }
  const NT length = internal::projected_squared_length(v);
  if (auto refusal = internal::refuse_zero(length, Refusal_code::DEPENDENT_DIRECTIONS,
                                           "the projection of the direction"))
    return *refusal;
  const auto combination = internal::normal_combination(surfaces.gradients);
  if (!combination)
    return Refusal(Refusal_code::PROJECTION_SINGULAR,
                   "no combination of the gradients is normal to the projection");
  NT curvature(0); // the paper's, which is minus ours
  for (std::size_t k = 0; k < surfaces.shape_operators.size(); ++k)
    curvature += combination->first[k] * surfaces.shape_operators[k];
  return N_space_normal_curvature<NT>{combination->second, NT(-(curvature / length))};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CROSS_CHECKS_H
