// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_PROPERTY_FORMULAS_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_PROPERTY_FORMULAS_H

// The formulas of the properties, written once over any ring: Elber and Cohen, section 3, with
// their errata. Powers of the weight are those that the comments in Surface_forms.h give.

#include <CGAL/Shape_interrogation/Property_surfaces/Property.h>
#include <CGAL/Shape_interrogation/Property_surfaces/internal/Surface_forms.h>

#include <optional>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// (numerator + sqrt(radicand)) / denominator.
template <class R>
struct Property_terms
{
  R numerator, denominator;
  std::optional<R> radicand;
};

template <class R, class NT>
Coordinates<R, 3> in_ring(const Coordinates<NT, 3>& x)
{
  return {R(x[0]), R(x[1]), R(x[2])};
}

template <class R>
R twice(const R& x)
{
  R y = x + x;
  return y;
}


// What the direction of view or the eye gives (3).
template <class R, class NT>
R silhouette(Surface_forms<R>& s, const Property_inputs<NT>& in)
{
  if (!in.eye)
    return dot(s.normal(), in_ring<R>(in.view));
  R x = s.height() - dot(s.normal(), in_ring<R>(*in.eye));
  return x;
}

// The square of L / (|n| E) for the normal curvature along one parameter.
template <class R>
Property_terms<R> squared_normal_curvature(Surface_forms<R>& s, const R& second, const R& first)
{
  return {s.times_weight(second * second, 6), s.normal_squared() * (first * first), {}};
}

template <class R, class NT>
Property_terms<R> slope(Surface_forms<R>& s, const Property_inputs<NT>& in)
{
  const Coordinates<R, 3> up = in_ring<R>(in.up);
  const R along = dot(s.normal(), up);
  const R square = along * along;
  return {s.normal_squared() * dot(up, up) - square, square, {}};
}

template <class R, class NT>
Property_terms<R> isophote(Surface_forms<R>& s, const Property_inputs<NT>& in)
{
  const Coordinates<R, 3> light = in_ring<R>(in.light);
  const R along = dot(s.normal(), light), level(in.level);
  const R lengths = s.normal_squared() * dot(light, light);
  return {along * along - level * level * lengths, lengths, {}};
}

template <class R>
Property_terms<R> speed_supremum(Surface_forms<R>& s)
{
  const R gap = s.first_uu() - s.first_vv(), mixed = twice(s.first_uv());
  return {s.first_uu() + s.first_vv(), s.times_weight(R(2), 4), R(gap * gap + mixed * mixed)};
}

template <class R>
Property_terms<R> tangential_twist(Surface_forms<R>& s)
{
  const R normal = s.times_weight(s.second_uv() * s.second_uv(), 4);
  return {s.twist_squared() * s.normal_squared() - normal, s.times_weight(s.normal_squared(), 6),
          {}};
}

// (mean^2 - c n.n det) W^2 / (n.n)^3: for c = 2 the sum of the squared principal curvatures (EC-03
// of the errata: |k| is bounded by its root), for c = 4 the squared difference.
template <class R>
Property_terms<R> curvature_squares(Surface_forms<R>& s, int c)
{
  const R product = s.normal_squared() * s.determinant() * R(c);
  return {s.times_weight(s.mean_squared() - s.times_weight(product, 2), 2), s.normal_sixth(), {}};
}

template <class R, class NT>
Property_terms<R> property_terms(Surface_forms<R>& s, Property property,
                                 const Property_inputs<NT>& in)
{
  const auto over_weight = [&](const R& x, int k) {
    return Property_terms<R>{x, s.times_weight(R(1), k), {}};
  };
  switch (property)
  {
  case Property::NORMAL_Z: return over_weight(s.normal()[2], 3);
  case Property::NORMAL_Z_SQUARED:
    return {s.normal()[2] * s.normal()[2], s.normal_squared(), {}};
  case Property::SLOPE: return slope(s, in);
  case Property::SPEED: return over_weight(s.first_uu() + s.first_vv(), 4);
  case Property::SPEED_SUPREMUM: return speed_supremum(s);
  case Property::TWIST_SQUARED: return over_weight(s.twist_squared(), 6);
  case Property::NORMAL_TWIST: return over_weight(s.second_uv(), 4);
  case Property::TANGENTIAL_TWIST_SQUARED: return tangential_twist(s);
  case Property::SECOND_FORM_DETERMINANT: return over_weight(s.determinant(), 8);
  case Property::GAUSSIAN: return {s.times_weight(s.determinant(), 4), s.normal_fourth(), {}};
  case Property::MEAN_SQUARED:
    return {s.times_weight(s.mean_squared(), 2) * R(NT(NT(1) / NT(4))), s.normal_sixth(), {}};
  case Property::CURVATURE_BOUND: return curvature_squares(s, 2);
  case Property::UMBILIC: return curvature_squares(s, 4);
  case Property::SILHOUETTE: return over_weight(silhouette(s, in), 3);
  case Property::ISOPHOTE: return isophote(s, in);
  case Property::ASYMPTOTIC_DISCRIMINANT: return over_weight(-s.determinant(), 8);
  case Property::CURVATURE_U: return squared_normal_curvature(s, s.second_uu(), s.first_uu());
  case Property::CURVATURE_V: break;
  }
  return squared_normal_curvature(s, s.second_vv(), s.first_vv());
}

// A polynomial with the sign of the property, or of what it is the square of, in the sign of the
// package: factors that are even powers of the weight are left out.
template <class R, class NT>
R property_sign(Surface_forms<R>& s, Property property, const Property_inputs<NT>& in)
{
  switch (property)
  {
  case Property::NORMAL_Z:
  case Property::NORMAL_Z_SQUARED: return s.times_weight(s.normal()[2], 1);
  case Property::SLOPE: return s.times_weight(dot(s.normal(), in_ring<R>(in.up)), 1);
  case Property::ISOPHOTE: return s.times_weight(dot(s.normal(), in_ring<R>(in.light)), 1);
  case Property::SILHOUETTE: return s.times_weight(silhouette(s, in), 1);
  case Property::NORMAL_TWIST: return s.second_uv();
  case Property::GAUSSIAN:
  case Property::SECOND_FORM_DETERMINANT: return s.determinant();
  case Property::ASYMPTOTIC_DISCRIMINANT: return -s.determinant();
  case Property::MEAN_SQUARED: return -s.mean();
  case Property::CURVATURE_U: return -s.second_uu();
  case Property::CURVATURE_V: return -s.second_vv();
  default: return property_terms(s, property, in).numerator;
  }
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_INTERNAL_PROPERTY_FORMULAS_H
