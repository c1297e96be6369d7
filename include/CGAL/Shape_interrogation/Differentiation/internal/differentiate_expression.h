// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIFFERENTIATE_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIFFERENTIATE_EXPRESSION_H

// The reverse sweep, carried out on the recorded operations: partial derivatives are expressions
// again, so that factors 1 and -1 vanish, constant entries are known and common products shared.

#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_graph.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Reverse_sweep
{
public:
  // The non-zero partial derivatives, sorted by variable.
  using Gradient = std::vector<std::pair<int, Expression>>;

  explicit Reverse_sweep(const Expression_graph& graph)
    : m_graph(graph), m_adjoint(graph.size()), m_in_cone(graph.size(), false)
  {}

  // Costs a constant times the number of operations below `output` (besides sorting them).
  Gradient operator()(int output)
  {
    Gradient gradient;
    collect_cone(output);
    if (!m_cone.empty())
      m_adjoint[output] = Expression(1);
    for (const int i : m_cone)
    {
      const Expression adjoint = std::exchange(m_adjoint[i], Expression());
      m_in_cone[i] = false;
      if (adjoint.is_constant() && CGAL::is_zero(adjoint.constant()))
        continue;
      if (m_graph[i].operation == Expression_operation::VARIABLE)
        gradient.emplace_back(m_graph[i].argument, adjoint);
      else
        propagate(i, adjoint);
    }
    std::sort(gradient.begin(), gradient.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return gradient;
  }

private:
  // All operations below the output that depend on a variable, the output first.
  void collect_cone(int output)
  {
    m_cone.clear();
    visit(output);
    for (std::size_t k = 0; k < m_cone.size(); ++k)
    {
      const Expression_graph::Node& n = m_graph[m_cone[k]];
      visit(n.first);
      visit(n.second);
    }
    std::sort(m_cone.begin(), m_cone.end(), std::greater<int>());
  }

  void visit(int i)
  {
    if (i < 0 || m_in_cone[i] || !m_graph[i].depends)
      return;
    m_in_cone[i] = true;
    m_cone.push_back(i);
  }

  bool wants(int i) const { return i >= 0 && m_graph[i].depends; }
  Expression value(int i) const { return m_graph.expression(i); }

  void add(int i, const Expression& contribution)
  {
    if (wants(i))
      m_adjoint[i] += contribution;
  }

  void propagate(int i, const Expression& adjoint)
  {
    using Op = Expression_operation;
    const Expression_graph::Node& n = m_graph[i];
    switch (n.operation)
    {
    case Op::ADD:
      add(n.first, adjoint);
      add(n.second, adjoint);
      break;
    case Op::SUBTRACT:
      add(n.first, adjoint);
      add(n.second, -adjoint);
      break;
    case Op::MULTIPLY:
      if (wants(n.first))
        add(n.first, adjoint * value(n.second));
      if (wants(n.second))
        add(n.second, adjoint * value(n.first));
      break;
    case Op::DIVIDE:
      propagate_quotient(i, adjoint);
      break;
    case Op::NEGATE:
      add(n.first, -adjoint);
      break;
    default:
      if (n.argument != 0 || n.operation != Op::POWER)
        add(n.first, derivative(i, adjoint));
    }
  }

  // d(a/b) = (da - (a/b) db) / b
  void propagate_quotient(int i, const Expression& adjoint)
  {
    const Expression_graph::Node& n = m_graph[i];
    const Expression share = adjoint / value(n.second);
    add(n.first, share);
    if (wants(n.second))
      add(n.second, -(share * value(i)));
  }

  // The adjoint times the derivative of a power or function.
  Expression derivative(int i, const Expression& adjoint) const
  {
    using Op = Expression_operation;
    const Expression_graph::Node& n = m_graph[i];
    const Expression x = value(n.first);
    switch (n.operation)
    {
    case Op::POWER: return adjoint * (n.argument * pow(x, n.argument - 1));
    case Op::SQRT: return (adjoint / 2) / value(i);
    case Op::EXP: return adjoint * value(i);
    case Op::LOG: return adjoint / x;
    case Op::SIN: return adjoint * cos(x);
    case Op::COS: return -(adjoint * sin(x));
    case Op::TAN: return adjoint * (1 + square(value(i)));
    case Op::ASIN: return adjoint / sqrt(1 - square(x));
    case Op::ACOS: return -(adjoint / sqrt(1 - square(x)));
    default: return adjoint / (1 + square(x)); // atan
    }
  }

  const Expression_graph& m_graph;
  std::vector<Expression> m_adjoint;
  std::vector<bool> m_in_cone;
  std::vector<int> m_cone;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_DIFFERENTIATE_EXPRESSION_H
