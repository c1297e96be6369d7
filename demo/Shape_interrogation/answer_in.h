// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_ANSWER_IN_H
#define INTERROGATE_ANSWER_IN_H

// The definitions of answer.h, which each number type instantiates in a file of its own.

#include "answer.h"
#include "curve_shapes.h"
#include "describe_enclosure.h"
#include "describe_shape.h"
#include "exact_cost.h"
#include "surface_shapes.h"
#include "system_shapes.h"

#include <CGAL/Shape_interrogation/Analysis/hessian_by_cases.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>

namespace interrogate {

// Runs an evaluation; what its number type throws becomes a refusal.
template <class T, class Evaluation>
si::Result<T> refusing(Evaluation evaluation)
{
  using Code = si::Refusal_code;
  try
  {
    return evaluation();
  }
  catch (const si::Not_algebraic_error& e) { return si::Refusal(Code::NOT_ALGEBRAIC, e.what()); }
  catch (const si::Mixed_roots_error& e) { return si::Refusal(Code::NOT_ALGEBRAIC, e.what()); }
  catch (const si::Division_by_zero_error& e) { return si::Refusal(Code::POLE, e.what()); }
  catch (const si::Domain_error& e) { return si::Refusal(Code::OUTSIDE_DOMAIN, e.what()); }
  catch (const si::Limit_error& e) { return si::Refusal(Code::LIMIT_EXCEEDED, e.what()); }
  catch (const CGAL::Uncertain_conversion_exception& e)
  {
    return si::Refusal(Code::UNDECIDED, "an enclosure does not decide a case");
  }
}

template <class NT>
si::Result<Shapes<NT>> shapes_of(const Surface_model& surface, const std::vector<NT>& at,
                                 const std::vector<NT>& direction)
{
  const auto* system = std::get_if<System_model>(&surface.data);
  return system ? system_shapes(*system, surface.orient, at, direction)
                : surface_shapes(surface, at);
}

// About the point that is proved near the place: in the box that encloses it, or in as many bits as
// it takes. (In floating point redundant equations beside the solution would not look like such.)
template <class NT>
si::Result<std::vector<Surface_answer>> answer_enclosed(const Surface_model& surface,
                                                        const Curvature_task& task)
{
  if constexpr (!si::Number_type_traits<NT>::is_enclosure)
    return answer_in_bits(surface, task);
  else
  {
    const si::Result<Enclosed_place> place = enclose_place(surface, task);
    if (!place)
      return place.refusal();
    std::vector<NT> at;
    for (const CGAL::Interval_nt<false>& x : place->enclosure.box)
      at.push_back(si::number_cast<NT>(Interval(x.pair())));
    const si::Result<Surface_answer> described = describe_in_box(*place, task, at);
    if (!described)
      return described.refusal();
    Surface_answer a = *described;
    a.enclosure = describe_enclosure(*place);
    return std::vector<Surface_answer>{a};
  }
}

template <class NT>
si::Result<std::vector<Surface_answer>> answer_about(const Surface_model& surface,
                                                     const Curvature_task& task)
{
  if (task.enclose)
    return answer_enclosed<NT>(surface, task);
  if constexpr (si::Number_type_traits<NT>::is_exact)
    check_exact_cost(surface, task.at);
  const std::vector<NT> at = evaluate<NT>(task.at);
  std::vector<NT> direction;
  if (task.direction)
    direction = evaluate<NT>(*task.direction);
  const si::Result<Shapes<NT>> shapes = shapes_of(surface, at, direction);
  if (!shapes)
    return shapes.refusal();
  std::vector<Surface_answer> answers;
  for (const Sided_shape<NT>& sided : *shapes)
  {
    const auto shape = surface.flip ? sided.shape.opposite() : sided.shape;
    answers.push_back(describe(shape));
    answers.back().side = sided.side;
    if (!task.direction)
      continue;
    const Vector_3<NT> v = first<3>(direction);
    if (auto refusal = si::refuse_direction(shape, v))
      return *refusal;
    answers.back().normal_curvature = describe_normal_curvature(shape, v);
  }
  return answers;
}

template <class NT>
si::Result<std::vector<Curve_answer>> answer_about(const Curve_model& curve,
                                                   const Curvature_task& task)
{
  if constexpr (si::Number_type_traits<NT>::is_exact)
    check_exact_cost(curve, task.at);
  const si::Result<Curve_shapes<NT>> shapes = curve_shapes(curve, evaluate<NT>(task.at));
  if (!shapes)
    return shapes.refusal();
  std::vector<Curve_answer> answers;
  for (const auto& sided : *shapes)
  {
    if (!sided.shape)
      return sided.shape.refusal();
    answers.push_back(describe(*sided.shape));
    if (shapes->size() > 1)
      answers.back().side = {name_of(sided.side)};
  }
  return answers;
}

template <class NT>
si::Result<std::vector<Surface_answer>> answer_about(const Shape_operator_task& task)
{
  const std::array<NT, 3> normal = evaluate<NT>(task.normal);
  std::array<Vector_3<NT>, 3> directions;
  for (int i = 0; i < 3; ++i)
    directions[i] = evaluate<NT>(task.directions[i]);
  const auto shape = si::shape_from_normal_curvatures<NT>({NT(0), NT(0), NT(0)}, normal, directions,
                                                          evaluate<NT>(task.curvatures));
  if (!shape)
    return shape.refusal();
  Surface_answer a = describe(*shape);
  a.point.reset();
  a.hessian_case = si::to_string(si::normal_pattern(normal));
  return std::vector<Surface_answer>{a};
}

template <class NT>
si::Result<std::vector<Surface_answer>> answer(const Surface_model& surface,
                                               const Curvature_task& task)
{
  return refusing<std::vector<Surface_answer>>([&] { return answer_about<NT>(surface, task); });
}

template <class NT>
si::Result<std::vector<Curve_answer>> answer(const Curve_model& curve, const Curvature_task& task)
{
  return refusing<std::vector<Curve_answer>>([&] { return answer_about<NT>(curve, task); });
}

template <class NT>
si::Result<std::vector<Surface_answer>> answer(const Shape_operator_task& task)
{
  return refusing<std::vector<Surface_answer>>([&] { return answer_about<NT>(task); });
}

} // namespace interrogate

#endif // INTERROGATE_ANSWER_IN_H
