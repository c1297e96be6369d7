// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H

// Adaptive triangulation of Bezier patches with a certified distance, and with identical vertices
// on the edges that patches have in common.

#include <CGAL/Shape_interrogation/Meshing/Patch_mesh_options.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Patch_mesher.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>

#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates Bezier patches, polynomial or rational, into one mesh.
 *
 * \details The parameter square of each patch is divided adaptively until each triangle is proved
 * to be within the tolerance of its piece of the patch, and the other bounds of `options` hold. The
 * proof bounds the second derivatives over the triangle's parameters by their Bernstein
 * coefficients in interval arithmetic; vertices are points of the patches, evaluated exactly and
 * rounded to the nearest doubles. Triangles are oriented by \f$ S_u \times S_v \f$. The result is
 * deterministic.
 *
 * <b>Common edges.</b> Edges of patches are common when their control points, and their weights up
 * to a common factor, are equal, in either order. They get identical vertices, also when the
 * patches are meshed one by one with the same tolerance and bounds: the division of an edge depends
 * on its curve alone. Within one mesh the patches are connected there, unless the edge has more
 * than two patches, or two of opposite orientations: then the mesh has its vertices twice and
 * `Mesh_report::manifold` is `false`. Patches that touch in a point only are not connected there.
 *
 * <b>Degenerate patches.</b> An edge that is collapsed to a point becomes one vertex, and no
 * triangle has two equal corners. Vertices where the parametrisation is irregular have no
 * curvature; see `Shape_property_maps` for their properties and `Mesh_report::refused_places` for
 * the list.
 *
 * <b>Distances.</b> The bound in the report holds in both directions: no point of the mesh is
 * farther from the patches, and no point of the patches is farther from the mesh.
 *
 * The vertex properties are those of `Shape_property_maps` and `Patch_property_maps`. Curvatures
 * are computed in interval arithmetic, and exactly where that is not accurate to \f$ 10^{-12} \f$
 * of the largest curvature there. On an edge between patches they belong to one of the patches:
 * they differ from those of the other where the patches do not join smoothly.
 *
 * \tparam Progress is called as `progress(done, total)` with the number of patches, see
 * `No_progress`
 *
 * \param patches the patches, with exact control points
 * \param options how fine the mesh must be
 * \param progress the progress callback
 *
 * \return the mesh with its report, whose distances are certified; or a refusal:
 * `LIMIT_EXCEEDED` when the bounds need more vertices than allowed, or a tolerance beyond the
 * resolution of doubles (2^-42 of the largest coordinate), `POLE` where the weight of a rational
 * patch vanishes, `IRREGULAR_PARAMETRISATION` for a patch that is a single curve or point,
 * or has two collapsed edges that meet, `CANCELLED`
 *
 * Source: the bound of Filip, Magedson and Markot for the interpolation of a surface by triangles,
 * in a form that keeps the directions of the edges (see triangle_bound.h).
 */
template <class Progress = No_progress>
Result<Shape_mesh> mesh_patches(const std::vector<Bezier_surface_3<Exact_rational>>& patches,
                                const Patch_mesh_options& options = Patch_mesh_options(),
                                Progress progress = Progress())
{
  try
  {
    return internal::Patch_mesher(patches, options)(progress);
  }
  catch (const internal::Mesh_refused& refused)
  {
    return refused.refusal;
  }
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_PATCHES_H
