// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The Hessian of the oriented distance from three normal curvatures: Hartmann's case formulas
// divide by products of components of the normal, the projector form does not. In exact types they
// agree; in double the case formulas lose all digits near a vanishing component.

#include <CGAL/Shape_interrogation/Analysis/hessian_by_cases.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>

#include <cmath>
#include <cstdio>

using namespace CGAL::Shape_interrogation;
using Exact = CGAL::Exact_rational;

template <class NT>
Local_shape_3<NT> make_shape(const Coordinates<NT, 3>& h)
{
  return Local_shape_3<NT>::from_form({0, 0, 0}, h, {2, 1, -3, 5, 1, -1});
}

// The largest deviation of an entry from the exact matrix.
double error(const Symmetric_matrix_3<double>& m, const Symmetric_matrix_3<Exact>& truth)
{
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
    {
      const Exact difference = Exact(m(i, j)) - truth(i, j);
      largest = std::max(largest, std::fabs(number_cast<double>(difference)));
    }
  return largest;
}

int main()
{
  bool agree = true;
  std::printf("h_z      pattern   case formulas   projector form\n");
  for (int k = 0; k <= 60; k += 10)
  {
    // A rational unit normal with h_z near 2^-k.
    const Exact t = std::ldexp(0.5, -k), d = 1 + t * t, c = (1 - t * t) / d;
    const Coordinates<Exact, 3> h{Exact(3 * c / 5), Exact(4 * c / 5), Exact(2 * t / d)};
    const Local_shape_3<Exact> shape = make_shape(h);
    const Symmetric_matrix_3<Exact> truth = shape.shape_matrix();
    const Normal_pattern pattern = normal_pattern(h);
    std::array<Exact, 3> kappa;
    for (int i = 0; i < 3; ++i)
      kappa[i] = normal_curvature(shape, case_directions(h, pattern)[i]);
    const auto exact = hessian_by_cases(h, pattern, kappa);
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        agree = agree && exact(i, j) == truth(i, j);

    // The same in double: the rounded normal and the rounded curvatures.
    const auto h_double = cast_argument<double>(h);
    const auto cases = hessian_by_cases(h_double, pattern, cast_argument<double>(kappa));
    std::printf("2^-%-5d %-9s error %.2e  error %.2e\n", k, to_string(pattern),
                error(cases, truth), error(make_shape(h_double).shape_matrix(), truth));
  }
  std::puts(agree ? "in the rationals both agree exactly" : "the exact matrices differ");
  return agree ? EXIT_SUCCESS : EXIT_FAILURE;
}
