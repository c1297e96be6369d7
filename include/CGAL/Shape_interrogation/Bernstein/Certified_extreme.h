// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_CERTIFIED_EXTREME_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_CERTIFIED_EXTREME_H

// What a search for the greatest value of a function finds, and when it may stop.

#include <array>
#include <cstddef>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief tells a search for bounds when to stop.
 */
struct Bound_limits
{
  double tolerance = 1e-9; //!< the width of the interval that suffices, as a part of the greatest
                           //!< absolute value that is met
  std::size_t boxes = 500; //!< how many boxes are looked at; of polynomials with more than 500
                           //!< coefficients as many fewer as there are more of these
};

namespace internal {

// The number of boxes that costs no more than `boxes` with 500 coefficients each.
inline std::size_t affordable_boxes(std::size_t boxes, std::size_t coefficients)
{
  const std::size_t affordable = boxes * 500 / coefficients;
  return affordable < boxes ? affordable : boxes;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief holds a certified interval of an extreme value of a function, and a place.
 *
 * Of a supremum, `lower` is at most a value that is taken at `at`; of an infimum, `upper` is at
 * least one. The other end is a bound of all values, if `is_bounded`.
 */
template <class NT, int d>
struct Certified_extreme
{
  NT lower{0};             //!< the lower end of the interval
  NT upper{0};             //!< the upper end of the interval
  std::array<NT, d> at{};  //!< a place where nearly the extreme value is taken
  bool is_attained = true; //!< whether a value was found; else `at` and its end mean nothing
  bool is_bounded = true;  //!< whether a bound was found; else the other end means nothing

  //! returns the extreme of the negative function.
  Certified_extreme negative() const
  {
    return {NT(-upper), NT(-lower), at, is_attained, is_bounded};
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_CERTIFIED_EXTREME_H
