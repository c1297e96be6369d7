// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_EXACT_CHECKS_H
#define SHAPE_INTERROGATION_TEST_EXACT_CHECKS_H

// Comparison of exact local shapes, of curves and of surfaces, and of enclosures with them; the
// knots that splines are tested with.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <vector>

namespace testing_shapes {

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;

inline Q fraction(int a, int b)
{
  Q x = Q(a) / Q(b);
  return x;
}

inline std::vector<Q> rationals(const std::vector<int>& x, int denominator = 1)
{
  std::vector<Q> y;
  for (int i : x)
    y.push_back(fraction(i, denominator));
  return y;
}

// Knot vectors of all kinds: clamped, unclamped, of high multiplicity, discontinuous, of degree 1
// and of a degree that is evaluated with storage on the heap.
inline const std::vector<Knot_vector<Q>> knot_vectors{
  Knot_vector<Q>(3, rationals({0, 0, 0, 0, 1, 3, 4, 4, 4, 4}, 7)),
  Knot_vector<Q>(2, rationals({0, 0, 0, 2, 5, 5, 7, 7, 7}, 3)),
  Knot_vector<Q>(3, rationals({-5, -3, -1, 0, 2, 3, 3, 3, 4, 6, 9}, 2)),
  Knot_vector<Q>(2, rationals({0, 0, 0, 1, 1, 1, 4, 4, 4})),
  Knot_vector<Q>(1, rationals({0, 1, 2, 2, 5, 6})),
  Knot_vector<Q>(9, rationals({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2}))};

inline void expect_contains(const CGAL::Interval_nt<true>& x, const Q& exact)
{
  EXPECT_LE(Q(x.inf()), exact);
  EXPECT_GE(Q(x.sup()), exact);
}

template <class T>
void expect_refusal(Refusal_code code, const Result<T>& result)
{
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(code, result.refusal().code()) << result.refusal().evidence();
}

// The positive factor m with b = m a.
template <std::size_t n>
Q expect_same_direction(const Coordinates<Q, n>& a, const Coordinates<Q, n>& b)
{
  const Q m = internal::dot(a, b) / internal::dot(a, a);
  EXPECT_GT(m, 0);
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_EQ(b[i], Q(m * a[i]));
  return m;
}

// The same point, the same oriented normal and the same b for it: all of the second-order data.
inline void expect_same_shape(const Local_shape_2<Q>& a, const Local_shape_2<Q>& b)
{
  EXPECT_EQ(a.point(), b.point());
  const Q m = expect_same_direction(a.normal(), b.normal());
  EXPECT_EQ(b.shape_number(), Q(m * a.shape_number()));
}

// The same with B, and what follows from it.
inline void expect_same_shape(const Local_shape_3<Q>& a, const Local_shape_3<Q>& b)
{
  EXPECT_EQ(a.point(), b.point());
  const Q m = expect_same_direction(a.normal(), b.normal());
  const auto x = a.shape_matrix(), y = b.shape_matrix();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(Q(m * x(i, j)), y(i, j));
  EXPECT_EQ(gaussian_curvature(a), gaussian_curvature(b));
  EXPECT_EQ(squared_mean_curvature(a), squared_mean_curvature(b));
  EXPECT_EQ(sign_of_mean_curvature(a), sign_of_mean_curvature(b));
  EXPECT_EQ(squared_curvature_gap(a), squared_curvature_gap(b));
}

template <class T>
void expect_same_result(const Result<T>& a, const Result<T>& b)
{
  ASSERT_EQ(a.has_value(), b.has_value());
  if (a)
    expect_same_shape(*a, *b);
  else
    EXPECT_EQ(a.refusal().code(), b.refusal().code());
}

// These take shapes too.
inline void expect_same_answer(const Result<Local_shape_2<Q>>& a, const Result<Local_shape_2<Q>>& b)
{
  expect_same_result(a, b);
}

inline void expect_same_answer(const Result<Local_shape_3<Q>>& a, const Result<Local_shape_3<Q>>& b)
{
  expect_same_result(a, b);
}

} // namespace testing_shapes

#endif // SHAPE_INTERROGATION_TEST_EXACT_CHECKS_H
