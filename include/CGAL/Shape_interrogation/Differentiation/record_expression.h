// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_RECORD_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_RECORD_EXPRESSION_H

// Records a user's functor by calling it once with variables.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

template <int N, int... I>
std::array<Expression, N> expression_variables(std::integer_sequence<int, I...>)
{
  return {Expression::variable(I)...};
}

template <int> using Always_expression = Expression;

// Whether F takes N separate arguments.
template <class F, class Sequence> struct Takes_arguments;
template <class F, int... I>
struct Takes_arguments<F, std::integer_sequence<int, I...>>
  : std::is_invocable<const F&, Always_expression<I>...>
{};

template <class F, int... I>
decltype(auto) call_recorded(const F& f, std::integer_sequence<int, I...>)
{
  return f(Expression::variable(I)...);
}

template <int N, class F>
decltype(auto) call_recorded(const F& f)
{
  using Sequence = std::make_integer_sequence<int, N>;
  using Point = std::array<Expression, N>;
  if constexpr (Takes_arguments<F, Sequence>::value)
    return call_recorded(f, Sequence());
  else
  {
    static_assert(std::is_invocable_v<const F&, const Point&>,
                  "the functor must be callable with N numbers of any number type, or with a"
                  " std::array of N of them");
    return f(expression_variables<N>(Sequence()));
  }
}

// A functor may also return a plain number.
inline Expression as_expressions(const Expression& e) { return e; }

template <class T, std::size_t K>
std::array<Expression, K> as_expressions(const std::array<T, K>& values)
{
  std::array<Expression, K> result;
  for (std::size_t k = 0; k < K; ++k)
    result[k] = values[k];
  return result;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief records a functor by calling it once with the variables \f$ x_0, \dots, x_{N-1} \f$.
 *
 * \tparam N the number of variables
 * \tparam F a functor that is templated on its number type: `template <class NT> NT operator()(NT
 *   x, NT y, NT z) const` with `N` arguments, or one argument `const std::array<NT, N>&`. It may
 *   also return `std::array<NT, K>`. A generic lambda will do.
 * \param f the functor; it must not branch on the values of its arguments
 * \return an `Expression`, or a `std::array<Expression, K>`
 */
template <int N, class F>
auto record_expression(const F& f)
{
  return internal::as_expressions(internal::call_recorded<N>(f));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_RECORD_EXPRESSION_H
