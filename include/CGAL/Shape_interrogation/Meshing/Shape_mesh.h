// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_SHAPE_MESH_H
#define CGAL_SHAPE_INTERROGATION_MESHING_SHAPE_MESH_H

// The triangle mesh that all meshers return: CGAL's Surface_mesh with the second-order data of the
// surface as vertex properties, computed from the surface and never estimated from triangles.

#include <CGAL/Shape_interrogation/Meshing/Mesh_report.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief is a triangle mesh with curvature data, and the report of the mesher.
 *
 * The vertex properties are those of `Shape_property_maps`. The mesh is an ordinary
 * `CGAL::Surface_mesh` that every function of \cgal takes.
 */
struct Shape_mesh
{
  using Kernel = Exact_predicates_inexact_constructions_kernel; //!< the kernel
  using Point_3 = Kernel::Point_3;                              //!< a vertex position
  using Vector_3 = Kernel::Vector_3;                            //!< a normal or direction
  using Point_2 = Kernel::Point_2;                              //!< parameters
  using Surface_mesh = CGAL::Surface_mesh<Point_3>;             //!< the mesh

  Surface_mesh surface_mesh; //!< the triangles
  Mesh_report report;        //!< what the mesher says about them
};

namespace internal {

// CGAL 5 answers a pair, CGAL 6 an optional.
template <class Map>
std::optional<Map> existing_map(const std::pair<Map, bool>& found)
{
  return found.second ? std::optional<Map>(found.first) : std::nullopt;
}

template <class Map>
std::optional<Map> existing_map(const std::optional<Map>& found) { return found; }

// The property map of the name and value type, if the mesh has it.
template <class Index, class T, class Mesh>
auto find_map(const Mesh& mesh, const std::string& name)
{
  return existing_map(mesh.template property_map<Index, T>(name));
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief gives access to the vertex properties of a mesh with curvature data.
 *
 * The names in the mesh are those of the members with the prefix `"v:"` that \cgal uses, for
 * example `"v:gaussian_curvature"`; in files they have no prefix. All values belong to the unit
 * normal `normal` and follow the sign rule of `Local_shape_3`: a sphere with outward normal has
 * positive mean and principal curvatures. `direction_min`, `direction_max` and `normal` are
 * orthonormal and right-handed in this order.
 *
 * <b>Vertices without data.</b> Where the surface refuses its second-order data, for example where
 * an edge of a patch is collapsed to a point, `regular` is `false`, the curvatures and directions
 * are zero, and `normal` is the limit of the unit normal if it exists for all patches there, else
 * zero. Each of these vertices is in `Mesh_report::refused_places`. At umbilics, where every
 * direction is principal, both directions are zero.
 */
class Shape_property_maps
{
public:
  using Mesh = Shape_mesh::Surface_mesh;    //!< the mesh
  using Vertex = Mesh::Vertex_index;        //!< a vertex
  using Vector_3 = Shape_mesh::Vector_3;    //!< a vector
  template <class T>
  using Map = Mesh::Property_map<Vertex, T>; //!< a property map

  //! gets the maps of the mesh, and adds those that it has not got.
  explicit Shape_property_maps(Mesh& mesh)
    : normal(add<Vector_3>(mesh, "v:normal", NULL_VECTOR)),
      gaussian_curvature(add(mesh, "v:gaussian_curvature", 0.0)),
      mean_curvature(add(mesh, "v:mean_curvature", 0.0)),
      kmin(add(mesh, "v:kmin", 0.0)),
      kmax(add(mesh, "v:kmax", 0.0)),
      direction_min(add<Vector_3>(mesh, "v:direction_min", NULL_VECTOR)),
      direction_max(add<Vector_3>(mesh, "v:direction_max", NULL_VECTOR)),
      regular(add(mesh, "v:regular", false))
  {}

  Map<Vector_3> normal;           //!< the unit normal
  Map<double> gaussian_curvature; //!< the Gaussian curvature
  Map<double> mean_curvature;     //!< the mean curvature
  Map<double> kmin;               //!< the smaller principal curvature
  Map<double> kmax;               //!< the larger principal curvature
  Map<Vector_3> direction_min;    //!< the unit direction of `kmin`
  Map<Vector_3> direction_max;    //!< the unit direction of `kmax`
  Map<bool> regular;              //!< whether the surface has these data here

private:
  template <class T>
  static Map<T> add(Mesh& mesh, const char* name, const T& value)
  {
    return mesh.add_property_map<Vertex, T>(name, value).first;
  }
};

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief gives access to the properties that only meshes of patches have.
 *
 * A vertex on an edge that several patches share has the patch of least index that is regular
 * there, and the parameters in that patch.
 */
class Patch_property_maps
{
public:
  using Mesh = Shape_mesh::Surface_mesh;    //!< the mesh
  using Vertex = Mesh::Vertex_index;        //!< a vertex
  using Face = Mesh::Face_index;            //!< a triangle
  using Point_2 = Shape_mesh::Point_2;      //!< parameters

  //! gets the maps of the mesh, and adds those that it has not got.
  explicit Patch_property_maps(Mesh& mesh)
    : parameter(mesh.add_property_map<Vertex, Point_2>("v:parameter", Point_2(0, 0)).first),
      vertex_patch(mesh.add_property_map<Vertex, int>("v:patch", -1).first),
      face_patch(mesh.add_property_map<Face, int>("f:patch", -1).first)
  {}

  Mesh::Property_map<Vertex, Point_2> parameter; //!< the parameters in the patch
  Mesh::Property_map<Vertex, int> vertex_patch;  //!< the patch that the vertex data come from
  Mesh::Property_map<Face, int> face_patch;      //!< the patch of a triangle
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_SHAPE_MESH_H
