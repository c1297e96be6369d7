// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_3_H
#define CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_3_H

// The waist of the hourglass: the second-order data (N, B) of a surface at a point.
// Everything is rational in the input and, until a value is asked for, free of divisions.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/assertions.h>

#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is the second-order data of a surface at one of its points: the point, an unnormalised
 * normal \f$ N \f$ and the symmetric 3x3 matrix \f$ B \f$ with \f$ B N = 0 \f$.
 *
 * Every representation of a surface produces it, every question consumes nothing else.
 * With \f$ q = N \cdot N \f$ the Hessian of the normalform (the oriented distance) is
 * \f$ B / \sqrt q \f$, and the normal curvature in a tangent direction \f$ v \f$ is
 * \f$ v^T B v / (\sqrt q \, v \cdot v) \f$.
 *
 * <b>Sign and orientation.</b> Curvature is the change of the unit normal: a sphere of radius
 * \f$ r \f$ with outward normal has curvature \f$ +1/r \f$ in all directions. Reversing the normal
 * replaces \f$ (N, B) \f$ by \f$ (-N, -B) \f$: the Gaussian curvature stays, mean and principal
 * curvatures change their signs. (O'Neill's shape operator, and Chuang-Hoffmann, Elber-Cohen and
 * Pegna-Wolter for the same normal, have the opposite sign.) This is the one rule of the package.
 *
 * <b>Storage.</b> As a homogeneous kernel keeps a common denominator, so does this class: it keeps
 * a symmetric form \f$ T \f$ and a positive denominator \f$ w \f$ with \f$ B = P T P / w \f$,
 * \f$ P = I - N N^T / q \f$ , and the numerators of trace and minors,
 * \f$ a = w \, q \, \mathrm{tr} B \f$ and \f$ b = w^2 q \, m_2(B) \f$, which a representation
 * computes in the lowest possible degree. Every decision is a polynomial in \f$ N, T, w, a, b \f$.
 *
 * \tparam NT a ring number type for decisions, a field number type for values; enclosures allowed
 */
template <class NT>
class Local_shape_3
{
public:
  using FT = NT;                          //!< the number type
  using Vector = Coordinates<NT, 3>;      //!< a point or a vector
  using Matrix = Symmetric_matrix_3<NT>;  //!< a symmetric matrix

  //! constructs data that must be assigned before use.
  Local_shape_3() = default;

  /*!
   * \brief constructs the data from \f$ N \f$ and \f$ B \f$.
   * \pre `normal` is not zero, and `b` annihilates it (checked as an exactness precondition)
   */
  Local_shape_3(const Vector& point, const Vector& normal, const Matrix& b)
    : Local_shape_3(point, normal, b, NT(1))
  {
    CGAL_precondition_msg(CGAL::possibly(!is_zero_decision(m_q)), "the normal must not be zero");
    CGAL_exactness_precondition_msg(annihilates_normal(), "B N must be 0");
  }

  /*!
   * \brief returns the data for the normal `n` and the form \f$ P\,T\,P / w \f$.
   *
   * For an implicit surface `f = 0`, `n` is the gradient, `t` the Hessian matrix and `w` is 1.
   * A representation that cannot know whether its normal vanishes refuses afterwards.
   * \pre `n` is not zero and `w` is positive (not checked)
   */
  static Local_shape_3 from_form(const Vector& point, const Vector& n, const Matrix& t,
                                 const NT& w = NT(1))
  {
    return Local_shape_3(point, n, t, w);
  }

