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

struct Normal_side
{
  bool is_decided = true;
  bool is_to_be_turned = false;
};

// The sign that decides the side, zero if it is undecided or there is none.
template <class NT>
CGAL::Sign side_sign(const NT& x, Normal_side& side)
{
  const auto sign = sign_decision(x);
  side.is_decided = CGAL::is_certain(sign);
  return side.is_decided ? CGAL::make_certain(sign) : CGAL::ZERO;
}

// Finds whether the normal `n` has to be turned: by the given direction, else by the first
// component that is not zero.
template <class NT>
std::optional<Refusal> orient(const N_space_system& system, const Coordinates<NT, 3>& n,
                              Normal_side& side)
{
  side = Normal_side();
  CGAL::Sign sign = CGAL::ZERO;
  if (system.orientation())
  {
    Coordinates<NT, 3> d;
    for (int i = 0; i < 3; ++i)
      d[i] = number_cast<NT>((*system.orientation())[i]);
    sign = side_sign(NT(dot(n, d)), side);
    if (side.is_decided && sign == CGAL::ZERO)
      return Refusal(Refusal_code::AMBIGUOUS,
                     "the direction that orients the normal is orthogonal to it");
  }
  for (int i = 0; i < 3 && side.is_decided && sign == CGAL::ZERO; ++i)
    sign = side_sign(n[i], side);
  side.is_to_be_turned = sign == CGAL::NEGATIVE;
  return std::nullopt;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_ORIENT_N_SPACE_SHAPE_H
