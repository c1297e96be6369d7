// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CORRECTOR_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CORRECTOR_H

// From an approximate point onto the solution of a system: Newton steps of least length by sparse
// elimination, and damped Gauss-Newton steps on all equations where those do not come nearer.

#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Sparse_elimination.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Values_nearby.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/gauss_newton_step.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/orthonormal_kernel.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is an approximate solution of a system in n-space. Nothing is proved: see
 * `enclose_solution()`.
 */
struct N_space_point
{
  std::vector<double> point; //!< the coordinates
  double residual = 0;       //!< the largest absolute value of an equation there
  double step = 0;           //!< the length of the last step, which estimates the error
  int iterations = 0;        //!< the number of steps
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief moves approximate points onto the solution of a system in n-space.
 *
 * Each Newton step is the shortest that satisfies the linearised equations (and conditions, of
 * which there may be as many as the solution has dimensions). Redundant equations are allowed, also
 * with vanishing gradients: an independent subset is used, which may differ from point to point.
 * Where a step does not make the residual smaller or leads to where an equation has no value, it is
 * damped, and where that does not help either, Gauss-Newton steps on all equations take over.
 *
 * Refused are a start that has not one coordinate for each variable (`NOT_ON_SOLUTION`), too few
 * equations (`UNDERDETERMINED`), a start at which an equation has no value (`POLE`,
 * `OUTSIDE_DOMAIN`), a Jacobian of too small rank on the way (`RANK_DEFICIENT`), numbers that are
 * not finite (`LIMIT_EXCEEDED`) and iterations that do not settle on a solution of all equations
 * and conditions (`NOT_ON_SOLUTION`).
 *
 * In floating point only; nothing is proved. A corrector keeps its memory and the order of
 * elimination from point to point, so it is not thread-safe; use one in each thread. It keeps a
 * reference to the system.
 *
 * Complexity: for each step linear in the length of the equations plus the sparse elimination; a
 * Gauss-Newton step is cubic in the number of variables.
 */
class N_space_corrector
{
public:
  //! constructs a corrector for `system`, which must outlive it, whose solution has the given
  //! `dimension`: 2 for surfaces, 1 for curves, 0 for points.
  explicit N_space_corrector(const N_space_system& system, int dimension = 2,
                             int max_iterations = 100)
    : m_system(system), m_n(system.number_of_variables()), m_m(system.number_of_equations()),
      m_dimension(dimension), m_max_iterations(max_iterations)
  {
    CGAL_precondition_msg(0 <= dimension && dimension <= 2, "a solution has dimension 0, 1 or 2");
  }

  //! returns a solution near `start` that satisfies the conditions. \pre there are at most as many
  //! conditions as dimensions, each with one coefficient for each variable
  Result<N_space_point> operator()(const std::vector<double>& start,
                                   const std::vector<N_space_condition>& conditions = {})
  {
    CGAL_precondition_msg(std::all_of(conditions.begin(), conditions.end(),
                                      [this](const N_space_condition& c) {
                                        return static_cast<int>(c.coefficients.size()) == m_n;
                                      }),
                          "a condition has one coefficient for each variable");
    CGAL_precondition_msg(static_cast<int>(conditions.size()) <= m_dimension,
                          "there are more conditions than dimensions");
    if (static_cast<int>(start.size()) != m_n)
      return Refusal(Refusal_code::NOT_ON_SOLUTION,
                     "the point has " + std::to_string(start.size()) + " coordinate(s) for " +
                       std::to_string(m_n) + " variables");
    if (auto refusal = internal::refuse_not_finite(start, m_system.variables()))
      return *refusal;
    if (m_m < m_n - m_dimension)
      return Refusal(Refusal_code::UNDERDETERMINED,
                     std::to_string(m_m) + " equation(s) in " + std::to_string(m_n) +
                       " variables leave more than " + std::to_string(m_dimension) +
                       " dimension(s)");
    return internal::refuse_errors<N_space_point>([&] { return iterate(start, conditions); });
  }

  //! returns an orthonormal basis of the kernel of the Jacobian at the point that was reached last:
  //! the tangent vectors of the solution.
  const std::vector<std::vector<double>>& tangent_basis() const { return m_kernel.basis(); }

private:
  Result<N_space_point> iterate(const std::vector<double>& start,
                                const std::vector<N_space_condition>& conditions)
  {
    N_space_point r;
    r.point = start;
    double norm = evaluate(r.point, conditions);
    double previous_step = HUGE_VAL;
    bool all_equations = false; // in place of an independent subset
    for (; r.iterations < m_max_iterations; ++r.iterations)
    {
      if (!std::isfinite(norm))
        return Refusal(Refusal_code::LIMIT_EXCEEDED, "the equations overflow on the way");
      if (all_equations)
        gauss_newton_step(conditions);
      else if (auto refusal = newton_step(r.point, conditions))
        return *refusal;
      r.step = std::sqrt(internal::dot_product(m_step, m_step));
      if (!std::isfinite(r.step))
        return Refusal(Refusal_code::RANK_DEFICIENT, "the Jacobian is singular on the way");
      // Settled: the step is a rounding of the point, or near it and not shrinking any more.
      const double size = internal::largest(r.point);
      const bool is_small = r.step <= std::ldexp(size, -26);
      const bool settled =
        r.step <= std::ldexp(size, -51) || (is_small && r.step > previous_step / 4);
      previous_step = is_small ? r.step : HUGE_VAL;
      if (!settled && advance(r.point, norm, conditions))
        continue;
      // Near the origin no step is small against the coordinates: the roundings alone tell.
      const bool is_solution =
        is_small ? others_vanish(r) : m_enclosure.may_vanish(m_system, r.point, 0);
      if (is_solution && internal::are_met(conditions, m_excess, size))
        return finish(std::move(r), all_equations);
      if (all_equations)
        break;
      all_equations = true; // the subset led nowhere
      previous_step = HUGE_VAL;
    }
    return not_reached(r);
  }

