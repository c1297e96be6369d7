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

#include <CGAL/Shape_interrogation/Surfaces/N_space_shape_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/form_vanishes_nearby.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/N_space_forms.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/orient_n_space_shape.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/plan_elimination.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/Unoriented_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

class N_space_surface_3;

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief evaluates the surface of one system in n-space at many points in one number type, reusing
 * its memory.
 *
 * Refused are, in this order: a point that has not one coordinate for each variable
 * (`NOT_ON_SOLUTION`); in floating point a coordinate that is not finite (`LIMIT_EXCEEDED`); too
 * few equations (`UNDERDETERMINED`); a point that certainly is not a solution (`NOT_ON_SOLUTION`;
 * floating point makes no such claim); a Jacobian of rank below
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
  explicit N_space_evaluator(const N_space_system& system) { set_system(system); }

  //! computes the second-order data at `point`, which has one coordinate for each variable.
  Result<Local_shape_3<NT>> operator()(const std::vector<NT>& point)
  {
    const Result<Local_shape_3<NT>> s =
      internal::refuse_errors<Local_shape_3<NT>>([&] { return evaluate(point); });
    if (s && !m_side.is_decided)
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
    return Unoriented_shape_3<NT>(*s, m_side.is_decided);
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
    full.tangent_basis = m_forms.basis();
    full.multipliers = m_forms.multipliers();
    if (m_side.is_to_be_turned)
      for (NT& alpha : full.multipliers)
        alpha = -alpha;
    full.redundant_equations = m_used_plan->redundant_rows;
    return full;
  }

