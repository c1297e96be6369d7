// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_REGION_PROPERTY_MAPS_H
#define CGAL_SHAPE_INTERROGATION_MESHING_REGION_PROPERTY_MAPS_H

// The regions of the triangles of a mesh.

#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief gives access to the properties that only meshes of regions have: `"f:region"` and
 * `"e:contour"`.
 */
class Region_property_maps
{
public:
  using Mesh = Shape_mesh::Surface_mesh;    //!< the mesh
  using Face = Mesh::Face_index;            //!< a triangle
  using Edge = Mesh::Edge_index;            //!< an edge

  //! gets the maps of the mesh, and adds those that it has not got.
  explicit Region_property_maps(Mesh& mesh)
    : face_region(mesh.add_property_map<Face, int>("f:region", unresolved_region).first),
      contour_edge(mesh.add_property_map<Edge, bool>("e:contour", false).first)
  {}

  Mesh::Property_map<Face, int> face_region;   //!< the region of a triangle
  Mesh::Property_map<Edge, bool> contour_edge; //!< whether an edge is on the contour
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_REGION_PROPERTY_MAPS_H
