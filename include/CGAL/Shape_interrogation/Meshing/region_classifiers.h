// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_REGION_CLASSIFIERS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_REGION_CLASSIFIERS_H

// Which region a point of the unit square belongs to, by exact signs.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/trichotomy_of_patch.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <optional>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief tells the sign of a polynomial at points of the unit square as a region: 0 where it is
 * negative, 1 where it is positive. Where it is zero the region is unresolved.
 *
 * It divides a patch, for example, where its slope is more or less than a bound, or where it is
 * seen from the front or from behind.
 */
class Sign_classifier
{
public:
  //! asks for the sign of this polynomial.
  explicit Sign_classifier(const Bernstein_polynomial_2<Exact_rational>& f)
    : m_f(internal::in_integers(f))
  {}

  //! returns the region of a point, whose coordinates are multiples of \f$ 2^{-52} \f$.
  int operator()(const std::array<double, 2>& p) const
  {
    const CGAL::Sign sign = m_f.sign_at(p[0], p[1]);
    return sign == ZERO ? unresolved_region : sign == POSITIVE ? 1 : 0;
  }

private:
  internal::Exact_function m_f;
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief tells whether a patch is convex, concave, saddle-shaped or flat at a point: the regions
 * are the values of `Region`. On the boundary between parts, and where the patch is not regular,
 * the region is unresolved.
 *
 * Source: Elber and Cohen, section 3.4.
 */
class Trichotomy_classifier
{
public:
  //! prepares the signs of the Gaussian and the mean curvature of a patch.
  explicit Trichotomy_classifier(const Bezier_surface_3<Exact_rational>& patch)
  {
    Property_surface_maker<Exact_rational> properties(patch);
    const auto gauss = properties.sign(Property::GAUSSIAN);
    const auto mean = properties.sign(Property::MEAN_SQUARED);
    m_is_developable = gauss.is_zero();
    m_is_flat = gauss.is_zero() && mean.is_zero();
    m_gauss.emplace(internal::inside_of(gauss));
    m_mean.emplace(internal::inside_of(mean));
  }

  //! returns the region of a point, whose coordinates are multiples of \f$ 2^{-52} \f$.
  int operator()(const std::array<double, 2>& p) const
  {
    if (m_is_flat)
      return static_cast<int>(Region::FLAT);
    const CGAL::Sign gauss = m_is_developable ? POSITIVE : m_gauss->sign_at(p[0], p[1]);
    if (gauss == NEGATIVE)
      return static_cast<int>(Region::SADDLE);
    const CGAL::Sign mean = gauss == ZERO ? ZERO : m_mean->sign_at(p[0], p[1]);
    if (mean == ZERO)
      return unresolved_region;
    return static_cast<int>(mean == POSITIVE ? Region::CONVEX : Region::CONCAVE);
  }

private:
  bool m_is_developable, m_is_flat;
  std::optional<internal::Exact_function> m_gauss, m_mean;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_REGION_CLASSIFIERS_H
