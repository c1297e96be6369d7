// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SET_SHAPE_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SET_SHAPE_H

// Puts the second-order data of a vertex into its properties.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Vertex_shape.h>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline Shape_mesh::Vector_3 kernel_vector(const Coordinates<double, 3>& v)
{
  return Shape_mesh::Vector_3(v[0], v[1], v[2]);
}

inline void set_shape(Shape_property_maps& maps, Shape_property_maps::Vertex v,
                      const Vertex_shape& s)
{
  maps.normal[v] = kernel_vector(s.normal);
  maps.gaussian_curvature[v] = s.gaussian_curvature;
  maps.mean_curvature[v] = s.mean_curvature;
  maps.kmin[v] = s.kmin;
  maps.kmax[v] = s.kmax;
  maps.direction_min[v] = kernel_vector(s.direction_min);
  maps.direction_max[v] = kernel_vector(s.direction_max);
  maps.regular[v] = true;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_SET_SHAPE_H
