// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_ISOLATE_ROOTS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_ISOLATE_ROOTS_H

// Real roots of a polynomial on the unit interval by Descartes' rule in Bernstein form. (CGAL's
// algebraic kernels isolate over the whole line and start from powers; here the intervals must be
// parts of the unit interval, and most calls end after counting signs once.)

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/Integer_coefficients.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>
#include <CGAL/assertions.h>
#include <CGAL/polynomial_utils.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {
class Root_isolator;
}

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief is a real root of a polynomial on the unit interval, enclosed between two rational bounds.
 *
 * Where the bounds differ, the root is strictly between them, and no other root of the polynomial
 * is. Where they agree, they are the root.
 */
class Bernstein_root
{
public:
  //! constructs a rational root.
  Bernstein_root(const Exact_rational& value, int multiplicity)
    : m_lower(value), m_upper(value), m_multiplicity(multiplicity)
  {}

  const Exact_rational& lower() const { return m_lower; } //!< returns the lower bound.
  const Exact_rational& upper() const { return m_upper; } //!< returns the upper bound.
  int multiplicity() const { return m_multiplicity; }     //!< returns the multiplicity.
  bool is_exact() const { return m_factor.empty(); }      //!< tells whether the bounds agree.

  //! halves the distance of the bounds.
  void refine()
  {
    if (is_exact())
      return;
    auto parts = internal::halves(std::move(m_factor));
    const Exact_rational middle = (m_lower + m_upper) / 2;
    const CGAL::Sign sign = CGAL::sign(parts[1].front());
    m_factor.clear();
    if (sign == ZERO)
      m_lower = m_upper = middle;
    else if (sign == CGAL::sign(parts[0].front()))
    {
      m_lower = middle;
      m_factor = std::move(parts[1]);
    }
    else
    {
      m_upper = middle;
      m_factor = std::move(parts[0]);
    }
  }

  //! halves the distance until it is at most `width`. \pre `width` is positive
  void refine(const Exact_rational& width)
  {
    while (m_upper - m_lower > width)
      refine();
  }

private:
  friend class internal::Root_isolator;

  // The only root of the factor, a simple one, strictly between the bounds.
  Bernstein_root(const Exact_rational& lower, const Exact_rational& upper, int multiplicity,
                 internal::Integers factor)
    : m_lower(lower), m_upper(upper), m_multiplicity(multiplicity), m_factor(std::move(factor))
  {}

  Exact_rational m_lower, m_upper;
  int m_multiplicity;
  internal::Integers m_factor; // its coefficients between the bounds, empty for a rational root
};

namespace internal {

// Descartes' rule: the variations of sign bound the number of roots strictly inside from above, and
// 0 and 1 are exact. Halving ends for square-free polynomials.
class Root_isolator
{
public:
  // Adds the roots strictly inside the unit interval of a polynomial, which has a simple root at
  // no end. Returns false where `depth` halvings did not separate them: multiple roots, perhaps.
  bool operator()(const Integers& b, int multiplicity, int depth,
                  std::vector<Bernstein_root>& roots)
  {
    m_roots = &roots;
    m_multiplicity = multiplicity;
    return isolate(b, 0, 1, depth);
  }

private:
  bool isolate(const Integers& b, const Exact_rational& lower, const Exact_rational& upper,
               int depth)
  {
    const int variations = sign_variations(b);
    if (variations == 0)
      return true;
    if (variations == 1 && !CGAL::is_zero(b.front()) && !CGAL::is_zero(b.back()))
    {
      m_roots->push_back(Bernstein_root(lower, upper, m_multiplicity, b));
      return true;
    }
    if (depth == 0)
      return false;
    const auto parts = halves(b);
    const Exact_rational middle = (lower + upper) / 2;
    if (!isolate(parts[0], lower, middle, depth - 1))
      return false;
    if (CGAL::is_zero(parts[1].front()))
    {
      if (CGAL::is_zero(parts[1][1]))
        return false; // multiple
      m_roots->push_back(Bernstein_root(middle, m_multiplicity));
    }
    return isolate(parts[1], middle, upper, depth - 1);
  }

  std::vector<Bernstein_root>* m_roots = nullptr;
  int m_multiplicity = 1;
};

// The roots strictly inside, where the coefficients at the ends are not zero.
inline void add_inner_roots(const Integers& scaled, std::vector<Bernstein_root>& roots)
{
  const std::size_t before = roots.size();
  if (Root_isolator()(unscaled(scaled), 1, 16, roots))
    return;
  // Perhaps there are multiple roots: the scaled coefficients are those of powers of u / (1 - u).
  roots.resize(before, Bernstein_root(0, 1));
  using Polynomial = CGAL::Polynomial<Exact_integer>;
  std::vector<std::pair<Polynomial, int>> factors;
  CGAL::square_free_factorize_up_to_constant_factor(Polynomial(scaled.begin(), scaled.end()),
                                                    std::back_inserter(factors));
  for (const auto& factor : factors)
    if (factor.first.degree() > 0)
      Root_isolator()(unscaled(Integers(factor.first.begin(), factor.first.end())), factor.second,
                      (std::numeric_limits<int>::max)(), roots);
}

inline bool overlap(const Bernstein_root& a, const Bernstein_root& b)
{
  // A rational root on a bound of the other is outside.
  return a.lower() < b.upper() && b.lower() < a.upper();
}

// Roots of different factors are different: their intervals become disjoint.
inline void separate(std::vector<Bernstein_root>& roots)
{
  const auto before = [](const Bernstein_root& a, const Bernstein_root& b) {
    return a.lower() + a.upper() < b.lower() + b.upper();
  };
  std::sort(roots.begin(), roots.end(), before);
  for (std::size_t i = 0; i + 1 < roots.size();)
  {
    if (!overlap(roots[i], roots[i + 1]))
    {
      ++i;
      continue;
    }
    roots[i].refine();
    roots[i + 1].refine();
    std::sort(roots.begin(), roots.end(), before);
    i = 0;
  }
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief returns the real roots of `p` on the closed unit interval in increasing order, each once,
 * with disjoint bounds. Exact.
 *
 * Complexity: polynomial in the degree and the length of the coefficients; where Descartes' rule
 * separates the roots after a few halvings, linear in the number of roots.
 * \pre `p` is not zero
 */
inline std::vector<Bernstein_root> isolate_roots(const Bernstein_polynomial_1<Exact_integer>& p)
{
  CGAL_precondition_msg(!p.is_zero(), "every number is a root of 0");
  const internal::Integers& c = p.scaled_coefficients();
  const auto is_not_zero = [](const Exact_integer& x) { return !CGAL::is_zero(x); };
  const auto first = std::find_if(c.begin(), c.end(), is_not_zero);
  const auto last = std::find_if(c.rbegin(), c.rend(), is_not_zero).base();
  std::vector<Bernstein_root> roots;
  if (first != c.begin())
    roots.emplace_back(Exact_rational(0), static_cast<int>(first - c.begin()));
  internal::add_inner_roots(internal::Integers(first, last), roots);
  if (last != c.end())
    roots.emplace_back(Exact_rational(1), static_cast<int>(c.end() - last));
  internal::separate(roots);
  return roots;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_ISOLATE_ROOTS_H
