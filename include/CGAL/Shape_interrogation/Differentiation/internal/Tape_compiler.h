// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_COMPILER_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_COMPILER_H

// Translates an expression graph to instructions.

#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_graph.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/schedule_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_instruction.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Translates the nodes of a graph in their order; a node that is used once, in the sum after it,
// is fused with the sum.
class Tape_compiler
{
  using Op = Expression_operation;
  using Code = Tape_operation;
  using Node = Expression_graph::Node;

public:
  Tape_compiler(const Expression_graph& graph, int number_of_variables)
    : m_graph(graph), m_variables(static_cast<std::uint32_t>(number_of_variables))
  {}

  const std::vector<Tape_instruction>& code() const { return m_code; }

  // Translates all nodes that the graph has by now. The results must be known here.
  void compile(const std::vector<int>& results)
  {
    const int begin = static_cast<int>(m_slots.size());
    const std::size_t begin_code = m_code.size();
    m_slots.resize(m_graph.size(), none);
    mark_fused(begin, results);
    for (int i = begin; i < m_graph.size(); ++i)
      if (!m_fused[i])
        translate(i);
    for (const int i : results) // one may have been fused when it was no result yet
      if (!is_constant(i))
        slot(i);
    const std::vector<std::uint32_t> new_slots = Tape_scheduler(m_code, m_variables)(begin_code);
    for (std::uint32_t& slot : m_slots)
      if (slot != none)
        slot = new_slots[slot];
  }

  // Where the value of a result is, unless it is a constant.
  std::uint32_t slot_of_result(int i) const
  {
    const Node& n = m_graph[i];
    return n.operation == Op::VARIABLE ? static_cast<std::uint32_t>(n.argument) : m_slots[i];
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  bool is_constant(int i) const { return m_graph[i].operation == Op::CONSTANT; }
  std::uint32_t constant(int i) const { return static_cast<std::uint32_t>(m_graph[i].argument); }

  // A product is fused into a sum that alone uses it. Nodes translated later may use it again
  // (derivatives do): they compute it anew.
  void mark_fused(int begin, const std::vector<int>& results)
  {
    std::vector<int> uses(m_graph.size(), 0);
    for (const int i : results)
      ++uses[i];
    for (int i = begin; i < m_graph.size(); ++i)
      for (const int operand : {m_graph[i].first, m_graph[i].second})
        if (operand >= 0)
          ++uses[operand];
    m_fused.resize(m_graph.size(), false);
    for (int i = begin; i < m_graph.size(); ++i)
      if (m_graph[i].operation == Op::ADD || m_graph[i].operation == Op::SUBTRACT)
        fuse_operand(i, begin, uses);
  }

  void fuse_operand(int i, int begin, const std::vector<int>& uses)
  {
    const Node& n = m_graph[i];
    if (is_constant(n.first) || is_constant(n.second))
      return;
    for (const int operand : {n.second, n.first})
      if (operand >= begin && uses[operand] == 1 && m_graph[operand].operation == Op::MULTIPLY)
      {
        m_fused[operand] = true;
        return;
      }
  }

  std::uint32_t slot(int i)
  {
    if (m_graph[i].operation == Op::VARIABLE)
      return static_cast<std::uint32_t>(m_graph[i].argument);
    if (m_slots[i] == none && is_constant(i))
      emit(i, Code::LOAD, 0, 0, constant(i));
    else if (m_slots[i] == none)
      translate(i);
    return m_slots[i];
  }

  void emit(int i, Code operation, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    m_slots[i] = static_cast<std::uint32_t>(m_variables + m_code.size());
    m_code.push_back(Tape_instruction{operation, a, b, c});
  }

  void translate(int i)
  {
    const Node& n = m_graph[i];
    switch (n.operation)
    {
    case Op::CONSTANT: return; // loaded where a slot is asked for
    case Op::VARIABLE: return;
    case Op::PI: return emit(i, Code::PI, 0, 0, 0);
    case Op::ADD: return translate_sum(i);
    case Op::SUBTRACT: return translate_difference(i);
    case Op::MULTIPLY: return translate_product(i);
    case Op::DIVIDE:
      if (is_constant(n.first))
        return emit(i, Code::DIVIDE_INTO, slot(n.second), 0, constant(n.first));
      return emit(i, Code::DIVIDE, slot(n.first), slot(n.second), 0);
    case Op::NEGATE: return emit(i, Code::NEGATE, slot(n.first), 0, 0);
    case Op::POWER:
      return emit(i, n.argument == 2 ? Code::SQUARE : Code::POWER, slot(n.first), 0,
                  static_cast<std::uint32_t>(n.argument));
    default: return emit(i, function_code(n.operation), slot(n.first), 0, 0);
    }
  }

  void translate_sum(int i)
  {
    const Node& n = m_graph[i];
    if (is_constant(n.first))
      return emit(i, Code::ADD_CONSTANT, slot(n.second), 0, constant(n.first));
    if (is_constant(n.second))
      return emit(i, Code::ADD_CONSTANT, slot(n.first), 0, constant(n.second));
    if (m_fused[n.second])
      return translate_fused(i, n.second, n.first, Code::MULTIPLY_ADD, Code::SCALE_ADD);
    if (m_fused[n.first])
      return translate_fused(i, n.first, n.second, Code::MULTIPLY_ADD, Code::SCALE_ADD);
    emit(i, Code::ADD, slot(n.first), slot(n.second), 0);
  }

  void translate_difference(int i)
  {
    const Node& n = m_graph[i];
    if (is_constant(n.first))
      return emit(i, Code::SUBTRACT_FROM, slot(n.second), 0, constant(n.first));
    if (m_fused[n.second])
      return translate_fused(i, n.second, n.first, Code::PRODUCT_FROM, Code::SCALED_FROM);
    if (m_fused[n.first])
      return translate_fused(i, n.first, n.second, Code::MULTIPLY_SUBTRACT, Code::SCALE_SUBTRACT);
    emit(i, Code::SUBTRACT, slot(n.first), slot(n.second), 0);
  }

  void translate_product(int i)
  {
    const Node& n = m_graph[i];
    if (is_constant(n.first))
      return emit(i, Code::SCALE, slot(n.second), 0, constant(n.first));
    if (is_constant(n.second))
      return emit(i, Code::SCALE, slot(n.first), 0, constant(n.second));
    emit(i, Code::MULTIPLY, slot(n.first), slot(n.second), 0);
  }

  // A sum of a product, or of a multiple, and another term.
  void translate_fused(int i, int product, int term, Code multiply, Code scale)
  {
    const Node& p = m_graph[product];
    const std::uint32_t other = slot(term);
    if (is_constant(p.first))
      emit(i, scale, slot(p.second), other, constant(p.first));
    else if (is_constant(p.second))
      emit(i, scale, slot(p.first), other, constant(p.second));
    else
      emit(i, multiply, slot(p.first), slot(p.second), other);
  }

  static Code function_code(Op operation)
  {
    const int k = static_cast<int>(operation) - static_cast<int>(Op::SQRT);
    return static_cast<Code>(static_cast<int>(Code::SQRT) + k);
  }

  const Expression_graph& m_graph;
  std::uint32_t m_variables;
  std::vector<Tape_instruction> m_code;
  std::vector<std::uint32_t> m_slots; // of the nodes
  std::vector<bool> m_fused;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_COMPILER_H
