// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_PROPERTY_PIECES_H
#define INTERROGATE_PROPERTY_PIECES_H

// A property of a surface of a model: at parameters, and as functions on its patches.

#include "functions_of.h"
#include "surface_shapes.h"

#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/patch_of_expressions.h>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace interrogate {

template <class NT>
si::Property_inputs<NT> inputs_of(const Property_task& task)
{
  si::Property_inputs<NT> in;
  in.up = evaluate<NT>(task.up);
  in.view = evaluate<NT>(task.view);
  in.light = evaluate<NT>(task.light);
  in.level = evaluate<NT>(task.level);
  if (task.eye)
    in.eye = evaluate<NT>(*task.eye);
  return in;
}

// The property for the opposite normal.
template <class NT>
si::Property_surface<NT> flipped(const si::Property_surface<NT>& p)
{
  const bool is_odd = p.property() == si::Property::NORMAL_Z ||
                      p.property() == si::Property::NORMAL_TWIST ||
                      p.property() == si::Property::SILHOUETTE;
  return {p.property(), is_odd ? -p.numerator() : p.numerator(), p.denominator(), p.radicand()};
}

template <class NT>
si::Result<std::vector<si::Surface_piece_3<NT>>> patches_of(const Surface_model& surface)
{
  if (const auto* patch = std::get_if<Patch_model>(&surface.data))
  {
    if (!patch->knots[0].empty())
      return make_nurbs<NT>(*patch).bezier_patches();
    return std::vector<si::Surface_piece_3<NT>>{
      {make_bezier<NT>(*patch), {NT(0), NT(1)}, {NT(0), NT(1)}}};
  }
  if constexpr (std::is_same_v<NT, Rational>)
  {
    const auto& parametric = std::get<Parametric_model>(surface.data);
    if (!are_algebraic(parametric.x))
      return si::Refusal(si::Refusal_code::NOT_ALGEBRAIC,
                         "properties of a whole surface need rational functions");
    return si::patch_of_expressions(parametric.x, evaluate<NT>((*parametric.domain)[0]),
                                    evaluate<NT>((*parametric.domain)[1]));
  }
  else
    return si::Refusal(si::Refusal_code::NOT_ALGEBRAIC,
                       "properties of a whole surface with functions need rational numbers");
}

// Properties have up to 12 times the degree.
template <class NT>
std::optional<si::Refusal> refuse_degrees(const std::vector<si::Surface_piece_3<NT>>& patches)
{
  constexpr int highest_degree = 32, highest_product = 256;
  for (const si::Surface_piece_3<NT>& piece : patches)
  {
    const int m = piece.patch.degree_u(), n = piece.patch.degree_v();
    if (m > highest_degree || n > highest_degree || m * n > highest_product)
      return si::Refusal(si::Refusal_code::LIMIT_EXCEEDED,
                         "the degrees are " + std::to_string(m) + " and " + std::to_string(n) +
                         ": for properties of the whole surface each may be 32 at most, and"
                         " their product 256");
  }
  return std::nullopt;
}

template <class NT>
si::Result<std::vector<si::Property_surface_piece<NT>>>
property_pieces(const Surface_model& surface, const Property_task& task)
{
  const auto patches = patches_of<NT>(surface);
  if (!patches)
    return patches.refusal();
  const si::Property_inputs<NT> in = inputs_of<NT>(task);
  std::vector<si::Property_surface_piece<NT>> pieces;
  if (auto refusal = refuse_degrees(*patches))
    return *refusal;
  for (const si::Surface_piece_3<NT>& piece : *patches)
  {
    const auto p = si::Property_surface_maker<NT>(piece)(task.property, in);
    pieces.push_back({surface.flip ? flipped(p) : p, piece.u, piece.v});
  }
  return pieces;
}

// The property at one place, seen from a side of the knots.
template <class NT>
struct Sided_property
{
  std::vector<std::string> side; // left or right; empty where there is but one
  si::Property_surface<NT> property;
};

template <class NT>
using Sided_derivatives =
  std::vector<std::pair<std::vector<std::string>, si::Result<si::Surface_derivatives_3<NT>>>>;

template <class NT>
si::Result<Sided_derivatives<NT>> nurbs_derivatives(const Patch_model& model,
                                                    const std::array<NT, 2>& at)
{
  const auto nurbs = make_nurbs<NT>(model);
  const auto u = nurbs.knots_u().spans_at(at[0], "u"), v = nurbs.knots_v().spans_at(at[1], "v");
  if (!u || !v)
    return (u ? v : u).refusal();
  Sided_derivatives<NT> all;
  for (const auto& a : *u)
    for (const auto& b : *v)
    {
      std::vector<std::string> side;
      if (u->size() + v->size() > 2)
        side = {name_of(a.side), name_of(b.side)};
      all.emplace_back(side, nurbs.derivatives(at, a.side, b.side));
    }
  return all;
}

template <class NT>
si::Result<Sided_derivatives<NT>> derivatives_at(const Surface_model& surface,
                                                 const std::array<NT, 2>& at)
{
  const auto one = [](const si::Result<si::Surface_derivatives_3<NT>>& d) {
    return Sided_derivatives<NT>{{{}, d}};
  };
  if (const auto* parametric = std::get_if<Parametric_model>(&surface.data))
    return one(make_surface(*parametric).derivatives(at));
  const auto& patch = std::get<Patch_model>(surface.data);
  if (patch.knots[0].empty())
    return one(make_bezier<NT>(patch).derivatives(at));
  return nurbs_derivatives(patch, at);
}

template <class NT>
si::Result<std::vector<Sided_property<NT>>> property_at(const Surface_model& surface,
                                                        const Property_task& task)
{
  const auto derivatives = derivatives_at(surface, first<2>(evaluate<NT>(*task.at)));
  if (!derivatives)
    return derivatives.refusal();
  const si::Property_inputs<NT> in = inputs_of<NT>(task);
  std::vector<Sided_property<NT>> all;
  for (const auto& [side, d] : *derivatives)
  {
    if (!d)
      return d.refusal();
    const auto p = si::property_at(*d, task.property, in);
    all.push_back({side, surface.flip ? flipped(p) : p});
  }
  return all;
}

} // namespace interrogate

#endif // INTERROGATE_PROPERTY_PIECES_H
