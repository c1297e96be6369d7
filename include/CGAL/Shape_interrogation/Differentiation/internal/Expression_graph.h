// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAPH_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAPH_H

// Hash consing: expressions are numbered so that equal subexpressions get equal numbers, and
// operands smaller numbers than their operation (a topological order). Nothing recurses.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/Hash_index.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Expression_graph
{
public:
  struct Node
  {
    Expression_operation operation;
    std::int32_t argument; // variable, exponent, or index of a constant
    std::int32_t first, second; // numbers of the operands, -1 if absent
    bool depends; // on a variable
  };

  explicit Expression_graph(const Expression_limits& limits) : m_limits(limits) {}

  // Returns the number of e.
  int insert(const Expression& e)
  {
    m_roots.push_back(e); // keeps the nodes, whose addresses are remembered
    m_pending.push_back({e.handle().get(), false});
    while (!m_pending.empty())
    {
      const Pending next = m_pending.back();
      m_pending.pop_back();
      const int known = next.operands_done ? -1 : find(next.node);
      if (known >= 0)
        m_results.push_back(known);
      else if (next.operands_done)
        m_results.push_back(remember(next.node, number(next.node)));
      else
        expand(next.node);
    }
    return pop_result();
  }

  int size() const { return static_cast<int>(m_nodes.size()); }
  const Node& operator[](int i) const { return m_nodes[i]; }
  const std::vector<CGAL::Exact_rational>& constants() const { return m_constants; }

  // A recorded operation with number i.
  Expression expression(int i) const
  {
    return Expression(Expression_handle::share(m_first_seen[i]));
  }

private:
  struct Pending
  {
    const Expression_node* node;
    bool operands_done; // their numbers are the last results
  };
  struct Seen
  {
    const Expression_node* node;
    int number;
  };

  // Leaves the node to be numbered after its operands, the first one first.
  void expand(const Expression_node* node)
  {
    m_pending.push_back({node, true});
    for (const Expression_node* operand : {node->second, node->first})
      if (operand)
        m_pending.push_back({operand, false});
  }

  static std::uint32_t hash(const Expression_node* node)
  {
    return mix_hash(reinterpret_cast<std::uintptr_t>(node));
  }

  int find(const Expression_node* node) const
  {
    const int i = m_seen_index.find(hash(node), [&](int k) { return m_seen[k].node == node; });
    return i < 0 ? -1 : m_seen[i].number;
  }

  int remember(const Expression_node* node, int number)
  {
    m_seen_index.insert(hash(node), static_cast<int>(m_seen.size()));
    m_seen.push_back({node, number});
    return number;
  }

  int pop_result()
  {
    const int result = m_results.back();
    m_results.pop_back();
    return result;
  }

  // The number of a node with the numbers of its operands; a new one if there is no such node yet.
  int number(const Expression_node* node)
  {
    using Op = Expression_operation;
    Node n{node->operation, node->argument, -1, -1, node->operation == Op::VARIABLE};
    if (node->second)
      n.second = pop_result();
    if (node->first)
      n.first = pop_result();
    if (n.operation == Op::CONSTANT)
      n.argument = constant(static_cast<const Constant_node*>(node)->value);
    if (n.operation == Op::MULTIPLY && n.first == n.second)
      n = Node{Op::POWER, 2, n.first, -1, n.depends};
    if ((n.operation == Op::ADD || n.operation == Op::MULTIPLY) && n.second < n.first)
      std::swap(n.first, n.second);
    const std::uint32_t key = hash(n);
    const int known = m_index.find(key, [&](int i) { return is_same(m_nodes[i], n); });
    if (known >= 0)
      return known;
    m_index.insert(key, size());
    append(n, node);
    return size() - 1;
  }

  static std::uint32_t hash(const Node& n)
  {
    const auto wide = [](std::int32_t i) { return std::uint64_t(static_cast<std::uint32_t>(i)); };
    const std::uint64_t own = wide(n.argument) << 8 | static_cast<std::uint64_t>(n.operation);
    return mix_hash((wide(n.first) << 32 | wide(n.second)) + own * 0xD6E8FEB86659FD93u);
  }

  static bool is_same(const Node& a, const Node& b)
  {
    return a.operation == b.operation && a.argument == b.argument && a.first == b.first &&
           a.second == b.second;
  }

  void append(Node n, const Expression_node* node)
  {
    if (m_nodes.size() >= m_limits.nodes)
      throw Limit_error("an expression has more than " + std::to_string(m_limits.nodes) +
                        " operations");
    for (const std::int32_t operand : {n.first, n.second})
      n.depends = n.depends || (operand >= 0 && m_nodes[operand].depends);
    m_nodes.push_back(n);
    m_first_seen.push_back(node);
  }

  std::int32_t constant(const CGAL::Exact_rational& value)
  {
    const auto found = m_constant_numbers.emplace(value, static_cast<int>(m_constants.size()));
    if (found.second)
      m_constants.push_back(value);
    return found.first->second;
  }

  Expression_limits m_limits;
  std::vector<Node> m_nodes;
  std::vector<const Expression_node*> m_first_seen;
  std::vector<CGAL::Exact_rational> m_constants;
  std::vector<Expression> m_roots;
  std::vector<Pending> m_pending;
  std::vector<int> m_results;
  std::vector<Seen> m_seen;
  Hash_index m_seen_index; // of the recorded operations
  Hash_index m_index;      // of the nodes
  std::map<CGAL::Exact_rational, int> m_constant_numbers;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAPH_H
