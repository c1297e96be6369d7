// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_REFUSAL_H
#define CGAL_SHAPE_INTERROGATION_WAIST_REFUSAL_H

// A question without an answer is answered by a typed refusal with its evidence,
// never by NaN, an assertion or a wrong number.

#include <CGAL/Shape_interrogation/Number_types/Answer_union.h>
#include <CGAL/Shape_interrogation/Number_types/Filter_answer.h>

#include <CGAL/assertions.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief tells why a question has no answer at a place.
 */
enum class Refusal_code
{
  NOT_ON_SURFACE,             //!< the point does not satisfy the equation
  SINGULAR_POINT,             //!< the gradient vanishes
  IRREGULAR_PARAMETRISATION,  //!< the first derivatives are linearly dependent
  POLE,                       //!< the common weight of a rational patch or curve vanishes
  NOT_ON_SOLUTION,            //!< the point does not satisfy the system
  UNDERDETERMINED,            //!< fewer than n - 2 equations
  RANK_DEFICIENT,             //!< the Jacobian has rank less than n - 2
  NOT_TWO_DIMENSIONAL,        //!< the Jacobian has rank greater than n - 2
  INCONSISTENT_REDUNDANCY,    //!< redundant equations contradict each other to second order
  PROJECTION_SINGULAR,        //!< the projection into space is not an immersion there
  DEPENDENT_DIRECTIONS,       //!< two of three given directions are parallel
  NOT_TANGENT,                //!< a given direction is not tangent
  AMBIGUOUS,                  //!< there are several answers, none better than the others
  NOT_ALGEBRAIC,              //!< the value does not exist in the number type
  OUTSIDE_DOMAIN,             //!< the parameter lies outside the domain
  LIMIT_EXCEEDED,             //!< a value overflows or a documented limit is exceeded
  UNDECIDED,                  //!< the number type cannot decide; an exact one can
  CANCELLED                   //!< the caller asked to stop
};

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief returns the name of `code` as it stands in reports, for example `"singular_point"`.
 */
inline const char* to_string(Refusal_code code)
{
  static const char* const names[] = {
    "not_on_surface", "singular_point", "irregular_parametrisation", "pole", "not_on_solution",
    "underdetermined", "rank_deficient", "not_two_dimensional", "inconsistent_redundancy",
    "projection_singular", "dependent_directions", "not_tangent", "ambiguous", "not_algebraic",
    "outside_domain", "limit_exceeded", "undecided", "cancelled"};
  return names[static_cast<int>(code)];
}

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is the reason why there is no answer: a code and the evidence in words.
 */
class Refusal
{
public:
  //! constructs a refusal; `evidence` is one sentence for people.
  Refusal(Refusal_code code, std::string evidence) : m_data(make(code, std::move(evidence))) {}

  //! returns the code.
  Refusal_code code() const { return m_data->code; }

  //! returns the evidence.
  const std::string& evidence() const { return m_data->evidence; }

private:
  template <class T> friend class Result;

  struct Data
  {
    Refusal_code code;
    std::string evidence;
  };
  using Data_pointer = std::shared_ptr<const Data>;

  // Out of line: refusals are rare, and the code around them is hot.
  [[gnu::noinline, gnu::cold]] static Data_pointer make(Refusal_code code, std::string evidence)
  {
    return std::make_shared<const Data>(Data{code, std::move(evidence)});
  }

  explicit Refusal(Data_pointer data) : m_data(std::move(data)) {}

  Data_pointer m_data;
};

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief holds the answer to a question, or the refusal that stands in its place.
 *
 * (The answer is a plain member, not part of a union: the compiler can then keep it in registers.)
 *
 * \tparam T the type of the answer, default constructible
 */
template <class T>
class Result
{
public:
  using value_type = T; //!< the type of the answer

  Result(T value) : m_value(std::move(value)) {} //!< holds an answer.
  //! holds the answer that `make()` returns, constructed in place: large answers are not copied.
  template <class Make>
  Result(std::in_place_t, Make make) : m_value(make())
  {}
  //! holds a refusal.
  Result(Refusal refusal) : m_value(), m_refusal(std::move(refusal.m_data)) {}

  //! tells whether there is an answer.
  bool has_value() const { return !m_refusal; }

  //! tells whether there is an answer.
  explicit operator bool() const { return has_value(); }

  //! returns the answer. \pre `has_value()`
  const T& value() const&
  {
    CGAL_precondition_msg(has_value(), "there is no answer: look at refusal()");
    return m_value;
  }

  //! returns the answer of a temporary. \pre `has_value()`
  T value() &&
  {
    CGAL_precondition_msg(has_value(), "there is no answer: look at refusal()");
    return std::move(m_value);
  }

  const T& operator*() const& { return value(); }      //!< is the same as `value()`.
  T operator*() && { return std::move(*this).value(); } //!< is the same as `value()`.
  const T* operator->() const { return &value(); } //!< gives access to members of the answer.

  //! returns the reason why there is no answer. \pre `!has_value()`
  Refusal refusal() const
  {
    CGAL_precondition_msg(!has_value(), "there is an answer: look at value()");
    return Refusal(m_refusal);
  }

private:
  T m_value;
  Refusal::Data_pointer m_refusal;
};

#ifndef DOXYGEN_RUNNING

// Refusals that another number type would not give are no answers to a filter.
template <class T>
struct Filter_answer<Result<T>>
{
  using Inner = Filter_answer<T>;
  using type = Result<typename Inner::type>;

  static bool assign(std::optional<type>& answer, const Result<T>& x)
  {
    if (!x)
      return assign_refusal(answer, x.refusal());
    std::optional<typename Inner::type> inner;
    if (!Inner::assign(inner, *x))
      return false;
    answer.emplace(*inner);
    return true;
  }

  // After the last stage, what does not exist exactly stays undecided.
  static type last(const Result<T>& x)
  {
    if (x)
      return Inner::last(*x);
    if (x.refusal().code() != Refusal_code::NOT_ALGEBRAIC)
      return x.refusal();
    return Refusal(Refusal_code::UNDECIDED,
                   "the enclosure does not decide, and there is no exact value: " +
                     x.refusal().evidence());
  }

private:
  static bool assign_refusal(std::optional<type>& answer, const Refusal& refusal)
  {
    const Refusal_code code = refusal.code();
    if (code == Refusal_code::UNDECIDED || code == Refusal_code::LIMIT_EXCEEDED ||
        code == Refusal_code::NOT_ALGEBRAIC)
      return false;
    answer.emplace(refusal);
    return true;
  }
};

template <class T>
struct Answer_union<Result<T>>
{
  static Result<T> of(const Result<T>& a, const Result<T>& b)
  {
    if (a && b)
      return Answer_union<T>::of(*a, *b);
    if (!a && !b && a.refusal().code() == b.refusal().code())
      return a;
    return Refusal(Refusal_code::UNDECIDED, "of two cases, of which the enclosure does not decide,"
                                            " one is refused: " +
                                              (a ? b : a).refusal().evidence());
  }
};

#endif

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_REFUSAL_H
