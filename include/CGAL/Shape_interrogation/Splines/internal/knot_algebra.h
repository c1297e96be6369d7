// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_KNOT_ALGEBRA_H
#define CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_KNOT_ALGEBRA_H

// The knots that results of operations on splines have, and the weights by which a B-spline
// coefficient, a value of the blossom of a polynomial piece, depends on its Bernstein coefficients.

#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The clamped knots of a degree over the domain, with the inner knots so often that the continuity
// is that of the less smooth of the two.
template <class NT>
Knot_vector<NT> common_knots(const Knot_vector<NT>& a, const Knot_vector<NT>& b, int degree)
{
  const auto of_a = a.breakpoints(), of_b = b.breakpoints();
  CGAL_precondition_msg(a.domain() == b.domain(), "the splines have different domains");
  std::vector<NT> knots(degree + 1, a.domain()[0]);
  auto i = of_a.begin() + 1, j = of_b.begin() + 1;
  while (i + 1 < of_a.end() || j + 1 < of_b.end())
  {
    const CGAL::Comparison_result order = CGAL::compare(i->value, j->value);
    const int of_first = order == CGAL::LARGER ? degree : a.degree() - i->multiplicity;
    const int of_second = order == CGAL::SMALLER ? degree : b.degree() - j->multiplicity;
    knots.insert(knots.end(), degree - (std::min)(of_first, of_second),
                 order == CGAL::LARGER ? j->value : i->value);
    i += order != CGAL::LARGER;
    j += order != CGAL::SMALLER;
  }
  knots.insert(knots.end(), degree + 1, a.domain()[1]);
  return Knot_vector<NT>(degree, std::move(knots));
}

// The knots with t inserted.
template <class NT>
Knot_vector<NT> with_knot(const Knot_vector<NT>& knots, const NT& t, int times)
{
  std::vector<NT> more = knots.knots();
  more.insert(std::upper_bound(more.begin(), more.end(), t), times, t);
  return Knot_vector<NT>(knots.degree(), std::move(more));
}

// How a coefficient follows from a piece: the position of the piece among the spans of the domain,
// and the weight of each of its Bernstein coefficients.
template <class NT>
struct Blossom_weights
{
  std::size_t span;
  std::vector<NT> weights;
};

// The blossom at the knots t_{i+1}, .., t_{i+p} of the polynomial over a span in the support.
template <class NT>
Blossom_weights<NT> blossom_weights(const Knot_vector<NT>& knots, int i)
{
  const int p = knots.degree();
  const std::vector<int>& spans = knots.spans();
  const std::vector<NT>& t = knots.knots();
  // Coefficients without influence on the domain may take any span.
  std::size_t s = std::lower_bound(spans.begin(), spans.end(), i) - spans.begin();
  s = (std::min)(s, spans.size() - 1);
  const NT& start = t[spans[s]];
  const NT length = t[spans[s] + 1] - start;
  std::vector<NT> w{NT(1)};
  for (int k = 1; k <= p; ++k)
  {
    const NT u = (t[i + k] - start) / length;
    std::vector<NT> next(w.size() + 1, NT(0));
    for (std::size_t j = 0; j < w.size(); ++j)
    {
      next[j] += w[j] * (NT(1) - u);
      next[j + 1] += w[j] * u;
    }
    w = std::move(next);
  }
  return {s, std::move(w)};
}

// The domain in spans: their ends in order.
template <class NT>
std::vector<NT> span_ends(const Knot_vector<NT>& knots)
{
  std::vector<NT> ends;
  for (const auto& b : knots.breakpoints())
    ends.push_back(b.value);
  return ends;
}

// The coefficients of the derivative that have a basis function: where a knot is so multiple that
// the function jumps, one has not.
template <class NT>
std::vector<int> derivative_indices(const Knot_vector<NT>& knots)
{
  std::vector<int> used;
  for (int i = 0; i + 1 < knots.number_of_control_points(); ++i)
    if (!CGAL::is_zero(knots.inverse_length(i + 1, knots.degree())))
      used.push_back(i);
  return used;
}

// The knots of the derivative: without the first and the last, and once less where it jumps.
template <class NT>
Knot_vector<NT> derivative_knots(const Knot_vector<NT>& knots)
{
  const int p = knots.degree();
  const std::vector<NT>& t = knots.knots();
  std::vector<NT> fewer;
  for (int k = 1; k + 1 < static_cast<int>(t.size()); ++k)
    if (k <= p || t[k] != t[k - p])
      fewer.push_back(t[k]);
  return Knot_vector<NT>(p - 1, std::move(fewer));
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SPLINES_INTERNAL_KNOT_ALGEBRA_H
