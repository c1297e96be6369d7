// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_BERNSTEIN_POLYNOMIAL_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_BERNSTEIN_POLYNOMIAL_H

// Polynomials on the unit cube in Bernstein form, a ring: sum, product and derivative of Elber and
// Cohen, section 2, over any number type and without division.

#include <CGAL/Shape_interrogation/Bernstein/internal/axis_operations.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/assertions.h>

#include <boost/operators.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief is a polynomial in `d` variables on the unit cube in tensor product Bernstein form,
 * \f$ \sum b_{ij} B^m_i(u) B^n_j(v) \f$ for `d` = 2.
 *
 * It keeps the *scaled* coefficients \f$ \binom{m}{i} \binom{n}{j} b_{ij} \f$, those of
 * \f$ u^i (1-u)^{m-i} v^j (1-v)^{n-j} \f$: with them sums, products, derivatives and restrictions
 * need a ring only, and polynomials with integer control points stay in the integers. Only
 * `coefficient()` divides.
 *
 * Degrees are formal: a sum has the greater one in each variable, a product their sum, and nothing
 * is cancelled, as for spline functions it must be. A constant converts to a polynomial of degree 0
 * so that the generic formulas of the package run over polynomials as they run over numbers. (A
 * polynomial is not an ordered number: there is no sign.)
 *
 * Coefficient arrays are in the order of the first variable, then the second: element
 * \f$ i (n + 1) + j \f$ for `d` = 2.
 *
 * \tparam NT a ring number type; enclosures allowed
 * \tparam d the number of variables, at least 1
 *
 * Complexity: a product of polynomials with a and b coefficients takes a b operations; over
 * `CGAL::Exact_integer` and `CGAL::Exact_rational` one multiplication of integers with all the
 * coefficients packed into them (Kronecker substitution) where that is faster.
 */
template <class NT, int d>
class Bernstein_polynomial : boost::additive1<Bernstein_polynomial<NT, d>>
{
public:
  using FT = NT;                        //!< the number type
  using Degree = std::array<int, d>;    //!< the degree in each variable
  using Index = std::array<int, d>;     //!< the index of a coefficient
  using Point = std::array<NT, d>;      //!< a point of the unit cube

  //! constructs the polynomial 0 of degree 0.
  Bernstein_polynomial() : Bernstein_polynomial(NT(0)) {}
  //! constructs a constant.
  Bernstein_polynomial(const NT& constant) : m_scaled(1, constant) { m_degree.fill(0); }
  //! constructs a constant.
  Bernstein_polynomial(int constant) : Bernstein_polynomial(NT(constant)) {}

  //! returns the polynomial with the given Bernstein coefficients.
  //! \pre there are \f$ \prod (m_k + 1) \f$ coefficients, and no degree is negative
  static Bernstein_polynomial from_coefficients(const Degree& degree, std::vector<NT> coefficients)
  {
    Bernstein_polynomial p = from_scaled_coefficients(degree, std::move(coefficients));
    const std::vector<NT> scales = internal::scaling<NT>(degree);
    for (std::size_t i = 0; i < scales.size(); ++i)
      p.m_scaled[i] = p.m_scaled[i] * scales[i];
    return p;
  }

  //! returns the polynomial with the given scaled coefficients. \pre as above
  static Bernstein_polynomial from_scaled_coefficients(const Degree& degree,
                                                       std::vector<NT> coefficients)
  {
    CGAL_precondition_msg(*std::min_element(degree.begin(), degree.end()) >= 0 &&
                            coefficients.size() == internal::size_of(degree),
                          "a polynomial of degree (m, n) has (m + 1)(n + 1) coefficients");
    Bernstein_polynomial p;
    p.m_degree = degree;
    p.m_scaled = std::move(coefficients);
    return p;
  }

  //! returns the coordinate with the number `axis`, as a polynomial of degree 1 in it.
  static Bernstein_polynomial coordinate(int axis)
  {
    Degree degree{};
    degree[axis] = 1;
    return from_scaled_coefficients(degree, {NT(0), NT(1)});
  }

  const Degree& degree() const { return m_degree; }                  //!< returns the degrees.
  const std::vector<NT>& scaled_coefficients() const { return m_scaled; } //!< returns all of them.

  //! returns a scaled coefficient. \pre the index is in range
  const NT& scaled_coefficient(const Index& index) const
  {
    return m_scaled[internal::position(m_degree, index)];
  }

  //! returns a Bernstein coefficient. Needs a field. \pre the index is in range
  NT coefficient(const Index& index) const
  {
    NT scale(1);
    for (int axis = 0; axis < d; ++axis)
      scale = scale * internal::binomials_in<NT>(m_degree[axis])[index[axis]];
    NT b = scaled_coefficient(index) / scale;
    return b;
  }

  //! returns all Bernstein coefficients. Needs a field.
  std::vector<NT> coefficients() const
  {
    std::vector<NT> b = m_scaled;
    const std::vector<NT> scales = internal::scaling<NT>(m_degree);
    for (std::size_t i = 0; i < b.size(); ++i)
      b[i] = b[i] / scales[i];
    return b;
  }

  //! tells whether the polynomial is identically zero: all coefficients are.
  typename Number_type_traits<NT>::Boolean is_zero() const
  {
    typename Number_type_traits<NT>::Boolean is_zero(true);
    for (const NT& c : m_scaled)
      is_zero = is_zero & is_zero_decision(c);
    return is_zero;
  }

  //! returns the value at a point, which may lie outside the unit cube.
  NT operator()(const Point& x) const { return at(x); }

