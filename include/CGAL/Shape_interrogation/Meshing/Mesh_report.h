// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_MESH_REPORT_H
#define CGAL_SHAPE_INTERROGATION_MESHING_MESH_REPORT_H

// What a mesher says about its mesh: topology, distances, and the places it could not evaluate.

#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a vertex of a mesh at which the second-order data were refused.
 */
struct Refused_place
{
  std::size_t vertex = 0;              //!< the index of the vertex in the mesh
  int patch = -1;                      //!< the patch, or -1 for a surface without parameters
  std::array<double, 2> parameters{};  //!< the parameters in the patch
  std::array<double, 3> point{};       //!< the point in space
  Refusal_code code = Refusal_code::UNDECIDED; //!< the reason
  std::string evidence;                //!< the reason in words
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief describes a mesh: its size and topology, how far it is from the surface, and the vertices
 * without second-order data.
 *
 * A distance that is certified is an upper bound of the true one in exact arithmetic; one that is
 * not is the largest that was seen at sample points.
 */
struct Mesh_report
{
  std::size_t vertices = 0;           //!< number of vertices
  std::size_t faces = 0;              //!< number of triangles
  //! whether the surfaces meet as in a manifold: each common edge has two of them, with the same
  //! orientation (at other edges the mesh has its vertices twice)
  bool manifold = true;
  std::size_t boundary_edges = 0;     //!< number of edges with one triangle
  std::size_t components = 0;         //!< number of connected components
  int euler_characteristic = 0;       //!< vertices - edges + faces
  double tolerance = 0;               //!< the distance that was asked for
  double max_vertex_distance = 0;     //!< of a vertex from the surface
  bool vertex_distance_certified = false; //!< whether that is an upper bound
  double max_face_distance = 0;       //!< of a point of a triangle from the surface
  bool face_distance_certified = false;   //!< whether that is an upper bound
  //! number of sample points from which no way to the surface was found: in the distances, which
  //! are not certified then, each stands as the length of an edge that was asked for
  std::size_t unmeasured_samples = 0;
  std::vector<Refused_place> refused_places; //!< vertices whose property `regular` is `false`
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_MESH_REPORT_H
