// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_DECIDE_BOUND_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_DECIDE_BOUND_H

// Bounds of one property surface as signs of polynomials, and its extremes.

#include <CGAL/Shape_interrogation/Bernstein/decide_nonnegative.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/Extreme_search.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Bound_verdict.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The property with a denominator that is nowhere negative.
template <class NT>
Property_surface<NT> with_nonnegative_denominator(const Property_surface<NT>& s)
{
  if (s.has_nonnegative_denominator() || s.denominator().scaled_coefficients().size() == 1)
    return s;
  return {s.property(), s.numerator() * s.denominator(), s.denominator() * s.denominator(),
          s.radicand()};
}

template <class NT>
Certified_extreme<NT, 2> property_extreme(const Property_surface<NT>& surface, bool is_supremum,
                                          const Bound_limits& limits)
{
  const auto s = with_nonnegative_denominator(surface);
  const auto p = is_supremum ? s.numerator() : -s.numerator();
  const double known = !is_supremum && is_square(s.property()) ? 0 : HUGE_VAL;
  const auto extreme = Extreme_search<NT, 2>(p, s.denominator(), limits, s.radicand(),
                                             is_supremum ? 1 : -1, known)
                         .run();
  return is_supremum ? extreme : extreme.negative();
}

// The polynomials c q - p for "at most", p - c q for "at least", and with a root (c q - p)^2 - r,
// respectively its negative: `all` of which, or one of which, must not be negative.
template <class NT>
struct Bound_margins
{
  std::vector<Bernstein_polynomial_2<NT>> polynomials;
  bool all = true;
};

template <class NT>
Bound_margins<NT> bound_margins(const Property_surface<NT>& s, const NT& bound, bool is_upper)
{
  const Bernstein_polynomial_2<NT> margin =
    s.denominator() * Bernstein_polynomial_2<NT>(bound) - s.numerator();
  if (!s.radicand())
    return {{is_upper ? margin : -margin}, true};
  const Bernstein_polynomial_2<NT> square = margin * margin - *s.radicand();
  if (is_upper)
    return {{margin, square}, true};
  return {{-margin, -square}, false};
}

template <class NT>
Sign_verdict<NT, 2> decide_margins(const Bound_margins<NT>& margins, std::size_t most_boxes)
{
  if (!margins.all)
    return decide_nonnegative(margins.polynomials, most_boxes);
  Sign_verdict<NT, 2> all{Verdict::YES, std::nullopt};
  for (const auto& p : margins.polynomials)
  {
    const auto one = decide_nonnegative<NT, 2>({p}, most_boxes);
    if (one.verdict == Verdict::NO)
      return one;
    if (one.verdict == Verdict::UNDECIDED)
      all = one;
  }
  return all;
}

// A witness where the property has a value: near the given one, which may be on a collapsed edge.
template <class NT>
std::optional<Coordinates<NT, 2>> regular_witness(const Property_surface<NT>& s,
                                                  const Bound_margins<NT>& margins,
                                                  const Coordinates<NT, 2>& witness)
{
  const auto is_witness = [&](const Coordinates<NT, 2>& x) {
    int negative = 0;
    for (const auto& p : margins.polynomials)
      negative += CGAL::sign(p(x)) == CGAL::NEGATIVE;
    return !CGAL::is_zero(s.denominator()(x)) &&
           (margins.all ? negative > 0 : negative == static_cast<int>(margins.polynomials.size()));
  };
  if (is_witness(witness))
    return witness;
  const NT x = NT(1) / NT(2), y = NT(2) / NT(5); // not on a line of symmetry
  return move_inside<NT>(witness, {x, y}, is_witness);
}

// At most (or at least) by what the numbers are, whatever the surface.
template <class NT>
bool is_bound_of_square(Property property, const NT& bound, bool is_upper)
{
  return !is_upper && is_square(property) && CGAL::sign(bound) != CGAL::POSITIVE;
}

template <class NT>
Result<Bound_verdict<NT>> decide_bound(const Property_surface<NT>& surface, const NT& bound,
                                       bool is_upper, const Bound_limits& limits)
{
  if (surface.denominator().is_zero())
    return Refusal(Refusal_code::IRREGULAR_PARAMETRISATION,
                   "the denominator of the property is zero on the whole patch");
  const auto s = with_nonnegative_denominator(surface);
  Bound_verdict<NT> v;
  v.extreme = property_extreme(s, is_upper, limits);
  v.at = v.extreme.at;
  const Bound_margins<NT> margins = bound_margins(s, bound, is_upper);
  const auto sign = is_bound_of_square(s.property(), bound, is_upper)
                      ? Sign_verdict<NT, 2>{Verdict::YES, std::nullopt}
                      : decide_margins(margins, 4 * limits.boxes);
  v.verdict = sign.verdict;
  if (sign.verdict == Verdict::NO)
  {
    v.at = regular_witness(s, margins, *sign.witness);
    if (!v.at)
      v.at = *sign.witness;
  }
  else if (sign.verdict == Verdict::UNDECIDED && v.extreme.is_bounded &&
           (is_upper ? v.extreme.upper <= bound : v.extreme.lower >= bound))
    v.verdict = Verdict::YES;
  return v;
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_DECIDE_BOUND_H
