// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_N_SPACE_SURFACE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_N_SPACE_SURFACE_H

// Triangulates the projection of a surface in n-space upstairs, where it is a manifold.

#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/N_space_mesher.h>
#include <CGAL/Shape_interrogation/Meshing/internal/fault_of_bounds.h>
#include <CGAL/Shape_interrogation/Meshing/internal/mesh_with_progress.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

inline std::string fault_of(const N_space_mesh_options& options, const N_space_system& system)
{
  if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
    return "the length of the edges must be a positive number";
  if (!(options.max_turning >= 0.001 && options.max_turning < 1))
    return "the largest turning must be an angle between 0.001 and 1 radian";
  const std::string fault = fault_of(options.bounds, system);
  return fault.empty() ? fault_of(options.search_box, system) : fault;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates the projection of the surface of a system in n-space.
 *
 * \details From each start point the surface is covered by vertices that are corrected onto the
 * solution of all equations (`N_space_corrector`), and then triangulated. All this is done in
 * n-space, where the surface is a manifold: its projection may cross itself or have cuspidal edges,
 * as the inner offset of an ellipsoid has, and the mesh is still that of the manifold upstairs. Two
 * vertices are neighbours only if they are near in n-space in the same tangent plane.
 *
 * The distance of neighbours is the same in all directions of n-space, and such that the longest
 * projection of an edge has the length `edge_length`. It is less where the tangent plane turns by
 * more than `max_turning` along an edge. Variables that change much faster than the projected
 * point therefore lead to shorter edges: choose units in which all variables have about the same
 * size.
 *
 * <b>Bounds.</b> Where a variable reaches a bound the mesh ends in vertices that are on it exactly;
 * where two bounds meet there is a vertex in the corner.
 *
 * <b>Orientation.</b> Triangles and normals are oriented alike upstairs, for each component of the
 * solution as its first vertex comes. Across a fold the projected normal turns over. A surface that
 * cannot be oriented is left with a cut, a rim.
 *
 * <b>What is certified.</b> Nothing: the corrections are done in floating point, distances are the
 * largest that were seen at sample points, and components that no start point leads to are missing.
 * Sheets that are nearer to each other in n-space than a tenth of an edge may be confused, and
 * holes between bounds that no vertex comes near are missed.
 *
 * The vertex properties are those of `Shape_property_maps` and `N_space_property_maps`. Where the
 * projection is singular at a vertex it is in `Mesh_report::refused_places`. The result is the same
 * for the same input.
 *
 * \tparam Progress is called as `progress(done, 0)` with a number of steps, see `No_progress`
 *
 * \param system the system
 * \param starts approximate points of n-space on each component
 * \param options how fine the mesh must be, its bounds, and where to search for more start points
 * \param progress the progress callback
 *
 * \return the mesh; or a refusal: `LIMIT_EXCEEDED` for options that make no sense and when more
 * vertices are needed than allowed, `NOT_ON_SOLUTION` when no start point leads to the surface,
 * `OUTSIDE_DOMAIN` when one leads out of the bounds, `NOT_TWO_DIMENSIONAL` when the solution is a
 * curve, those of `N_space_corrector` at a start point,
 * `CANCELLED`
 *
 * Complexity: linear in the number of vertices, each with a few corrections
 */
template <class Progress = No_progress>
Result<N_space_mesh> mesh_n_space_surface(const N_space_system& system,
                                          const std::vector<std::vector<double>>& starts,
                                          const N_space_mesh_options& options,
                                          Progress progress = Progress())
{
  const std::string fault = internal::fault_of(options, system);
  if (!fault.empty())
    return Refusal(Refusal_code::LIMIT_EXCEEDED, fault);
  return internal::mesh_with_progress<N_space_mesh>(progress, [&](auto go_on) {
    return internal::N_space_mesher<decltype(go_on)>(system, options, go_on)(starts);
  });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_N_SPACE_SURFACE_H
