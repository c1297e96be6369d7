// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_SYSTEM_SHAPES_H
#define INTERROGATE_SYSTEM_SHAPES_H

// Systems in n-space: the primitive normal of the report, bounds, directions in n-space, and what
// constructions say in words.

#include "surface_shapes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace interrogate {

// The positive number that makes the vector primitive. For a rational vector: integers without a
// common factor. With a root the first component that is not zero is made rational before.
inline Quadratic primitive_factor(const Vector_3<Quadratic>& n)
{
  using Traits = CGAL::Fraction_traits<Rational>;
  using Integer = Traits::Numerator_type;
  Quadratic first(0);
  for (int i = 2; i >= 0; --i)
    if (n[i] != Quadratic(0))
      first = n[i];
  if (first < Quadratic(0))
    first = -first;
  Integer denominators(1), numerators(0);
  const auto add = [&](const Rational& x) {
    Integer numerator, denominator;
    Traits::Decompose()(x, numerator, denominator);
    numerators = CGAL::gcd(numerators, numerator);
    denominators = CGAL::integral_division(Integer(denominators * denominator),
                                           CGAL::gcd(denominators, denominator));
  };
  for (const Quadratic& component : n)
  {
    const Quadratic x = component / first;
    add(x.rational_part());
    add(x.root_coefficient());
  }
  return Quadratic(Traits::Compose()(denominators, numerators)) / first;
}

template <class NT>
si::Local_shape_3<NT> with_primitive_normal(const si::Local_shape_3<NT>& s) { return s; }

inline si::Local_shape_3<Quadratic> with_primitive_normal(const si::Local_shape_3<Quadratic>& s)
{
  return s.scaled_normal(primitive_factor(s.normal()));
}

// Refuses a direction of n-space in which some equation certainly changes to first order; floating
// point makes no such claim.
template <class NT>
std::optional<si::Refusal> refuse_not_tangent(const si::N_space_surface_3& surface,
                                              const std::vector<NT>& at,
                                              const std::vector<NT>& direction)
{
  const si::Expression_tape& equations = surface.system().tape();
  const si::Sparse_pattern& pattern = equations.gradient_pattern();
  const std::vector<NT> gradient = equations.gradient(at);
  for (int k = 0; k < equations.number_of_outputs(); ++k)
  {
    NT change(0);
    for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
      change += gradient[e] * direction[pattern.columns[e]];
    using Traits = si::Number_type_traits<NT>;
    if ((Traits::is_exact || Traits::is_enclosure) &&
        CGAL::certainly(!si::is_zero_decision(change)))
      return si::Refusal(si::Refusal_code::NOT_TANGENT,
                         "equation " + std::to_string(k + 1) + " changes in the direction");
  }
  return std::nullopt;
}

// An orientation that is tangent orients nothing.
template <class NT>
std::optional<si::Refusal> refuse_orientation(const si::N_space_surface_3& surface,
                                              const Vector_3<NT>& normal)
{
  if (!surface.system().orientation())
    return std::nullopt;
  const Vector_3<NT> d = si::cast_argument<NT>(*surface.system().orientation());
  const NT product = normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2];
  const auto is_zero = si::is_zero_decision(product);
  if (CGAL::certainly(is_zero))
    return si::Refusal(si::Refusal_code::AMBIGUOUS,
                       "\"orient\" is a tangent vector there and chooses no side");
  if (CGAL::possibly(is_zero))
    return si::Refusal(si::Refusal_code::UNDECIDED,
                       "it is undecided which side \"orient\" chooses");
  return std::nullopt;
}

// A point that is no solution of a construction is told in its words.
template <class NT>
si::Refusal in_words(const si::Refusal& refusal, const System_model& model,
                     const std::vector<NT>& at)
{
  if (refusal.code() != si::Refusal_code::NOT_ON_SOLUTION || !model.constraints)
    return refusal;
  std::string sentences;
  for (const si::Violation<NT>& violation : model.constraints->violated(at))
    sentences += violation.sentence + "; ";
  return si::Refusal(refusal.code(), sentences + refusal.evidence());
}

template <class NT>
si::Result<Shapes<NT>> system_shapes(const System_model& model,
                                     const std::optional<std::array<Rational, 3>>& orient,
                                     const std::vector<NT>& at, const std::vector<NT>& direction)
{
  if (auto refusal = si::refuse_outside_bounds(at, model.bounds, model.variables))
    return *refusal;
  const si::N_space_surface_3 surface = make_surface(model, orient);
  const si::Result<si::Local_shape_3<NT>> shape = surface(at);
  if (!shape)
    return in_words(shape.refusal(), model, at);
  if (auto refusal = refuse_orientation(surface, shape->normal()))
    return *refusal;
  if (direction.size() > 3 && direction.size() == at.size())
    if (auto refusal = refuse_not_tangent(surface, at, direction))
      return *refusal;
  return Shapes<NT>{{{}, with_primitive_normal(*shape)}};
}

} // namespace interrogate

#endif // INTERROGATE_SYSTEM_SHAPES_H
