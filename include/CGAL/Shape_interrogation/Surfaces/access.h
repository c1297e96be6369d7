// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_ACCESS_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_ACCESS_H

// Access to a surface beside the waist: a point moved onto it, and its second-order data enclosed
// over a box. What tracing, meshing and searches need.

#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/Has_level_set.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a point that an iteration has moved onto a surface, with its residual.
 */
struct Projected_point_3
{
  Coordinates<double, 3> point{}; //!< the point
  double residual = 0;            //!< the value of the function there
  double step = 0;                //!< the length of the last step
  int iterations = 0;             //!< the number of steps
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief moves a point onto an implicit surface by Newton steps along the gradient.
 *
 * This is a point of the surface near `p`, not the foot point. It is approximate and carries its
 * residual; nothing is proved. Refused are a vanishing gradient on the way (`SINGULAR_POINT`) and
 * iterations that do not settle (`NOT_ON_SURFACE`).
 * \param surface the surface
 * \param p where to start
 * \param max_iterations the largest number of steps
 */
template <class Function>
Result<Projected_point_3> project_to_surface(const Implicit_surface_3<Function>& surface,
                                             const Coordinates<double, 3>& p,
                                             int max_iterations = 50)
{
  return internal::refuse_errors<Projected_point_3>([&]() -> Result<Projected_point_3> {
    Projected_point_3 r;
    r.point = p;
    double previous = HUGE_VAL; // |f| one step before
    for (r.iterations = 0; r.iterations < max_iterations; ++r.iterations)
    {
      const Jet<double, 3, 1> f = surface.template jet<1>(r.point);
      const Coordinates<double, 3> g{f.derivative(0), f.derivative(1), f.derivative(2)};
      const double q = internal::dot(g, g);
      r.residual = f.value();
      if (!std::isfinite(q) || !std::isfinite(r.residual))
        return Refusal(Refusal_code::LIMIT_EXCEEDED, "the function overflows on the way");
      if (q == 0)
      {
        if (r.residual == 0)
          return r;
        return Refusal(Refusal_code::SINGULAR_POINT, "the gradient vanishes on the way");
      }
      r.step = std::fabs(r.residual) / std::sqrt(q);
      // Newton has settled when the step is a rounding of the point, or when nothing is gained any
      // more near the surface: the rest is the rounding of f.
      const double size =
        (std::max)({std::fabs(r.point[0]), std::fabs(r.point[1]), std::fabs(r.point[2])});
      if (r.step <= std::ldexp(size, -52) ||
          (std::fabs(r.residual) >= previous && r.step <= std::ldexp(size, -26)))
        return r;
      previous = std::fabs(r.residual);
      for (int i = 0; i < 3; ++i)
        r.point[i] -= r.residual / q * g[i];
    }
    return Refusal(Refusal_code::NOT_ON_SURFACE,
                   "no point of the surface was reached in " + std::to_string(max_iterations) +
                     " steps");
  });
}

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief encloses the second-order data of a surface over a box of queries: of every level set for
 * an implicit one, of every point of the parameter box for a parametrised one.
 *
 * Decisions on the result hold for the whole box or are undecided. Refused with `UNDECIDED` if the
 * box may contain singular places. Sets the rounding mode for the call.
 * \param source a model of `ShapeSource_3` that takes queries in `Interval_nt<false>`; its
 * `level_set_shape()` is called where there is one, else its call operator
 * \param box the coordinates as intervals
 */
template <class Source, class Box>
Result<Local_shape_3<Interval_nt<false>>> enclose_shape(const Source& source, const Box& box)
{
  Interval_nt<false>::Protector protector;
  if constexpr (internal::Has_level_set<Source, Box>::value)
    return source.level_set_shape(box);
  else
    return source(box);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_ACCESS_H
