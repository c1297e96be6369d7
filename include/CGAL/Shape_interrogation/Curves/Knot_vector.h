// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_KNOT_VECTOR_H
#define CGAL_SHAPE_INTERROGATION_CURVES_KNOT_VECTOR_H

// Knot vectors: what makes one valid, its spans, and the side of a knot that a parameter is on.
// Which knots are equal is decided once and kept, so that rounding and enclosures cannot undo it.

#include <CGAL/Shape_interrogation/Curves/internal/refuse_outside.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief names a side of a knot: that of smaller or that of greater parameters.
 */
enum class Side
{
  LEFT, //!< smaller parameters
  RIGHT //!< greater parameters
};

/*!
 * \ingroup PkgShapeInterrogationCurves
 * \brief is the full knot vector of a B-spline of degree \f$ p \f$ with \f$ n \f$ control points:
 * \f$ n + p + 1 \f$ knots that do not decrease, each at most \f$ p + 1 \f$ times.
 *
 * The domain is \f$ [t_p, t_n] \f$; the ends need not be multiple (unclamped vectors). At a knot of
 * multiplicity \f$ r \f$ inside the domain the spline has \f$ p - r \f$ continuous derivatives;
 * with fewer than two, the second-order data differ from side to side.
 *
 * \tparam NT a field number type
 */
template <class NT>
class Knot_vector
{
public:
  using FT = NT; //!< the number type

  //! is a knot in the domain with its multiplicity.
  struct Breakpoint
  {
    NT value;         //!< the parameter
    int multiplicity; //!< how often it is among all knots
  };

  //! is a part of the domain between two different knots, seen from a parameter.
  struct Span
  {
    Side side; //!< the side of the parameter on which the span lies
    int index; //!< the index of the last knot at its start
  };

  /*!
   * \brief tells in one sentence why the numbers are no knot vector, or nothing if they are one.
   *
   * This is the question for data from outside. With enclosures as knots it can also be undecided,
   * and the sentence says so.
   */
  static std::optional<std::string> why_invalid(int degree, const std::vector<NT>& knots)
  {
    if (degree < 1)
      return "the degree is " + std::to_string(degree) + ", at least 1 was expected";
    const int size = static_cast<int>(knots.size());
    if (size < 2 * degree + 2)
      return "there are " + std::to_string(size) + " knots, at least " +
             std::to_string(2 * degree + 2) + " were expected for degree " + std::to_string(degree);
    std::vector<int> groups;
    if (auto reason = find_groups(knots, groups))
      return reason;
    for (int i = degree + 1; i < size; ++i)
      if (groups[i] == groups[i - degree - 1])
        return "knot " + std::to_string(i) + " (" + internal::text_of(knots[i]) +
               ") occurs more than degree + 1 = " + std::to_string(degree + 1) + " times";
    if (groups[degree] == groups[size - degree - 1])
      return "the domain from knot " + std::to_string(degree) + " to knot " +
             std::to_string(size - degree - 1) + " is a single parameter";
    return std::nullopt;
  }

  //! constructs the knot vector. \pre `why_invalid()` has nothing to tell
  Knot_vector(int degree, std::vector<NT> knots) : m_degree(degree), m_knots(std::move(knots))
  {
    CGAL_precondition_code(const auto reason = why_invalid(m_degree, m_knots);)
    CGAL_precondition_msg(!reason, reason ? reason->c_str() : "");
    find_groups(m_knots, m_groups);
    prepare();
  }

  int degree() const { return m_degree; }                     //!< returns the degree.
  const std::vector<NT>& knots() const { return m_knots; }    //!< returns all knots.

  //! returns the number of control points.
  int number_of_control_points() const { return static_cast<int>(m_knots.size()) - m_degree - 1; }

  //! returns the ends of the domain.
  std::array<NT, 2> domain() const
  {
    return {m_knots[m_degree], m_knots[number_of_control_points()]};
  }

  //! returns the different knots in the domain, both ends included.
  std::vector<Breakpoint> breakpoints() const
  {
    std::vector<Breakpoint> points;
    for (int k : m_spans)
      points.push_back({m_knots[k], multiplicity(k)});
    const int end = number_of_control_points();
    points.push_back({m_knots[end], multiplicity(end)});
    return points;
  }

  //! returns the spans of the domain by the index of their last knot at the start.
  const std::vector<int>& spans() const { return m_spans; }

