// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_CONSTANTS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_CONSTANTS_H

// The constants of a tape: exact, and ready as double and interval, so that evaluation in these
// does not touch rationals. Jets take the constants of their coefficients.

#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

template <class NT, int N, int Order> class Jet;

namespace internal {

struct Tape_constants
{
  Tape_constants() = default;
  explicit Tape_constants(const std::vector<CGAL::Exact_rational>& values) : exact(values)
  {
    for (const CGAL::Exact_rational& x : exact)
    {
      nearest.push_back(number_cast<double>(x));
      enclosure.push_back(number_cast<Interval_nt<false>>(x));
    }
  }

  std::vector<CGAL::Exact_rational> exact;
  std::vector<double> nearest;
  std::vector<Interval_nt<false>> enclosure;
};

// Constants as seen by a number type: by default converted where used, cheaply from double where
// that is exact.
template <class NT>
struct Constants_view
{
  explicit Constants_view(const Tape_constants& c) : m_constants(&c) {}

  NT operator[](std::uint32_t i) const
  {
    if (m_constants->enclosure[i].is_point())
      return number_cast<NT>(m_constants->nearest[i]);
    return number_cast<NT>(m_constants->exact[i]);
  }

  const Tape_constants* m_constants;
};

template <class NT>
struct Stored_constants_view
{
  const NT& operator[](std::uint32_t i) const { return m_first[i]; }
  const NT* m_first;
};

template <>
struct Constants_view<double> : Stored_constants_view<double>
{
  explicit Constants_view(const Tape_constants& c)
    : Stored_constants_view<double>{c.nearest.data()}
  {}
};

template <>
struct Constants_view<Interval_nt<false>> : Stored_constants_view<Interval_nt<false>>
{
  explicit Constants_view(const Tape_constants& c)
    : Stored_constants_view<Interval_nt<false>>{c.enclosure.data()}
  {}
};

template <>
struct Constants_view<CGAL::Exact_rational> : Stored_constants_view<CGAL::Exact_rational>
{
  explicit Constants_view(const Tape_constants& c)
    : Stored_constants_view<CGAL::Exact_rational>{c.exact.data()}
  {}
};

template <>
struct Constants_view<Interval_nt<true>>
{
  explicit Constants_view(const Tape_constants& c) : m_first(c.enclosure.data()) {}

  Interval_nt<true> operator[](std::uint32_t i) const
  {
    return Interval_nt<true>(m_first[i].inf(), m_first[i].sup());
  }

  const Interval_nt<false>* m_first;
};

// Jets are multiplied by constants of their coefficients' type.
template <class NT, int N, int Order>
struct Constants_view<Jet<NT, N, Order>> : Constants_view<NT>
{
  using Constants_view<NT>::Constants_view;
};

// The positions of results that are found in slots, and of those that are constants.
struct Tape_results
{
  struct Item { std::uint32_t position, index; };

  std::size_t size() const { return in_slots.size() + constant.size(); }

  template <class NT>
  void gather(const NT* slots, const Tape_constants& constants, NT* results) const
  {
    const Constants_view<NT> view(constants);
    for (const Item& item : in_slots)
      results[item.position] = slots[item.index];
    for (const Item& item : constant)
      results[item.position] = NT(view[item.index]);
  }

  // The index of the constant at a position, or null.
  const std::uint32_t* find_constant(std::size_t position) const
  {
    const auto item = std::lower_bound(
      constant.begin(), constant.end(), position,
      [](const Item& i, std::size_t p) { return i.position < p; });
    return item != constant.end() && item->position == position ? &item->index : nullptr;
  }

  std::vector<Item> in_slots, constant; // positions increase
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_TAPE_CONSTANTS_H
