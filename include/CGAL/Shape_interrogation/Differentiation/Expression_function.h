// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTION_H

// A tape as the functor that surfaces and curves are made of: functions given as text get the same
// classes as functions written in C++.

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief is a function of `N` numbers with `K` values, made from recorded expressions.
 *
 * It is called with `N` numbers of any type and returns one number for `K` = 1, an array of `K` for
 * more: `Expression_function<3>` is a function for `Implicit_surface_3`, `Expression_function<2,
 * 3>` a map for `Parametric_surface_3`. It throws what `Expression_tape` throws. Const calls are
 * thread-safe.
 *
 * \tparam N the number of variables
 * \tparam K the number of values
 * \cgalModels{ImplicitFunction_3}
 */
template <int N, int K = 1>
class Expression_function
{
public:
  //! constructs the function that is zero.
  Expression_function() : Expression_function(std::vector<Expression>(K, Expression(0))) {}

  //! constructs a function with one value.
  explicit Expression_function(const Expression& f) : Expression_function(std::vector{f})
  {
    static_assert(K == 1, "a function with several values needs several expressions");
  }

  //! constructs the function with the values `f`. \pre `f.size() == K`
  explicit Expression_function(const std::vector<Expression>& f)
    : m_tape(f, N, Expression_tape::Derivatives::NONE)
  {
    CGAL_precondition_msg(f.size() == std::size_t(K), "one expression is needed for each value");
  }

  //! returns the tape.
  const Expression_tape& tape() const { return m_tape; }

  //! names the variables in messages.
  void set_variable_names(std::vector<std::string> names)
  {
    m_tape.set_variable_names(std::move(names));
  }

  //! computes the value or values.
  template <class NT, class... More>
  auto operator()(const NT& x, const More&... more) const
  {
    static_assert(1 + sizeof...(More) == N, "one number is needed for each variable");
    const std::array<NT, N> variables{x, more...};
    std::array<NT, K> values;
    evaluate(variables, values);
    if constexpr (K == 1)
      return NT(std::move(values[0]));
    else
      return values;
  }

private:
  // Memory is kept from call to call for the types that hold none of their own. The interpreter is
  // not for inlining, even where the caller is flattened.
  template <class NT>
  [[gnu::noinline]] void evaluate(const std::array<NT, N>& variables,
                                  std::array<NT, K>& values) const
  {
    if constexpr (std::is_trivially_destructible_v<NT>)
    {
      static thread_local std::vector<NT> workspace;
      m_tape.evaluate(variables.data(), values.data(), workspace);
    }
    else
    {
      std::vector<NT> workspace;
      m_tape.evaluate(variables.data(), values.data(), workspace);
    }
  }

  Expression_tape m_tape;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_FUNCTION_H
