// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_MAGNITUDES_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_MAGNITUDES_H

// The sums of a tensor product with a running magnitude, bounded as a whole: the values are those
// of double, and a sum of b_i c_j p_ij is bounded by (sum of |b_i|)(sum of |c_j|) max |p_ij|.
// Then many roundings of a large bound are exchanged for more of a small one, see below.

#include <CGAL/Shape_interrogation/Number_types/internal/Magnitude.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Tensor_derivatives.h>

#include <algorithm>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A net of magnitudes read as one of doubles.
struct Values_of_magnitudes
{
  const Magnitude* first;
  double operator[](int i) const { return first[i].value(); }
  Values_of_magnitudes operator+(int i) const { return {first + i}; }
};

// The values of the basis functions; for each order a bound on the sum of their absolute values;
// and a number of roundings that no function exceeds.
template <int Degree>
struct Basis_magnitudes
{
  Basis_values<double, Degree> values;
  std::array<double, 3> bound;
  int roundings;
};

template <int Degree>
Basis_magnitudes<Degree> with_bounds(const Basis_values<Magnitude, Degree>& b)
{
  Basis_magnitudes<Degree> m{Basis_values<double, Degree>(b.degree()), {0, 0, 0}, 0};
  for (int order = 0; order < 3; ++order)
    for (int i = 0; i <= b.degree(); ++i)
    {
      m.values(order, i) = b(order, i).value();
      m.bound[order] += b(order, i).bound();
      m.roundings = (std::max)(m.roundings, b(order, i).roundings());
    }
  return m;
}

// Numbers in general need no more than the basis itself.
template <class NT, int Degree>
const Basis_values<NT, Degree>& with_bounds(const Basis_values<NT, Degree>& b) { return b; }

template <int Degree, class NT>
Basis_values<NT, Degree> bernstein_with_bounds(int degree, const NT& t)
{
  return bernstein_basis<Degree>(degree, t);
}

// The sums of the absolute values are at most a^n, 2 n a^(n-1) and 4 n (n-1) a^(n-2), where a is
// |1 - t| + |t|. Each step of the recursion rounds 1 - t, a product and a sum.
template <int Degree>
Basis_magnitudes<Degree> bernstein_with_bounds(int degree, const Magnitude& t)
{
  Basis_magnitudes<Degree> m{bernstein_basis<Degree>(degree, t.value()), {1, 2, 4}, 0};
  const int n = m.values.degree();
  const double a = (Magnitude(1) - t).bound() + t.bound();
  m.bound[1] *= n;
  m.bound[2] *= n * (n - 1);
  for (int r = 1; r <= n; ++r)
    for (int order = 0; order < 3 && order <= n - r; ++order)
      m.bound[order] *= a;
  m.roundings = n * (t.roundings() + 4) + 8;
  return m;
}

// The values, and bounds that belong to `roundings` roundings: k u m = K u (m k / K), and a larger
// K gives bounds m that are nearer to the values, so that their products stay small.
template <int Dim>
struct Tensor_magnitudes
{
  static constexpr int roundings = 4096;
  Tensor_derivatives<double, Dim> value, bound;
};

// The largest bound on one coordinate of the net, in units for Tensor_magnitudes.
template <int Dim>
double net_bound(const Magnitude* net, int rows, int columns, int stride, int basis_roundings)
{
  double bound = 0;
  int roundings = 0;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
    {
      const Magnitude& p = net[i * stride + j * Dim];
      bound = (std::max)(bound, p.bound());
      roundings = (std::max)(roundings, p.roundings());
    }
  // The last term: two products and the additions, for the bounds as well.
  return bound * ((roundings + basis_roundings + 2 * (rows + columns) + 2) /
                  double(Tensor_magnitudes<Dim>::roundings));
}

template <int Dim, int DegreeU, int DegreeV>
Tensor_magnitudes<Dim> tensor_derivatives(const Magnitude* net, int stride,
                                          const Basis_magnitudes<DegreeU>& bu,
                                          const Basis_magnitudes<DegreeV>& bv)
{
  Tensor_magnitudes<Dim> t;
  t.value = tensor_derivatives<Dim>(Values_of_magnitudes{net}, stride, bu.values, bv.values);
  for (int d = 0; d < Dim; ++d)
  {
    const double bound = net_bound<Dim>(net + d, bu.values.degree() + 1, bv.values.degree() + 1,
                                        stride, bu.roundings + bv.roundings);
    const double b0 = bound * bu.bound[0], b1 = bound * bu.bound[1], b2 = bound * bu.bound[2];
    t.bound.s[d] = b0 * bv.bound[0];
    t.bound.u[d] = b1 * bv.bound[0];
    t.bound.v[d] = b0 * bv.bound[1];
    t.bound.uu[d] = b2 * bv.bound[0];
    t.bound.uv[d] = b1 * bv.bound[1];
    t.bound.vv[d] = b0 * bv.bound[2];
  }
  return t;
}

template <std::size_t Dim>
[[gnu::always_inline]] inline std::array<Magnitude, Dim>
magnitudes(const std::array<double, Dim>& value, const std::array<double, Dim>& bound)
{
  std::array<Magnitude, Dim> m;
  for (std::size_t d = 0; d < Dim; ++d)
    m[d] = Magnitude::bounded(value[d], bound[d], Tensor_magnitudes<Dim>::roundings);
  return m;
}

// The sums as numbers. Made where they are used, so that the compiler knows the count and folds all
// that follow.
template <class NT, int Dim>
const Tensor_derivatives<NT, Dim>& as_numbers(const Tensor_derivatives<NT, Dim>& t) { return t; }

template <int Dim>
[[gnu::always_inline]] inline Tensor_derivatives<Magnitude, Dim>
as_numbers(const Tensor_magnitudes<Dim>& t)
{
  return {magnitudes(t.value.s, t.bound.s),   magnitudes(t.value.u, t.bound.u),
          magnitudes(t.value.v, t.bound.v),   magnitudes(t.value.uu, t.bound.uu),
          magnitudes(t.value.uv, t.bound.uv), magnitudes(t.value.vv, t.bound.vv)};
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_TENSOR_MAGNITUDES_H
