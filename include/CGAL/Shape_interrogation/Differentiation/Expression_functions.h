// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTIONS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTIONS_H

// Powers and elementary functions of recorded expressions, found by argument-dependent lookup,
// through CGAL::square() and CGAL::sqrt(), and as Elementary_functions<Expression>.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>

#include <CGAL/Algebraic_structure_traits.h>

#include <limits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief returns \f$ x^n \f$; a negative exponent is \f$ 1/x^{-n} \f$.
 * \exception Division_by_zero_error for a negative power of the constant zero
 */
inline Expression pow(const Expression& x, int n)
{
  CGAL_precondition_msg(n != std::numeric_limits<int>::min(), "the exponent is out of range");
  return Expression(internal::power(x.handle(), n));
}

#ifndef DOXYGEN_RUNNING
namespace internal {

inline Expression record_function(Expression_operation op, const Expression& x)
{
  return Expression(function_of(op, x.handle()));
}

} // namespace internal
#endif

//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the square of `x`.
inline Expression square(const Expression& x) { return pow(x, 2); }
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the square root of `x`.
inline Expression sqrt(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::SQRT, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the exponential function of `x`.
inline Expression exp(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::EXP, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the natural logarithm of `x`.
inline Expression log(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::LOG, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the sine of `x`.
inline Expression sin(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::SIN, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the cosine of `x`.
inline Expression cos(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::COS, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the tangent of `x`.
inline Expression tan(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::TAN, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the inverse sine of `x`.
inline Expression asin(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::ASIN, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the inverse cosine of `x`.
inline Expression acos(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::ACOS, x);
}
//! \ingroup PkgShapeInterrogationDifferentiation
//! \brief records the inverse tangent of `x`.
inline Expression atan(const Expression& x)
{
  return internal::record_function(internal::Expression_operation::ATAN, x);
}

#ifndef DOXYGEN_RUNNING

template <>
struct Elementary_functions<Expression>
{
  using NT = Expression;
  static NT sqrt(const NT& x) { return Shape_interrogation::sqrt(x); }
  static NT exp(const NT& x) { return Shape_interrogation::exp(x); }
  static NT log(const NT& x) { return Shape_interrogation::log(x); }
  static NT sin(const NT& x) { return Shape_interrogation::sin(x); }
  static NT cos(const NT& x) { return Shape_interrogation::cos(x); }
  static NT tan(const NT& x) { return Shape_interrogation::tan(x); }
  static NT asin(const NT& x) { return Shape_interrogation::asin(x); }
  static NT acos(const NT& x) { return Shape_interrogation::acos(x); }
  static NT atan(const NT& x) { return Shape_interrogation::atan(x); }
  static NT pi() { return Expression::pi(); }
};

} // namespace Shape_interrogation

// CGAL::square() and CGAL::sqrt() of a recorded value.
template <>
class Algebraic_structure_traits<Shape_interrogation::Expression>
  : public Algebraic_structure_traits_base<Shape_interrogation::Expression, Null_tag>
{
  using Expression = Shape_interrogation::Expression;

public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;

  struct Square
  {
    using argument_type = Expression;
    using result_type = Expression;
    Expression operator()(const Expression& x) const { return Shape_interrogation::square(x); }
  };
  struct Sqrt
  {
    using argument_type = Expression;
    using result_type = Expression;
    Expression operator()(const Expression& x) const { return Shape_interrogation::sqrt(x); }
  };
  struct Inverse
  {
    using argument_type = Expression;
    using result_type = Expression;
    Expression operator()(const Expression& x) const { return Expression(1) / x; }
  };
};

#else
} // namespace Shape_interrogation
#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTIONS_H
