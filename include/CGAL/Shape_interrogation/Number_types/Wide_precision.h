// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_PRECISION_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_PRECISION_H

// How many bits the numbers of many bits have that a thread computes.

#include <CGAL/assertions.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief sets the precision in which a thread computes with `Wide_interval`, until the end of its
 * scope.
 */
class Wide_precision
{
public:
  //! sets the precision of this thread. \pre `bits` is at least 2
  explicit Wide_precision(int bits) : m_outer(current())
  {
    CGAL_precondition_msg(bits >= 2, "a number has at least two bits");
    current() = bits;
  }
  //! restores the precision that was in force before.
  ~Wide_precision() { current() = m_outer; }
  Wide_precision(const Wide_precision&) = delete;
  Wide_precision& operator=(const Wide_precision&) = delete;

  //! returns the precision in force in this thread: 106 bits where none was set.
  static int bits() { return current(); }

private:
  static int& current()
  {
    static thread_local int bits = 106;
    return bits;
  }

  int m_outer;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_WIDE_PRECISION_H
