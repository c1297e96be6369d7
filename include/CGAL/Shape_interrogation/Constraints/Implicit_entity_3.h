// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_IMPLICIT_ENTITY_3_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_IMPLICIT_ENTITY_3_H

// An implicit surface as one recorded function, to be put into equations: value and gradient at
// points that are expressions themselves.

#include <CGAL/Shape_interrogation/Constraints/Constraint_point_3.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is the surface \f$ f = 0 \f$ as an ingredient of constructions.
 *
 * Equations that contain \f$ f \f$ or its gradient are made by evaluating the recorded function and
 * its reverse sweep on expressions, which keeps them as short as by hand.
 */
class Implicit_entity_3
{
public:
  //! constructs the surface from a recorded function of the variables 0, 1, 2.
  //! \param f the function
  //! \param name how sentences call the surface; a construction gives a name if there is none
  //! \exception Shape_error if the function has other variables
  explicit Implicit_entity_3(const Expression& f, std::string name = "")
    : m_name(std::move(name)), m_tape({f}, 3, Expression_tape::Derivatives::GRADIENT)
  {}

  //! constructs the surface from a functor, a model of `ImplicitFunction_3`.
  template <class Function, class = std::enable_if_t<std::is_invocable_v<
                              const Function&, Expression, Expression, Expression>>>
  explicit Implicit_entity_3(const Function& f, std::string name = "")
    : Implicit_entity_3(Expression(record_expression<3>(f)), std::move(name))
  {}

  //! returns the name.
  const std::string& name() const { return m_name; }
  //! changes the name.
  void set_name(std::string name) { m_name = std::move(name); }
  //! returns the function, in the variables 0, 1, 2.
  const Expression& function() const { return m_tape.output(0); }

  //! returns \f$ f \f$ at a point.
  Expression value(const Constraint_point_3& p) const { return m_tape.evaluate(variables(p))[0]; }

  //! returns the gradient of \f$ f \f$ at a point.
  Coordinates<Expression, 3> gradient(const Constraint_point_3& p) const
  {
    const std::vector<Expression> entries = m_tape.gradient(variables(p));
    Coordinates<Expression, 3> result;
    for (std::size_t k = 0; k < entries.size(); ++k)
      result[m_tape.gradient_pattern().columns[k]] = entries[k];
    return result;
  }

private:
  static std::vector<Expression> variables(const Constraint_point_3& p)
  {
    const Coordinates<Expression, 3> x = p.cartesian();
    return {x.begin(), x.end()};
  }

  std::string m_name;
  Expression_tape m_tape;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_IMPLICIT_ENTITY_3_H
