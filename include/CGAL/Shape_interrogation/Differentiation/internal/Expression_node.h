// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_NODE_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_NODE_H

// Immutable nodes of an expression DAG, counted by their handles.
// The last handle frees the nodes through a list threaded into them: a chain of a million
// operations is destroyed without recursion and without allocation.

#include <CGAL/Exact_rational.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

enum class Expression_operation : std::uint8_t
{
  CONSTANT, VARIABLE, PI,
  ADD, SUBTRACT, MULTIPLY, DIVIDE, // two operands
  NEGATE, POWER,                   // one operand; the power also has an exponent
  SQRT, EXP, LOG, SIN, COS, TAN, ASIN, ACOS, ATAN
};

// What occurs in an expression. PARTIAL: its value may not exist at some points.
enum Expression_property : std::uint8_t
{
  USES_DIVISION = 1, USES_SQRT = 2, USES_TRANSCENDENTAL = 4, IS_PARTIAL = 8
};

struct Expression_node
{
  Expression_node(Expression_operation op, std::int32_t argument_)
    : argument(argument_), operation(op)
  {}
  Expression_node(const Expression_node&) = delete;
  Expression_node& operator=(const Expression_node&) = delete;

  mutable std::atomic<std::size_t> references{1};
  mutable const Expression_node* next_dead = nullptr;
  const Expression_node* first = nullptr;
  const Expression_node* second = nullptr;
  std::int32_t argument;    // index of a variable, exponent of a power
  std::uint32_t degree = 0; // see Expression::degree_bound()
  Expression_operation operation;
  std::uint8_t properties = 0;
};

struct Constant_node : Expression_node
{
  explicit Constant_node(const CGAL::Exact_rational& v)
    : Expression_node(Expression_operation::CONSTANT, 0), value(v)
  {}
  CGAL::Exact_rational value;
};

inline void acquire(const Expression_node* node) noexcept
{
  if (node)
    node->references.fetch_add(1, std::memory_order_relaxed);
}

// Drops one reference; a node that nobody holds any more is put in front of the list.
inline void drop_reference(const Expression_node* node, const Expression_node*& dead) noexcept
{
  if (node && node->references.fetch_sub(1, std::memory_order_acq_rel) == 1)
  {
    node->next_dead = dead;
    dead = node;
  }
}

inline void release(const Expression_node* node) noexcept
{
  const Expression_node* dead = nullptr;
  drop_reference(node, dead);
  while (dead)
  {
    const Expression_node* current = dead;
    dead = current->next_dead;
    drop_reference(current->first, dead);
    drop_reference(current->second, dead);
    if (current->operation == Expression_operation::CONSTANT)
      delete static_cast<const Constant_node*>(current);
    else
      delete current;
  }
}

// Shares a node. Null only when moved from.
class Expression_handle
{
public:
  // Takes over a reference that the caller owns.
  static Expression_handle adopt(const Expression_node* node) { return Expression_handle(node); }
  static Expression_handle share(const Expression_node* node)
  {
    acquire(node);
    return Expression_handle(node);
  }

  Expression_handle(const Expression_handle& other) noexcept : m_node(other.m_node)
  {
    acquire(m_node);
  }
  Expression_handle(Expression_handle&& other) noexcept
    : m_node(std::exchange(other.m_node, nullptr))
  {}
  Expression_handle& operator=(Expression_handle other) noexcept
  {
    std::swap(m_node, other.m_node);
    return *this;
  }
  ~Expression_handle() { release(m_node); }

  const Expression_node* get() const { return m_node; }
  const Expression_node* operator->() const { return m_node; }
  Expression_handle first() const { return share(m_node->first); }
  Expression_handle second() const { return share(m_node->second); }

  bool is(Expression_operation op) const { return m_node->operation == op; }
  bool is_constant() const { return is(Expression_operation::CONSTANT); }
  bool is_partial() const { return (m_node->properties & IS_PARTIAL) != 0; }
  const CGAL::Exact_rational& constant() const
  {
    return static_cast<const Constant_node*>(m_node)->value;
  }

private:
  explicit Expression_handle(const Expression_node* node) noexcept : m_node(node) {}

  const Expression_node* m_node;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_NODE_H
