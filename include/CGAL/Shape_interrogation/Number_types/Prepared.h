// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_PREPARED_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_PREPARED_H

// Data with the conversions that the first stages of a filter ask for, made once.

#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/internal/Magnitude.h>

#include <CGAL/Interval_nt.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief keeps data together with their enclosure, so that a filter does not convert them in each
 * call.
 *
 * \tparam Data a class with a member type `FT` and a member template `cast<To>()`
 */
template <class Data>
class Prepared
{
public:
  using FT = typename Data::FT; //!< the number type of the data

  //! converts once.
  explicit Prepared(Data data)
    : m_data(std::move(data)), m_enclosure(enclose(m_data)), m_magnitude(measure(m_data))
  {}

  //! returns the data.
  const Data& data() const { return m_data; }

  //! returns the data in another number type.
  template <class To>
  decltype(auto) cast() const
  {
    if constexpr (std::is_same_v<To, Interval_nt<false>>)
      return static_cast<const Enclosure&>(m_enclosure);
    else if constexpr (std::is_same_v<To, internal::Magnitude> && has_doubles)
      return static_cast<const Magnitude&>(m_magnitude);
    else if constexpr (std::is_same_v<To, FT>)
      return static_cast<const Data&>(m_data);
    else
      return m_data.template cast<To>();
  }

private:
  template <class To>
  using Cast = std::decay_t<decltype(std::declval<const Data&>().template cast<To>())>;
  static constexpr bool has_doubles = internal::Has_double_data<FT>::value;
  struct None {};
  using Enclosure = Cast<Interval_nt<false>>;
  using Magnitude = std::conditional_t<has_doubles, Cast<internal::Magnitude>, None>;

  static Enclosure enclose(const Data& data)
  {
    Interval_nt<false>::Protector protector;
    return data.template cast<Interval_nt<false>>();
  }
  static Magnitude measure(const Data& data)
  {
    if constexpr (has_doubles)
      return data.template cast<internal::Magnitude>();
    else
      return None();
  }

  Data m_data;
  Enclosure m_enclosure;
  Magnitude m_magnitude;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_PREPARED_H
