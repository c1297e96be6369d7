// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_DESCRIBE_ENCLOSURE_H
#define INTERROGATE_DESCRIBE_ENCLOSURE_H

// What a report says about a point that is proved by an enclosure, and about the surface there.

#include "describe_shape.h"
#include "system_shapes.h"

#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>

#include <vector>

namespace interrogate {

struct Enclosed_place
{
  std::optional<si::N_space_surface_3> surface;
  std::vector<si::N_space_bound> bounds;
  // The same with the gradient for its normal, if it is f = 0 in space.
  std::optional<si::Implicit_surface_3<si::Expression_function<3>>> implicit;
  bool flip = false;
  si::N_space_enclosure enclosure;
};

// Proves the point near the place of the task.
si::Result<Enclosed_place> enclose_place(const Surface_model& surface, const Curvature_task& task);

Enclosure_answer describe_enclosure(const Enclosed_place& place);

// What is true on both sides of a surface of which the side is undecided.
Surface_answer united(const Surface_answer& a, const Surface_answer& b);

template <class NT>
si::Result<si::Unoriented_shape_3<NT>> shape_in_box(const Enclosed_place& place,
                                                    const std::vector<NT>& box)
{
  if (!place.implicit)
    return place.surface->unoriented(box);
  const si::Result<si::Local_shape_3<NT>> shape = (*place.implicit)(first<3>(box));
  if (!shape)
    return shape.refusal();
  return si::Unoriented_shape_3<NT>(*shape, true);
}

// All about the surface in a box that contains the point, except for the proof.
template <class NT>
si::Result<Surface_answer> describe_in_box(const Enclosed_place& place, const Curvature_task& task,
                                           const std::vector<NT>& box)
{
  if (auto refusal = si::refuse_outside_bounds(box, place.bounds,
                                               place.surface->system().variables()))
    return *refusal;
  const auto unoriented = shape_in_box(place, box);
  if (!unoriented)
    return unoriented.refusal();
  const auto shape = place.flip ? unoriented->opposite() : *unoriented;
  std::vector<NT> direction;
  if (task.direction)
    direction = evaluate<NT>(*task.direction);
  if (direction.size() > 3 && direction.size() == box.size())
    if (auto refusal = refuse_not_tangent(*place.surface, box, direction))
      return *refusal;
  if (task.direction)
    if (auto refusal = si::refuse_direction(shape.one_side(), first<3>(direction)))
      return *refusal;
  return shape.ask([&](const si::Local_shape_3<NT>& s) {
    Surface_answer a = describe(s);
    if (task.direction)
      a.normal_curvature = describe_normal_curvature(s, first<3>(direction));
    return a;
  });
}

} // namespace interrogate

namespace CGAL {
namespace Shape_interrogation {

template <>
struct Answer_union<interrogate::Surface_answer>
{
  static interrogate::Surface_answer of(const interrogate::Surface_answer& a,
                                        const interrogate::Surface_answer& b)
  {
    return interrogate::united(a, b);
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // INTERROGATE_DESCRIBE_ENCLOSURE_H
