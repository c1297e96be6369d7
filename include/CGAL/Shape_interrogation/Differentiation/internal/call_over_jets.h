// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_CALL_OVER_JETS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_CALL_OVER_JETS_H

// Calls a user's function over jets. For light number types everything is inlined into one
// function, where the compiler sees the sparsity of the jets and drops the zero terms: about five
// times faster.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>

#include <array>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class J, class Function, class NT, std::size_t n, std::size_t... i>
auto call_plain(const Function& f, const std::array<NT, n>& x, std::index_sequence<i...>)
{
  return f(J::variable(static_cast<int>(i), x[i])...);
}

template <class J, class Function, class NT, std::size_t n, std::size_t... i>
[[gnu::flatten]] auto call_flattened(const Function& f, const std::array<NT, n>& x,
                                     std::index_sequence<i...>)
{
  return f(J::variable(static_cast<int>(i), x[i])...);
}

template <int Order, class Function, class NT, std::size_t n>
auto call_over_jets(const Function& f, const std::array<NT, n>& x)
{
  using J = Jet<NT, static_cast<int>(n), Order>;
  if constexpr (Number_type_traits<NT>::is_light)
    return call_flattened<J>(f, x, std::make_index_sequence<n>());
  else
    return call_plain<J>(f, x, std::make_index_sequence<n>());
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_CALL_OVER_JETS_H
