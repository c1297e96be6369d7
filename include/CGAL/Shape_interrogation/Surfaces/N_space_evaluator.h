// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_EVALUATOR_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_EVALUATOR_H

// Chuang and Hoffmann's curvature at a point: rank, tangent plane V, normal (N, 0) = J^T alpha,
// then V^T (sum alpha_k H_k) V by second-order jets along V. MATH: n-space.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_shape_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Sparse_elimination.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/Unoriented_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief evaluates the surface of one system in n-space at many points in one number type, reusing
 * its memory.
 *
 * Refused are, in this order: a point that has not one coordinate for each variable
 * (`NOT_ON_SOLUTION`); too few equations (`UNDERDETERMINED`); a point that certainly is not a
 * solution (`NOT_ON_SOLUTION`; floating point makes no such claim); a Jacobian of rank below
 * (`RANK_DEFICIENT`) or above (`NOT_TWO_DIMENSIONAL`) \f$ n - 2 \f$; a tangent plane that the
 * projection does not map injectively (`PROJECTION_SINGULAR`); redundant equations that contradict
 * each other to second order (`INCONSISTENT_REDUNDANCY`). Enclosures answer `UNDECIDED` where they
 * cannot tell. In floating point, rank and redundancy are numerical.
 *
 * An answer from redundant equations is conditional on their being satisfied by the whole surface:
 * the second-order test is necessary, not sufficient.
 *
 * An evaluator is not thread-safe; use one in each thread. It keeps a reference to the system.
 *
 * An orienting direction that is orthogonal to the normal is refused (`AMBIGUOUS`). Where an
 * enclosure does not decide the side of the normal, `operator()` and `shape()` refuse (`UNDECIDED`)
 * and `unoriented()` answers.
 *
 * \tparam NT a field number type
 *
 * Complexity: linear in the length of the equations plus the sparse elimination, for which the
 * order is chosen once if `N_space_system::prepare()` was called.
 */
template <class NT>
class N_space_evaluator
{
public:
  //! constructs an evaluator for `system`, which must outlive it.
  explicit N_space_evaluator(const N_space_system& system)
    : m_system(system), m_n(system.number_of_variables()),
      m_m(system.number_of_equations())
  {}

  //! computes the second-order data at `point`, which has one coordinate for each variable.
  Result<Local_shape_3<NT>> operator()(const std::vector<NT>& point)
  {
    const Result<Local_shape_3<NT>> s =
      internal::refuse_errors<Local_shape_3<NT>>([&] { return evaluate(point); });
    if (s && !m_is_oriented)
      return Refusal(Refusal_code::UNDECIDED, "the orientation of the normal is undecided");
    return s;
  }

  //! computes the data at `point`, with either normal where the enclosure does not decide its side.
  Result<Unoriented_shape_3<NT>> unoriented(const std::vector<NT>& point)
  {
    const Result<Local_shape_3<NT>> s =
      internal::refuse_errors<Local_shape_3<NT>>([&] { return evaluate(point); });
    if (!s)
      return s.refusal();
    return Unoriented_shape_3<NT>(*s, m_is_oriented);
  }

  //! computes the data at `point` with rank, tangent basis and multipliers.
  Result<N_space_shape_3<NT>> shape(const std::vector<NT>& point)
  {
    const Result<Local_shape_3<NT>> s = (*this)(point);
    if (!s)
      return s.refusal();
    N_space_shape_3<NT> full;
    full.shape = *s;
    full.rank = m_n - 2;
    full.tangent_basis = m_basis;
    full.multipliers = m_alpha;
    if (m_flipped)
      for (NT& alpha : full.multipliers)
        alpha = -alpha;
    full.redundant_equations = m_used_plan->redundant_rows;
    return full;
  }

private:
  using J = Jet<NT, 2, 2>;
  using Vector = Coordinates<NT, 3>;
  using Elimination = internal::Sparse_elimination<NT>;

