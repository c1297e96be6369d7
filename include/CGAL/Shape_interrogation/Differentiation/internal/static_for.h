// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_STATIC_FOR_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_STATIC_FOR_H

// A loop over compile-time indices, unrolled: f(0), f(1), ..., f(n-1) as integral constants.

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class F, int... k>
[[gnu::always_inline]] inline void static_for(F f, std::integer_sequence<int, k...>)
{
  (f(std::integral_constant<int, k>()), ...);
}

template <int n, class F>
[[gnu::always_inline]] inline void static_for(F f)
{
  static_for(f, std::make_integer_sequence<int, n>());
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_STATIC_FOR_H