  /*!
   * \brief returns the value at a point with coordinates in another ring `T`, constructible from
   * `NT`: at a point with polynomials as coordinates it is the composition.
   */
  template <class T>
  T at(const std::array<T, d>& x) const
  {
    std::array<T, d> complement;
    for (int axis = 0; axis < d; ++axis)
      complement[axis] = T(1) - x[axis];
    return internal::value_homogeneous(
      m_degree, std::vector<T>(m_scaled.begin(), m_scaled.end()), x, complement);
  }

  //! returns the partial derivative in the variable `axis`, of a degree less by one (of a constant:
  //! 0 of degree 0).
  Bernstein_polynomial derivative(int axis) const
  {
    if (m_degree[axis] == 0)
      return from_scaled_coefficients(m_degree, std::vector<NT>(m_scaled.size(), NT(0)));
    return with_lines(axis, m_degree[axis] - 1,
                      internal::differentiated_lines(m_scaled, layout(axis)));
  }

  //! returns the same polynomial with the degrees `degree`. \pre no degree is less than it was
  Bernstein_polynomial elevated(const Degree& degree) const
  {
    Bernstein_polynomial p = *this;
    for (int axis = 0; axis < d; ++axis)
    {
      CGAL_precondition_msg(degree[axis] >= m_degree[axis], "elevation does not lower a degree");
      for (int n = m_degree[axis] + 1; n <= degree[axis]; ++n)
        p = p.with_lines(axis, n, internal::elevated_lines(p.m_scaled, p.layout(axis)));
    }
    return p;
  }

  /*!
   * \brief returns the polynomial in \f$ x \f$ after \f$ u = a (1 - x) + b x \f$ in the variable
   * `axis`: the part over \f$ [a, b] \f$, on the unit interval again.
   */
  Bernstein_polynomial restricted(int axis, const NT& a, const NT& b) const
  {
    return with_lines(axis, m_degree[axis],
                      internal::multiplied_lines(
                        m_scaled, layout(axis),
                        internal::restriction_matrix(m_degree[axis], a, b, NT(1))));
  }

  //! returns the polynomial in the other variables where the variable `axis` has the value `x`.
  //! \pre `d` is at least 2
  Bernstein_polynomial<NT, d - 1> fixed(int axis, const NT& x) const
  {
    return Bernstein_polynomial<NT, d - 1>::from_scaled_coefficients(
      internal::without_axis(m_degree, axis),
      internal::fixed_lines(
        m_scaled, layout(axis),
        internal::homogeneous_powers(m_degree[axis], x, NT(NT(1) - x))));
  }

  //! returns the polynomial in another number type; the scaled coefficients are converted.
  template <class To>
  Bernstein_polynomial<To, d> cast() const
  {
    std::vector<To> scaled;
    for (const NT& c : m_scaled)
      scaled.push_back(number_cast<To>(c));
    return Bernstein_polynomial<To, d>::from_scaled_coefficients(m_degree, std::move(scaled));
  }

  /// \name Ring operations
  /// @{

  //! adds `q`; there is the sum of two as well.
  Bernstein_polynomial& operator+=(const Bernstein_polynomial& q)
  {
    return combine(q, [](NT& a, const NT& b) { a += b; });
  }
  //! subtracts `q`; there is the difference of two as well.
  Bernstein_polynomial& operator-=(const Bernstein_polynomial& q)
  {
    return combine(q, [](NT& a, const NT& b) { a -= b; });
  }
  //! returns the negative.
  friend Bernstein_polynomial operator-(Bernstein_polynomial p)
  {
    for (NT& c : p.m_scaled)
      c = -c;
    return p;
  }
  //! returns the product.
  friend Bernstein_polynomial operator*(const Bernstein_polynomial& p,
                                        const Bernstein_polynomial& q)
  {
    Degree degree;
    for (int axis = 0; axis < d; ++axis)
      degree[axis] = p.m_degree[axis] + q.m_degree[axis];
    return from_scaled_coefficients(
      degree, internal::multiply_arrays(p.m_degree, p.m_scaled, q.m_degree, q.m_scaled));
  }
  //! multiplies by `q`.
  Bernstein_polynomial& operator*=(const Bernstein_polynomial& q) { return *this = *this * q; }

  /// @}

private:
  internal::Axis_layout layout(int axis) const
  {
    return internal::axis_layout(m_degree, axis);
  }

  // The polynomial with other lines along the axis.
  Bernstein_polynomial with_lines(int axis, int degree, std::vector<NT> scaled) const
  {
    Degree degrees = m_degree;
    degrees[axis] = degree;
    return from_scaled_coefficients(degrees, std::move(scaled));
  }

  template <class Combine>
  Bernstein_polynomial& combine(const Bernstein_polynomial& q, Combine combine)
  {
    Degree degree;
    for (int axis = 0; axis < d; ++axis)
      degree[axis] = (std::max)(m_degree[axis], q.m_degree[axis]);
    if (m_degree != degree)
      *this = elevated(degree);
    if (q.m_degree != degree)
      return this->combine(q.elevated(degree), combine);
    for (std::size_t i = 0; i < m_scaled.size(); ++i)
      combine(m_scaled[i], q.m_scaled[i]);
    return *this;
  }

  Degree m_degree;
  std::vector<NT> m_scaled;
};

/// \ingroup PkgShapeInterrogationBernstein
/// @{

//! is a polynomial on the unit interval.
template <class NT>
using Bernstein_polynomial_1 = Bernstein_polynomial<NT, 1>;
//! is a polynomial on the unit square.
template <class NT>
using Bernstein_polynomial_2 = Bernstein_polynomial<NT, 2>;

/// @}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_BERNSTEIN_POLYNOMIAL_H
