// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_2_H
#define CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_2_H

// The waist in the plane: the second-order data (N, b) of a curve at a point.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is the second-order data of a planar curve at one of its points: the point, an
 * unnormalised normal \f$ N \f$ and a number \f$ b \f$.
 *
 * With \f$ q = N \cdot N \f$ the curvature is \f$ b / \sqrt q \f$ and the Hessian of the normalform
 * is \f$ b \, t t^T / (q \sqrt q) \f$ with \f$ t = (-N_y, N_x) \f$. The sign rule is that of
 * `Local_shape_3`: a circle of radius \f$ r \f$ with outward normal has curvature \f$ +1/r \f$.
 * Reversing the normal replaces \f$ (N, b) \f$ by \f$ (-N, -b) \f$.
 * (The bordered determinant form printed in Hartmann, section 3.1, has the opposite sign.)
 *
 * \tparam NT a ring number type for decisions, a field number type for values
 */
template <class NT>
class Local_shape_2
{
public:
  using FT = NT;                     //!< the number type
  using Vector = Coordinates<NT, 2>; //!< a point or a vector

  //! constructs data that must be assigned before use.
  Local_shape_2() = default;

  /*!
   * \brief constructs the data from the numerator \f$ q \, b \f$ , which needs no division:
   * minus the bordered Hessian determinant of an implicit curve with gradient `normal`, or
   * \f$ \det(c'', c') \f$ of a parametrised one with normal \f$ (-c_2', c_1') \f$.
   * \pre `normal` is not zero
   */
  Local_shape_2(const Vector& point, const Vector& normal, const NT& numerator)
    : Local_shape_2(point, normal, internal::dot(normal, normal), numerator)
  {
    CGAL_precondition_msg(CGAL::possibly(!is_zero_decision(m_q)), "the normal must not be zero");
  }

  /*!
   * \brief returns the data, or a refusal with the given code where `normal` is zero or perhaps is;
   * `what` names its squared length in the evidence.
   */
  static Result<Local_shape_2> make(const Vector& point, const Vector& normal, const NT& numerator,
                                    Refusal_code code, const char* what)
  {
    const NT q = internal::dot(normal, normal);
    if (auto refusal = internal::refuse_zero(q, code, what))
      return *refusal;
    return Local_shape_2(point, normal, q, numerator);
  }

  const Vector& point() const { return m_point; }   //!< returns the point.
  const Vector& normal() const { return m_normal; } //!< returns the unnormalised normal.

  //! returns \f$ q = N \cdot N \f$.
  const NT& normal_squared_length() const { return m_q; }

  //! returns \f$ q \, b \f$; its sign is the sign of the curvature.
  const NT& numerator() const { return m_numerator; }

  //! returns \f$ b \f$. Needs a field.
  NT shape_number() const
  {
    NT b = m_numerator / m_q;
    return b;
  }

  //! returns \f$ t t^T b / q \f$, the Hessian of the normalform times \f$ \sqrt q \f$, as
  //! xx, xy, yy. Needs a field.
  std::array<NT, 3> shape_matrix() const
  {
    const NT c = m_numerator / (m_q * m_q);
    return {NT(c * m_normal[1] * m_normal[1]), NT(-(c * m_normal[0] * m_normal[1])),
            NT(c * m_normal[0] * m_normal[0])};
  }

  //! returns the data of the same curve with the opposite normal.
  Local_shape_2 opposite() const
  {
    return Local_shape_2(m_point, {NT(-m_normal[0]), NT(-m_normal[1])}, m_q, NT(-m_numerator));
  }

  //! returns the data in another number type, converted by `number_cast()`.
  template <class To>
  Local_shape_2<To> cast() const
  {
    using Other = typename Local_shape_2<To>::Vector;
    const Other normal{number_cast<To>(m_normal[0]), number_cast<To>(m_normal[1])};
    return Local_shape_2<To>({number_cast<To>(m_point[0]), number_cast<To>(m_point[1])}, normal,
                             internal::dot(normal, normal), number_cast<To>(m_numerator));
  }

private:
  template <class> friend class Local_shape_2;

  Local_shape_2(const Vector& point, const Vector& normal, const NT& q, const NT& numerator)
    : m_point(point), m_normal(normal), m_q(q), m_numerator(numerator)
  {}

  Vector m_point, m_normal;
  NT m_q, m_numerator;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_2_H
