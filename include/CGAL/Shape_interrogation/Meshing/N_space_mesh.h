// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_N_SPACE_MESH_H
#define CGAL_SHAPE_INTERROGATION_MESHING_N_SPACE_MESH_H

// What a mesh of a surface in n-space is made of, and how fine it must be.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief says how fine a mesh of a surface in n-space must be, and where it ends.
 */
struct N_space_mesh_options
{
  //! length that the projections of edges have at most, about. Must be positive.
  double edge_length = 0;
  //! angle in radian by which the tangent plane in n-space turns along an edge at most, about:
  //! edges become shorter where it turns fast. From 0.001 to 1. It is aimed at and not guaranteed:
  //! `N_space_mesh::max_turning` is the largest angle of the mesh.
  double max_turning = 0.5;
  //! the mesh ends where a variable leaves one of these, rounded to `double`; at most 32
  std::vector<N_space_bound> bounds;
  //! start points are also looked for in the box of these ranges; none are looked for without any.
  //! A variable that is not named is looked for between plus and minus the largest bound.
  std::vector<N_space_bound> search_box;
  //! number of points of the box from which a way to the surface is looked for
  std::size_t search_points = 500;
  //! largest number of vertices
  std::size_t max_vertices = 200000;
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a polyline in n-space.
 */
struct N_space_polyline
{
  std::vector<std::vector<double>> points; //!< its points in n-space
  bool closed = false;                     //!< whether the last point is joined to the first
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a place beyond which a surface in n-space, or a fold of it, could not be followed.
 */
struct N_space_stop
{
  std::vector<double> point;                   //!< the last point, in n-space
  Refusal_code code = Refusal_code::UNDECIDED; //!< the reason
  std::string evidence;                        //!< the reason in words
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a mesh of the projection of a surface in n-space.
 *
 * The distances in the report are not certified. `report.refused_places` has the vertices at which
 * the projection is singular.
 */
struct N_space_mesh : Shape_mesh
{
  //! the curves along which the projection folds the surface, for example the cuspidal edges of an
  //! offset: the projected triangles turn over there. They end at the border of the mesh, or in a
  //! place that is in `stops`; smaller folds than a sixteenth of an edge may be missing
  std::vector<N_space_polyline> folds;
  //! borders of the mesh that lie on no bound: at singular points of the solution, for example
  std::vector<N_space_polyline> rims;
  //! where the surface or a fold could not be followed
  std::vector<N_space_stop> stops;
  double max_residual = 0;    //!< the largest absolute value of an equation at a vertex
  //! the largest angle in radian between the tangent planes in n-space of neighbours
  double max_turning = 0;
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief gives access to the vertex properties that only meshes of surfaces in n-space have.
 */
class N_space_property_maps
{
public:
  using Mesh = Shape_mesh::Surface_mesh;    //!< the mesh
  using Vertex = Mesh::Vertex_index;        //!< a vertex

  //! gets the maps of the mesh, and adds those that it has not got.
  explicit N_space_property_maps(Mesh& mesh)
    : n_space_point(mesh.add_property_map<Vertex, std::vector<double>>("v:n_space_point").first),
      projection_contraction(
        mesh.add_property_map<Vertex, double>("v:projection_contraction", 0.).first)
  {}

  Mesh::Property_map<Vertex, std::vector<double>> n_space_point; //!< the point in n-space
  //! the least length of the projection of a unit tangent vector in n-space: the distance, between
  //! 0 and 1, of the projection of the tangent plane from a singular one
  Mesh::Property_map<Vertex, double> projection_contraction;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_N_SPACE_MESH_H
