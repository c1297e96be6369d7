// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SYSTEM_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SYSTEM_H

// m equations in n variables in compiled form, and the order in which their Jacobian is eliminated.

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Elimination_plan.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/plan_elimination.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a system of \f$ m \f$ equations in \f$ n \f$ variables whose solutions are looked at in
 * the space of the first three.
 *
 * It holds the equations in compiled form and, once prepared, the order of elimination of their
 * Jacobian. The object is independent of the number type; const calls are thread-safe.
 */
class N_space_system
{
public:
  /*!
   * \brief constructs the system from expressions in the variables `0` to `n-1`.
   * \param variables the names of the variables, for messages; the first three are the space
   * \param equations the left hand sides
   * \pre there are at least three variables
   */
  N_space_system(std::vector<std::string> variables, const std::vector<Expression>& equations)
    : m_variables(std::move(variables)),
      m_tape(equations, static_cast<int>(m_variables.size()),
             Expression_tape::Derivatives::GRADIENT)
  {
    CGAL_precondition_msg(m_variables.size() >= 3, "a system needs at least three variables");
    m_tape.set_variable_names(m_variables);
  }

  //! orients the normal to have a positive product with `direction`.
  void set_orientation(const Coordinates<CGAL::Exact_rational, 3>& direction)
  {
    m_orientation = direction;
  }

  /*!
   * \brief chooses the order of elimination once, from the values at `sample`, a point of the
   * solution; evaluations then replay it and look for another order only where a pivot vanishes.
   *
   * Without this call each evaluation finds its own order. The answers agree in exact types; in
   * floating point they may differ in rounding. Not thread-safe.
   * \return false if the system has not rank `n - 2` at `sample`, or the number type has no values
   * there, or `sample` has not `n` coordinates; nothing is changed then
   */
  template <class NT>
  bool prepare(const std::vector<NT>& sample)
  {
    std::optional<internal::Elimination_plan> plan = plan_at(sample);
    if (!plan)
      return false;
    m_plan = std::move(plan);
    return true;
  }

  //! returns the number `n` of variables.
  int number_of_variables() const { return static_cast<int>(m_variables.size()); }
  //! returns the number `m` of equations.
  int number_of_equations() const { return m_tape.number_of_outputs(); }
  //! returns the names of the variables.
  const std::vector<std::string>& variables() const { return m_variables; }
  //! returns the equations in compiled form.
  const Expression_tape& tape() const { return m_tape; }
  //! returns the direction that orients the normal, if one was given.
  const std::optional<Coordinates<CGAL::Exact_rational, 3>>& orientation() const
  {
    return m_orientation;
  }

#ifndef DOXYGEN_RUNNING
  const internal::Elimination_plan* elimination_plan() const { return m_plan ? &*m_plan : nullptr; }

  // The order of elimination that prepare() would choose.
  template <class NT>
  std::optional<internal::Elimination_plan> plan_at(const std::vector<NT>& sample) const
  {
    if (sample.size() != m_variables.size())
      return std::nullopt;
    std::vector<NT> gradient(m_tape.gradient_pattern().number_of_entries()), workspace;
    try
    {
      m_tape.evaluate_with_gradient<NT>(sample.data(), nullptr, gradient.data(), workspace);
    }
    catch (const Shape_error&) { return std::nullopt; }
    internal::Elimination_plan plan =
      internal::plan_elimination(m_tape.gradient_pattern(), number_of_variables(), gradient);
    if (plan.rank() != number_of_variables() - 2)
      return std::nullopt;
    return plan;
  }
#endif

private:
  std::vector<std::string> m_variables;
  Expression_tape m_tape;
  std::optional<internal::Elimination_plan> m_plan;
  std::optional<Coordinates<CGAL::Exact_rational, 3>> m_orientation;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_SYSTEM_H
