// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTERED_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTERED_H

// A filter around a whole chain from input to decision: running magnitude, interval, an exact ring,
// then exact rationals, each only where the one before is undecided.

#include <CGAL/Shape_interrogation/Number_types/Filter_answer.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Exact_ring.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Magnitude.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief counts how often each stage of a filter gave the answer. Thread-safe.
 */
struct Filter_statistics
{
  std::atomic<unsigned long> magnitude{0};  //!< answers of the running magnitude
  std::atomic<unsigned long> interval{0};   //!< answers of the interval
  std::atomic<unsigned long> exact_ring{0}; //!< answers of the exact ring
  std::atomic<unsigned long> exact{0};      //!< answers of the exact number type

  //! returns how often interval arithmetic did not suffice.
  unsigned long fallbacks() const { return exact_ring + exact; }
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief makes any chain of computations that ends in a decision a certified one.
 *
 * The chain is a callable that works in every number type: called with arguments converted by
 * `cast_argument()` it returns a decision (`Sign`, `bool`, or `Uncertain` of these), or a `Result`
 * of one. The chain is run in floating point with a running magnitude (only for data given in
 * `double`), then in interval arithmetic under one protection of the rounding mode, and only where
 * these are undecided exactly: in a ring of dyadic numbers if the data are doubles and the chain
 * does not divide, else in `ExactNT`. For systems in n-space, which divide at every step, there are
 * only the interval and `ExactNT`. The filter covers the whole chain: a decision about data that
 * were rounded before would be exact about the wrong data.
 *
 * To work in every number type a chain has to decide by `sign_decision()` and `is_zero_decision()`:
 * the number types of the first and third stage have no comparisons, and neither `CGAL::sign()` nor
 * `CGAL::is_zero()`.
 *
 * A chain that checks a point to be on a surface is only certified where the check is: an enclosure
 * cannot prove a zero. Chains should use the level set of the point
 * (`Implicit_surface_3::level_set_shape()`), or check once with an exact type.
 *
 * Const calls are thread-safe if those of the chain are. The rounding mode is restored on every
 * path, also when the chain throws. A filter can be copied, but not assigned to.
 *
 * Where no stage decides, because the chain has no value in `ExactNT` (transcendental functions), a
 * chain that refuses then answers `Refusal_code::UNDECIDED`; for a bare decision there is an
 * exception.
 *
 * \exception Not_algebraic_error if no stage decides, and the chain throws this or
 * `Mixed_roots_error` in `ExactNT`
 * \exception Conversion_error if no stage before the exact ones decides and the data are not finite
 *
 * \tparam Chain a default or copy constructible callable
 * \tparam ExactNT an exact field that all data convert to
 */
template <class Chain, class ExactNT = CGAL::Exact_rational>
class Filtered
{
public:
  //! constructs the filter; `statistics`, if given, counts and must outlive the filter.
  explicit Filtered(Chain chain = Chain(), Filter_statistics* statistics = nullptr)
    : m_chain(std::move(chain)), m_statistics(statistics)
  {}

  //! constructs a copy, which learns about its stages on its own.
  Filtered(const Filtered& other) : m_chain(other.m_chain), m_statistics(other.m_statistics) {}

  //! returns the certified decision of the chain for the arguments.
  template <class... Args>
  auto operator()(const Args&... args) const
  {
    using Exact_answer = Filter_answer<
      std::decay_t<decltype(m_chain(cast_argument<ExactNT>(args)...))>>;
    using Answer = typename Exact_answer::type;
    constexpr bool doubles = (internal::Has_double_data<Args>::value && ...) &&
                             !(internal::Needs_field<Args>::value || ...);
    std::optional<Answer> answer;
    if constexpr (doubles)
      if (m_use_magnitude.load(std::memory_order_relaxed) &&
          internal::Magnitude::is_safe_in_rounding_mode() && try_magnitude(answer, args...))
        return count(&Filter_statistics::magnitude, *answer);
    if (try_interval(answer, args...))
      return count(&Filter_statistics::interval, *answer);
    Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
#ifdef CGAL_HAS_MPZF
    if constexpr (doubles)
      if (m_use_ring.load(std::memory_order_relaxed) &&
          try_ring<internal::Exact_ring>(answer, m_use_ring, args...))
        return count(&Filter_statistics::exact_ring, *answer);
#endif
    return count(&Filter_statistics::exact, last_answer<Exact_answer>(args...));
  }

private:
  template <class Answer>
  Answer count(std::atomic<unsigned long> Filter_statistics::*stage, const Answer& answer) const
  {
    if (m_statistics)
      (m_statistics->*stage).fetch_add(1, std::memory_order_relaxed);
    return answer;
  }

  template <class Answer, class T>
  [[gnu::always_inline]] static bool assign(std::optional<Answer>& answer, const T& x)
  {
    return Filter_answer<T>::assign(answer, x);
  }

  // A stage that cannot represent the chain (a constant 1/3, a function) is not tried again.
  template <class NT, class Answer, class... Args>
  bool try_ring(std::optional<Answer>& answer, std::atomic<bool>& use,
                                       const Args&... args) const
  {
    try
    {
      return assign(answer, m_chain(cast_argument<NT>(args)...));
    }
    catch (const Conversion_error&) { use.store(false, std::memory_order_relaxed); }
    catch (const Uncertain_conversion_exception&) {}
    return false;
  }

  // Everything in one function: what the decision does not need is then not computed at all.
  template <class Answer, class... Args>
  [[gnu::flatten]] bool try_magnitude(std::optional<Answer>& answer, const Args&... args) const
  {
    return try_ring<internal::Magnitude>(answer, m_use_magnitude, args...);
  }

  template <class Answer, class... Args>
  bool try_interval(std::optional<Answer>& answer, const Args&... args) const
  {
    using Interval = Interval_nt<false>;
    Interval::Protector protector;
    try
    {
      return assign(answer, m_chain(cast_argument<Interval>(args)...));
    }
    catch (const Uncertain_conversion_exception&) {}
    return false;
  }

  template <class Exact_answer, class... Args>
  auto last_answer(const Args&... args) const
  {
    try
    {
      return Exact_answer::last(m_chain(cast_argument<ExactNT>(args)...));
    }
    catch (const Not_algebraic_error& e) { refuse_undecided(e); }
    catch (const Mixed_roots_error& e) { refuse_undecided(e); }
  }

  [[noreturn]] static void refuse_undecided(const Shape_error& no_value)
  {
    throw Not_algebraic_error(
      std::string("the enclosure does not decide, and there is no exact value: ") +
      no_value.what());
  }

  Chain m_chain;
  Filter_statistics* m_statistics;
  mutable std::atomic<bool> m_use_magnitude{true}, m_use_ring{true};
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_FILTERED_H
