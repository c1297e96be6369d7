// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_CAST_ARGUMENT_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_CAST_ARGUMENT_H

// Conversion of whole arguments: numbers, arrays of them, and anything with a member cast<NT>().

#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Real_embeddable_traits.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

template <class T>
constexpr bool is_number = Real_embeddable_traits<T>::Is_real_embeddable::value;

template <class To, class T, class = void>
struct Has_cast : std::false_type {};
template <class To, class T>
struct Has_cast<To, T, std::void_t<decltype(std::declval<const T&>().template cast<To>())>>
  : std::true_type {};

template <class T, class = void>
struct Has_own_numbers : std::false_type {};
template <class T>
struct Has_own_numbers<T, std::void_t<typename T::R>> : std::true_type {}; // kernel objects
template <class T, class = void>
struct Has_field_type : std::false_type {};
template <class T>
struct Has_field_type<T, std::void_t<typename T::FT>> : std::true_type {};

// Whether the data of an argument are doubles (or it has none of its own).
template <class T, class = void>
struct Has_double_data : std::bool_constant<!is_number<T> || std::is_arithmetic_v<T>> {};
template <class T, std::size_t n>
struct Has_double_data<std::array<T, n>> : Has_double_data<T> {};
template <class T>
struct Has_double_data<std::vector<T>> : Has_double_data<T> {};
template <class T>
struct Has_double_data<T, std::void_t<typename T::FT>> : Has_double_data<typename T::FT> {};

// Whether the evaluation of an argument divides all the time, as one that solves linear equations:
// the stages of a filter that are rings, or lose their bounds in divisions, are of no use then.
template <class T> struct Needs_field : std::false_type {};

} // namespace internal

#ifndef DOXYGEN_RUNNING
template <class To, class T, std::size_t n>
auto cast_argument(const std::array<T, n>& x);
template <class To, class T>
auto cast_argument(const std::vector<T>& x);
#endif

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief returns `x` with all its numbers converted by `number_cast()`.
 *
 * Numbers, arrays and vectors are converted element by element; a class with a member template
 * `cast<To>()` is asked; anything else, such as a function that works in every number type, is
 * passed through by reference.
 */
template <class To, class T>
decltype(auto) cast_argument(const T& x)
{
  if constexpr (internal::is_number<T>)
    return number_cast<To>(x);
  else if constexpr (internal::Has_cast<To, T>::value)
    return x.template cast<To>();
  else
  {
    static_assert(!internal::Has_own_numbers<T>::value && !internal::Has_field_type<T>::value,
                  "an argument with numbers of its own needs a member cast<To>(): pass the"
                  " coordinates of kernel objects");
    return static_cast<const T&>(x);
  }
}

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief converts the elements of an array.
 */
template <class To, class T, std::size_t n>
auto cast_argument(const std::array<T, n>& x)
{
  std::array<std::decay_t<decltype(cast_argument<To>(x[0]))>, n> y;
  for (std::size_t i = 0; i < n; ++i)
    y[i] = cast_argument<To>(x[i]);
  return y;
}

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief converts the elements of a vector.
 */
template <class To, class T>
auto cast_argument(const std::vector<T>& x)
{
  std::vector<std::decay_t<decltype(cast_argument<To>(x[0]))>> y;
  y.reserve(x.size());
  for (const T& element : x)
    y.push_back(cast_argument<To>(element));
  return y;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_CAST_ARGUMENT_H
