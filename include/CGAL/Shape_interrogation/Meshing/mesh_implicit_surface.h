// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_IMPLICIT_SURFACE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_IMPLICIT_SURFACE_H

// Meshes of implicit surfaces in a box, through CGAL's Delaunay refinement. This header takes about
// twenty seconds to compile: include it in one file of a program.

#include <CGAL/Shape_interrogation/Meshing/Implicit_mesh_options.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Implicit_mesher.h>
#include <CGAL/Shape_interrogation/Waist/progress.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief triangulates the part of an implicit surface that lies in a box.
 *
 * \details The surface is looked for on a grid over the box, refined by \cgal's surface mesher, and
 * its vertices are moved onto the surface by Newton steps. At the faces of the box it is cut:
 * vertices of the cut lie on the surface and on the face. Triangles are oriented along the
 * gradient, so that a closed surface around negative values has outward normals. The function must
 * exist in the ball around the box whose radius is two edge lengths larger than half the diagonal.
 *
 * <b>What is certified.</b> The distances in the report are upper bounds, found with interval
 * arithmetic, where the report says so; else, near singular points for example, they are the
 * largest that were seen at sample points. They may exceed the tolerance; the report says by how
 * much. The topology is not certified: components and holes that are smaller than a cell of the
 * grid or than the edges can be missed, and so are parts along which the function does not change
 * its sign, such as a factor of even multiplicity.
 *
 * <b>Singular curves.</b> Where sheets cross or touch each other along a curve, no refinement ends
 * in a manifold. After a few more vertices than a smooth surface needs, the mesh then stays as it
 * is and `Mesh_report::manifold` is `false`: the triangles beside the curve are as close to the
 * surface as the report says, but they may overlap or leave gaps.
 *
 * The vertex properties are those of `Shape_property_maps`, for the level set of the function
 * through the vertex, which is as near to the surface as doubles allow. Vertices at singular points
 * are in `Mesh_report::refused_places`.
 *
 * \tparam Function must be a model of `ImplicitFunction_3`
 * \tparam Progress is called as `progress(done, 0)` with a number of steps, see `No_progress`
 *
 * \param surface the surface
 * \param box the box
 * \param options how fine the mesh must be
 * \param progress the progress callback
 *
 * \return the mesh with its report; or a refusal: `NOT_ON_SURFACE` when nothing is found in the
 * box, as the function certainly changes its sign nowhere on the grid, `OUTSIDE_DOMAIN` for an
 * empty box or where the function does not exist, `LIMIT_EXCEEDED` when more vertices are needed
 * than allowed, the function overflows or the mesher fails, `CANCELLED`
 */
template <class Function, class Progress = No_progress>
Result<Shape_mesh> mesh_implicit_surface(const Implicit_surface_3<Function>& surface,
                                         const Bbox_3& box,
                                         const Implicit_mesh_options& options =
                                           Implicit_mesh_options(),
                                         Progress progress = Progress())
{
  std::size_t steps = 0;
  const auto go_on = [&] { return progress(++steps, std::size_t(0)); };
  const internal::Mesh_box sides{{{box.xmin(), box.xmax()}, {box.ymin(), box.ymax()},
                                  {box.zmin(), box.zmax()}}};
  try
  {
    return internal::refuse_errors<Shape_mesh>([&]() -> Result<Shape_mesh> {
      return internal::Implicit_mesher<Function, decltype(go_on)>(surface, sides, options, go_on)();
    });
  }
  catch (const internal::Mesh_refused& refused)
  {
    return refused.refusal;
  }
  catch (const Failure_exception& failure)
  {
    return Refusal(Refusal_code::LIMIT_EXCEEDED,
                   std::string("the surface mesher gives up: ") + failure.what());
  }
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_IMPLICIT_SURFACE_H