  Result<Local_shape_3<NT>> evaluate(const std::vector<NT>& p)
  {
    if (static_cast<int>(p.size()) != m_n)
      return Refusal(Refusal_code::NOT_ON_SOLUTION,
                     "the point has " + std::to_string(p.size()) + " coordinate(s) for " +
                       std::to_string(m_n) + " variables");
    if (m_m < m_n - 2)
      return Refusal(Refusal_code::UNDERDETERMINED,
                     std::to_string(m_m) + " equation(s) in " + std::to_string(m_n) +
                       " variables do not define a surface");
    if (auto refusal = differentiate(p))
      return *refusal;
    if (auto refusal = eliminate())
      return *refusal;
    for (int i = 0; i < 2; ++i)
      m_elimination.kernel_vector(i, m_basis[i]);
    const Vector w1{m_basis[0][0], m_basis[0][1], m_basis[0][2]};
    const Vector w2{m_basis[1][0], m_basis[1][1], m_basis[1][2]};
    const Vector n = internal::cross(w1, w2);
    if (auto refusal = internal::refuse_zero(
          NT(internal::dot(n, n)), Refusal_code::PROJECTION_SINGULAR,
          "the squared normal of the projected tangent plane"))
      return *refusal;
    second_derivatives(p);
    if (auto refusal = check_redundancy())
      return *refusal;
    m_right_hand_side.assign(m_n, NT(0));
    for (int i = 0; i < 3; ++i)
      m_right_hand_side[i] = n[i];
    m_elimination.multipliers(m_right_hand_side, m_alpha);
    const std::array<NT, 3> h = combine(m_alpha);
    return oriented(Local_shape_3<NT>::from_frame({p[0], p[1], p[2]}, w1, w2, h[0], h[1], h[2]));
  }

  std::optional<Refusal> differentiate(const std::vector<NT>& p)
  {
    const Expression_tape& tape = m_system.tape();
    m_values.resize(m_m);
    m_gradient.resize(tape.gradient_pattern().number_of_entries());
    tape.evaluate_with_gradient(p.data(), m_values.data(), m_gradient.data(), m_workspace);
    for (int k = 0; k < m_m; ++k)
      if (!CGAL::possibly(is_zero_decision(m_values[k])))
        if (auto refusal = internal::refuse_nonzero(
              m_values[k], Refusal_code::NOT_ON_SOLUTION,
              ("equation " + std::to_string(k + 1) + " at the point").c_str()))
          return refusal;
    return std::nullopt;
  }

  // Replays the prepared order; where it fails, the values at this point decide.
  std::optional<Refusal> eliminate()
  {
    m_used_plan = m_system.elimination_plan();
    if (m_used_plan)
    {
      const auto status = m_elimination.factor(*m_used_plan, m_gradient);
      if (status == Elimination::Status::OK)
        return std::nullopt;
    }
    m_plan = internal::plan_elimination(m_system.tape().gradient_pattern(), m_n, m_gradient);
    m_used_plan = &m_plan;
    const int rank = m_plan.rank();
    if (rank == m_n - 2)
    {
      const auto status = m_elimination.factor(m_plan, m_gradient, true);
      if (status == Elimination::Status::OK)
        return std::nullopt;
    }
    const std::string text = "the Jacobian has rank " + std::to_string(rank) + " of " +
                             std::to_string(m_n - 2) + " at the point";
    if (rank < m_n - 2)
      return m_plan.undecided
        ? Refusal(Refusal_code::UNDECIDED, text + " or more: the enclosure does not decide")
        : Refusal(Refusal_code::RANK_DEFICIENT, text);
    return Refusal(Refusal_code::NOT_TWO_DIMENSIONAL, text);
  }

  // The forms v_i' H_k v_j of all equations, from one pass of second-order jets along the basis.
  void second_derivatives(const std::vector<NT>& p)
  {
    m_moving.resize(m_n);
    m_jets.resize(m_m);
    for (int i = 0; i < m_n; ++i)
      m_moving[i] = J::along(p[i], {m_basis[0][i], m_basis[1][i]});
    m_system.tape().evaluate(m_moving.data(), m_jets.data(), m_jet_workspace);
  }

