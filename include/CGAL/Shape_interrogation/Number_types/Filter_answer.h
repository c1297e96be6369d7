// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTER_ANSWER_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTER_ANSWER_H

// What a chain may return to a filter, and when that is certain.

#include <CGAL/Uncertain.h>

#include <optional>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief tells a filter what a certain answer is. The primary template is for types that are always
 * certain (`Sign`, `bool`); there are specialisations for `Uncertain` and `Result`.
 *
 * \tparam T the type that a chain returns
 */
template <class T>
struct Filter_answer
{
  using type = T; //!< the type of a certain answer
  //! stores the answer and returns `true`, or returns `false` if the answer is not certain.
  static bool assign(std::optional<type>& answer, const T& x)
  {
    answer.emplace(x);
    return true;
  }
  //! returns the answer of the last, exact stage.
  static type last(const T& x) { return x; }
};

#ifndef DOXYGEN_RUNNING

template <class T>
struct Filter_answer<Uncertain<T>>
{
  using type = T;
  static bool assign(std::optional<type>& answer, const Uncertain<T>& x)
  {
    if (!x.is_certain())
      return false;
    answer.emplace(x.make_certain());
    return true;
  }
  static type last(const Uncertain<T>& x) { return x.make_certain(); }
};

#endif

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTER_ANSWER_H