  /*!
   * \brief returns the index of the span that contains `t`; where `t` is a knot, the one on the
   * given side, or the inner one at an end of the domain. A refusal calls the parameter `name`.
   *
   * Refused are parameters outside the domain, and enclosures of which it is undecided.
   */
  Result<int> span(const NT& t, Side side, const char* name = "t") const
  {
    const std::array<NT, 2> ends = domain();
    if (auto refusal = internal::refuse_outside(name, t, ends[0], ends[1]))
      return *refusal;
    std::size_t low = 0, high = m_spans.size();
    while (high - low > 1)
    {
      const std::size_t middle = (low + high) / 2;
      const NT& knot = m_knots[m_spans[middle]];
      const auto sign = sign_decision(NT(t - knot));
      const auto after = side == Side::RIGHT ? sign != CGAL::NEGATIVE : sign == CGAL::POSITIVE;
      if (!CGAL::certainly(after) && !CGAL::certainly(!after))
        return undecided(t, knot);
      (CGAL::certainly(after) ? low : high) = middle;
    }
    return m_spans[low];
  }

  /*!
   * \brief returns the spans from which `t` gets different second-order data: two at a knot inside
   * the domain where the spline has fewer than two continuous derivatives, else one.
   */
  Result<std::vector<Span>> spans_at(const NT& t, const char* name = "t") const
  {
    const Result<int> right = span(t, Side::RIGHT, name);
    if (!right)
      return right.refusal();
    const NT& start = m_knots[*right];
    std::vector<Span> spans{{Side::RIGHT, *right}};
    if (*right != m_spans.front() && m_degree - multiplicity(*right) < 2)
    {
      const auto at_knot = is_zero_decision(NT(t - start));
      if (!CGAL::certainly(at_knot) && !CGAL::certainly(!at_knot))
        return undecided(t, start);
      if (CGAL::certainly(at_knot))
        spans.insert(spans.begin(), {Side::LEFT, *span(t, Side::LEFT)});
    }
    const auto at_end = is_zero_decision(NT(t - domain()[1]));
    if (CGAL::certainly(at_end))
      spans.back().side = Side::LEFT;
    return spans;
  }

  //! returns \f$ 1 / (t_{i+r} - t_i) \f$, or 0 where the two knots are equal.
  const NT& inverse_length(int i, int r) const { return m_inverse_lengths[r - 1][i]; }

  //! returns the knot vector in another number type; equal knots stay equal, others different.
  template <class To>
  Knot_vector<To> cast() const
  {
    Knot_vector<To> to;
    to.m_degree = m_degree;
    for (const NT& t : m_knots)
      to.m_knots.push_back(number_cast<To>(t));
    to.m_groups = m_groups;
    to.prepare();
    return to;
  }

private:
  template <class> friend class Knot_vector;

  Knot_vector() = default;

  // Numbers the different knots in order.
  static std::optional<std::string> find_groups(const std::vector<NT>& knots,
                                                std::vector<int>& groups)
  {
    const auto name = [&](std::size_t i) {
      return "knot " + std::to_string(i) + " (" + internal::text_of(knots[i]) + ")";
    };
    for (std::size_t i = 0; i < knots.size(); ++i)
    {
      if (!Number_type_traits<NT>::is_finite(knots[i]))
        return name(i) + " is not a finite number";
      if (i == 0)
      {
        groups.push_back(0);
        continue;
      }
      const auto sign = sign_decision(NT(knots[i] - knots[i - 1]));
      if (CGAL::certainly(sign == CGAL::NEGATIVE))
        return name(i) + " is less than " + name(i - 1) + " before it";
      const bool is_equal = CGAL::certainly(sign == CGAL::ZERO);
      if (!is_equal && !CGAL::certainly(sign == CGAL::POSITIVE))
        return "it is undecided whether " + name(i) + " is greater than " + name(i - 1);
      groups.push_back(is_equal ? groups.back() : groups.back() + 1);
    }
    return std::nullopt;
  }

  static Refusal undecided(const NT& t, const NT& knot)
  {
    return Refusal(Refusal_code::UNDECIDED, "it is undecided on which side of the knot " +
                                              internal::text_of(knot) + " the parameter " +
                                              internal::text_of(t) + " is");
  }

  int multiplicity(int k) const
  {
    return static_cast<int>(std::count(m_groups.begin(), m_groups.end(), m_groups[k]));
  }

  // The spans of the domain and the divisions that evaluation needs.
  void prepare()
  {
    for (int k = m_degree; k < number_of_control_points(); ++k)
      if (m_groups[k] != m_groups[k + 1])
        m_spans.push_back(k);
    m_inverse_lengths.resize(m_degree);
    for (int r = 1; r <= m_degree; ++r)
      for (std::size_t i = 0; i + r < m_knots.size(); ++i)
        m_inverse_lengths[r - 1].push_back(m_groups[i] == m_groups[i + r]
                                             ? NT(0)
                                             : NT(NT(1) / (m_knots[i + r] - m_knots[i])));
  }

  int m_degree = 0;
  std::vector<NT> m_knots;
  std::vector<int> m_groups, m_spans;
  std::vector<std::vector<NT>> m_inverse_lengths;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_KNOT_VECTOR_H
