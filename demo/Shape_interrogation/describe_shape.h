// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_DESCRIBE_SHAPE_H
#define INTERROGATE_DESCRIBE_SHAPE_H

// All that a report says about second-order data: one library call a field.

#include "make_scalar.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

namespace interrogate {

template <class NT, std::size_t d>
std::array<Scalar, d> make_scalars(const std::array<NT, d>& numbers)
{
  std::array<Scalar, d> scalars;
  for (std::size_t i = 0; i < d; ++i)
    scalars[i] = make_scalar(numbers[i]);
  return scalars;
}

// A value whose sign is known exactly to be zero is zero, whatever its enclosure.
template <class NT>
Signed_scalar signed_scalar(Scalar value, Sign_decision sign, std::optional<Scalar> squared)
{
  if (si::Number_type_traits<NT>::is_exact && sign == 0)
    value = Scalar{0.0, "0", {}};
  return {std::move(value), sign, std::move(squared)};
}

template <class NT>
void describe_directions(const si::Local_shape_3<NT>& s, Surface_answer& a)
{
  const auto directions = [](const auto& shape) {
    std::optional<std::array<std::array<Scalar, 3>, 2>> scalars;
    if (const auto pair = si::principal_directions(shape))
      scalars = {make_scalars((*pair)[0]), make_scalars((*pair)[1])};
    return scalars;
  };
  if (a.umbilic && !*a.umbilic)
    a.principal_directions = rooted(s, directions);
}

template <class NT>
Surface_answer describe(const si::Local_shape_3<NT>& s)
{
  Surface_answer a;
  a.point = make_scalars(s.point());
  a.normal = make_scalars(s.normal());
  a.normal_squared_length = make_scalar(s.normal_squared_length());
  a.gaussian_curvature = {make_scalar(si::gaussian_curvature(s)),
                          sign_of(si::sign_of_gaussian_curvature(s)), {}};
  a.mean_curvature = signed_scalar<NT>(
    rooted(s, [](const auto& shape) { return make_scalar(si::mean_curvature(shape)); }),
    sign_of(si::sign_of_mean_curvature(s)), make_scalar(si::squared_mean_curvature(s)));
  a.principal_curvatures = rooted(
    s, [](const auto& shape) { return make_scalars(si::principal_curvatures(shape)); });
  a.umbilic = decision_of(si::is_umbilic(s));
  a.planar = decision_of(si::is_planar(s));
  describe_directions(s, a);
  const si::Symmetric_matrix_3<NT> b = s.shape_matrix();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      a.shape_operator[i][j] = make_scalar(b(i, j));
  return a;
}

template <class NT>
Signed_scalar describe_normal_curvature(const si::Local_shape_3<NT>& s,
                                        const si::Coordinates<NT, 3>& v)
{
  const auto value = [&v](const auto& shape) {
    using To = typename std::decay_t<decltype(shape)>::FT;
    const auto w = si::cast_argument<To>(v);
    return make_scalar(si::normal_curvature(shape, w));
  };
  return signed_scalar<NT>(rooted(s, value), sign_of(si::sign_of_normal_curvature(s, v)),
                           make_scalar(si::squared_normal_curvature(s, v)));
}

template <class NT>
Curve_answer describe(const si::Local_shape_2<NT>& s)
{
  Curve_answer a;
  a.point = make_scalars(s.point());
  a.normal = make_scalars(s.normal());
  a.normal_squared_length = make_scalar(s.normal_squared_length());
  const NT b = s.shape_number();
  const NT squared = b * b / s.normal_squared_length();
  const auto value = [](const auto& shape) {
    using To = typename std::decay_t<decltype(shape)>::FT;
    const To root = si::Elementary_functions<To>::sqrt(shape.normal_squared_length());
    return make_scalar(To(shape.shape_number() / root));
  };
  a.curvature = signed_scalar<NT>(rooted(s, value), sign_of(si::sign_decision(s.numerator())),
                                  make_scalar(squared));
  const auto hessian = [](const auto& shape) {
    using To = typename std::decay_t<decltype(shape)>::FT;
    const To root = si::Elementary_functions<To>::sqrt(shape.normal_squared_length());
    std::array<To, 3> h = shape.shape_matrix();
    for (To& x : h)
      x = x / root;
    return make_scalars(h);
  };
  const std::array<Scalar, 3> h = rooted(s, hessian);
  a.hessian = {{{h[0], h[1]}, {h[1], h[2]}}};
  return a;
}

} // namespace interrogate

#endif // INTERROGATE_DESCRIBE_SHAPE_H
