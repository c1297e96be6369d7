// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CURVE_ENTITY_3_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CURVE_ENTITY_3_H

// A parametric curve in space as recorded functions, to be put into equations.

#include <CGAL/Shape_interrogation/Constraints/internal/Recorded_map.h>
#include <CGAL/Shape_interrogation/Constraints/internal/bernstein_expressions.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>

#include <CGAL/assertions.h>
#include <CGAL/Exact_rational.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is the space curve \f$ c(r) = (X, Y, Z) / W \f$ as an ingredient of constructions.
 *
 * As for `Parametric_entity_3`, equations are multiplied by powers of \f$ W \f$.
 */
class Curve_entity_3
{
public:
  /*!
   * \brief constructs the curve from recorded functions of the variable 0.
   * \param x the functions \f$ X, Y, Z \f$
   * \param name how sentences call the curve; a construction gives a name if there is none
   * \param weight the function \f$ W \f$
   * \exception Shape_error if a function has other variables, or the weight is zero
   */
  explicit Curve_entity_3(const Coordinates<Expression, 3>& x, std::string name = "",
                          const Expression& weight = Expression(1))
    : m_name(std::move(name)), m_map(x, weight)
  {}

  //! constructs the curve from a functor that returns an array of three coordinates, or the four
  //! numbers \f$ X, Y, Z, W \f$, for a parameter of any number type.
  template <class Map, class = std::enable_if_t<std::is_invocable_v<const Map&, Expression>>>
  explicit Curve_entity_3(const Map& map, std::string name = "")
    : m_name(std::move(name)),
      m_map(internal::make_recorded_map<1>(record_expression<1>(map)))
  {}

  //! returns the Bezier curve with the control points \f$ (w x, w y, w z, w) \f$. Its parameter is
  //! not bounded by the unit interval. \pre there are at least two
  static Curve_entity_3
  bezier(const std::vector<Coordinates<CGAL::Exact_rational, 4>>& points, std::string name = "")
  {
    CGAL_precondition_msg(points.size() >= 2, "a Bezier curve has at least two control points");
    const auto x = internal::bernstein_form(
      internal::bernstein_expressions(static_cast<int>(points.size()) - 1, Expression::variable(0)),
      {Expression(1)}, [&](int i, int) { return points[i]; });
    return Curve_entity_3({x[0], x[1], x[2]}, std::move(name), x[3]);
  }

  //! returns the name.
  const std::string& name() const { return m_name; }
  //! changes the name.
  void set_name(std::string name) { m_name = std::move(name); }
  //! returns \f$ X, Y, Z, W \f$ in the variable 0; a constant weight is divided by, and 1 then.
  std::vector<Expression> functions() const { return m_map.functions(); }

  //! returns the point with the given parameter, under the name `name`.
  Constraint_point_3 point(const std::string& name, const Expression& r) const
  {
    return m_map.point(name, {r});
  }

  //! returns \f$ W^2 c' \f$.
  Coordinates<Expression, 3> tangent(const Expression& r) const { return m_map.tangents({r})[0]; }

private:
  std::string m_name;
  internal::Recorded_map<1> m_map;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CURVE_ENTITY_3_H
