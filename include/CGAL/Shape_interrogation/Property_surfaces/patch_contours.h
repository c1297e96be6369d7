// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_CONTOURS_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_CONTOURS_H

// Contours on patches: where a property has a value, and plane sections (Elber and Cohen, equation
// 4), with certified topology.

#include <CGAL/Shape_interrogation/Contours/contour.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// Keeps the parts on which the polynomial has the given sign. \pre it has no zero on them
inline void keep_sign(Contour_2& contour, const Bernstein_polynomial_2<Exact_rational>& f,
                      CGAL::Sign sign)
{
  const Exact_function exact(in_integers(f));
  const auto has_other_sign = [&](const std::array<double, 2>& p) {
    return exact.sign_at(p[0], p[1]) != sign;
  };
  contour.curves.erase(std::remove_if(contour.curves.begin(), contour.curves.end(),
                                      [&](const Contour_curve_2& c) {
                                        return has_other_sign(c.points[c.points.size() / 2]);
                                      }),
                       contour.curves.end());
  if (contour.is_everything)
    contour.is_everything = !has_other_sign({0.5, 0.5});
  contour.edges.erase(std::remove_if(contour.edges.begin(), contour.edges.end(),
                                     [&](const Contour_edge_2& e) {
                                       std::array<double, 2> middle{0.5, 0.5};
                                       middle[e.axis] = e.end;
                                       return has_other_sign(middle);
                                     }),
                      contour.edges.end());
  contour.isolated_points.erase(std::remove_if(contour.isolated_points.begin(),
                                               contour.isolated_points.end(), has_other_sign),
                                contour.isolated_points.end());
}

// The zero set of p / q without edges on which both vanish.
template <class Progress>
Result<Contour_2> contour_of_quotient(const Bernstein_polynomial_2<Exact_rational>& p,
                                      const Bernstein_polynomial_2<Exact_rational>& q,
                                      const Contour_options& options, Progress& progress)
{
  if (q.is_zero())
    return Refusal(Refusal_code::IRREGULAR_PARAMETRISATION,
                   "the denominator of the property vanishes everywhere");
  std::vector<Integer_polynomial_2> parts{in_integers(p), in_integers(q)};
  std::vector<Contour_edge_2> common;
  divide_by_common_edges(parts, common);
  return contour(parts.front(), options, progress);
}

// Whether the zeros of the property are those of its sign, without squares and without the poles.
inline bool has_sign_of_lower_degree(Property property)
{
  return property == Property::GAUSSIAN || property == Property::MEAN_SQUARED ||
         property == Property::CURVATURE_U || property == Property::CURVATURE_V;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief computes where a property of a patch has the value `level`, in the unit square.
 *
 * Edges on which numerator and denominator both vanish, such as collapsed ones, do not count.
 * For `Property::ISOPHOTE` the level is the one in `inputs`, and only the part counts where the
 * cosine has its sign, which no curve of the zero set changes.
 *
 * \return the zero set of \f$ p - level \cdot q \f$ , see `contour()`. Refused are
 * `Property::SPEED_SUPREMUM`, which is a root (`NOT_ALGEBRAIC`), a property that has no value
 * anywhere (`IRREGULAR_PARAMETRISATION`), and what the callback stops (`CANCELLED`).
 */
template <class Progress = No_progress>
Result<Contour_2> property_contour(const Surface_piece_3<Exact_rational>& piece, Property property,
                                   const Exact_rational& level = 0,
                                   const Property_inputs<Exact_rational>& inputs = {},
                                   const Contour_options& options = {},
                                   Progress progress = Progress())
{
  using Polynomial = Bernstein_polynomial_2<Exact_rational>;
  Property_surface_maker<Exact_rational> properties(piece);
  if (CGAL::is_zero(level) && internal::has_sign_of_lower_degree(property))
    return internal::contour_of_quotient(properties.sign(property, inputs),
                                         properties.normal_squared(), options, progress);
  const Property_surface<Exact_rational> p = properties(property, inputs);
  if (p.radicand())
    return Refusal(Refusal_code::NOT_ALGEBRAIC,
                   std::string(to_string(property)) + " is a root and has no contours");
  const Result<Contour_2> zeros = internal::contour_of_quotient(
    p.numerator() - Polynomial(level) * p.denominator(), p.denominator(), options, progress);
  if (!zeros || property != Property::ISOPHOTE || CGAL::is_zero(inputs.level))
    return zeros;
  Contour_2 part = *zeros;
  internal::keep_sign(part, properties.sign(property, inputs), CGAL::sign(inputs.level));
  return part;
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief computes the section of a patch with the plane \f$ a x + b y + c z + d = 0 \f$, in the
 * unit square, see `contour()`.
 */
template <class Progress = No_progress>
Result<Contour_2> plane_section(const Bezier_surface_3<Exact_rational>& patch,
                                const Coordinates<Exact_rational, 4>& plane,
                                const Contour_options& options = {},
                                Progress progress = Progress())
{
  std::vector<Exact_rational> values;
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
    {
      const Coordinates<Exact_rational, 4> x = patch.homogeneous_control_point(i, j);
      values.push_back(plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] + plane[3] * x[3]);
    }
  return contour(Bernstein_polynomial_2<Exact_rational>::from_coefficients(
                   {patch.degree_u(), patch.degree_v()}, std::move(values)),
                 options, progress);
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns the points of a patch over the points of a contour, in floating point.
 *
 * Points at which the patch has a pole are left out.
 */
inline std::vector<Coordinates<double, 3>> lifted(const std::vector<std::array<double, 2>>& points,
                                                  const Bezier_surface_3<double>& patch)
{
  std::vector<Coordinates<double, 3>> on_patch;
  for (const std::array<double, 2>& p : points)
    if (const auto x = patch.point(p))
      on_patch.push_back(*x);
  return on_patch;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PATCH_CONTOURS_H
