// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_MULTIPLY_ARRAYS_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_MULTIPLY_ARRAYS_H

// Products of arrays of coefficients: by rows in any ring, packed into one product of integers
// where that is faster, and for rationals in the integers over a common denominator.

#include <CGAL/Shape_interrogation/Bernstein/internal/Packed_polynomial.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <std::size_t d>
std::size_t size_of(const std::array<int, d>& degree)
{
  std::size_t size = 1;
  for (int n : degree)
    size *= n + std::size_t(1);
  return size;
}

// Where the coefficients of a polynomial stand in an array for polynomials of a higher degree.
template <std::size_t d>
std::vector<int> slots(const std::array<int, d>& degree, const std::array<int, d>& higher)
{
  std::vector<int> at{0};
  for (std::size_t k = 0; k < d; ++k)
  {
    std::vector<int> next;
    next.reserve(at.size() * (degree[k] + 1));
    for (int start : at)
      for (int i = 0; i <= degree[k]; ++i)
        next.push_back(start * (higher[k] + 1) + i);
    at = std::move(next);
  }
  return at;
}

// An integer of GMP that is constructed without a value is zero and has no memory yet.
template <class NT>
std::vector<NT> zeros(std::size_t size)
{
  if constexpr (Has_gmp<NT>::value)
    return std::vector<NT>(size);
  else
    return std::vector<NT>(size, NT(0));
}

template <class NT>
void add_product(NT& sum, const NT& a, const NT& b)
{
  if constexpr (Has_gmp<NT>::value)
    mpz_addmul(gmp_of(sum), gmp_of(a), gmp_of(b));
  else
    sum += a * b;
}

template <class NT>
void multiply_by_rows(const std::vector<NT>& a, const std::vector<int>& slots_a,
                      const std::vector<NT>& b, const std::vector<int>& slots_b,
                      std::vector<NT>& product)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      add_product(product[slots_a[i] + slots_b[j]], a[i], b[j]);
}

template <class Integer>
std::size_t longest(const std::vector<Integer>& numbers)
{
  std::size_t bits = 1;
  for (const Integer& z : numbers)
    bits = std::max(bits, mpz_sizeinbase(gmp_of(z), 2));
  return bits;
}

// The limbs that hold every coefficient of the product and its sign.
inline std::size_t slot_width(std::size_t bits_a, std::size_t bits_b, std::size_t terms)
{
  std::size_t bits = bits_a + bits_b + 1;
  for (; terms > 0; terms /= 2)
    ++bits;
  return (bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
}

template <class Integer>
void multiply_packed(const std::vector<Integer>& a, const std::vector<int>& slots_a,
                     const std::vector<Integer>& b, const std::vector<int>& slots_b,
                     std::size_t width, std::vector<Integer>& product)
{
  const Packed_polynomial x(a, slots_a, width);
  if (&a == &b)
    Packed_polynomial(x, x).unpack(product, width);
  else
    Packed_polynomial(x, Packed_polynomial(b, slots_b, width)).unpack(product, width);
}

// A common denominator of the numbers and their numerators over it.
template <class NT>
auto clear_denominators(const std::vector<NT>& numbers,
                        typename Fraction_traits<NT>::Denominator_type& denominator)
{
  using Traits = Fraction_traits<NT>;
  using Integer = typename Traits::Numerator_type;
  typename Traits::Decompose decompose;
  std::vector<Integer> numerators(numbers.size());
  std::vector<typename Traits::Denominator_type> denominators(numbers.size());
  denominator = 1;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    decompose(numbers[i], numerators[i], denominators[i]);
    if (denominators[i] != denominator)
    {
      const auto common = typename Traits::Common_factor()(denominator, denominators[i]);
      denominator = denominator / common * denominators[i];
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (denominators[i] != denominator)
      numerators[i] *= Integer(denominator / denominators[i]);
  return numerators;
}

template <class NT>
constexpr bool is_fraction_of_gmp()
{
  using Traits = Fraction_traits<NT>;
  if constexpr (Traits::Is_fraction::value)
    return Has_gmp<typename Traits::Numerator_type>::value;
  else
    return false;
}

template <class NT, std::size_t d>
std::vector<NT> multiply_arrays(const std::array<int, d>& degree_a, const std::vector<NT>& a,
                                const std::array<int, d>& degree_b, const std::vector<NT>& b)
{
  std::array<int, d> degree;
  for (std::size_t k = 0; k < d; ++k)
    degree[k] = degree_a[k] + degree_b[k];
  if constexpr (is_fraction_of_gmp<NT>())
  {
    using Traits = Fraction_traits<NT>;
    typename Traits::Denominator_type denominator_a, denominator_b;
    const auto x = clear_denominators(a, denominator_a);
    const auto y = clear_denominators(b, denominator_b);
    const typename Traits::Denominator_type denominator = denominator_a * denominator_b;
    std::vector<NT> product;
    for (auto& z : multiply_arrays(degree_a, x, degree_b, &a == &b ? x : y))
      product.push_back(typename Traits::Compose()(z, denominator));
    return product;
  }
  else
  {
    std::vector<NT> product = zeros<NT>(size_of(degree));
    const std::vector<int> slots_a = slots(degree_a, degree), slots_b = slots(degree_b, degree);
    if constexpr (Has_gmp<NT>::value)
    {
      const std::size_t width = slot_width(longest(a), longest(b), std::min(a.size(), b.size()));
      if (a.size() * b.size() > 100 * width) // measured: below, packing does not pay
      {
        multiply_packed(a, slots_a, b, slots_b, width, product);
        return product;
      }
    }
    multiply_by_rows(a, slots_a, b, slots_b, product);
    return product;
  }
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_MULTIPLY_ARRAYS_H
