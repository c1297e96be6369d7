// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ANSWER_UNION_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ANSWER_UNION_H

// One answer in place of two of which one is right: what both say, or the hull of both.

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <algorithm>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief unites two answers of which one is right. There is no general rule: specialisations are
 * for `Uncertain`, `Interval_nt`, `Wide_interval` and `Result`; other types join by their own.
 *
 * \tparam T the type of an answer, which can say that it is not certain
 */
template <class T>
struct Answer_union
{
#ifdef DOXYGEN_RUNNING
  //! returns an answer that both `a` and `b` imply.
  static T of(const T& a, const T& b);
#endif
};

#ifndef DOXYGEN_RUNNING

template <class T>
struct Answer_union<Uncertain<T>>
{
  static Uncertain<T> of(const Uncertain<T>& a, const Uncertain<T>& b)
  {
    return Uncertain<T>((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
  }
};

template <bool P>
struct Answer_union<Interval_nt<P>>
{
  static Interval_nt<P> of(const Interval_nt<P>& a, const Interval_nt<P>& b)
  {
    return Interval_nt<P>((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
  }
};

#endif

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ANSWER_UNION_H
