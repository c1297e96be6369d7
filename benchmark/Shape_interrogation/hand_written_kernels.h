// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_BENCHMARK_HAND_WRITTEN_KERNELS_H
#define SHAPE_INTERROGATION_BENCHMARK_HAND_WRITTEN_KERNELS_H

// What a careful programmer writes in double for one surface: derivatives by hand, bordered
// determinants, no generic code. The measure for the generic code.

#include <cmath>

struct Hand_written
{
  double gaussian, mean, min, max, discriminant;
};

inline Hand_written curvatures_of(double q, double trace_numerator, double minors_numerator)
{
  const double a = trace_numerator, root_q = std::sqrt(q);
  Hand_written c;
  c.discriminant = a * a - 4 * q * minors_numerator;
  c.gaussian = minors_numerator / (q * q);
  const double length = 2 * q * root_q;
  c.mean = a / length;
  const double root = std::sqrt(c.discriminant > 0 ? c.discriminant : 0.0);
  // The larger one first, the other as a quotient: no cancellation.
  const double larger = a > 0 ? a + root : a - root;
  const double smaller = larger != 0 ? 4 * q * minors_numerator / larger : 0;
  c.min = (a > 0 ? smaller : larger) / length;
  c.max = (a > 0 ? larger : smaller) / length;
  return c;
}

// (x^2 + y^2 + z^2 + 3)^2 - 16 (x^2 + y^2): the torus with radii 2 and 1.
inline Hand_written hand_written_torus(double x, double y, double z)
{
  const double s = x * x + y * y + z * z + 3;
  const double fx = 4 * x * (s - 8), fy = 4 * y * (s - 8), fz = 4 * z * s;
  const double fxx = 4 * (s - 8) + 8 * x * x, fyy = 4 * (s - 8) + 8 * y * y;
  const double fzz = 4 * s + 8 * z * z;
  const double fxy = 8 * x * y, fxz = 8 * x * z, fyz = 8 * y * z;
  const double q = fx * fx + fy * fy + fz * fz;
  const double ux = fxx * fx + fxy * fy + fxz * fz;
  const double uy = fxy * fx + fyy * fy + fyz * fz;
  const double uz = fxz * fx + fyz * fy + fzz * fz;
  const double a = q * (fxx + fyy + fzz) - (fx * ux + fy * uy + fz * uz);
  const double cxx = fyy * fzz - fyz * fyz, cyy = fxx * fzz - fxz * fxz;
  const double czz = fxx * fyy - fxy * fxy, cxy = fxz * fyz - fxy * fzz;
  const double cxz = fxy * fyz - fxz * fyy, cyz = fxy * fxz - fxx * fyz;
  const double b = cxx * fx * fx + cyy * fy * fy + czz * fz * fz +
                   2 * (cxy * fx * fy + cxz * fx * fz + cyz * fy * fz);
  return curvatures_of(q, a, b);
}

// A bicubic Bezier patch, control points [i][j][coordinate].
inline Hand_written hand_written_bicubic(const double p[4][4][3], double u, double v)
{
  double b[2][3][4]; // parameter, derivative, index
  const double t[2] = {u, v};
  for (int k = 0; k < 2; ++k)
  {
    const double x = t[k], y = 1 - x;
    b[k][0][0] = y * y * y;
    b[k][0][1] = 3 * x * y * y;
    b[k][0][2] = 3 * x * x * y;
    b[k][0][3] = x * x * x;
    b[k][1][0] = -3 * y * y;
    b[k][1][1] = 3 * y * (y - 2 * x);
    b[k][1][2] = 3 * x * (2 * y - x);
    b[k][1][3] = 3 * x * x;
    b[k][2][0] = 6 * y;
    b[k][2][1] = 6 * (x - 2 * y);
    b[k][2][2] = 6 * (y - 2 * x);
    b[k][2][3] = 6 * x;
  }
  double d[3][3][3] = {}; // derivative in u, in v, coordinate
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c)
    {
      double row[3] = {0, 0, 0};
      for (int j = 0; j < 4; ++j)
        for (int e = 0; e < 3; ++e)
          row[e] += b[1][e][j] * p[i][j][c];
      d[0][0][c] += b[0][0][i] * row[0];
      d[0][1][c] += b[0][0][i] * row[1];
      d[0][2][c] += b[0][0][i] * row[2];
      d[1][0][c] += b[0][1][i] * row[0];
      d[1][1][c] += b[0][1][i] * row[1];
      d[2][0][c] += b[0][2][i] * row[0];
    }
  const double* su = d[1][0];
  const double* sv = d[0][1];
  const double n[3] = {su[1] * sv[2] - su[2] * sv[1], su[2] * sv[0] - su[0] * sv[2],
                       su[0] * sv[1] - su[1] * sv[0]};
  double e = 0, f = 0, g = 0, l = 0, m = 0, o = 0, q = 0;
  for (int c = 0; c < 3; ++c)
  {
    e += su[c] * su[c];
    f += su[c] * sv[c];
    g += sv[c] * sv[c];
    q += n[c] * n[c];
    l -= n[c] * d[2][0][c];
    m -= n[c] * d[1][1][c];
    o -= n[c] * d[0][2][c];
  }
  return curvatures_of(q, e * o - 2 * f * m + g * l, l * o - m * m);
}

#endif // SHAPE_INTERROGATION_BENCHMARK_HAND_WRITTEN_KERNELS_H
