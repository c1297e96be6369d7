// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_WAIST_SYMMETRIC_MATRIX_3_H
#define CGAL_SHAPE_INTERROGATION_WAIST_SYMMETRIC_MATRIX_3_H

// Three-vectors as arrays and symmetric 3x3 matrices over any ring: the few operations of the
// waist.

#include <array>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is a vector of `d` numbers; a kernel's vectors are made from it by the traits classes.
 */
template <class NT, int d>
using Coordinates = std::array<NT, d>;

/*!
 * \ingroup PkgShapeInterrogationWaist
 * \brief is a symmetric 3x3 matrix.
 * \tparam NT a ring number type
 */
template <class NT>
class Symmetric_matrix_3
{
public:
  //! constructs a matrix with unspecified entries.
  Symmetric_matrix_3() = default;

  //! constructs the matrix with the upper triangle xx, xy, xz, yy, yz, zz.
  Symmetric_matrix_3(const NT& xx, const NT& xy, const NT& xz, const NT& yy, const NT& yz,
                     const NT& zz)
    : m_entries{xx, xy, xz, yy, yz, zz}
  {}

  //! returns the entry in row `i` and column `j`.
  const NT& operator()(int i, int j) const { return m_entries[index(i, j)]; }

  //! gives access to the entry in row `i` and column `j`, and so to its mirror image.
  NT& operator()(int i, int j) { return m_entries[index(i, j)]; }

private:
  static constexpr int index(int i, int j)
  {
    return i <= j ? i * (5 - i) / 2 + j : j * (5 - j) / 2 + i;
  }

  std::array<NT, 6> m_entries;
};

namespace internal {

template <class NT>
NT dot(const Coordinates<NT, 3>& a, const Coordinates<NT, 3>& b)
{
  NT s = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return s;
}

template <class NT>
NT dot(const Coordinates<NT, 2>& a, const Coordinates<NT, 2>& b)
{
  NT s = a[0] * b[0] + a[1] * b[1];
  return s;
}

template <class NT>
Coordinates<NT, 3> cross(const Coordinates<NT, 3>& a, const Coordinates<NT, 3>& b)
{
  return {NT(a[1] * b[2] - a[2] * b[1]), NT(a[2] * b[0] - a[0] * b[2]),
          NT(a[0] * b[1] - a[1] * b[0])};
}

template <class NT>
NT determinant(const Coordinates<NT, 3>& a, const Coordinates<NT, 3>& b,
               const Coordinates<NT, 3>& c)
{
  return dot(a, cross(b, c));
}

template <class NT>
Coordinates<NT, 3> multiply(const Symmetric_matrix_3<NT>& m, const Coordinates<NT, 3>& v)
{
  return {NT(m(0, 0) * v[0] + m(0, 1) * v[1] + m(0, 2) * v[2]),
          NT(m(0, 1) * v[0] + m(1, 1) * v[1] + m(1, 2) * v[2]),
          NT(m(0, 2) * v[0] + m(1, 2) * v[1] + m(2, 2) * v[2])};
}

template <class NT>
NT trace(const Symmetric_matrix_3<NT>& m)
{
  NT t = m(0, 0) + m(1, 1) + m(2, 2);
  return t;
}

// n' adj(m) n = minus the bordered 4x4 determinant.
template <class NT>
NT bordered(const Symmetric_matrix_3<NT>& m, const Coordinates<NT, 3>& n)
{
  const NT xx = m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
  const NT yy = m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2);
  const NT zz = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
  const NT xy = m(0, 2) * m(1, 2) - m(0, 1) * m(2, 2);
  const NT xz = m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1);
  const NT yz = m(0, 1) * m(0, 2) - m(0, 0) * m(1, 2);
  const NT mixed = xy * n[0] * n[1] + xz * n[0] * n[2] + yz * n[1] * n[2];
  NT s = xx * n[0] * n[0] + yy * n[1] * n[1] + zz * n[2] * n[2] + mixed + mixed;
  return s;
}

} // namespace internal

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_WAIST_SYMMETRIC_MATRIX_3_H
