// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SUBDIVISION_BOX_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SUBDIVISION_BOX_H

// Bernstein coefficients over a box of the unit cube that is halved again and again, by the
// algorithm of de Casteljau without division: rationals run in the integers.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT, bool = is_fraction_of_gmp<NT>()>
struct Subdivision_ring
{
  using type = NT;
};
template <class NT>
struct Subdivision_ring<NT, true>
{
  using type = typename Fraction_traits<NT>::Numerator_type;
};

// Coefficients times a positive number that nobody needs to know.
template <class Ring, int d>
struct Coefficient_array
{
  std::array<int, d> degree;
  std::vector<Ring> numbers;
};

template <class Ring>
Ring times_power_of_two(const Ring& x, int k)
{
  if constexpr (Has_gmp<Ring>::value)
  {
    Ring y;
    mpz_mul_2exp(gmp_of(y), gmp_of(x), k);
    return y;
  }
  else
  {
    Ring y = x;
    for (; k > 0; --k)
      y = y + y;
    return y;
  }
}

template <class NT>
int sign_of(const NT& x)
{
  return static_cast<int>(CGAL::sign(x));
}

// The coefficients of polynomials, which may be compared with each other: all are multiplied by the
// same number.
template <class NT, int d>
auto subdivision_arrays(const std::vector<Bernstein_polynomial<NT, d>>& polynomials)
{
  using Ring = typename Subdivision_ring<NT>::type;
  std::vector<Coefficient_array<Ring, d>> arrays;
  if constexpr (std::is_same_v<Ring, NT>)
    for (const auto& p : polynomials)
      arrays.push_back({p.degree(), p.coefficients()});
  else
  {
    std::vector<NT> all;
    for (const auto& p : polynomials)
      for (const NT& c : p.coefficients())
        all.push_back(c);
    typename Fraction_traits<NT>::Denominator_type denominator;
    const std::vector<Ring> numerators = clear_denominators(all, denominator);
    auto next = numerators.begin();
    for (const auto& p : polynomials)
    {
      arrays.push_back({p.degree(), std::vector<Ring>(next, next + size_of(p.degree()))});
      next += size_of(p.degree());
    }
  }
  return arrays;
}

// Both halves along an axis, times 2^n for the degree n, or times 2^power for a greater power.
template <class Ring, int d>
std::array<Coefficient_array<Ring, d>, 2> halves(const Coefficient_array<Ring, d>& from, int axis,
                                                 int power)
{
  const Axis_layout layout = axis_layout(from.degree, axis);
  const int n = from.degree[axis], more = power - n;
  std::array<Coefficient_array<Ring, d>, 2> to{from, from};
  std::vector<Ring> line(n + 1);
  for (std::size_t o = 0; o < layout.outer; ++o)
    for (std::size_t r = 0; r < layout.stride; ++r)
    {
      const auto place = [&](int i) { return (o * layout.length + i) * layout.stride + r; };
      for (int i = 0; i <= n; ++i)
        line[i] = from.numbers[place(i)];
      for (int k = n; k >= 0; --k)
      {
        to[0].numbers[place(n - k)] = times_power_of_two(line[0], more + k);
        to[1].numbers[place(k)] = times_power_of_two(line[k], more + k);
        for (int i = 0; i < k; ++i)
          line[i] += line[i + 1];
      }
    }
  return to;
}

// Some polynomials over a box.
template <class NT, int d>
struct Subdivision_box
{
  using Ring = typename Subdivision_ring<NT>::type;
  using Array = Coefficient_array<Ring, d>;
  using Point = std::array<NT, d>;

  std::vector<Array> arrays;
  std::array<int, d> depth{};
  Point low, high;

  explicit Subdivision_box(std::vector<Array> all = {}) : arrays(std::move(all))
  {
    low.fill(NT(0));
    high.fill(NT(1));
  }

  int degree(int axis) const
  {
    int n = 0;
    for (const Array& a : arrays)
      n = (std::max)(n, a.degree[axis]);
    return n;
  }

  // The two halves along the axis that has been halved least, of those that matter.
  std::array<Subdivision_box, 2> split() const
  {
    int axis = 0;
    for (int k = 1; k < d; ++k)
      if (degree(axis) == 0 || (degree(k) > 0 && depth[k] < depth[axis]))
        axis = k;
    std::array<Subdivision_box, 2> half{Subdivision_box(), Subdivision_box()};
    for (const Array& a : arrays)
    {
      auto parts = halves(a, axis, degree(axis));
      for (int side = 0; side < 2; ++side)
        half[side].arrays.push_back(std::move(parts[side]));
    }
    const NT middle = (low[axis] + high[axis]) / NT(2);
    for (auto& h : half)
    {
      h.low = low;
      h.high = high;
      h.depth = depth;
      ++h.depth[axis];
    }
    half[0].high[axis] = middle;
    half[1].low[axis] = middle;
    return half;
  }

  // Calls f with the corner and the place of its coefficient in an array of the degree.
  template <class Function>
  void for_each_corner(const std::array<int, d>& degree, Function f) const
  {
    for (int corner = 0; corner < 1 << d; ++corner)
    {
      Point x;
      std::size_t place = 0;
      for (int k = 0; k < d; ++k)
      {
        const bool is_high = corner >> k & 1;
        x[k] = is_high ? high[k] : low[k];
        place = place * (degree[k] + 1) + (is_high ? degree[k] : 0);
      }
      f(x, place);
    }
  }

  Point centre() const
  {
    Point x;
    for (int k = 0; k < d; ++k)
      x[k] = (low[k] + high[k]) / NT(2);
    return x;
  }
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_SUBDIVISION_BOX_H
