// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_INLINE_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_INLINE_H

// Forced inlining where the standard has no place for an attribute: behind the parameters of a
// lambda. Elsewhere [[gnu::always_inline]] serves, which other compilers are free to ignore.

#if defined(__GNUC__) || defined(__clang__)
#  define CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA __attribute__((always_inline))
#else
#  define CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA
#endif

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_INLINE_H
