// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_TAPE_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_TAPE_H

// Compiled expressions: values in any number type, and sparse gradients by a reverse sweep that
// was carried out once, on the recorded operations.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/division_message.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/run_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_program.h>
#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>

#include <CGAL/assertions.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief evaluates expressions \f$ f_1, \dots, f_m \f$ of \f$ n \f$ variables and their sparse
 * gradients, in any number type.
 *
 * \details The tape is a flat list of operations in which equal subexpressions of all outputs are
 * computed once. Gradients come from a reverse sweep over the part of the expression that an output
 * depends on; it is carried out on the recorded operations when the tape is built, so that
 * evaluation runs one loop, factors \f$ \pm 1 \f$ cost nothing and entries that are constant are
 * known beforehand. Second derivatives along directions are values over jets: evaluate over
 * `Jet<NT, 2, 2>`, with each variable a `Jet::along()` the directions.
 *
 * Constants are converted by `number_cast()` (`double` and intervals have them ready), functions
 * come from `Elementary_functions`. A ring without `operator/` can be used where
 * nothing is divided. `Interval_nt<false>` needs the rounding protection of the caller.
 *
 * Evaluation does not change the tape: it may be shared by threads, each with its own workspace. A
 * workspace may be used with different tapes; it grows when needed and is never shrunk.
 *
 * The evaluating members throw `Division_by_zero_error` where a divisor is certainly zero,
 * `Not_algebraic_error` where the number type lacks a function, and `Domain_error` where an
 * argument is certainly outside a function's domain.
 *
 * Complexity: construction is linear in the recorded operations, for gradients in the sum over the
 * outputs of the operations below each (besides sorting); evaluation is linear in the operations.
 */
class Expression_tape
{
public:
  //! What a tape is built for.
  enum class Derivatives
  {
    NONE,    //!< values (in all number types, jets included)
    GRADIENT //!< values and gradients
  };

  /// \name Construction
  /// @{

  //! constructs a tape without outputs and variables.
  Expression_tape() = default;

  /*!
   * \brief compiles expressions.
   * \param outputs the expressions
   * \param number_of_variables `n`: variables have the indices `0` to `n-1`
   * \param derivatives whether gradients will be asked for
   * \param limits the bounds for the number of operations and for the degree
   * \exception Limit_error if a limit is exceeded
   * \exception Shape_error if a variable has an index that is not below `number_of_variables`
   */
  Expression_tape(const std::vector<Expression>& outputs, int number_of_variables,
                  Derivatives derivatives = Derivatives::GRADIENT,
                  const Expression_limits& limits = Expression_limits())
    : m_number_of_variables(number_of_variables), m_expressions(outputs)
  {
    CGAL_precondition_msg(number_of_variables >= 0, "the number of variables is not negative");
    internal::Tape_assembler assemble(number_of_variables, limits);
    m_program = assemble(outputs, derivatives == Derivatives::GRADIENT);
  }

  /// @}
  /// \name Structure
  /// @{

  //! returns the number of variables.
  int number_of_variables() const { return m_number_of_variables; }
  //! returns the number of outputs.
  int number_of_outputs() const { return static_cast<int>(m_expressions.size()); }
  //! returns the number of operations that compute the values.
  std::size_t number_of_operations() const { return m_program.value_operations; }
  //! returns the number of operations that compute values and gradients.
  std::size_t number_of_all_operations() const { return m_program.code.size(); }
  //! tells whether gradients were compiled.
  bool has_gradient() const { return m_program.pattern.number_of_rows() == m_expressions.size(); }

  //! returns output `i` as it was given.
  const Expression& output(int i) const { return m_expressions[i]; }

  //! tells whether all outputs are polynomials; for a single one ask `output(i)`.
  bool is_polynomial() const { return all_of([](auto& f) { return f.is_polynomial(); }); }
  //! tells whether all outputs are algebraic functions.
  bool is_algebraic() const { return all_of([](auto& f) { return f.is_algebraic(); }); }
  //! tells whether no output divides.
  bool is_division_free() const { return all_of([](auto& f) { return !f.uses_division(); }); }

  //! returns where the gradients have entries: row `i` for output `i`, a column for each variable
  //! that its value depends on. \pre `has_gradient()`
  const Sparse_pattern& gradient_pattern() const
  {
    CGAL_precondition_msg(has_gradient(), "the tape was built without gradients");
    return m_program.pattern;
  }

