// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORIENT_N_SPACE_SHAPE_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORIENT_N_SPACE_SHAPE_H

// The side of the normal of a system: that of the direction that orients it, else the one with the
// first non-zero component positive.

#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/Uncertain.h>

#include <optional>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
std::optional<Refusal> refuse_orientation(const NT& x, CGAL::Sign& sign)
{
  const auto decision = sign_decision(x);
  if (!CGAL::is_certain(decision))
    return Refusal(Refusal_code::UNDECIDED,
                   "the orientation of the normal is undecided: " + text_of(x));
  sign = CGAL::make_certain(decision);
  return std::nullopt;
}

// Finds whether the normal `n` has to be turned. An orientation that is undecided makes every odd
// sign undecided.
template <class NT>
std::optional<Refusal> orient(const N_space_system& system, const Coordinates<NT, 3>& n,
                              bool& is_to_be_turned)
{
  CGAL::Sign sign = CGAL::ZERO;
  if (system.orientation())
  {
    Coordinates<NT, 3> d;
    for (int i = 0; i < 3; ++i)
      d[i] = number_cast<NT>((*system.orientation())[i]);
    if (auto refusal = refuse_orientation(NT(dot(n, d)), sign))
      return refusal;
    if (sign == CGAL::ZERO)
      return Refusal(Refusal_code::AMBIGUOUS,
                     "the direction that orients the normal is orthogonal to it");
  }
  for (int i = 0; i < 3 && sign == CGAL::ZERO; ++i)
    if (auto refusal = refuse_orientation(n[i], sign))
      return refusal;
  is_to_be_turned = sign == CGAL::NEGATIVE;
  return std::nullopt;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORIENT_N_SPACE_SHAPE_H
