// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_HAS_LEVEL_SET_H
#define CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_HAS_LEVEL_SET_H

// Whether a source answers for the level set through any point, not only for one surface.

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Source, class Query, class = void>
struct Has_level_set : std::false_type {};
template <class Source, class Query>
struct Has_level_set<Source, Query,
                     std::void_t<decltype(std::declval<const Source&>().level_set_shape(
                       std::declval<const Query&>()))>> : std::true_type {};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_INTERNAL_HAS_LEVEL_SET_H
