// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_FUNCTION_H
#define CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_FUNCTION_H

// Piecewise polynomial functions in B-spline form (Elber and Cohen, section 2): exact Bezier
// extraction, and back by blossoms.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Curves/internal/spline_basis.h>
#include <CGAL/Shape_interrogation/Splines/Spline_piece.h>
#include <CGAL/Shape_interrogation/Splines/internal/knot_algebra.h>
#include <CGAL/Shape_interrogation/Splines/internal/tensor_index.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSplines
 * \brief is a tensor product spline function of `d` variables.
 *
 * Operations give the degree and the knots that the result must have. A sum has the greater degree,
 * a product the sum of both, and across each knot the continuity of the less smooth operand; both
 * are clamped at the ends of the domain (`+`, `-` and `*` are in `spline_algebra.h`). Knot vectors
 * may be unclamped, as those of `periodic_spline()`. Coefficients are in the order of the first
 * variable, then the second.
 *
 * \tparam NT an exact field number type
 * \tparam d the number of variables, at least 1
 *
 * Source: Elber and Cohen, section 2; the derivative in the corrected form
 * \f$ p (c_{i+1} - c_i) / (t_{i+p+1} - t_{i+1}) \f$.
 */
template <class NT, int d>
class Spline_function
{
public:
  using FT = NT;                                      //!< the number type
  using Point = std::array<NT, d>;                    //!< parameters
  using Knots = std::array<Knot_vector<NT>, d>;       //!< a knot vector for each variable
  using Polynomial = Bernstein_polynomial<NT, d>;     //!< the pieces
  using Piece = Spline_piece<NT, d>;                  //!< a piece with its parameters
  using Sides = std::array<Side, d>;                  //!< a side for each variable

  //! constructs a function. \pre there are as many coefficients as the knots have basis functions
  Spline_function(Knots knots, std::vector<NT> coefficients)
    : m_knots(std::move(knots)), m_coefficients(std::move(coefficients))
  {
    CGAL_precondition_msg(m_coefficients.size() == internal::size_of(last()),
                          "the number of coefficients does not belong to the knot vectors");
  }

  /*!
   * \brief returns the function on the given knots whose polynomials over the spans are `pieces`,
   * in the order of `pieces()`.
   * \pre there is one piece for each tuple of spans, of at most the degrees of the knot vectors,
   * and across the knots they are as smooth as these say (not checked)
   *
   * Coefficients without influence on the domain continue the nearest piece.
   */
  static Spline_function from_pieces(const Knots& knots, const std::vector<Polynomial>& pieces)
  {
    std::array<int, d> degree, spans;
    std::array<std::vector<internal::Blossom_weights<NT>>, d> weights;
    for (int k = 0; k < d; ++k)
    {
      degree[k] = knots[k].degree();
      spans[k] = static_cast<int>(knots[k].spans().size()) - 1;
      for (int i = 0; i < knots[k].number_of_control_points(); ++i)
        weights[k].push_back(internal::blossom_weights(knots[k], i));
    }
    CGAL_precondition_msg(pieces.size() == internal::size_of(spans),
                          "there must be one piece for each tuple of knot spans");
    std::vector<std::vector<NT>> bernstein;
    for (const Polynomial& p : pieces)
      bernstein.push_back(p.elevated(degree).coefficients());
    Spline_function f(knots);
    internal::for_each_index(f.last(), [&](const std::array<int, d>& i) {
      std::size_t piece = 0;
      std::vector<NT> w{NT(1)};
      for (int k = 0; k < d; ++k)
      {
        piece = piece * (spans[k] + 1) + weights[k][i[k]].span;
        w = internal::outer_product(w, weights[k][i[k]].weights);
      }
      NT sum(0);
      for (std::size_t j = 0; j < w.size(); ++j)
        sum += w[j] * bernstein[piece][j];
      f.m_coefficients.push_back(sum);
    });
    return f;
  }

  const Knots& knots() const { return m_knots; }                         //!< returns all knots.
  const Knot_vector<NT>& knots(int axis) const { return m_knots[axis]; } //!< returns some knots.
  int degree(int axis) const { return m_knots[axis].degree(); } //!< returns the degree.
  const std::vector<NT>& coefficients() const { return m_coefficients; } //!< returns all of them.

  //! returns the value, at a knot from the given sides; refused outside the domain.
  Result<NT> operator()(const Point& x, const Sides& sides = right()) const
  {
    std::array<int, d> span, degrees;
    std::vector<NT> w{NT(1)};
    for (int k = 0; k < d; ++k)
    {
      const Result<int> at = m_knots[k].span(x[k], sides[k]);
      if (!at)
        return at.refusal();
      span[k] = *at;
      degrees[k] = degree(k);
      const auto b = internal::spline_basis<internal::any_degree>(m_knots[k], *at, x[k]);
      std::vector<NT> values;
      for (int i = 0; i <= degree(k); ++i)
        values.push_back(b(0, i));
      w = internal::outer_product(w, values);
    }
    const std::vector<NT> c = local_coefficients(span, degrees);
    NT sum(0);
    for (std::size_t j = 0; j < w.size(); ++j)
      sum += w[j] * c[j];
    return sum;
  }

