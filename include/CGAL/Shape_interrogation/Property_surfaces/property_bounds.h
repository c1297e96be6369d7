// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_BOUNDS_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_BOUNDS_H

// The range of a property over a whole patch, and theorems "at most" and "at least" about it.

#include <CGAL/Shape_interrogation/Bernstein/bounds.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Bound_verdict.h>
#include <CGAL/Shape_interrogation/Property_surfaces/internal/decide_bound.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns certified intervals of the least and the greatest value of a property on its
 * patch, with their places, see `supremum()`.
 *
 * Where numerator and denominator both vanish along an edge, as on collapsed ones, the property is
 * continued.
 *
 * \tparam NT an exact field number type
 * \pre the denominator is not identically zero
 */
template <class NT>
Certified_range<NT, 2> bounds(const Property_surface<NT>& surface, const Bound_limits& limits = {})
{
  return {internal::property_extreme(surface, false, limits),
          internal::property_extreme(surface, true, limits)};
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief decides whether a property is at most `bound` on the whole patch, where it has a value.
 *
 * A proof or a witness, exactly, also where the bound is attained at a corner or along an edge; see
 * `decide_nonnegative()` for what stays undecided. For `SPEED_SUPREMUM` the two conditions
 * \f$ E + G \le 2 c \f$ and \f$ c^2 - (E + G) c + E G - F^2 \ge 0 \f$ take the place of the root.
 * Refused where the property has no value anywhere (`IRREGULAR_PARAMETRISATION`).
 *
 * \tparam NT an exact field number type
 */
template <class NT>
Result<Bound_verdict<NT>> decide_at_most(const Property_surface<NT>& surface, const NT& bound,
                                         const Bound_limits& limits = {})
{
  return internal::decide_bound(surface, bound, true, limits);
}

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief decides whether a property is at least `bound` on the whole patch, as
//! `decide_at_most()` does.
template <class NT>
Result<Bound_verdict<NT>> decide_at_least(const Property_surface<NT>& surface, const NT& bound,
                                          const Bound_limits& limits = {})
{
  return internal::decide_bound(surface, bound, false, limits);
}

namespace internal {

// The extreme of all pieces, in the parameters of the spline surface.
template <class NT>
void unite(Certified_extreme<NT, 2>& all, const Certified_extreme<NT, 2>& one, bool is_supremum)
{
  const auto further = [&](const NT& x, const NT& y) { return is_supremum ? x < y : y < x; };
  NT Certified_extreme<NT, 2>::*const attained =
    is_supremum ? &Certified_extreme<NT, 2>::lower : &Certified_extreme<NT, 2>::upper;
  NT Certified_extreme<NT, 2>::*const bound =
    is_supremum ? &Certified_extreme<NT, 2>::upper : &Certified_extreme<NT, 2>::lower;
  if (one.is_attained && (!all.is_attained || further(all.*attained, one.*attained)))
  {
    all.at = one.at;
    all.*attained = one.*attained;
    all.is_attained = true;
  }
  if (one.is_bounded && further(all.*bound, one.*bound))
    all.*bound = one.*bound;
  all.is_bounded = all.is_bounded && one.is_bounded;
}

template <class NT>
Result<Bound_verdict<NT>> decide_bound(const std::vector<Property_surface_piece<NT>>& pieces,
                                       const NT& bound, bool is_upper, const Bound_limits& limits)
{
  std::optional<Bound_verdict<NT>> all;
  for (const auto& piece : pieces)
  {
    Result<Bound_verdict<NT>> decided = decide_bound(piece.surface, bound, is_upper, limits);
    if (!decided)
      return decided.refusal();
    Bound_verdict<NT> one = *decided;
    one.extreme.at = piece.on_surface(one.extreme.at);
    one.at = piece.on_surface(*one.at);
    if (!all)
    {
      all = one;
      continue;
    }
    unite(all->extreme, one.extreme, is_upper);
    if (all->verdict != Verdict::NO)
    {
      all->at = one.verdict == Verdict::NO ? one.at : all->extreme.at;
      if (one.verdict != Verdict::YES)
        all->verdict = one.verdict;
    }
  }
  return *all;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief decides whether a property of a spline surface is at most `bound`; places are in the
 * parameters of the surface. \pre there is at least one piece
 */
template <class NT>
Result<Bound_verdict<NT>> decide_at_most(const std::vector<Property_surface_piece<NT>>& pieces,
                                         const NT& bound, const Bound_limits& limits = {})
{
  return internal::decide_bound(pieces, bound, true, limits);
}

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief decides whether a property of a spline surface is at least `bound`.
//! \pre there is at least one piece
template <class NT>
Result<Bound_verdict<NT>> decide_at_least(const std::vector<Property_surface_piece<NT>>& pieces,
                                          const NT& bound, const Bound_limits& limits = {})
{
  return internal::decide_bound(pieces, bound, false, limits);
}

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief returns the range of a property of a spline surface, with places in its parameters.
//! \pre there is at least one piece
template <class NT>
Certified_range<NT, 2> bounds(const std::vector<Property_surface_piece<NT>>& pieces,
                              const Bound_limits& limits = {})
{
  std::optional<Certified_range<NT, 2>> all;
  for (const auto& piece : pieces)
  {
    Certified_range<NT, 2> one = bounds(piece.surface, limits);
    one.infimum.at = piece.on_surface(one.infimum.at);
    one.supremum.at = piece.on_surface(one.supremum.at);
    if (!all)
      all = one;
    internal::unite(all->infimum, one.infimum, false);
    internal::unite(all->supremum, one.supremum, true);
  }
  return *all;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_BOUNDS_H