  Refusal not_reached(const N_space_point& r) const
  {
    const int k = internal::index_of_largest(m_values), c = internal::index_of_largest(m_excess);
    const bool is_condition = c >= 0 && std::fabs(m_excess[c]) > std::fabs(m_values[k]);
    return Refusal(Refusal_code::NOT_ON_SOLUTION,
                   "no solution was reached in " + std::to_string(r.iterations) + " step(s): " +
                     (is_condition ? "condition " : "equation ") +
                     std::to_string((is_condition ? c : k) + 1) + " is still " +
                     internal::text_of(is_condition ? m_excess[c] : m_values[k]));
  }

  // Redundant equations were not used: they must vanish within the roundings as well, which an
  // enclosure of the neighbourhood tells without a tolerance.
  bool others_vanish(const N_space_point& r)
  {
    if (m_m == m_n - m_dimension)
      return true;
    return m_enclosure.may_vanish(
      m_system, r.point, 16 * (r.step + std::ldexp(internal::largest(r.point), -50)));
  }

  // A Newton step has left the tangent basis of the point; one of all equations has not.
  Result<N_space_point> finish(N_space_point r, bool needs_basis)
  {
    r.residual = internal::largest(m_values);
    if (needs_basis)
      if (auto refusal = newton_step(r.point, {}))
        return *refusal;
    return r;
  }

  // Values and gradients at p. Returns the norm of all residuals.
  double evaluate(const std::vector<double>& p, const std::vector<N_space_condition>& conditions)
  {
    const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
    m_values.resize(m_m);
    m_gradient.resize(pattern.number_of_entries());
    m_system.tape().evaluate_with_gradient(p.data(), m_values.data(), m_gradient.data(),
                                           m_workspace);
    m_excess.resize(conditions.size());
    for (std::size_t c = 0; c < conditions.size(); ++c)
      m_excess[c] = internal::dot_product(conditions[c].coefficients, p) - conditions[c].value;
    double sum = 0;
    for (double x : m_values)
      sum += x * x;
    for (double x : m_excess)
      sum += x * x;
    return std::sqrt(sum);
  }

  // The shortest step that satisfies the linearised equations and conditions.
  std::optional<Refusal> newton_step(const std::vector<double>& p,
                                     const std::vector<N_space_condition>& conditions)
  {
    if (m_plan.rank() != m_n - m_dimension ||
        m_elimination.factor(m_plan, m_gradient, true) != Elimination::Status::OK)
    {
      internal::Elimination_limits limits;
      limits.max_rank = m_n - m_dimension;
      m_plan = internal::plan_elimination(m_system.tape().gradient_pattern(), m_n, m_gradient,
                                          limits);
      if (m_plan.rank() != m_n - m_dimension ||
          m_elimination.factor(m_plan, m_gradient, true) != Elimination::Status::OK)
        return Refusal(Refusal_code::RANK_DEFICIENT,
                       "the Jacobian has rank " + std::to_string(m_plan.rank()) + " of " +
                         std::to_string(m_n - m_dimension) + " near (" +
                         internal::coordinates_text(p) + ")");
    }
    m_kernel.compute(m_elimination, m_dimension);
    m_right_hand_side.resize(m_m);
    for (int k = 0; k < m_m; ++k)
      m_right_hand_side[k] = -m_values[k];
    m_elimination.solve(m_right_hand_side, m_step);
    m_kernel.remove_from(m_step);
    m_kernel.satisfy(conditions, m_excess, m_step);
    return std::nullopt;
  }

  // Makes the step, or a part of it, if the residual becomes smaller.
  bool advance(std::vector<double>& p, double& norm,
               const std::vector<N_space_condition>& conditions)
  {
    for (double part = 1; part > 1e-3; part /= 2)
    {
      m_trial = p;
      for (int i = 0; i < m_n; ++i)
        m_trial[i] += part * m_step[i];
      const double trial_norm = norm_at_trial(conditions);
      if (trial_norm < norm)
      {
        p.swap(m_trial);
        norm = trial_norm;
        return true;
      }
    }
    evaluate(p, conditions);
    return false;
  }

  // Infinite where an equation has no value.
  double norm_at_trial(const std::vector<N_space_condition>& conditions)
  {
    try
    {
      return evaluate(m_trial, conditions);
    }
    catch (const Shape_error&) { return HUGE_VAL; }
  }

  void gauss_newton_step(const std::vector<N_space_condition>& conditions)
  {
    internal::gauss_newton_step(m_system.tape().gradient_pattern(), m_gradient, m_values,
                                conditions, m_excess, m_n, m_step);
  }

  using Elimination = internal::Sparse_elimination<double>;

  const N_space_system& m_system;
  int m_n, m_m, m_dimension, m_max_iterations;
  internal::Elimination_plan m_plan;
  Elimination m_elimination;
  internal::Orthonormal_kernel m_kernel;
  std::vector<double> m_values, m_gradient, m_workspace, m_excess, m_right_hand_side, m_step,
    m_trial;
  internal::Values_nearby m_enclosure;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_CORRECTOR_H
