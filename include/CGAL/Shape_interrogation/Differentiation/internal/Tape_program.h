// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_PROGRAM_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_PROGRAM_H

// Everything that a tape consists of, and how it comes from expressions: number them, compile
// the values, differentiate, compile the derivatives behind the values.

#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/differentiate_expression.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_graph.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_compiler.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_constants.h>
#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

struct Tape_program
{
  std::vector<Tape_instruction> code;
  std::size_t value_operations = 0; // the first instructions, which yield the values
  Tape_constants constants;
  Tape_results values, gradient;
  Sparse_pattern pattern; // of the gradient
};

class Tape_assembler
{
public:
  Tape_assembler(int number_of_variables, const Expression_limits& limits)
    : m_number_of_variables(number_of_variables), m_limits(limits), m_graph(limits),
      m_compiler(m_graph, number_of_variables)
  {}

  Tape_program operator()(const std::vector<Expression>& outputs, bool with_gradient)
  {
    std::vector<int> roots;
    for (const Expression& f : outputs)
    {
      check_degree(f);
      roots.push_back(m_graph.insert(f));
    }
    check_variables();
    m_program.values = compile(roots);
    m_program.value_operations = m_compiler.code().size();
    if (with_gradient)
      m_program.gradient = compile(differentiate(roots));
    m_program.code = m_compiler.code();
    m_program.constants = Tape_constants(m_graph.constants());
    return std::move(m_program);
  }

private:
  void check_degree(const Expression& f) const
  {
    if (f.degree_bound() > m_limits.degree)
      throw Limit_error("an expression has a degree of up to " + std::to_string(f.degree_bound()) +
                        ", the limit is " + std::to_string(m_limits.degree));
  }

  void check_variables() const
  {
    for (int i = 0; i < m_graph.size(); ++i)
      if (m_graph[i].operation == Expression_operation::VARIABLE &&
          m_graph[i].argument >= m_number_of_variables)
        throw Shape_error("an expression uses the variable with index " +
                          std::to_string(m_graph[i].argument) +
                          ", but the number of variables is " +
                          std::to_string(m_number_of_variables));
  }

  // The numbers of the entries; fills in the pattern.
  std::vector<int> differentiate(const std::vector<int>& roots)
  {
    std::vector<Reverse_sweep::Gradient> gradients;
    Reverse_sweep sweep(m_graph);
    for (const int root : roots)
      gradients.push_back(sweep(root));
    std::vector<int> entries;
    for (const Reverse_sweep::Gradient& row : gradients)
    {
      for (const auto& entry : row)
      {
        m_program.pattern.columns.push_back(entry.first);
        entries.push_back(m_graph.insert(entry.second));
      }
      m_program.pattern.row_starts.push_back(entries.size());
    }
    return entries;
  }

  Tape_results compile(const std::vector<int>& nodes)
  {
    m_compiler.compile(nodes);
    Tape_results results;
    for (std::uint32_t k = 0; k < nodes.size(); ++k)
    {
      const Expression_graph::Node& node = m_graph[nodes[k]];
      if (node.operation == Expression_operation::CONSTANT)
        results.constant.push_back({k, static_cast<std::uint32_t>(node.argument)});
      else
        results.in_slots.push_back({k, m_compiler.slot_of_result(nodes[k])});
    }
    return results;
  }

  int m_number_of_variables;
  Expression_limits m_limits;
  Expression_graph m_graph;
  Tape_compiler m_compiler;
  Tape_program m_program;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_PROGRAM_H