  //! returns the polynomials over the knot spans, in the order of the first variable, then the
  //! second: exactly.
  std::vector<Piece> pieces() const
  {
    std::array<int, d> spans, degrees;
    std::array<std::vector<std::vector<std::vector<NT>>>, d> matrices;
    for (int k = 0; k < d; ++k)
    {
      spans[k] = static_cast<int>(m_knots[k].spans().size()) - 1;
      degrees[k] = degree(k);
      for (int s : m_knots[k].spans())
        matrices[k].push_back(internal::bezier_matrix(m_knots[k], s));
    }
    std::vector<Piece> all;
    internal::for_each_index(spans, [&](const std::array<int, d>& s) {
      std::array<int, d> span;
      Piece piece;
      for (int k = 0; k < d; ++k)
      {
        span[k] = m_knots[k].spans()[s[k]];
        piece.low[k] = m_knots[k].knots()[span[k]];
        piece.high[k] = m_knots[k].knots()[span[k] + 1];
      }
      std::vector<NT> c = local_coefficients(span, degrees);
      for (int k = 0; k < d; ++k)
        c = internal::change_lines(c, internal::axis_layout(degrees, k), degrees[k] + 1,
                                   [&](auto from, auto to) {
                                     const auto& rows = matrices[k][s[k]];
                                     for (std::size_t i = 0; i < rows.size(); ++i)
                                       for (std::size_t j = 0; j < rows.size(); ++j)
                                         to(i) += rows[i][j] * from(j);
                                   });
      piece.polynomial = Polynomial::from_coefficients(degrees, std::move(c));
      all.push_back(std::move(piece));
    });
    return all;
  }

  //! returns the polynomials over the spans of other knots, in the order of `pieces()`.
  //! \pre the domains are the same, and each knot of the function is among the others
  std::vector<Polynomial> pieces_on(const Knots& finer) const
  {
    const std::vector<Piece> coarse = pieces();
    std::array<std::vector<NT>, d> ends;
    std::array<int, d> spans;
    for (int k = 0; k < d; ++k)
    {
      ends[k] = internal::span_ends(finer[k]);
      spans[k] = static_cast<int>(ends[k].size()) - 2;
    }
    std::vector<Polynomial> all;
    internal::for_each_index(spans, [&](const std::array<int, d>& s) {
      std::array<NT, d> low, high;
      for (int k = 0; k < d; ++k)
      {
        low[k] = ends[k][s[k]];
        high[k] = ends[k][s[k] + 1];
      }
      const auto piece = std::find_if(coarse.begin(), coarse.end(),
                                      [&](const Piece& c) { return c.contains(low, high); });
      CGAL_precondition_msg(piece != coarse.end(), "the knots lack one that the function has");
      all.push_back(piece->restricted(low, high));
    });
    return all;
  }

  /*!
   * \brief returns the same function on other knots: more of them, a higher degree, or both.
   * \pre the knots have the same domains and allow all the jumps that the function has
   */
  Spline_function on_knots(const Knots& knots) const
  {
    return from_pieces(knots, pieces_on(knots));
  }

  //! returns the same function with the knot `t` of the variable `axis` inserted. \pre `t` is in
  //! the domain, and the knot does not become more multiple than the degree plus 1
  Spline_function with_knot(int axis, const NT& t, int times = 1) const
  {
    Knots knots = m_knots;
    knots[axis] = internal::with_knot(knots[axis], t, times);
    return on_knots(knots);
  }

  //! returns the same function in a higher degree, clamped. \pre the degree is not less than it was
  Spline_function elevated(int axis, int degree) const
  {
    Knots knots = m_knots;
    knots[axis] = internal::common_knots(knots[axis], knots[axis], degree);
    return on_knots(knots);
  }

  /*!
   * \brief returns the partial derivative in the variable `axis`, of a degree less by one on the
   * same knots without the first and the last. (Of degree 1 it has degree 1 again, with jumps.)
   */
  Spline_function derivative(int axis) const
  {
    if (degree(axis) == 1)
      return elevated(axis, 2).derivative(axis);
    const Knot_vector<NT>& t = m_knots[axis];
    const std::vector<int> used = internal::derivative_indices(t);
    Knots reduced = m_knots;
    reduced[axis] = internal::derivative_knots(t);
    Spline_function f(reduced);
    f.m_coefficients = internal::change_lines(
      m_coefficients, internal::axis_layout(last(), axis), used.size(), [&](auto from, auto to) {
        for (std::size_t k = 0; k < used.size(); ++k)
          to(k) = NT(t.degree()) * (from(used[k] + 1) - from(used[k])) *
                  t.inverse_length(used[k] + 1, t.degree());
      });
    return f;
  }

private:
  explicit Spline_function(const Knots& knots) : m_knots(knots) {}
  static Sides right() { return internal::filled<Sides>(Side::RIGHT); }

  // The last index of a coefficient along each axis: what a degree is for polynomials.
  std::array<int, d> last() const
  {
    std::array<int, d> n;
    for (int k = 0; k < d; ++k)
      n[k] = m_knots[k].number_of_control_points() - 1;
    return n;
  }

  // The coefficients of the basis functions that live on the spans.
  std::vector<NT> local_coefficients(const std::array<int, d>& span,
                                     const std::array<int, d>& degrees) const
  {
    const std::array<int, d> n = last();
    std::vector<NT> c;
    internal::for_each_index(degrees, [&](const std::array<int, d>& i) {
      std::size_t at = 0;
      for (int k = 0; k < d; ++k)
        at = at * (n[k] + 1) + span[k] - degrees[k] + i[k];
      c.push_back(m_coefficients[at]);
    });
    return c;
  }

  Knots m_knots;
  std::vector<NT> m_coefficients;
};

/// \ingroup PkgShapeInterrogationSplines
/// @{

//! is a spline function of one variable.
template <class NT>
using Spline_function_1 = Spline_function<NT, 1>;
//! is a spline function of two variables.
template <class NT>
using Spline_function_2 = Spline_function<NT, 2>;

/// @}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_FUNCTION_H