  //! returns the value of entry `k` of the gradients if it is constant. \pre `has_gradient()`
  std::optional<CGAL::Exact_rational> constant_gradient_entry(std::size_t k) const
  {
    CGAL_precondition_msg(has_gradient(), "the tape was built without gradients");
    const std::uint32_t* constant = m_program.gradient.find_constant(k);
    if (!constant)
      return std::nullopt;
    return m_program.constants.exact[*constant];
  }

  //! tells whether all constants are exactly representable as `double`, so that rings of dyadic
  //! numbers can take them.
  bool has_double_constants() const
  {
    const auto& enclosures = m_program.constants.enclosure;
    return std::all_of(enclosures.begin(), enclosures.end(), [](auto& x) { return x.is_point(); });
  }

  //! names the variables in messages; without names they are `x0`, `x1`, ...
  void set_variable_names(std::vector<std::string> names) { m_names = std::move(names); }

  /// @}
  /// \name Evaluation
  /// @{

  /*!
   * \brief computes the values.
   * \tparam NT a number type
   * \param variables the `n` variables
   * \param outputs receives the `m` values
   * \param workspace memory for reuse; must not contain `variables` or `outputs`
   */
  template <class NT>
  void evaluate(const NT* variables, NT* outputs, std::vector<NT>& workspace) const
  {
    const NT* slots = run(variables, m_program.value_operations, workspace);
    m_program.values.gather(slots, m_program.constants, outputs);
  }

  //! returns the values. \pre `variables.size() == number_of_variables()`
  template <class NT>
  std::vector<NT> evaluate(const std::vector<NT>& variables) const
  {
    CGAL_precondition_msg(int(variables.size()) == number_of_variables(),
                          "one number is needed for each variable");
    std::vector<NT> outputs(m_expressions.size()), workspace;
    evaluate(variables.data(), outputs.data(), workspace);
    return outputs;
  }

  /*!
   * \brief computes the values and the entries of the gradients.
   * \tparam NT a number type
   * \param variables the `n` variables
   * \param outputs receives the `m` values; may be null if they are not needed
   * \param gradient receives the entries of `gradient_pattern()`
   * \param workspace memory for reuse; must not contain the other arguments
   * \pre `has_gradient()`
   */
  template <class NT>
  void evaluate_with_gradient(const NT* variables, NT* outputs, NT* gradient,
                              std::vector<NT>& workspace) const
  {
    CGAL_precondition_msg(has_gradient(), "the tape was built without gradients");
    const NT* slots = run(variables, m_program.code.size(), workspace);
    if (outputs)
      m_program.values.gather(slots, m_program.constants, outputs);
    m_program.gradient.gather(slots, m_program.constants, gradient);
  }

  //! returns the entries of `gradient_pattern()`. \pre `has_gradient()`
  //! \pre `variables.size() == number_of_variables()`
  template <class NT>
  std::vector<NT> gradient(const std::vector<NT>& variables) const
  {
    CGAL_precondition_msg(int(variables.size()) == number_of_variables(),
                          "one number is needed for each variable");
    std::vector<NT> entries(m_program.gradient.size()), workspace;
    evaluate_with_gradient<NT>(variables.data(), nullptr, entries.data(), workspace);
    return entries;
  }

  /// @}

private:
  template <class Predicate>
  bool all_of(Predicate predicate) const
  {
    return std::all_of(m_expressions.begin(), m_expressions.end(), predicate);
  }

  // Executes the first `operations` instructions and returns all slots.
  template <class NT>
  const NT* run(const NT* variables, std::size_t operations, std::vector<NT>& workspace) const
  {
    const std::size_t n = static_cast<std::size_t>(m_number_of_variables);
    if (workspace.size() < n + operations)
      workspace.resize(n + operations);
    NT* slots = workspace.data();
    std::copy_n(variables, n, slots);
    const internal::Tape_instruction* begin = m_program.code.data();
    const internal::Tape_instruction* failed =
      internal::run_tape(begin, begin + operations, slots, slots + n, m_program.constants);
    if (failed)
      throw Division_by_zero_error(internal::division_message(begin, failed, m_program.constants,
                                                              m_number_of_variables, m_names));
    return slots;
  }

  int m_number_of_variables = 0;
  std::vector<Expression> m_expressions;
  internal::Tape_program m_program;
  std::vector<std::string> m_names;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_EXPRESSION_TAPE_H
