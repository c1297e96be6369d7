// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_REGIONS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_REGIONS_H

// A patch divided along the curves of a contour, as one mesh with a region for each triangle.

#include <CGAL/Shape_interrogation/Meshing/divide_domain.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Region_mesher.h>
#include <CGAL/Shape_interrogation/Meshing/region_classifiers.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a patch divided into regions, in its domain and in space.
 */
struct Region_mesh
{
  Divided_domain domain; //!< the domain in triangles, with trimming loops for the regions
  Shape_mesh mesh;       //!< the patch, in the same triangles
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates a patch with its regions: the triangles of `divide_domain()`, lifted to
 * space.
 *
 * \details Triangles are oriented by \f$ S_u \times S_v \f$; for the opposite normal mesh
 * `Bezier_surface_3::transposed()`. The vertex properties are those of `Shape_property_maps` and
 * `Patch_property_maps` (for the patch 0), those of faces and edges are those of
 * `Region_property_maps`. Vertices are points of the patch in interval arithmetic or, where that is
 * not accurate, exact ones rounded to doubles; `Mesh_report::max_vertex_distance` is certified. The
 * distance of the triangles is measured at their centres only.
 *
 * \tparam Classify see `divide_domain()`
 * \tparam Progress is called as `progress(done, total)` with about twice the number of vertices,
 * see `No_progress`
 *
 * \param patch the patch
 * \param contour the curves that divide it, on the unit square
 * \param classify tells the regions of points
 * \param options how fine the triangles must be, in the unit square
 * \param progress the progress callback
 *
 * \return the mesh. Refused are what `divide_domain()` refuses (`LIMIT_EXCEEDED`, `UNDECIDED`), a
 * rational patch with a vanishing weight (`POLE`), a patch that is nowhere regular
 * (`IRREGULAR_PARAMETRISATION`), and what the callback stops (`CANCELLED`).
 *
 * Degenerate cases: an edge of the square that the patch maps to a point becomes one vertex,
 * without the triangles that would have two equal corners, unless the mesh were no manifold then;
 * in this case all vertices are kept, some of them at equal points. Where curves of the contour
 * meet in a point, triangles can be as small as \f$ 10^{-13} \f$ of the domain, so that some in
 * space have no area in floating point.
 */
template <class Classify, class Progress = No_progress>
Result<Region_mesh> mesh_regions(const Bezier_surface_3<Exact_rational>& patch,
                                 const Contour_2& contour, Classify classify,
                                 const Domain_options& options = {},
                                 Progress progress = Progress())
{
  Result<Divided_domain> domain = divide_domain(contour, std::move(classify), options);
  if (!domain)
    return domain.refusal();
  try
  {
    Shape_mesh mesh = internal::Region_mesher(patch, *domain)(progress);
    return Region_mesh{*domain, std::move(mesh)};
  }
  catch (const internal::Mesh_refused& refused)
  {
    return refused.refusal;
  }
}

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is the trichotomy of a patch with its regions as a mesh; these are the values of `Region`.
 */
struct Trichotomy_mesh
{
  Trichotomy trichotomy; //!< the certified division
  Region_mesh regions;   //!< the mesh
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates a patch with its convex, concave and saddle parts, see
 * `trichotomy_of_patch()` and `mesh_regions()`. The points of the boundary curves are not farther
 * from each other than the edges of the mesh.
 *
 * \param patch the patch
 * \param options how fine the triangles must be, in the unit square
 * \param trichotomy_options how well areas must be known, and what may be spent on it
 * \param progress the progress callback, see `No_progress`
 *
 * \return the mesh; the refusals are those of the two functions
 */
template <class Progress = No_progress>
Result<Trichotomy_mesh> mesh_trichotomy(const Bezier_surface_3<Exact_rational>& patch,
                                        const Domain_options& options = {},
                                        Trichotomy_options trichotomy_options = {},
                                        Progress progress = Progress())
{
  double& step = trichotomy_options.contour.step;
  step = (std::min)(step, options.edge_length);
  const auto parts = trichotomy_of_patch(patch, trichotomy_options, progress);
  if (!parts)
    return parts.refusal();
  const auto mesh =
    mesh_regions(patch, parts->boundary, Trichotomy_classifier(patch), options, progress);
  if (!mesh)
    return mesh.refusal();
  return Trichotomy_mesh{*parts, *mesh};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_REGIONS_H
