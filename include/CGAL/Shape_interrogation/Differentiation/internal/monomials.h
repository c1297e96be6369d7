// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MONOMIALS_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MONOMIALS_H

// The monomials of N variables up to a total degree, sorted by degree, then lexicographically,
// and the table of their products, all at compile time.

#include <array>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <int N, int Order>
struct Monomials
{
  static_assert(N >= 1, "a jet needs at least one variable");
  static_assert(Order >= 1 && Order <= 4, "jets have order 1 to 4");

  struct Product { int left, right, result; };
  using Exponents = std::array<int, N>;

  static constexpr int count()
  {
    long long c = 1;
    for (int k = 1; k <= Order; ++k)
      c = c * (N + k) / k;
    return static_cast<int>(c);
  }
  static constexpr int size = count();
  static_assert(size <= 64, "the jet has more than 64 coefficients");

  // Fills one degree in lexicographic order of the sorted variable lists (x0x0, x0x1, ...).
  static constexpr void fill(std::array<Exponents, size>& table, int& next, Exponents current,
                             int first, int left)
  {
    if (left == 0)
    {
      table[next++] = current;
      return;
    }
    for (int i = first; i < N; ++i)
    {
      Exponents e = current;
      ++e[i];
      fill(table, next, e, i, left - 1);
    }
  }
  static constexpr std::array<Exponents, size> make_table()
  {
    std::array<Exponents, size> table{};
    int next = 0;
    for (int degree = 0; degree <= Order; ++degree)
      fill(table, next, Exponents{}, 0, degree);
    return table;
  }
  static constexpr std::array<Exponents, size> table = make_table();

  static constexpr int index_of(const Exponents& e)
  {
    for (int k = 0; k < size; ++k)
    {
      bool equal = true;
      for (int i = 0; i < N; ++i)
        equal = equal && table[k][i] == e[i];
      if (equal)
        return k;
    }
    return -1;
  }
  static constexpr int index(int i, int j)
  {
    Exponents e{};
    ++e[i];
    ++e[j];
    return index_of(e);
  }

  static constexpr Exponents sum(const Exponents& a, const Exponents& b)
  {
    Exponents e{};
    for (int i = 0; i < N; ++i)
      e[i] = a[i] + b[i];
    return e;
  }
  static constexpr int number_of()
  {
    int n = 0;
    for (int a = 0; a < size; ++a)
      for (int b = 0; b < size; ++b)
        n += index_of(sum(table[a], table[b])) >= 0;
    return n;
  }
  static constexpr int number_of_products = number_of();
  static constexpr std::array<Product, number_of_products> make_products()
  {
    std::array<Product, number_of_products> p{};
    int n = 0;
    for (int a = 0; a < size; ++a)
      for (int b = 0; b < size; ++b)
      {
        const int k = index_of(sum(table[a], table[b]));
        if (k >= 0)
          p[n++] = Product{a, b, k};
      }
    return p;
  }
  static constexpr std::array<Product, number_of_products> products = make_products();
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_MONOMIALS_H
