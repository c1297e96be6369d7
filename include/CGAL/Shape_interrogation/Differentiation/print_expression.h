// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PRINT_EXPRESSION_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PRINT_EXPRESSION_H

// Expressions as text that parse_expression() reads back. Nothing recurses.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/function_names.h>

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

class Expression_printer
{
  using Op = Expression_operation;
  // How tightly an operation binds.
  enum Strength { SUM = 1, PRODUCT = 2, POWER = 3, ATOM = 4 };

  // Either a node that is to be printed, in parentheses if it binds less than `strength`, or text.
  struct Piece
  {
    const Expression_node* node;
    int strength;
    std::string text;
  };

public:
  Expression_printer(const std::vector<std::string>& names, std::size_t max_length)
    : m_names(names), m_max_length(max_length)
  {}

  std::string operator()(const Expression& e)
  {
    std::vector<Piece> pending{Piece{e.handle().get(), SUM, ""}};
    while (!pending.empty())
    {
      const Piece piece = pending.back();
      pending.pop_back();
      if (piece.node)
        open(piece, pending);
      else
        m_text += piece.text;
      if (m_text.size() > m_max_length)
        return m_text.substr(0, m_max_length) + "...";
    }
    return m_text;
  }

private:
  static const CGAL::Exact_rational& value(const Expression_node* node)
  {
    return static_cast<const Constant_node*>(node)->value;
  }

  static Strength strength(const Expression_node* node)
  {
    switch (node->operation)
    {
    case Op::ADD: case Op::SUBTRACT: case Op::NEGATE: return SUM;
    case Op::MULTIPLY: case Op::DIVIDE: return PRODUCT;
    case Op::POWER: return POWER;
    case Op::CONSTANT: return constant_strength(value(node));
    default: return ATOM;
    }
  }

  static Strength constant_strength(const CGAL::Exact_rational& x)
  {
    if (CGAL::is_negative(x))
      return SUM;
    return x == CGAL::Exact_rational(0) || print(x).find('/') == std::string::npos ? ATOM : PRODUCT;
  }

  static std::string print(const CGAL::Exact_rational& x)
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << x;
    return out.str();
  }

  // Prints a leaf, or replaces an operation by its parts, the last one first.
  void open(const Piece& piece, std::vector<Piece>& pending)
  {
    const Expression_node* node = piece.node;
    const bool parentheses = strength(node) < piece.strength;
    if (parentheses)
    {
      m_text += "(";
      pending.push_back(Piece{nullptr, 0, ")"});
    }
    switch (node->operation)
    {
    case Op::CONSTANT: m_text += print(value(node)); break;
    case Op::VARIABLE: m_text += name(node->argument); break;
    case Op::PI: m_text += "pi"; break;
    case Op::ADD: sum(node, pending); break;
    case Op::SUBTRACT: binary(node, SUM, " - ", PRODUCT, pending); break;
    case Op::MULTIPLY: binary(node, PRODUCT, "*", POWER, pending); break;
    case Op::DIVIDE: binary(node, PRODUCT, "/", POWER, pending); break;
    case Op::NEGATE:
      m_text += "-";
      pending.push_back(Piece{node->first, PRODUCT, ""});
      break;
    case Op::POWER: power(node, pending); break;
    default:
      m_text += std::string(function_name(node->operation)) + "(";
      pending.push_back(Piece{nullptr, 0, ")"});
      pending.push_back(Piece{node->first, SUM, ""});
    }
  }

  // A negative constant is subtracted.
  void sum(const Expression_node* node, std::vector<Piece>& pending)
  {
    const Expression_node* last = node->second;
    const bool negative = last->operation == Op::CONSTANT && CGAL::is_negative(value(last));
    if (!negative)
      return binary(node, SUM, " + ", PRODUCT, pending);
    pending.push_back(Piece{nullptr, 0, " - " + print(CGAL::Exact_rational(-value(last)))});
    pending.push_back(Piece{node->first, SUM, ""});
  }

  static void binary(const Expression_node* node, int left, const char* sign, int right,
                     std::vector<Piece>& pending)
  {
    pending.push_back(Piece{node->second, right, ""});
    pending.push_back(Piece{nullptr, 0, sign});
    pending.push_back(Piece{node->first, left, ""});
  }

  static void power(const Expression_node* node, std::vector<Piece>& pending)
  {
    pending.push_back(Piece{nullptr, 0, "^" + std::to_string(node->argument)});
    pending.push_back(Piece{node->first, ATOM, ""});
  }

  std::string name(std::int32_t index) const
  {
    const std::size_t i = static_cast<std::size_t>(index);
    return i < m_names.size() ? m_names[i] : "x" + std::to_string(index);
  }

  const std::vector<std::string>& m_names;
  std::size_t m_max_length;
  std::string m_text;
};

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief returns an expression as text, which `parse_expression()` reads back.
 *
 * \param e the expression
 * \param names the names of the variables; those without a name are `x0`, `x1`, ...
 * \param max_length the text is cut there, and `...` appended: shared subexpressions are written
 *   out wherever they occur, which can be long
 */
inline std::string to_string(const Expression& e, const std::vector<std::string>& names = {},
                             std::size_t max_length = std::size_t(1) << 20)
{
  return internal::Expression_printer(names, max_length)(e);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_PRINT_EXPRESSION_H