  std::array<NT, 3> combine(const std::vector<NT>& weights) const
  {
    std::array<NT, 3> h{NT(0), NT(0), NT(0)};
    for (int k = 0; k < m_m; ++k)
    {
      if (Number_type_traits<NT>::is_exact && CGAL::certainly(is_zero_decision(weights[k])))
        continue;
      h[0] += weights[k] * m_jets[k].derivative(0, 0);
      h[1] += weights[k] * m_jets[k].derivative(0, 1);
      h[2] += weights[k] * m_jets[k].derivative(1, 1);
    }
    return h;
  }

  // Every combination of gradients that vanishes must have a vanishing second form on the tangent
  // plane: otherwise the equations do not hold on one surface.
  std::optional<Refusal> check_redundancy()
  {
    for (std::size_t r = 0; r < m_used_plan->redundant_rows.size(); ++r)
    {
      m_elimination.left_kernel_vector(static_cast<int>(r), m_beta);
      const std::array<NT, 3> h = combine(m_beta);
      for (const NT& x : h)
        if (!vanishes(x))
          return Refusal(Refusal_code::INCONSISTENT_REDUNDANCY,
                         "equation " + std::to_string(m_used_plan->redundant_rows[r] + 1) +
                           " depends on others to first order but not to second (" +
                           internal::text_of(x) + ")");
    }
    return std::nullopt;
  }

  // In floating point a form that is rounding noise against the sizes that went into it vanishes.
  bool vanishes(const NT& x) const
  {
    if constexpr (Number_type_traits<NT>::is_exact || Number_type_traits<NT>::is_enclosure)
      return CGAL::possibly(is_zero_decision(x));
    else
    {
      NT step(0), size(0);
      for (int i = 0; i < m_n; ++i)
        step += m_basis[0][i] * m_basis[0][i] + m_basis[1][i] * m_basis[1][i];
      const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
      for (int k = 0; k < m_m; ++k)
      {
        NT slope(0);
        for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
          slope += std::fabs(m_gradient[e]);
        size += std::fabs(m_beta[k]) *
                (slope * step + std::fabs(m_jets[k].derivative(0, 0)) +
                 std::fabs(m_jets[k].derivative(0, 1)) + std::fabs(m_jets[k].derivative(1, 1)));
      }
      return std::fabs(x) <= NT(internal::numerical_rank_tolerance) * size;
    }
  }

  // Orients by the given direction, else by the first component that is not zero.
  Result<Local_shape_3<NT>> oriented(const Local_shape_3<NT>& s)
  {
    const Vector& n = s.normal();
    m_is_oriented = true;
    CGAL::Sign sign = CGAL::ZERO;
    if (m_system.orientation())
    {
      Vector d;
      for (int i = 0; i < 3; ++i)
        d[i] = number_cast<NT>((*m_system.orientation())[i]);
      sign = orientation_sign(NT(internal::dot(n, d)));
      if (m_is_oriented && sign == CGAL::ZERO)
        return Refusal(Refusal_code::AMBIGUOUS,
                       "the direction that orients the normal is orthogonal to it");
    }
    for (int i = 0; i < 3 && m_is_oriented && sign == CGAL::ZERO; ++i)
      sign = orientation_sign(n[i]);
    m_flipped = sign == CGAL::NEGATIVE;
    return m_flipped ? s.opposite() : s;
  }

  CGAL::Sign orientation_sign(const NT& x)
  {
    const auto sign = sign_decision(x);
    m_is_oriented = CGAL::is_certain(sign);
    return m_is_oriented ? CGAL::make_certain(sign) : CGAL::ZERO;
  }

  const N_space_system& m_system;
  int m_n, m_m;
  internal::Elimination_plan m_plan;
  const internal::Elimination_plan* m_used_plan = nullptr;
  Elimination m_elimination;
  std::vector<NT> m_values, m_gradient, m_workspace, m_right_hand_side, m_alpha, m_beta;
  std::array<std::vector<NT>, 2> m_basis;
  std::vector<J> m_moving, m_jets, m_jet_workspace;
  bool m_is_oriented = false, m_flipped = false;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_EVALUATOR_H
