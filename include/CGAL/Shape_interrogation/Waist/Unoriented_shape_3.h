// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_UNORIENTED_SHAPE_3_H
#define CGAL_SHAPE_INTERROGATION_WAIST_UNORIENTED_SHAPE_3_H

// Second-order data (N, B) or (-N, -B), where an enclosure does not tell which: questions are asked
// of both.

#include <CGAL/Shape_interrogation/Number_types/Answer_union.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is the second-order data of a surface of which the side of the normal may be undecided:
 * \f$ (N, B) \f$ or \f$ (-N, -B) \f$.
 *
 * A rule such as "the first component of the normal that is not zero is positive" decides nothing
 * where an enclosure of that component contains zero. The data are known all the same, up to one
 * common sign. `ask()` therefore puts a question to both sides and unites the answers: what does
 * not depend on the side (the Gaussian curvature and its sign, umbilic, planar, the type of the
 * point, squares) is answered as sharply as for an oriented surface; what does (the signs of mean
 * and normal curvatures) is undecided, or enclosed in the hull of both values. No question needs to
 * know which kind it is of.
 *
 * \tparam NT the number type; in one that is no enclosure the side is always decided
 */
template <class NT>
class Unoriented_shape_3
{
public:
  //! constructs data that must be assigned before use.
  Unoriented_shape_3() = default;

  //! constructs the data from those of one side, which is the right one if `is_oriented`.
  explicit Unoriented_shape_3(Local_shape_3<NT> shape, bool is_oriented = false)
    : m_shape(std::move(shape)), m_is_oriented(is_oriented)
  {}

  //! tells whether the side is decided.
  bool is_oriented() const { return m_is_oriented; }

  //! returns the data of one side: of the right one if `is_oriented()`.
  const Local_shape_3<NT>& one_side() const { return m_shape; }

  //! returns the data of the same surface with the opposite normal.
  Unoriented_shape_3 opposite() const
  {
    return Unoriented_shape_3(m_shape.opposite(), m_is_oriented);
  }

  /*!
   * \brief returns what `question` answers about the side, or about both if that is undecided.
   * \param question a function object that takes a `Local_shape_3<NT>`; if `NT` is an enclosure,
   * there is an `Answer_union` of its answers
   */
  template <class Question>
  auto ask(Question question) const
  {
    using Answer = std::decay_t<decltype(question(m_shape))>;
    if constexpr (Number_type_traits<NT>::is_enclosure)
      if (!m_is_oriented)
        return Answer_union<Answer>::of(question(m_shape), question(m_shape.opposite()));
    return Answer(question(m_shape));
  }

private:
  Local_shape_3<NT> m_shape;
  bool m_is_oriented = false;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_UNORIENTED_SHAPE_3_H
