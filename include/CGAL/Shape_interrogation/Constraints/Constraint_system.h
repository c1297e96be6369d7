// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_SYSTEM_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_SYSTEM_H

// Geometry stated as equations: named unknowns and constraints, from which a system in n-space is
// made (Chuang and Hoffmann, section 2), and which says in words what does not hold at a point.

#include <CGAL/Shape_interrogation/Constraints/Constraint.h>
#include <CGAL/Shape_interrogation/Constraints/Constraint_point_3.h>
#include <CGAL/Shape_interrogation/Constraints/internal/Entity_names.h>
#include <CGAL/Shape_interrogation/Constraints/internal/variable_name.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// Certainly outside of [-tolerance, tolerance]; what is no number is outside of it.
template <class NT>
bool exceeds(const NT& residual, const NT& tolerance)
{
  if constexpr (std::is_floating_point_v<NT>)
    return !(-tolerance <= residual && residual <= tolerance);
  else
    return CGAL::certainly(sign_decision(NT(residual - tolerance)) == CGAL::POSITIVE) ||
           CGAL::certainly(sign_decision(NT(residual + tolerance)) == CGAL::NEGATIVE);
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief collects unknown points and numbers and the constraints between them.
 *
 * <b>Variables.</b> The first point is the projected one: it is there from the beginning, and its
 * coordinates are the variables `x`, `y`, `z`. Another unknown point with the name `p` has the
 * variables `p_x`, `p_y`, `p_z`; an unknown number has the variable of its name. Variables are
 * numbered in the order in which they are added. These names are what bounds and messages refer to.
 *
 * <b>Names.</b> Sentences call surfaces, curves and points by their names, so that in one system a
 * name stands for one of them: the functions that add constraints throw a `Shape_error` if it
 * already stands for another one. Things without a name are not told apart.
 *
 * Constraints are added by the functions `require_on()`, `require_projection()`,
 * `require_distance()` and the like, or with equations of one's own by `add()`.
 *
 * Const calls are thread-safe.
 */
class Constraint_system
{
public:
  /// \name Construction
  /// @{

  //! constructs a system without constraints; the projected point has the given name in sentences.
  explicit Constraint_system(std::string projected_point = "q")
  {
    m_projected = {std::move(projected_point),
                   {add_scalar("x"), add_scalar("y"), add_scalar("z")}};
    m_names.add_point(m_projected);
  }

  //! adds an unknown number and returns its variable.
  //! \exception Shape_error if the name is taken, or is none that `parse_expression()` reads
  Expression add_scalar(const std::string& name)
  {
    internal::check_new_variable(name, m_variables);
    m_variables.push_back(name);
    return Expression::variable(number_of_variables() - 1);
  }

  //! adds an unknown point and returns it.
  //! \exception Shape_error as `add_scalar()`, or if another point has the name; nothing is added
  //! then
  Constraint_point_3 add_point(const std::string& name)
  {
    for (const char* coordinate : {"_x", "_y", "_z"})
      internal::check_new_variable(name + coordinate, m_variables);
    m_names.check_new_point(name);
    const Constraint_point_3 p{
      name, {add_scalar(name + "_x"), add_scalar(name + "_y"), add_scalar(name + "_z")}};
    m_names.add_point(p);
    return p;
  }

  //! adds a constraint and returns its index.
  int add(Constraint constraint)
  {
    m_first_equation.push_back(number_of_equations());
    m_equations.insert(m_equations.end(), constraint.equations().begin(),
                       constraint.equations().end());
    m_constraints.push_back(std::move(constraint));
    return static_cast<int>(m_constraints.size()) - 1;
  }

  /// @}
  /// \name Access
  /// @{

  //! returns the projected point.
  const Constraint_point_3& projected_point() const { return m_projected; }

  //! returns the number of variables.
  int number_of_variables() const { return static_cast<int>(m_variables.size()); }
  //! returns the names of the variables.
  const std::vector<std::string>& variables() const { return m_variables; }
  //! returns the index of a variable, or -1 if there is none of that name.
  int find_variable(const std::string& name) const
  {
    const auto found = std::find(m_variables.begin(), m_variables.end(), name);
    return found == m_variables.end() ? -1 : static_cast<int>(found - m_variables.begin());
  }

  //! returns the constraints.
  const std::vector<Constraint>& constraints() const { return m_constraints; }
  //! returns the index of the first equation of a constraint; the others follow it.
  int first_equation(int constraint) const { return m_first_equation.at(constraint); }

  //! returns the number of equations.
  int number_of_equations() const { return static_cast<int>(m_equations.size()); }
  //! returns the left hand sides of all equations, constraint by constraint.
  const std::vector<Expression>& equations() const { return m_equations; }

  //! returns the number of variables less the ranks of the constraints: 2 for a surface, unless
  //! constraints depend on each other.
  int expected_dimension() const
  {
    int dimension = number_of_variables();
    for (const Constraint& c : m_constraints)
      dimension -= c.rank();
    return dimension;
  }

  /// @}
  /// \name Use
  /// @{

  //! returns the equations in compiled form, for `N_space_surface_3`.
  //! \exception Shape_error if an equation has a variable that was never added
  N_space_system n_space_system() const { return N_space_system(m_variables, m_equations); }

  /*!
   * \brief returns the constraints that do not hold for the given values of the variables.
   *
   * \details In exact types a constraint holds if its residuals are zero, or at most `tolerance` in
   * absolute value. For enclosures those are returned that certainly do not hold. In `double`,
   * residuals of valid points are rounding errors, and a tolerance for them is needed.
   *
   * \tparam NT a number type that `Expression_tape` takes
   * \param values the values, in the order of `variables()`
   * \param tolerance the largest absolute value of a residual that is taken for zero
   * \pre there are as many values as variables, and the tolerance is not negative
   * \exception Shape_error if an equation has no value there: see `Expression_tape`
   *
   * Complexity: linear in the equations, which are compiled in each call
   */
  template <class NT>
  std::vector<Violation<NT>> violated(const std::vector<NT>& values,
                                      const NT& tolerance = NT(0)) const
  {
    CGAL_precondition_msg(int(values.size()) == number_of_variables(),
                          "one value is needed for each variable");
    Expression_tape tape(m_equations, number_of_variables(), Expression_tape::Derivatives::NONE);
    tape.set_variable_names(m_variables);
    const std::vector<NT> residuals = tape.evaluate(values);
    std::vector<Violation<NT>> result;
    auto last = residuals.begin();
    for (std::size_t k = 0; k < m_constraints.size(); ++k)
    {
      const auto first = last;
      last += static_cast<std::ptrdiff_t>(m_constraints[k].equations().size());
      if (std::any_of(first, last, [&](const NT& r) { return internal::exceeds(r, tolerance); }))
        result.push_back({int(k), m_constraints[k].violation(), std::vector<NT>(first, last)});
    }
    return result;
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  internal::Entity_names& names() { return m_names; }
#endif

private:
  std::vector<std::string> m_variables;
  Constraint_point_3 m_projected;
  std::vector<Constraint> m_constraints;
  std::vector<int> m_first_equation;
  std::vector<Expression> m_equations;
  internal::Entity_names m_names;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_SYSTEM_H
