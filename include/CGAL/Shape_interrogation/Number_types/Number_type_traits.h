// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_TYPE_TRAITS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_TYPE_TRAITS_H

// What the package asks of a number type: signs that say when they do not know.
// Every branch on a value goes through sign_decision() and is_zero_decision().

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief collects the properties of a number type that the package uses.
 *
 * The primary template works for every model of the \cgal concepts
 * `RingNumberType` and `RealEmbeddable`. It is specialised for the package's own number types.
 *
 * \tparam NT a number type
 */
template <class NT>
struct Number_type_traits
{
  //! `CGAL::Sign`, or `CGAL::Uncertain<CGAL::Sign>` for enclosures.
  using Sign = typename Same_uncertainty_nt<CGAL::Sign, NT>::type;
  //! `bool`, or `CGAL::Uncertain<bool>` for enclosures.
  using Boolean = typename Same_uncertainty_nt<bool, NT>::type;

  //! tells whether the arithmetic is exact, so that every decision is.
  static constexpr bool is_exact = Algebraic_structure_traits<NT>::Is_exact::value;
  //! tells whether the operations are single instructions, so that a whole evaluation may be
  //! inlined into one function. (For exact types that would cost minutes of compilation and gain
  //! nothing.)
  static constexpr bool is_light = std::is_floating_point_v<NT>;
  //! tells whether a number stands for a set of values that contains the true one.
  static constexpr bool is_enclosure = !std::is_same_v<Boolean, bool>;

  //! returns the sign of `x`.
  static Sign sign(const NT& x) { return CGAL::sign(x); }
  //! tells whether `x` is zero.
  static Boolean is_zero(const NT& x) { return CGAL::is_zero(x); }
  //! tells whether `x` is a number at all, not the result of an overflow.
  static bool is_finite(const NT& x)
  {
    if constexpr (std::is_floating_point_v<NT>)
      return std::isfinite(x);
    else
      return CGAL::is_finite(x);
  }
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief returns the sign of `x`; an enclosure that contains zero and more answers
 * `Uncertain`.
 */
template <class NT>
inline typename Number_type_traits<NT>::Sign sign_decision(const NT& x)
{
  return Number_type_traits<NT>::sign(x);
}

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief tells whether `x` is zero; an enclosure that contains zero and more answers
 * `Uncertain`.
 */
template <class NT>
inline typename Number_type_traits<NT>::Boolean is_zero_decision(const NT& x)
{
  return Number_type_traits<NT>::is_zero(x);
}

namespace internal {

// A quantity known to be non-negative: what rounding put below zero is cut off. An exact number
// that is negative would be an error, which is not hidden.
template <class NT>
NT nonnegative_part(const NT& x)
{
  if constexpr (std::is_floating_point_v<NT>)
    return x < NT(0) ? NT(0) : x;
  else
    return x;
}

template <bool P>
Interval_nt<P> nonnegative_part(const Interval_nt<P>& x)
{
  return x.inf() < 0 ? Interval_nt<P>(0, (std::max)(x.sup(), 0.0)) : x;
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_NUMBER_TYPE_TRAITS_H
