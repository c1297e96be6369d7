// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PACK_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PACK_H

// Several doubles as one number type: the same computation at several points, in vectors of the
// width that the target has. Nothing is decided for single lanes but by masks.

#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_constants.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// As many doubles as one instruction takes, at most four: wider vectors would be passed through
// memory.
#if (defined(__GNUC__) || defined(__clang__)) && defined(__AVX__)
typedef double Double_vector __attribute__((vector_size(32)));
#elif defined(__GNUC__) || defined(__clang__)
typedef double Double_vector __attribute__((vector_size(16)));
#else
typedef double Double_vector; // one by one
#endif

template <int W>
class Pack
{
  static constexpr int chunk = sizeof(Double_vector) / sizeof(double);
  static constexpr int chunks = W / chunk;
  static_assert(W % chunk == 0, "whole vectors");

public:
  static constexpr int width = W;

  [[gnu::always_inline]] Pack() {} // not set
  [[gnu::always_inline]] Pack(double x)
  {
    for (int i = 0; i < chunks; ++i)
      m_v[i] = Double_vector{} + x;
  }
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  [[gnu::always_inline]] Pack(Integer x) : Pack(static_cast<double>(x))
  {}

  // Copies from and to memory that need not be aligned.
  [[gnu::always_inline]] static Pack load(const double* x)
  {
    Pack p;
    std::memcpy(p.m_v, x, sizeof p.m_v);
    return p;
  }
  [[gnu::always_inline]] void store(double* x) const { std::memcpy(x, m_v, sizeof m_v); }

  [[gnu::always_inline]] friend Pack operator+(const Pack& a) { return a; }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = -a.m_v[i];
    return r;
  }
  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] + b.m_v[i];
    return r;
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] - b.m_v[i];
    return r;
  }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] * b.m_v[i];
    return r;
  }
  [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] / b.m_v[i];
    return r;
  }
  [[gnu::always_inline]] Pack& operator+=(const Pack& b) { return *this = *this + b; }
  [[gnu::always_inline]] Pack& operator-=(const Pack& b) { return *this = *this - b; }
  [[gnu::always_inline]] Pack& operator*=(const Pack& b) { return *this = *this * b; }
  [[gnu::always_inline]] Pack& operator/=(const Pack& b) { return *this = *this / b; }

  [[gnu::always_inline]] friend Pack fabs(const Pack& a) { return larger(a, -a); }
  // The second where they cannot be compared.
  [[gnu::always_inline]] friend Pack larger(const Pack& a, const Pack& b)
  {
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] > b.m_v[i] ? a.m_v[i] : b.m_v[i];
    return r;
  }
  // 1 where a > b, else 0.
  [[gnu::always_inline]] friend Pack is_greater(const Pack& a, const Pack& b)
  {
    const Pack one(1.0), zero(0.0);
    Pack r;
    for (int i = 0; i < chunks; ++i)
      r.m_v[i] = a.m_v[i] > b.m_v[i] ? one.m_v[i] : zero.m_v[i];
    return r;
  }

private:
  Double_vector m_v[chunks];
};

template <class NT> struct Is_pack : std::false_type {};
template <int W> struct Is_pack<Pack<W>> : std::true_type {};

// The constants of a tape.
template <int W>
struct Constants_view<Pack<W>>
{
  explicit Constants_view(const Tape_constants& c) : m_first(c.nearest.data()) {}
  [[gnu::always_inline]] Pack<W> operator[](std::uint32_t i) const { return Pack<W>(m_first[i]); }
  const double* m_first;
};

} // namespace internal

// What divides by zero in one lane does so in the pack: the points are then taken one by one.
template <int W>
struct Number_type_traits<internal::Pack<W>>
{
  using Sign = CGAL::Sign;
  using Boolean = bool;
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = false;
  static constexpr bool is_light = true;

  static bool is_zero(const internal::Pack<W>& x)
  {
    double lanes[W];
    x.store(lanes);
    bool any = false;
    for (double lane : lanes)
      any |= lane == 0;
    return any;
  }
};

template <int W>
struct Elementary_functions<internal::Pack<W>>
{
  using NT = internal::Pack<W>;
  using Base = Elementary_functions<double>;
  static NT sqrt(const NT& x) { return each(x, Base::sqrt); }
  static NT exp(const NT& x) { return each(x, Base::exp); }
  static NT log(const NT& x) { return each(x, Base::log); }
  static NT sin(const NT& x) { return each(x, Base::sin); }
  static NT cos(const NT& x) { return each(x, Base::cos); }
  static NT tan(const NT& x) { return each(x, Base::tan); }
  static NT asin(const NT& x) { return each(x, Base::asin); }
  static NT acos(const NT& x) { return each(x, Base::acos); }
  static NT atan(const NT& x) { return each(x, Base::atan); }
  static NT pi() { return NT(Base::pi()); }

private:
  static NT each(const NT& x, double (*function)(double))
  {
    double lanes[W];
    x.store(lanes);
    for (double& lane : lanes)
      lane = function(lane);
    return NT::load(lanes);
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_PACK_H
