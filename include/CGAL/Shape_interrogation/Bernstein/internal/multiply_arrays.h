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
#include <utility>
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

// An even number of bits that holds every coefficient of the product and its sign.
inline std::size_t slot_bits(std::size_t bits_a, std::size_t bits_b, std::size_t terms)
{
  std::size_t bits = bits_a + bits_b + 1;
  for (; terms > 0; terms /= 2)
    ++bits;
  return bits + bits % 2;
}

template <class Integer>
void multiply_packed(const std::vector<Integer>& a, const std::vector<int>& slots_a,
                     const std::vector<Integer>& b, const std::vector<int>& slots_b,
                     std::size_t bits, std::vector<Integer>& product)
{
  const Packed_polynomial x(a, slots_a, bits);
  if (&a == &b)
    Packed_polynomial(x, x).unpack(product, bits);
  else
    Packed_polynomial(x, Packed_polynomial(b, slots_b, bits)).unpack(product, bits);
}

// The values at 2^(bits / 2) and at the negative of it, in half the length: two
// products of half the length, from which the even and the odd coefficients are read (D. Harvey,
// Faster polynomial multiplication via multipoint Kronecker substitution).
template <class Integer>
void multiply_packed_twice(const std::vector<Integer>& a, const std::vector<int>& slots_a,
                           const std::vector<Integer>& b, const std::vector<int>& slots_b,
                           std::size_t bits, std::vector<Integer>& product)
{
  const mp_bitcnt_t half = bits / 2;
  const auto evaluate = [&](const auto& c, const std::vector<int>& slots, Integer& at_plus,
                            Integer& at_minus) {
    Integer even, odd;
    Packed_polynomial(c, slots, bits, 0, 2).get(gmp_of(even));
    Packed_polynomial(c, slots, bits, 1, 2).get(gmp_of(odd));
    mpz_mul_2exp(gmp_of(odd), gmp_of(odd), half);
    mpz_add(gmp_of(at_plus), gmp_of(even), gmp_of(odd));
    mpz_sub(gmp_of(at_minus), gmp_of(even), gmp_of(odd));
  };
  Integer a_plus, a_minus, b_plus, b_minus;
  evaluate(a, slots_a, a_plus, a_minus);
  if (&a != &b)
    evaluate(b, slots_b, b_plus, b_minus);
  mpz_mul(gmp_of(a_plus), gmp_of(a_plus), gmp_of(&a == &b ? a_plus : b_plus));
  mpz_mul(gmp_of(a_minus), gmp_of(a_minus), gmp_of(&a == &b ? a_minus : b_minus));
  std::vector<Integer> parts[2]{std::vector<Integer>((product.size() + 1) / 2),
                                std::vector<Integer>(product.size() / 2)};
  mpz_add(gmp_of(b_plus), gmp_of(a_plus), gmp_of(a_minus));
  mpz_sub(gmp_of(b_minus), gmp_of(a_plus), gmp_of(a_minus));
  mpz_tdiv_q_2exp(gmp_of(b_plus), gmp_of(b_plus), 1);
  mpz_tdiv_q_2exp(gmp_of(b_minus), gmp_of(b_minus), half + 1);
  Packed_polynomial(gmp_of(std::as_const(b_plus))).unpack(parts[0], bits);
  Packed_polynomial(gmp_of(std::as_const(b_minus))).unpack(parts[1], bits);
  for (std::size_t k = 0; k < product.size(); ++k)
    mpz_swap(gmp_of(product[k]), gmp_of(parts[k % 2][k / 2]));
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
      const std::size_t bits = slot_bits(longest(a), longest(b), std::min(a.size(), b.size()));
      if (a.size() * b.size() > 2 * bits) // measured: below, packing does not pay
      {
        // Measured: two products of half the length take four fifths of the time.
        if (bits * (std::max)(slots_a.back(), slots_b.back()) > 40000)
          multiply_packed_twice(a, slots_a, b, slots_b, bits, product);
        else
          multiply_packed(a, slots_a, b, slots_b, bits, product);
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