private:
  friend class N_space_surface_3;
  using Forms = internal::N_space_forms<NT>;
  using Status = typename internal::Sparse_elimination<NT>::Status;

  // For the surface, which keeps the memory of an evaluator for systems that come and go.
  N_space_evaluator() = default;

  void set_system(const N_space_system& system)
  {
    m_system = &system;
    m_n = system.number_of_variables();
    m_m = system.number_of_equations();
  }

  Result<Local_shape_3<NT>> evaluate(const std::vector<NT>& p)
  {
    if (static_cast<int>(p.size()) != m_n)
      return Refusal(Refusal_code::NOT_ON_SOLUTION,
                     "the point has " + std::to_string(p.size()) + " coordinate(s) for " +
                       std::to_string(m_n) + " variables");
    if (auto refusal = internal::refuse_not_finite(p, m_system->variables()))
      return *refusal;
    if (m_m < m_n - 2)
      return Refusal(Refusal_code::UNDERDETERMINED,
                     std::to_string(m_m) + " equation(s) in " + std::to_string(m_n) +
                       " variables do not define a surface");
    m_forms.differentiate(*m_system, p.data());
    if (auto refusal = check_values())
      return *refusal;
    if (auto refusal = eliminate())
      return *refusal;
    m_forms.span_tangent_plane();
    const Coordinates<NT, 3>& n = m_forms.normal();
    if (auto refusal = internal::refuse_zero(
          NT(internal::dot(n, n)), Refusal_code::PROJECTION_SINGULAR,
          "the squared normal of the projected tangent plane"))
      return *refusal;
    m_forms.bend(p.data());
    if (auto refusal = check_redundancy(p))
      return *refusal;
    if (auto refusal = internal::orient(*m_system, n, m_side))
      return *refusal;
    const std::array<NT, 3> h = m_forms.normal_form();
    const auto s = Local_shape_3<NT>::from_frame({p[0], p[1], p[2]}, m_forms.projected(0),
                                                 m_forms.projected(1), h[0], h[1], h[2]);
    return m_side.is_to_be_turned ? s.opposite() : s;
  }

  std::optional<Refusal> check_values() const
  {
    const std::vector<NT>& values = m_forms.values();
    for (int k = 0; k < m_m; ++k)
      if (internal::refuse_nonzero(values[k], Refusal_code::NOT_ON_SOLUTION, ""))
        return internal::refuse_nonzero(
          values[k], Refusal_code::NOT_ON_SOLUTION,
          ("equation " + std::to_string(k + 1) + " at the point").c_str());
    return std::nullopt;
  }

  // Replays the prepared order; where it fails, the values at this point decide.
  std::optional<Refusal> eliminate()
  {
    m_used_plan = m_system->elimination_plan();
    if (m_used_plan &&
        m_forms.elimination().factor(*m_used_plan, m_forms.gradient()) == Status::OK)
      return std::nullopt;
    m_plan = internal::plan_elimination(m_system->tape().gradient_pattern(), m_n,
                                        m_forms.gradient());
    m_used_plan = &m_plan;
    const int rank = m_plan.rank();
    if (rank == m_n - 2 &&
        m_forms.elimination().factor(m_plan, m_forms.gradient(), true) == Status::OK)
      return std::nullopt;
    const std::string text = "the Jacobian has rank " + std::to_string(rank) + " of " +
                             std::to_string(m_n - 2) + " at the point";
    if (rank < m_n - 2)
      return m_plan.undecided
        ? Refusal(Refusal_code::UNDECIDED, text + " or more: the enclosure does not decide")
        : Refusal(Refusal_code::RANK_DEFICIENT, text);
    if (rank > m_n - 2)
      return Refusal(Refusal_code::NOT_TWO_DIMENSIONAL, text);
    return Refusal(Refusal_code::UNDECIDED, text + ", but its factors overflow");
  }

  // Every combination of gradients that vanishes must have a vanishing second form on the tangent
  // plane: otherwise the equations do not hold on one surface.
  std::optional<Refusal> check_redundancy(const std::vector<NT>& p)
  {
    const std::vector<int>& rows = m_used_plan->redundant_rows;
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      const std::array<NT, 3> h = m_forms.redundant_form(static_cast<int>(r));
      if (const NT* x = find_nonzero(p, h, static_cast<int>(r)))
        return Refusal(Refusal_code::INCONSISTENT_REDUNDANCY,
                       "equation " + std::to_string(rows[r] + 1) +
                         " depends on others to first order but not to second (" +
                         internal::text_of(*x) + ")");
    }
    return std::nullopt;
  }

  const NT* find_nonzero(const std::vector<NT>& p, const std::array<NT, 3>& h, int index)
  {
    static_cast<void>(p);
    static_cast<void>(index);
    const NT* found = nullptr;
    if constexpr (Number_type_traits<NT>::is_exact || Number_type_traits<NT>::is_enclosure)
      found = find_if(h, [](const NT& x) { return !CGAL::possibly(is_zero_decision(x)); });
    else
    {
      // A form that is rounding noise against the sizes that went into it vanishes.
      const NT noise =
        NT(internal::numerical_rank_tolerance) * m_forms.size_of_redundant_form(index);
      found = find_if(h, [&](const NT& x) { return !(std::fabs(x) <= noise); });
      if (found && may_vanish(p))
        found = nullptr;
    }
    return found;
  }

  template <class Predicate>
  static const NT* find_if(const std::array<NT, 3>& h, Predicate predicate)
  {
    const auto x = std::find_if(h.begin(), h.end(), predicate);
    return x == h.end() ? nullptr : &*x;
  }

  [[gnu::noinline, gnu::cold]] bool may_vanish(const std::vector<NT>& p) const
  {
    const auto doubles = [](const std::vector<NT>& x) {
      return std::vector<double>(x.begin(), x.end());
    };
    const auto& basis = m_forms.basis();
    return internal::form_vanishes_nearby(*m_system, doubles(p),
                                          {doubles(basis[0]), doubles(basis[1])},
                                          doubles(m_forms.redundant_weights()));
  }

  const N_space_system* m_system = nullptr;
  int m_n = 0, m_m = 0;
  internal::Elimination_plan m_plan;
  const internal::Elimination_plan* m_used_plan = nullptr;
  Forms m_forms;
  internal::Normal_side m_side;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_EVALUATOR_H