  /*!
   * \brief returns the data for two tangent vectors and the second derivatives of the height over
   * the tangent plane.
   *
   * The normal is `w1 x w2`; `h11, h12, h22` is the form \f$ -w_i \cdot \f$ (the second derivative
   * of the surface against that normal), that is \f$ -\hat L, -\hat M, -\hat N \f$ of a
   * parametrisation with partial derivatives `w1, w2`, divided by the positive number `scale`.
   * \pre `w1` and `w2` are linearly independent
   */
  static Local_shape_3 from_frame(const Vector& point, const Vector& w1, const Vector& w2,
                                  const NT& h11, const NT& h12, const NT& h22,
                                  const NT& scale = NT(1))
  {
    Local_shape_3 s;
    s.m_point = point;
    s.m_normal = internal::cross(w1, w2);
    const NT e = internal::dot(w1, w1), f = internal::dot(w1, w2), g = internal::dot(w2, w2);
    s.m_q = internal::dot(s.m_normal, s.m_normal);
    s.m_b = h11 * h22 - h12 * h12;
    const NT fh = f * h12;
    s.m_a = e * h22 - fh - fh + g * h11;
    // T = W adj(I) h adj(I) W^T over q^2: with the reciprocal frame r1 = g w1 - f w2,
    // r2 = e w2 - f w1 this is h11 r1 r1^T + h12 (r1 r2^T + r2 r1^T) + h22 r2 r2^T.
    Vector r1, r2;
    for (int i = 0; i < 3; ++i)
    {
      r1[i] = g * w1[i] - f * w2[i];
      r2[i] = e * w2[i] - f * w1[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      const NT s1 = h11 * r1[i] + h12 * r2[i], s2 = h12 * r1[i] + h22 * r2[i];
      for (int j = i; j < 3; ++j)
        s.m_form(i, j) = s1 * r1[j] + s2 * r2[j];
    }
    // a and b above belong to w = scale; bring them to the denominator of the form.
    s.m_scale = scale;
    s.m_denominator = s.m_q * s.m_q * scale;
    return s;
  }

  const Vector& point() const { return m_point; }   //!< returns the point.
  const Vector& normal() const { return m_normal; } //!< returns the unnormalised normal \f$ N \f$.

  //! returns \f$ q = N \cdot N \f$, which is positive.
  const NT& normal_squared_length() const { return m_q; }

  //! returns the form \f$ T \f$ with \f$ B = P T P / w \f$, \f$ w \f$ = `form_denominator()`.
  const Matrix& form() const { return m_form; }

  //! returns the positive denominator \f$ w \f$ of the form.
  const NT& form_denominator() const { return m_denominator; }

  //! returns \f$ c \, q \, \mathrm{tr} B \f$ with \f$ c \f$ = `scale()`: no division.
  const NT& trace_numerator() const { return m_a; }

  //! returns \f$ c^2 q \, m_2(B) \f$, where \f$ m_2 \f$ is the sum of the principal minors and
  //! \f$ c \f$ = `scale()`: no division.
  const NT& minors_numerator() const { return m_b; }

  //! returns the positive common factor \f$ c \f$ of the two numerators.
  const NT& scale() const { return m_scale; }

  //! returns \f$ B \f$. Needs a field.
  Matrix shape_matrix() const
  {
    const Vector u = internal::multiply(m_form, m_normal);
    const NT r = NT(1) / m_q;
    const NT s = internal::dot(m_normal, u) * r;
    const NT d = NT(1) / m_denominator;
    Matrix b;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
      {
        const NT mixed = m_normal[i] * u[j] + m_normal[j] * u[i] - s * m_normal[i] * m_normal[j];
        b(i, j) = (m_form(i, j) - mixed * r) * d;
      }
    return b;
  }

  //! returns \f$ w q^2 B \f$, a positive multiple of \f$ B \f$, without division.
  Matrix scaled_shape_matrix() const
  {
    const Vector u = internal::multiply(m_form, m_normal);
    const NT s = internal::dot(m_normal, u);
    Matrix b;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
      {
        const NT mixed = m_q * m_form(i, j) - m_normal[i] * u[j] - m_normal[j] * u[i];
        b(i, j) = m_q * mixed + s * m_normal[i] * m_normal[j];
      }
    return b;
  }

  //! returns the data of the same surface with the opposite normal.
  Local_shape_3 opposite() const { return scaled_normal(NT(-1)); }

  //! returns the data of the same surface with the normal multiplied by `mu`. \pre `mu` is not 0
  Local_shape_3 scaled_normal(const NT& mu) const
  {
    Local_shape_3 s = *this;
    for (NT& x : s.m_normal)
      x = x * mu;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        s.m_form(i, j) = m_form(i, j) * mu;
    const NT mu2 = mu * mu;
    s.m_q = m_q * mu2;
    s.m_a = m_a * mu * mu2;
    s.m_b = m_b * mu2 * mu2;
    return s;
  }

  //! returns the same data at another point.
  Local_shape_3 at(const Vector& point) const
  {
    Local_shape_3 s = *this;
    s.m_point = point;
    return s;
  }

  //! returns the data in another number type, converted by `number_cast()`.
  template <class To>
  Local_shape_3<To> cast() const
  {
    Local_shape_3<To> s;
    for (int i = 0; i < 3; ++i)
    {
      s.m_point[i] = number_cast<To>(m_point[i]);
      s.m_normal[i] = number_cast<To>(m_normal[i]);
      for (int j = i; j < 3; ++j)
        s.m_form(i, j) = number_cast<To>(m_form(i, j));
    }
    s.m_q = number_cast<To>(m_q);
    s.m_a = number_cast<To>(m_a);
    s.m_b = number_cast<To>(m_b);
    s.m_scale = number_cast<To>(m_scale);
    s.m_denominator = number_cast<To>(m_denominator);
    return s;
  }

private:
  template <class> friend class Local_shape_3;

  // a = q tr T - n'Tn and b = n' adj(T) n: the bordered determinants, degrees 3 and 4.
  Local_shape_3(const Vector& point, const Vector& n, const Matrix& t, const NT& w)
    : m_point(point), m_normal(n), m_q(internal::dot(n, n)), m_form(t), m_denominator(w),
      m_scale(w)
  {
    m_a = m_q * internal::trace(t) - internal::dot(n, internal::multiply(t, n));
    m_b = internal::bordered(t, n);
  }

  bool annihilates_normal() const
  {
    const Vector u = internal::multiply(m_form, m_normal);
    return CGAL::possibly(is_zero_decision(u[0])) && CGAL::possibly(is_zero_decision(u[1])) &&
           CGAL::possibly(is_zero_decision(u[2]));
  }

  Vector m_point, m_normal;
  NT m_q;
  Matrix m_form;
  NT m_denominator, m_a, m_b, m_scale;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_LOCAL_SHAPE_3_H
