// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_DECIDE_AT_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_DECIDE_AT_H

// A decision at a point that is known by its enclosure: in double precision, then in more and more
// bits, up to a stated number.

#include <CGAL/Shape_interrogation/Number_types/Filter_answer.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_refinement.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a certain decision, and the bits of the numbers that decided.
 */
template <class T>
struct Enclosed_decision
{
  T answer{};   //!< the decision
  int bits = 0; //!< the precision that was needed: 53 for intervals of doubles
};

#ifndef DOXYGEN_RUNNING
namespace internal {

template <class T> struct As_result { using type = Result<T>; };
template <class T> struct As_result<Result<T>> { using type = Result<T>; };

// The question, put to the surface in a box of any enclosures. It may refuse.
template <class NT, class Question>
auto ask_in_box(const N_space_system& system, const std::vector<NT>& box, const Question& question)
{
  using Answer = std::decay_t<decltype(question(Local_shape_3<NT>()))>;
  using Answer_or_refusal = typename As_result<Answer>::type;
  const Result<Unoriented_shape_3<NT>> shape = N_space_evaluator<NT>(system).unoriented(box);
  if (!shape)
    return Answer_or_refusal(shape.refusal());
  return refuse_errors<typename Answer_or_refusal::value_type>(
    [&]() -> Answer_or_refusal { return shape->ask(question); });
}

template <class Question>
auto ask_in_doubles(const N_space_system& system, const N_space_enclosure& enclosure,
                    const Question& question)
{
  Interval_nt<false>::Protector protector;
  return ask_in_box(system, enclosure.box, question);
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief decides a question about the surface of a system at a point that an enclosure contains.
 *
 * \details The question is asked in intervals of doubles, and where these leave it open in numbers
 * of 106, 212, ... bits, for which the enclosure is refined. A certain answer holds for the point
 * in the enclosure, as long as the equations of `N_space_enclosure::others_contain_zero` vanish
 * there. It is never guessed: a curvature that is exactly zero stays open in every precision,
 * because an interval that contains zero does not prove it, and is refused with `UNDECIDED`; an
 * exact point decides it. What depends on the side of the normal is refused in the same way where
 * that stays open: see `Unoriented_shape_3`. Other refusals are those of `N_space_evaluator` where
 * they are certain, such as `NOT_TWO_DIMENSIONAL`, and those of the question.
 *
 * Thread-safe if the question is.
 * \param system the system
 * \param enclosure a result of `enclose_solution()` for the system
 * \param question a function object that takes a `Local_shape_3` of `Interval_nt<false>` or of
 * `Wide_interval`, and returns an `Uncertain` decision, or a `Result` of one
 * \param max_bits the precision after which it gives up
 * \return the decision and the bits that it took
 */
template <class Question>
auto decide_at(const N_space_system& system, const N_space_enclosure& enclosure,
               const Question& question, int max_bits = 848)
{
  using First = decltype(internal::ask_in_doubles(system, enclosure, question));
  using Certain = typename Filter_answer<First>::type; // Result of what is certain
  using Decision = Result<Enclosed_decision<typename Certain::value_type>>;
  std::optional<Certain> certain;
  int bits = 53;
  const auto decided = [&]() -> Decision {
    if (!*certain)
      return certain->refusal();
    return Enclosed_decision<typename Certain::value_type>{**certain, bits};
  };
  if (Filter_answer<First>::assign(certain, internal::ask_in_doubles(system, enclosure, question)))
    return decided();
  N_space_refinement refine(system, enclosure);
  while (bits < max_bits)
  {
    bits = (std::min)(2 * bits, max_bits);
    const Result<std::vector<Wide_interval>> box = refine(bits);
    if (!box)
      return Decision(box.refusal());
    const Wide_precision precision(bits + 32);
    const auto answer = internal::ask_in_box(system, *box, question);
    if (Filter_answer<std::decay_t<decltype(answer)>>::assign(certain, answer))
      return decided();
  }
  return Decision(Refusal(Refusal_code::UNDECIDED,
                          "undecided in " + std::to_string(bits) +
                            " bits: it may be degenerate, which an exact point would tell"));
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_DECIDE_AT_H
