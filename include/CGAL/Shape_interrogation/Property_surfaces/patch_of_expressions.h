// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_OF_EXPRESSIONS_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_OF_EXPRESSIONS_H

// A surface given by rational expressions as a Bezier patch, so that what is known of patches is
// known of it.

#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Property_surfaces/internal/Bernstein_quotient.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// The numerators over the product of the different denominators.
inline std::array<Bernstein_quotient::Polynomial, 4>
over_common_denominator(const std::vector<Bernstein_quotient>& x)
{
  using Polynomial = Bernstein_quotient::Polynomial;
  std::vector<Polynomial> different;
  for (const Bernstein_quotient& q : x)
    if (std::none_of(different.begin(), different.end(), [&](const Polynomial& p) {
          return Bernstein_quotient::are_equal(p, q.denominator());
        }))
      different.push_back(q.denominator());
  std::array<Polynomial, 4> y{x[0].numerator(), x[1].numerator(), x[2].numerator(), 1};
  for (const Polynomial& p : different)
  {
    for (int k = 0; k < 3; ++k)
      if (!Bernstein_quotient::are_equal(p, x[k].denominator()))
        y[k] = Bernstein_quotient::product(y[k], p);
    y[3] = Bernstein_quotient::product(y[3], p);
  }
  return y;
}

// The patch with the numerators and the weight y; a polynomial one if the weight is constant.
inline Bezier_surface_3<CGAL::Exact_rational>
patch_of_polynomials(const std::array<Bernstein_quotient::Polynomial, 4>& y)
{
  using Q = CGAL::Exact_rational;
  std::array<int, 2> degree{1, 1};
  for (const auto& p : y)
    for (int k = 0; k < 2; ++k)
      degree[k] = (std::max)(degree[k], p.degree()[k]);
  std::array<std::vector<Q>, 4> b;
  for (int k = 0; k < 4; ++k)
    b[k] = y[k].elevated(degree).coefficients();
  std::vector<Coordinates<Q, 4>> points;
  std::vector<Coordinates<Q, 3>> affine;
  const bool is_polynomial = y[3].scaled_coefficients().size() == 1;
  for (std::size_t i = 0; i < b[0].size(); ++i)
    if (is_polynomial)
      affine.push_back({Q(b[0][i] / b[3][i]), Q(b[1][i] / b[3][i]), Q(b[2][i] / b[3][i])});
    else
      points.push_back({b[0][i], b[1][i], b[2][i], b[3][i]});
  if (is_polynomial)
    return Bezier_surface_3<Q>(degree[0], degree[1], std::move(affine));
  return Bezier_surface_3<Q>::from_homogeneous(degree[0], degree[1], points);
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns the surface with the coordinates `x` over the rectangle `u`, `v` as a patch,
 * exactly: a polynomial one if the expressions are polynomials, else a rational one.
 *
 * Degrees are those of the expressions as they are written; nothing is cancelled.
 *
 * \param x three expressions in two variables
 * \param u the range of the first variable
 * \param v the range of the second one
 * \return one piece, as from `Nurbs_surface_3::bezier_patches()`
 *
 * Refused are functions that are not rational (`NOT_ALGEBRAIC`), divisions by zero everywhere
 * (`POLE`), and degrees above 200 (`LIMIT_EXCEEDED`). A denominator may have zeros on the
 * rectangle: there the patch has a pole.
 * \pre `u[0] < u[1]` and `v[0] < v[1]`
 */
inline Result<std::vector<Surface_piece_3<CGAL::Exact_rational>>>
patch_of_expressions(const std::vector<Expression>& x,
                     const Coordinates<CGAL::Exact_rational, 2>& u,
                     const Coordinates<CGAL::Exact_rational, 2>& v)
{
  using Q = CGAL::Exact_rational;
  using Quotient = internal::Bernstein_quotient;
  using Pieces = std::vector<Surface_piece_3<Q>>;
  CGAL_precondition_msg(x.size() == 3 && u[0] < u[1] && v[0] < v[1],
                        "a patch has three coordinates over a rectangle");
  const auto range = [](int axis, const Coordinates<Q, 2>& ends) {
    const Q length = ends[1] - ends[0];
    return Quotient(Quotient::Polynomial(ends[0]) +
                    Quotient::Polynomial::coordinate(axis) * Quotient::Polynomial(length));
  };
  return internal::refuse_errors<Pieces>([&]() -> Result<Pieces> {
    const Expression_tape tape(x, 2, Expression_tape::Derivatives::NONE);
    const auto values = tape.evaluate(std::vector<Quotient>{range(0, u), range(1, v)});
    return Pieces{{internal::patch_of_polynomials(internal::over_common_denominator(values)), u,
                   v}};
  });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_OF_EXPRESSIONS_H
