// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_ENTITY_3_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_ENTITY_3_H

// A parametric surface or patch as recorded functions, to be put into equations.

#include <CGAL/Shape_interrogation/Constraints/internal/Recorded_map.h>
#include <CGAL/Shape_interrogation/Constraints/internal/bernstein_expressions.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is the surface \f$ S(s, t) = (X, Y, Z) / W \f$ as an ingredient of constructions.
 *
 * Equations are multiplied by powers of \f$ W \f$ and so free of division if the functions are.
 * Where \f$ W \f$ vanishes they may have solutions that are no points of the surface.
 */
class Parametric_entity_3
{
public:
  using Parameters = std::array<Expression, 2>; //!< a pair \f$ (s, t) \f$

  /*!
   * \brief constructs the surface from recorded functions of the variables 0 and 1.
   * \param x the functions \f$ X, Y, Z \f$
   * \param name how sentences call the surface; a construction gives a name if there is none
   * \param weight the function \f$ W \f$
   * \exception Shape_error if a function has other variables, or the weight is zero
   */
  explicit Parametric_entity_3(const Coordinates<Expression, 3>& x, std::string name = "",
                               const Expression& weight = Expression(1))
    : m_name(std::move(name)), m_map(x, weight)
  {}

  //! constructs the surface from a functor: a model of `ParametricMap_3`, or one that returns the
  //! four numbers \f$ X, Y, Z, W \f$.
  template <class Map, class = std::enable_if_t<
                         std::is_invocable_v<const Map&, Expression, Expression>>>
  explicit Parametric_entity_3(const Map& map, std::string name = "")
    : m_name(std::move(name)),
      m_map(internal::make_recorded_map<2>(record_expression<2>(map)))
  {}

  //! constructs the surface of a patch, in Bernstein form; `cast()` converts others to it. The
  //! parameters are not bounded by the unit square.
  explicit Parametric_entity_3(const Bezier_surface_3<CGAL::Exact_rational>& patch,
                               std::string name = "")
    : Parametric_entity_3(patch, Expression::variable(0), Expression::variable(1), std::move(name))
  {}

  //! constructs the surface of a spline that is a single Bezier patch, with the spline's own
  //! parameters.
  //! \exception Shape_error if it has several knot spans: a piecewise function is no expression
  explicit Parametric_entity_3(const Nurbs_surface_3<CGAL::Exact_rational>& spline,
                               std::string name = "")
    : Parametric_entity_3(single_patch(spline), std::move(name))
  {}

  //! returns the name.
  const std::string& name() const { return m_name; }
  //! changes the name.
  void set_name(std::string name) { m_name = std::move(name); }
  //! returns \f$ X, Y, Z, W \f$ in the variables 0 and 1; a constant weight is divided by, and 1
  //! then.
  std::vector<Expression> functions() const { return m_map.functions(); }

  //! returns the point with the given parameters, under the name `name`.
  Constraint_point_3 point(const std::string& name, const Parameters& st) const
  {
    return m_map.point(name, st);
  }

  //! returns \f$ W^2 S_s \f$ and \f$ W^2 S_t \f$.
  std::array<Coordinates<Expression, 3>, 2> tangents(const Parameters& st) const
  {
    return m_map.tangents(st);
  }

private:
  using Piece = Surface_piece_3<CGAL::Exact_rational>;

  Parametric_entity_3(const Bezier_surface_3<CGAL::Exact_rational>& patch, const Expression& u,
                      const Expression& v, std::string name)
    : m_name(std::move(name)),
      m_map(internal::make_recorded_map<2>(internal::bernstein_form(
        internal::bernstein_expressions(patch.degree_u(), u),
        internal::bernstein_expressions(patch.degree_v(), v),
        [&](int i, int j) { return patch.homogeneous_control_point(i, j); })))
  {}

  Parametric_entity_3(const Piece& piece, std::string name)
    : Parametric_entity_3(piece.patch, to_unit(piece.u, 0), to_unit(piece.v, 1), std::move(name))
  {}

  // The variable with the given index, from the span to [0, 1].
  static Expression to_unit(const Coordinates<CGAL::Exact_rational, 2>& span, int index)
  {
    const CGAL::Exact_rational length = span[1] - span[0];
    return (Expression::variable(index) - span[0]) / length;
  }

  static Piece single_patch(const Nurbs_surface_3<CGAL::Exact_rational>& spline)
  {
    const std::vector<Piece> pieces = spline.bezier_patches();
    if (pieces.size() != 1)
      throw Shape_error("the spline surface has " + std::to_string(pieces.size()) +
                        " pairs of knot spans, and a constraint takes one: construct with one of"
                        " its bezier_patches()");
    return pieces.front();
  }

  std::string m_name;
  internal::Recorded_map<2> m_map;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PARAMETRIC_ENTITY_3_H
