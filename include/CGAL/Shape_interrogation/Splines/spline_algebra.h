// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_ALGEBRA_H
#define CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_ALGEBRA_H

// Sums and products of spline functions with the knots that they must have, and periodic functions
// (Elber and Cohen, section 2).

#include <CGAL/Shape_interrogation/Splines/Spline_function.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <class NT, int d, class Combine>
Spline_function<NT, d> combine(const Spline_function<NT, d>& f, const Spline_function<NT, d>& g,
                               bool is_product, Combine combine)
{
  typename Spline_function<NT, d>::Knots knots = f.knots();
  for (int k = 0; k < d; ++k)
  {
    const int degree =
      is_product ? f.degree(k) + g.degree(k) : (std::max)(f.degree(k), g.degree(k));
    knots[k] = common_knots(f.knots(k), g.knots(k), degree);
  }
  auto a = f.pieces_on(knots);
  const auto b = g.pieces_on(knots);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = combine(a[i], b[i]);
  return Spline_function<NT, d>::from_pieces(knots, a);
}

} // namespace internal

// The domains must be the same.
template <class NT, int d>
Spline_function<NT, d> operator+(const Spline_function<NT, d>& f, const Spline_function<NT, d>& g)
{
  return internal::combine(f, g, false, [](const auto& p, const auto& q) { return p + q; });
}

template <class NT, int d>
Spline_function<NT, d> operator-(const Spline_function<NT, d>& f, const Spline_function<NT, d>& g)
{
  return internal::combine(f, g, false, [](const auto& p, const auto& q) { return p - q; });
}

template <class NT, int d>
Spline_function<NT, d> operator*(const Spline_function<NT, d>& f, const Spline_function<NT, d>& g)
{
  return internal::combine(f, g, true, [](const auto& p, const auto& q) { return p * q; });
}

/*!
 * \ingroup PkgShapeInterrogationSplines
 * \brief returns the periodic function of one variable with the given coefficients, on the domain
 * of one period.
 *
 * \param degree the degree
 * \param knots the knots of one period, both ends included: the last one is the first one again
 * \param coefficients one for each span of a period; those that follow are the first ones again
 *
 * The function and its derivatives below the degree continue across the ends of the domain.
 * \pre the knots increase; there is one coefficient less than knots, and at least `degree` many
 */
template <class NT>
Spline_function<NT, 1> periodic_spline(int degree, const std::vector<NT>& knots,
                                       std::vector<NT> coefficients)
{
  const int n = static_cast<int>(knots.size()) - 1;
  CGAL_precondition_msg(n >= degree && static_cast<int>(coefficients.size()) == n,
                        "a periodic spline has as many coefficients as spans, and not fewer than"
                        " its degree");
  const NT period = knots[n] - knots[0];
  std::vector<NT> all;
  for (int i = -degree; i <= n + degree; ++i)
    all.push_back(i < 0 ? NT(knots[i + n] - period)
                        : i > n ? NT(knots[i - n] + period) : knots[i]);
  for (int i = 0; i < degree; ++i)
    coefficients.push_back(coefficients[i]);
  return Spline_function<NT, 1>({Knot_vector<NT>(degree, std::move(all))},
                                std::move(coefficients));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SPLINES_SPLINE_ALGEBRA_H
