// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_RECORDED_MAP_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_RECORDED_MAP_H

// A curve (N = 1) or surface (N = 2) X/W as recorded functions of its parameters, evaluated on
// expressions. Tangent vectors are W X' - X W', which is W^2 times the derivative.

#include <CGAL/Shape_interrogation/Constraints/Constraint_point_3.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <int N>
class Recorded_map
{
public:
  using Parameters = std::array<Expression, N>;

  Recorded_map(const Coordinates<Expression, 3>& x, const Expression& weight)
    : m_is_rational(!weight.is_constant()),
      m_tape(m_is_rational ? std::vector<Expression>{x[0], x[1], x[2], weight}
                           : std::vector<Expression>{x[0] / weight, x[1] / weight, x[2] / weight},
             N, Expression_tape::Derivatives::GRADIENT)
  {}

  std::vector<Expression> functions() const
  {
    std::vector<Expression> x;
    for (int i = 0; i < m_tape.number_of_outputs(); ++i)
      x.push_back(m_tape.output(i));
    x.resize(4, Expression(1));
    return x;
  }

  Constraint_point_3 point(const std::string& name, const Parameters& t) const
  {
    const std::vector<Expression> x = m_tape.evaluate(variables(t));
    return {name, {x[0], x[1], x[2]}, m_is_rational ? x[3] : Expression(1)};
  }

  std::array<Coordinates<Expression, 3>, N> tangents(const Parameters& t) const
  {
    const auto gradient = gradients(t);
    std::array<Coordinates<Expression, 3>, N> result;
    for (int k = 0; k < N; ++k)
      for (int i = 0; i < 3; ++i)
        result[k][i] = gradient[i][k];
    if (m_is_rational)
    {
      const std::vector<Expression> x = m_tape.evaluate(variables(t));
      for (int k = 0; k < N; ++k)
        for (int i = 0; i < 3; ++i)
          result[k][i] = x[3] * gradient[i][k] - x[i] * gradient[3][k];
    }
    return result;
  }

private:
  static std::vector<Expression> variables(const Parameters& t) { return {t.begin(), t.end()}; }

  std::array<std::array<Expression, N>, 4> gradients(const Parameters& t) const
  {
    const Sparse_pattern& pattern = m_tape.gradient_pattern();
    const std::vector<Expression> entries = m_tape.gradient(variables(t));
    std::array<std::array<Expression, N>, 4> result;
    for (std::size_t i = 0; i < pattern.number_of_rows(); ++i)
      for (std::size_t k = pattern.row_starts[i]; k < pattern.row_starts[i + 1]; ++k)
        result[i][pattern.columns[k]] = entries[k];
    return result;
  }

  bool m_is_rational;
  Expression_tape m_tape;
};

// What a functor of N parameters returns: three coordinates, or four homogeneous ones.
template <int N>
Recorded_map<N> make_recorded_map(const std::array<Expression, 3>& x)
{
  return Recorded_map<N>(x, Expression(1));
}

template <int N>
Recorded_map<N> make_recorded_map(const std::array<Expression, 4>& x)
{
  return Recorded_map<N>({x[0], x[1], x[2]}, x[3]);
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_INTERNAL_RECORDED_MAP_H
