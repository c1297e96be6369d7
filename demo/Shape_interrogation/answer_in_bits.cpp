// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Points of systems that are proved, and answers about them in as many bits as it takes.

#include "answer.h"
#include "describe_enclosure.h"

#include <CGAL/Shape_interrogation/Surfaces/N_space_refinement.h>

#include <CGAL/Shape_interrogation/Constraints/prove_by_identities.h>

#include <algorithm>

namespace interrogate {

namespace {

std::pair<double, double> ends(const Scalar& s)
{
  return s.interval ? *s.interval : std::make_pair(*s.approx, *s.approx);
}

Scalar united(const Scalar& a, const Scalar& b)
{
  const auto x = ends(a), y = ends(b);
  if (x == y)
    return a;
  Scalar hull;
  hull.interval = {(std::min)(x.first, y.first), (std::max)(x.second, y.second)};
  approximate(hull);
  return hull;
}

template <std::size_t n>
std::array<Scalar, n> united(const std::array<Scalar, n>& a, const std::array<Scalar, n>& b)
{
  std::array<Scalar, n> hull;
  for (std::size_t i = 0; i < n; ++i)
    hull[i] = united(a[i], b[i]);
  return hull;
}

// Decisions are kept where both are the same.
Signed_scalar united(const Signed_scalar& a, const Signed_scalar& b)
{
  return {united(a.value, b.value), a.sign == b.sign ? a.sign : std::nullopt, a.squared};
}

// Calls f for every value of the answer.
template <class F>
void for_each_scalar(Surface_answer& a, F f)
{
  const auto each = [&](auto& values) { std::for_each(values.begin(), values.end(), f); };
  each(*a.point);
  each(a.normal);
  f(a.normal_squared_length);
  f(a.gaussian_curvature.value);
  for (Signed_scalar* s : {&a.mean_curvature, a.normal_curvature ? &*a.normal_curvature : nullptr})
    if (s)
    {
      f(s->value);
      f(*s->squared);
    }
  each(a.principal_curvatures);
  if (a.principal_directions)
    for (auto& direction : *a.principal_directions)
      each(direction);
  for (auto& row : a.shape_operator)
    each(row);
}

bool is_decided(const Surface_answer& a)
{
  return a.gaussian_curvature.sign && a.mean_curvature.sign && a.umbilic && a.planar &&
         (!a.normal_curvature || a.normal_curvature->sign);
}

bool is_sharp_and_decided(Surface_answer& a)
{
  bool sharp = is_decided(a);
  for_each_scalar(a, [&](const Scalar& s) { sharp = sharp && is_sharp(s); });
  return sharp;
}

} // namespace

Surface_answer united(const Surface_answer& a, const Surface_answer& b)
{
  Surface_answer u = a;
  u.normal = united(a.normal, b.normal);
  u.mean_curvature = united(a.mean_curvature, b.mean_curvature);
  u.principal_curvatures = united(a.principal_curvatures, b.principal_curvatures);
  u.principal_directions.reset(); // the two of them are exchanged on the other side
  for (int i = 0; i < 3; ++i)
    u.shape_operator[i] = united(a.shape_operator[i], b.shape_operator[i]);
  if (a.normal_curvature)
    u.normal_curvature = united(*a.normal_curvature, *b.normal_curvature);
  return u;
}

si::Result<Enclosed_place> enclose_place(const Surface_model& surface, const Curvature_task& task)
{
  Enclosed_place place;
  const auto* system = std::get_if<System_model>(&surface.data);
  if (system)
  {
    place.surface = make_surface(*system, surface.orient);
    place.bounds = system->bounds;
  }
  else
  {
    const auto& implicit = std::get<Implicit_model>(surface.data);
    place.surface =
      si::N_space_surface_3(si::N_space_system(implicit.variables, {implicit.f}));
    place.implicit = make_surface(implicit);
  }
  place.flip = surface.flip;
  const auto enclosure =
    si::enclose_solution(place.surface->system(), evaluate<double>(task.at));
  if (!enclosure)
    return enclosure.refusal();
  const bool has_identities = system && system->constraints;
  place.enclosure =
    has_identities ? si::prove_by_identities(*system->constraints, *enclosure) : *enclosure;
  return place;
}

Enclosure_answer describe_enclosure(const Enclosed_place& place)
{
  Enclosure_answer a;
  for (const CGAL::Interval_nt<false>& x : place.enclosure.box)
    a.box.push_back(make_scalar(Interval(x.pair())));
  for (int i = 0; i < 2; ++i)
    a.fixed.emplace_back(place.surface->system().variables()[place.enclosure.fixed[i]],
                         make_scalar(place.enclosure.values[i]));
  for (int k : place.enclosure.equations)
    a.equations.push_back(k + 1);
  for (int k : place.enclosure.others_proved)
    a.proved.push_back(k + 1);
  for (int k : place.enclosure.others_contain_zero)
    a.others.push_back(k + 1);
  return a;
}

si::Result<std::vector<Surface_answer>> answer_in_bits(const Surface_model& surface,
                                                       const Curvature_task& task)
{
  const si::Result<Enclosed_place> place = enclose_place(surface, task);
  if (!place)
    return place.refusal();
  si::N_space_refinement refine(place->surface->system(), place->enclosure);
  const int most_bits = 1696;
  for (int bits = 106;; bits *= 2)
  {
    const si::Wide_precision precision(bits + 32);
    const auto box = refine(bits);
    if (!box)
      return box.refusal();
    const si::Result<Surface_answer> described = describe_in_box(*place, task, *box);
    Surface_answer a = described ? *described : Surface_answer();
    if (bits < most_bits && !(described && is_sharp_and_decided(a)))
      continue;
    if (!described)
      return described.refusal();
    for_each_scalar(a, [](Scalar& s) { approximate(s); });
    a.enclosure = describe_enclosure(*place);
    return std::vector<Surface_answer>{a};
  }
}

} // namespace interrogate
