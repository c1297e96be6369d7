// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_TRACE_N_SPACE_CURVE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_TRACE_N_SPACE_CURVE_H

// Follows the solution curve of a system in n-space, or a section of a surface.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Path_tracer.h>
#include <CGAL/Shape_interrogation/Meshing/internal/curvature_of_curve.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fault_of_bounds.h>
#include <CGAL/Shape_interrogation/Meshing/internal/mesh_with_progress.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how a curve in n-space is followed.
 */
struct N_space_curve_options
{
  //! length that the projections of steps have at most. Must be positive.
  double step = 0;
  //! angle in radian by which the tangent in n-space turns in a step at most, from 0.001 to 1
  double max_turning = 0.2;
  //! the curve ends where a variable leaves one of these; at most 32
  std::vector<N_space_bound> bounds;
  //! largest number of points in each direction
  std::size_t max_points = 100000;
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says why a curve in n-space ends.
 */
enum class N_space_curve_end
{
  CLOSED,   //!< it comes back to its start
  BOUND,    //!< a variable reaches a bound
  SINGULAR, //!< its equations are dependent: branches cross, or it has a cusp
  LIMIT     //!< the largest number of points is reached
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is one end of a curve in n-space.
 */
struct N_space_curve_end_data
{
  N_space_curve_end reason = N_space_curve_end::LIMIT; //!< why the curve ends
  std::string evidence; //!< the same in words, with the variable for a bound
  //! for a singular point: the ranges of the variables in which it is expected; not proved
  std::vector<std::array<double, 2>> box;
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a curve in n-space as a polyline with its ends.
 */
struct N_space_curve : N_space_polyline
{
  std::array<N_space_curve_end_data, 2> ends; //!< at the first and at the last point
  //! the curvature of the projected curve at each point, evaluated there, not estimated from the
  //! polyline; none where the curve or its projection is singular
  std::vector<std::optional<double>> curvatures;
  double max_residual = 0; //!< the largest absolute value of an equation at a point
};

#ifndef DOXYGEN_RUNNING
namespace internal {

inline N_space_curve_end_data end_of(const Path& path, const Path_point& last,
                                     const std::vector<Bound_side>& sides,
                                     const N_space_system& system)
{
  N_space_curve_end_data end;
  switch (path.end)
  {
  case Path_end::CLOSED:
    end.reason = N_space_curve_end::CLOSED;
    end.evidence = "the curve is closed";
    break;
  case Path_end::BOUND:
    end.reason = N_space_curve_end::BOUND;
    end.evidence = system.variables()[sides[path.side].variable] + " is " +
                   text_of(sides[path.side].value);
    break;
  case Path_end::SINGULAR:
    end.reason = N_space_curve_end::SINGULAR;
    end.evidence = path.evidence;
    for (double x : last.point)
      end.box.push_back({x - path.last_step, x + path.last_step});
    break;
  case Path_end::LIMIT:
    end.evidence = "the largest number of points is reached";
  }
  return end;
}

template <class Go_on>
Result<N_space_curve> trace_both_ways(const N_space_system& system,
                                      const std::optional<N_space_condition>& section,
                                      const std::vector<double>& start,
                                      const N_space_curve_options& options, Go_on go_on)
{
  const std::vector<Bound_side> sides = sides_of(options.bounds);
  Path_limits limits;
  limits.cos_turning = std::cos(options.max_turning);
  limits.max_points = options.max_points;
  limits.stops_at_branches = true;
  std::vector<N_space_condition> fixed;
  if (section)
    fixed.push_back(*section);
  Path_tracer tracer(system, fixed, sides, limits);
  const Result<Path_point> first = tracer.start(start);
  if (!first)
    return first.refusal();
  for (const Bound_side& s : sides)
    if (s.distance(first->point) < -1e-9 * (1 + std::fabs(s.value)))
      return Refusal(Refusal_code::OUTSIDE_DOMAIN,
                     "the variable " + system.variables()[s.variable] +
                       " is out of bounds on the curve near the start");
  // Where the projection contracts the curve it does not tell how far to go.
  const auto unit = [&](const Path_point& p) {
    const double stretch = std::hypot(p.tangent[0], p.tangent[1], p.tangent[2]);
    return options.step / (std::max)(stretch, 1. / 16);
  };
  N_space_curve curve;
  curve.points.push_back(first->point);
  Path_point s = *first;
  for (int direction = 0; direction < 2 && !curve.closed; ++direction)
  {
    const Path path = tracer.trace(s, unit, go_on);
    for (const Path_point& p : path.points)
      if (p.point != curve.points.back()) // the start may lie on a bound
        curve.points.push_back(p.point);
    curve.ends[1] = end_of(path, path.points.empty() ? s : path.points.back(), sides, system);
    curve.closed = path.end == Path_end::CLOSED;
    if (direction == 1)
      break;
    if (curve.closed)
      curve.ends[0] = curve.ends[1];
    else
    {
      std::reverse(curve.points.begin(), curve.points.end());
      std::swap(curve.ends[0], curve.ends[1]);
      for (double& x : s.tangent)
        x = -x;
    }
  }
  for (const std::vector<double>& p : curve.points)
  {
    curve.curvatures.push_back(curvature_of_curve(system, section, p));
    for (double x : system.tape().evaluate(p))
      curve.max_residual = (std::max)(curve.max_residual, std::fabs(x));
  }
  return curve;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief follows a solution curve of a system in n-space in both directions from a point near it.
 *
 * \details The system has `n - 1` independent equations along the curve; more, redundant ones are
 * allowed. With a `section` it has `n - 2`, and the curve is that in which its surface meets the
 * hyperplane of the section: a plane section, or the line where a variable has a constant value.
 *
 * Each step goes along the tangent and back to the curve by Newton's method in the hyperplane
 * across. Steps become shorter where the tangent turns; where the curve and its tangent do not
 * allow even a very short one it ends at a singular point. It also ends where two branches
 * cross, which is told by the sign of a determinant; that is not looked for in systems of
 * more than 96 variables. Nothing is proved: a step can jump to a branch that is nearer than the
 * step is long, and go beyond a bound and back.
 *
 * \tparam Progress is called as `progress(done, 0)` with a number of steps, see `No_progress`
 *
 * \param system the system
 * \param start an approximate point in n-space
 * \param options the length of steps and where the curve ends
 * \param section a linear condition that cuts the curve out of a surface
 * \param progress the progress callback
 *
 * \return the curve; or a refusal: `LIMIT_EXCEEDED` for options that make no sense,
 * `OUTSIDE_DOMAIN` when the start leads out of the bounds, `RANK_DEFICIENT` when there is no
 * tangent at the start, those of `N_space_corrector` there, `CANCELLED`
 *
 * Complexity: linear in the number of points, each with a few corrections, and with dense
 * factorisations for the curvature and where branches are looked for
 */
template <class Progress = No_progress>
Result<N_space_curve> trace_n_space_curve(const N_space_system& system,
                                          const std::vector<double>& start,
                                          const N_space_curve_options& options,
                                          const std::optional<N_space_condition>& section =
                                            std::nullopt,
                                          Progress progress = Progress())
{
  if (!(options.step > 0) || !std::isfinite(options.step))
    return Refusal(Refusal_code::LIMIT_EXCEEDED, "the length of steps must be a positive number");
  if (!(options.max_turning >= 0.001 && options.max_turning < 1))
    return Refusal(Refusal_code::LIMIT_EXCEEDED,
                   "the largest turning must be an angle between 0.001 and 1 radian");
  if (section && static_cast<int>(section->coefficients.size()) != system.number_of_variables())
    return Refusal(Refusal_code::LIMIT_EXCEEDED,
                   "the section has " + std::to_string(section->coefficients.size()) +
                     " coefficient(s) for " + std::to_string(system.number_of_variables()) +
                     " variables");
  const std::string fault = internal::fault_of(options.bounds, system);
  if (!fault.empty())
    return Refusal(Refusal_code::LIMIT_EXCEEDED, fault);
  return internal::mesh_with_progress<N_space_curve>(progress, [&](auto go_on) {
    return internal::trace_both_ways(system, section, start, options, go_on);
  });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_TRACE_N_SPACE_CURVE_H
