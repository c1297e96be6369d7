// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_RANDOM_RATIONALS_H
#define SHAPE_INTERROGATION_TEST_RANDOM_RATIONALS_H

// Reproducible random numbers, vectors and rotations with exact rational entries.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>

namespace testing_shapes {

using CGAL::Shape_interrogation::Coordinates;
using CGAL::Shape_interrogation::Symmetric_matrix_3;
using Q = CGAL::Exact_rational;

// Numbers from a fixed seed, which a test that fails prints.
class Random
{
public:
  explicit Random(unsigned seed)
    : m_trace(__FILE__, __LINE__, "seed " + std::to_string(seed)), m_engine(seed)
  {}

  // Evenly in [low, high]. (The standard's distributions differ between libraries.)
  int integer(int low, int high)
  {
    const long long size = static_cast<long long>(high) - low + 1;
    return static_cast<int>(low + static_cast<long long>(m_engine() % size));
  }

  // A fraction with its numerator in [low, high] and its denominator in [1, denominators].
  Q fraction(int low, int high, int denominators)
  {
    const int numerator = integer(low, high); // drawn first, whatever the compiler
    Q x = Q(numerator) / Q(integer(1, denominators));
    return x;
  }

  // A fraction with small numerator and denominator.
  Q rational(int size = 9) { return fraction(-size, size, size); }

  // Strictly between 0 and 1.
  Q in_unit_interval()
  {
    Q x = Q(integer(1, 96)) / Q(97);
    return x;
  }

  Q nonzero_rational(int size = 9)
  {
    Q x = rational(size);
    while (CGAL::is_zero(x))
      x = rational(size);
    return x;
  }

  Coordinates<Q, 3> vector() { return {rational(), rational(), rational()}; }

  Coordinates<Q, 3> nonzero_vector()
  {
    return {rational(), rational(), nonzero_rational()};
  }

  Symmetric_matrix_3<Q> matrix()
  {
    return {rational(), rational(), rational(), rational(), rational(), rational()};
  }

  // A double with all its 53 bits.
  double real(double low, double high)
  {
    const double fine = static_cast<double>(m_engine() >> 11) / 2097152.0;
    return low + (high - low) * ((static_cast<double>(m_engine()) + fine) / 4294967296.0);
  }

private:
  testing::ScopedTrace m_trace;
  std::mt19937 m_engine;
};

using Rotation = std::array<Coordinates<Q, 3>, 3>; // rows

// The rotation of a quaternion with integer components, which is rational.
inline Rotation random_rotation(Random& random)
{
  const Q a = random.integer(1, 5), b = random.integer(-5, 5), c = random.integer(-5, 5),
          d = random.integer(-5, 5);
  const Q n = a * a + b * b + c * c + d * d;
  return {Coordinates<Q, 3>{Q((a * a + b * b - c * c - d * d) / n), Q(2 * (b * c - a * d) / n),
                            Q(2 * (b * d + a * c) / n)},
          Coordinates<Q, 3>{Q(2 * (b * c + a * d) / n), Q((a * a - b * b + c * c - d * d) / n),
                            Q(2 * (c * d - a * b) / n)},
          Coordinates<Q, 3>{Q(2 * (b * d - a * c) / n), Q(2 * (c * d + a * b) / n),
                            Q((a * a - b * b - c * c + d * d) / n)}};
}

} // namespace testing_shapes

#endif // SHAPE_INTERROGATION_TEST_RANDOM_RATIONALS_H
