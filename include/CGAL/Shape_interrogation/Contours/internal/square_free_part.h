// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SQUARE_FREE_PART_H
#define CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SQUARE_FREE_PART_H

// The square-free part of a polynomial in two variables: on a multiple factor every point of the
// zero set is singular. Most polynomials are proved square-free by their image in a finite field.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>
#include <CGAL/polynomial_utils.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Polynomials in one variable over the field with 2^31 - 1 elements, the lowest power first.
class Modular_polynomial
{
public:
  static constexpr std::uint64_t prime = 2147483647;

  explicit Modular_polynomial(std::vector<std::uint64_t> coefficients)
    : m_c(std::move(coefficients))
  {
    trim();
  }

  int degree() const { return static_cast<int>(m_c.size()) - 1; } // -1 for 0

  Modular_polynomial derivative() const
  {
    std::vector<std::uint64_t> c;
    for (std::size_t i = 1; i < m_c.size(); ++i)
      c.push_back(m_c[i] * i % prime);
    return Modular_polynomial(c);
  }

  // Whether it has no common factor with its derivative.
  bool is_square_free() const
  {
    Modular_polynomial a = *this, b = derivative();
    while (b.degree() >= 0)
    {
      a.reduce(b);
      std::swap(a, b);
    }
    return a.degree() == 0;
  }

private:
  void trim()
  {
    while (!m_c.empty() && m_c.back() == 0)
      m_c.pop_back();
  }

  // The remainder of the division by b.
  void reduce(const Modular_polynomial& b)
  {
    const std::uint64_t inverse = power(b.m_c.back(), prime - 2);
    while (degree() >= b.degree())
    {
      const std::uint64_t q = prime - m_c.back() * inverse % prime;
      const std::size_t shift = m_c.size() - b.m_c.size();
      for (std::size_t i = 0; i < b.m_c.size(); ++i)
        m_c[shift + i] = (m_c[shift + i] + q * b.m_c[i]) % prime;
      trim();
    }
  }

  static std::uint64_t power(std::uint64_t x, std::uint64_t n)
  {
    std::uint64_t y = 1;
    for (; n > 0; n /= 2, x = x * x % prime)
      if (n % 2 == 1)
        y = y * x % prime;
    return y;
  }

  std::vector<std::uint64_t> m_c;
};

// Whether the image where the other variable is fixed has full degree and is square-free: then no
// factor that contains the variable `axis` is multiple.
inline bool is_square_free_in(const Bernstein_polynomial_2<Exact_integer>& f, int axis)
{
  constexpr std::uint64_t p = Modular_polynomial::prime;
  const int rows = f.degree()[axis] + 1, columns = f.degree()[1 - axis] + 1;
  for (const std::uint64_t x : {1234567u, 7654321u, 987654u})
  {
    std::vector<std::uint64_t> image(rows, 0);
    for (int i = 0; i < rows; ++i)
      for (int j = columns - 1; j >= 0; --j)
      {
        const std::array<int, 2> index =
          axis == 0 ? std::array<int, 2>{i, j} : std::array<int, 2>{j, i};
        image[i] =
          (image[i] * x + mpz_fdiv_ui(gmp_of(f.scaled_coefficient(index)), p)) % p;
      }
    const Modular_polynomial g(image);
    if (g.degree() == rows - 1 && (rows == 1 || g.is_square_free()))
      return true;
  }
  return false;
}

// Whether no factor is multiple; false also where the images do not show it.
inline bool is_proved_square_free(const Bernstein_polynomial_2<Exact_integer>& f)
{
  return is_square_free_in(f, 0) && is_square_free_in(f, 1);
}

// The scaled coefficients are those of powers of u / (1 - u) and v / (1 - v), in which factors are
// those of the polynomial, but for powers of 1 - u and 1 - v. \pre f has no such factor
inline Bernstein_polynomial_2<Exact_integer> square_free_part(
  const Bernstein_polynomial_2<Exact_integer>& f)
{
  using Polynomial_1 = CGAL::Polynomial<Exact_integer>;
  using Polynomial_2 = CGAL::Polynomial<Polynomial_1>;
  const auto& c = f.scaled_coefficients();
  const int rows = f.degree()[0] + 1, columns = f.degree()[1] + 1;
  std::vector<Polynomial_1> in_v;
  for (int i = 0; i < rows; ++i)
    in_v.emplace_back(c.begin() + i * columns, c.begin() + (i + 1) * columns);
  std::vector<std::pair<Polynomial_2, int>> factors;
  CGAL::square_free_factorize_up_to_constant_factor(Polynomial_2(in_v.begin(), in_v.end()),
                                                    std::back_inserter(factors));
  Polynomial_2 product(Polynomial_1(1));
  for (const auto& factor : factors)
    product *= factor.first;
  int degree_v = 0;
  for (int i = 0; i <= product.degree(); ++i)
    degree_v = (std::max)(degree_v, product[i].degree());
  std::vector<Exact_integer> scaled;
  for (int i = 0; i <= product.degree(); ++i)
    for (int j = 0; j <= degree_v; ++j)
      scaled.push_back(j <= product[i].degree() ? product[i][j] : Exact_integer(0));
  return Bernstein_polynomial_2<Exact_integer>::from_scaled_coefficients(
    {product.degree(), degree_v}, std::move(scaled));
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONTOURS_INTERNAL_SQUARE_FREE_PART_H
