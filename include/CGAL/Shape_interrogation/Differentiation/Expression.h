// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_H

// A recorded expression: a cheap handle to an immutable DAG of operations with exact constants.
// It is a number type to a user's functor, which is thereby recorded instead of computed.

#include <CGAL/Shape_interrogation/Differentiation/internal/simplify_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <CGAL/assertions.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The numbers that an expression takes in exactly and without being asked.
template <class T>
struct Is_exact_number
  : std::bool_constant<std::is_arithmetic_v<T> ? !std::is_same_v<T, bool> &&
                                                   !std::is_same_v<T, long double>
                                               : std::is_convertible_v<const T&,
                                                                       CGAL::Exact_rational>>
{};

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief is a recorded function of variables \f$ x_0, x_1, \dots \f$ with exact rational
 * constants.
 *
 * \details An expression is made from numbers and variables with `+ - * /`, integer powers, `sqrt`,
 * `exp`, `log`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan` and \f$ \pi \f$. It behaves as a number
 * type, so that a functor written as `template <class NT> NT operator()(NT x, NT y, NT z) const` is
 * recorded by calling it (`record_expression()`); text is read by `parse_expression()`.
 * Values and derivatives are computed by an `Expression_tape`.
 *
 * The handle is a pointer; copies share their operations. Expressions are immutable and may be
 * shared between threads. Recording compares nothing: the order relations are deleted, as a branch
 * in a recorded functor would be taken once and for all.
 *
 * <b>Simplification.</b> Operations on constants are carried out exactly, also functions of
 * constants where the value is rational (`sqrt(9/4)`, `cos(0)`). Division by a constant becomes a
 * product with its reciprocal, so that `x/2` stays a polynomial. \f$ x + 0 \f$, \f$ 1 x \f$,
 * \f$ x/1 \f$, \f$ x^1 \f$, \f$ -(-x) \f$ are \f$ x \f$; \f$ x x \f$ is \f$ x^2 \f$. Nothing is
 * simplified where this would hide a point at which the expression has no value:
 * \f$ 0 x \f$, \f$ x^0 \f$ and \f$ x - x \f$ become \f$ 0 \f$, \f$ 1 \f$ and \f$ 0 \f$ only if
 * \f$ x \f$ has a value everywhere (no division, root, `log`, `tan`, `asin` or `acos` in it), and
 * \f$ x/x \f$ stays. \f$ 0^0 = 1 \f$.
 *
 * \exception Division_by_zero_error on division by the constant zero
 * \exception Limit_error if a constant grows beyond a million bits
 *
 * Complexity: each operation is constant (besides the arithmetic of constants).
 */
class Expression
{
public:
  /// \name Construction
  /// @{

  //! constructs the constant 0.
  Expression();

  //! constructs a constant: integers, finite `double`s and exact rationals, all exactly.
  //! \exception Conversion_error if `number` is infinite or not a number
#ifdef DOXYGEN_RUNNING
  template <class Number>
  Expression(const Number& number);
#else
  template <class Number, class = std::enable_if_t<internal::Is_exact_number<Number>::value>>
  Expression(const Number& number);
#endif

  //! returns the variable with the given index. \pre `index >= 0`
  static Expression variable(int index);

  //! returns the number \f$ \pi \f$.
  static Expression pi();

  /// @}
  /// \name Structure
  /// @{

  //! tells whether the expression is a rational constant.
  bool is_constant() const { return m_handle.is_constant(); }

  //! returns the constant. \pre `is_constant()`
  const CGAL::Exact_rational& constant() const
  {
    CGAL_precondition_msg(is_constant(), "the expression is not a constant");
    return m_handle.constant();
  }

  //! tells whether there is a division by a non-constant or a negative power.
  bool uses_division() const { return has(internal::USES_DIVISION); }
  //! tells whether there is a square root.
  bool uses_sqrt() const { return has(internal::USES_SQRT); }
  //! tells whether there is \f$ \pi \f$ or a function other than the square root.
  bool uses_transcendental() const { return has(internal::USES_TRANSCENDENTAL); }
  //! tells whether only `+ - *` and non-negative powers occur.
  bool is_polynomial() const
  {
    return !uses_division() && !uses_sqrt() && !uses_transcendental();
  }
  //! tells whether the function is algebraic: field operations, powers and square roots.
  bool is_algebraic() const { return !uses_transcendental(); }

  //! returns a bound of the total degree of a polynomial, saturated at \f$ 2^{32}-1 \f$.
  //! In general it counts as if quotients were products and functions their arguments, and so
  //! measures how long exact values can become.
  std::uint32_t degree_bound() const { return m_handle->degree; }

  //! tells whether both handles refer to the same recorded operation.
  bool is_identical(const Expression& other) const
  {
    return m_handle.get() == other.m_handle.get();
  }

  /// @}

#ifndef DOXYGEN_RUNNING
  explicit Expression(internal::Expression_handle handle) : m_handle(std::move(handle)) {}
  const internal::Expression_handle& handle() const { return m_handle; }

  friend Expression operator+(const Expression& a) { return a; }
  friend Expression operator-(const Expression& a)
  {
    return Expression(internal::negation(a.m_handle));
  }
  friend Expression operator+(const Expression& a, const Expression& b)
  {
    return Expression(internal::sum(a.m_handle, b.m_handle));
  }
  friend Expression operator-(const Expression& a, const Expression& b)
  {
    return Expression(internal::difference(a.m_handle, b.m_handle));
  }
  friend Expression operator*(const Expression& a, const Expression& b)
  {
    return Expression(internal::product(a.m_handle, b.m_handle));
  }
  friend Expression operator/(const Expression& a, const Expression& b)
  {
    return Expression(internal::quotient(a.m_handle, b.m_handle));
  }
  Expression& operator+=(const Expression& b) { return *this = *this + b; }
  Expression& operator-=(const Expression& b) { return *this = *this - b; }
  Expression& operator*=(const Expression& b) { return *this = *this * b; }
  Expression& operator/=(const Expression& b) { return *this = *this / b; }

  friend bool operator==(const Expression&, const Expression&) = delete;
  friend bool operator!=(const Expression&, const Expression&) = delete;
  friend bool operator<(const Expression&, const Expression&) = delete;
  friend bool operator>(const Expression&, const Expression&) = delete;
  friend bool operator<=(const Expression&, const Expression&) = delete;
  friend bool operator>=(const Expression&, const Expression&) = delete;
#endif

private:
  bool has(internal::Expression_property p) const { return (m_handle->properties & p) != 0; }

  internal::Expression_handle m_handle;
};

#ifndef DOXYGEN_RUNNING

inline Expression::Expression() : m_handle(internal::zero_constant()) {}

template <class Number, class>
inline Expression::Expression(const Number& number)
  : m_handle(internal::make_constant(internal::exact_number(number)))
{}

inline Expression Expression::variable(int index)
{
  CGAL_precondition_msg(index >= 0, "the index of a variable is not negative");
  return Expression(internal::make_leaf(internal::Expression_operation::VARIABLE, index));
}

inline Expression Expression::pi()
{
  return Expression(internal::make_leaf(internal::Expression_operation::PI, 0));
}

template <>
struct Number_type_traits<Expression>
{
  using Boolean = Uncertain<bool>;
  static constexpr bool is_exact = true;
  static constexpr bool is_enclosure = false;
  static Boolean is_zero(const Expression& x)
  {
    return x.is_constant() ? Boolean(CGAL::is_zero(x.constant())) : Boolean::indeterminate();
  }
};

#endif // DOXYGEN_RUNNING

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_H
