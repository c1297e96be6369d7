// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_REFUSE_OUTSIDE_H
#define CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_REFUSE_OUTSIDE_H

// Parameters outside a domain: certainly outside, or perhaps.

#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <optional>
#include <string>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
std::optional<Refusal> refuse_outside(const char* name, const NT& t, const NT& low, const NT& high)
{
  if (!Number_type_traits<NT>::is_finite(t))
    return Refusal(Refusal_code::OUTSIDE_DOMAIN,
                   std::string("the parameter ") + name + " is not a finite number");
  const auto below = sign_decision(NT(t - low)) == CGAL::NEGATIVE;
  const auto above = sign_decision(NT(high - t)) == CGAL::NEGATIVE;
  if (CGAL::certainly(!below) && CGAL::certainly(!above))
    return std::nullopt;
  const std::string what = std::string("the parameter ") + name + " = " + text_of(t);
  const std::string where = " the domain [" + text_of(low) + ", " + text_of(high) + "]";
  if (CGAL::certainly(below) || CGAL::certainly(above))
    return Refusal(Refusal_code::OUTSIDE_DOMAIN, what + " is outside" + where);
  return Refusal(Refusal_code::UNDECIDED, "it is undecided whether " + what + " is in" + where);
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CURVES_INTERNAL_REFUSE_OUTSIDE_H
