// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_PATCH_PROPERTIES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_PATCH_PROPERTIES_H

// The properties of the vertices of a mesh of patches, each computed from a patch at its
// parameters.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_shape.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_store.h>
#include <CGAL/Shape_interrogation/Meshing/internal/limit_normal.h>
#include <CGAL/Shape_interrogation/Meshing/internal/set_shape.h>

#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// A point of a patch, in dyadic parameters.
struct Patch_place
{
  int patch;
  std::int32_t u, v;
};

// One patch in the number types of the evaluation.
class Patch_evaluator
{
public:
  Patch_evaluator(const Bezier_surface_3<Exact_rational>& patch, bool is_flipped)
    : m_exact(patch), m_enclosure(enclose(patch)), m_is_flipped(is_flipped)
  {}

  Result<Vertex_shape> operator()(double u, double v) const
  {
    using Interval = Interval_nt<false>;
    const Result<Vertex_shape> shape = vertex_shape(
      [&] { return m_enclosure({Interval(u), Interval(v)}); },
      [&] { return m_exact({Exact_rational(u), Exact_rational(v)}); });
    return shape && m_is_flipped ? Result<Vertex_shape>(opposite(*shape)) : shape;
  }

  // The point and a bound of its distance from that of the patch.
  Result<Double_point> point(double u, double v, double& distance) const
  {
    const Result<Double_point> enclosed = enclosed_point(u, v, distance);
    if (enclosed && distance <= 1e-15 * (std::fabs((*enclosed)[0]) + std::fabs((*enclosed)[1]) +
                                         std::fabs((*enclosed)[2])))
      return enclosed;
    const auto exact = m_exact.point({Exact_rational(u), Exact_rational(v)});
    if (!exact)
      return exact.refusal();
    Vertex_store rounded;
    rounded.add(*exact);
    distance = rounded.max_distance();
    return rounded[0];
  }

private:
  Result<Double_point> enclosed_point(double u, double v, double& distance) const
  {
    using Interval = Interval_nt<false>;
    const Interval::Protector protector;
    const auto p = m_enclosure.point({Interval(u), Interval(v)});
    if (!p)
      return p.refusal();
    Interval squares(0);
    Double_point middle;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = ((*p)[k].inf() + (*p)[k].sup()) / 2;
      squares += CGAL::square((*p)[k] - Interval(middle[k]));
    }
    distance = CGAL::sqrt(squares).sup();
    return middle;
  }

  static Bezier_surface_3<Interval_nt<false>> enclose(const Bezier_surface_3<Exact_rational>& patch)
  {
    const Interval_nt<false>::Protector protector;
    return patch.cast<Interval_nt<false>>();
  }

  const Bezier_surface_3<Exact_rational>& m_exact;
  const Bezier_surface_3<Interval_nt<false>> m_enclosure;
  const bool m_is_flipped;
};

// Limits of the normal at vertices where edges of patches are collapsed: none where two patches
// disagree or one has no limit.
using Limit_normals = std::map<std::size_t, std::optional<Exact_vector>>;

inline void add_limit_normal(Limit_normals& limits, std::size_t vertex,
                             std::optional<Exact_vector> n, bool is_flipped)
{
  for (int k = 0; k < 3 && n && is_flipped; ++k)
    (*n)[k] = -(*n)[k];
  const auto added = limits.emplace(vertex, n);
  std::optional<Exact_vector>& known = added.first->second;
  if (!added.second && known && !(n && is_same_direction(*known, *n)))
    known.reset();
}

// Fills the properties of one vertex from the first of its places that is regular. Returns the
// refusal of the first place if none is.
inline std::optional<Refused_place> fill_vertex(Shape_property_maps& maps,
                                                Patch_property_maps& where,
                                                Shape_property_maps::Vertex v,
                                                const Shape_mesh::Point_3& point,
                                                const std::vector<Patch_evaluator>& patches,
                                                const std::vector<Patch_place>& places)
{
  std::optional<Refused_place> refused;
  for (const Patch_place& place : places)
  {
    const double u = parameter_value(place.u), t = parameter_value(place.v);
    const Result<Vertex_shape> shape = patches[place.patch](u, t);
    if (shape || !refused)
    {
      where.vertex_patch[v] = place.patch;
      where.parameter[v] = Shape_mesh::Point_2(u, t);
    }
    if (shape)
    {
      set_shape(maps, v, *shape);
      return std::nullopt;
    }
    if (!refused)
      refused = Refused_place{v.idx(), place.patch, {u, t}, {point.x(), point.y(), point.z()},
                              shape.refusal().code(), shape.refusal().evidence()};
  }
  return refused;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_FILL_PATCH_PROPERTIES_H
