// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_COLOR_BY_PROPERTY_H
#define CGAL_SHAPE_INTERROGATION_MESHING_COLOR_BY_PROPERTY_H

// Colours of vertices for a signed property such as a curvature: blue for negative, white for zero,
// red for positive values.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

namespace internal {

// The area of the triangles around each vertex.
inline std::vector<double> areas_at_vertices(const Shape_mesh::Surface_mesh& mesh)
{
  std::vector<double> areas(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), 0);
  for (const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Shape_mesh::Point_3 &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
                              &c = mesh.point(mesh.target(mesh.next(h)));
    const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
    for (const auto v : mesh.vertices_around_face(h))
      areas[v.idx()] += area;
  }
  return areas;
}

// White at 0, the full colour at 1 and beyond.
inline CGAL::IO::Color diverging_color(double x)
{
  const double t = (std::min)(std::abs(x), 1.0);
  const double blue[] = {38, 84, 196}, red[] = {200, 40, 32}, white = 245;
  unsigned char rgb[3];
  for (int k = 0; k < 3; ++k)
    rgb[k] = static_cast<unsigned char>(std::lround(white + t * ((x < 0 ? blue : red)[k] - white)));
  return CGAL::IO::Color(rgb[0], rgb[1], rgb[2]);
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationMeshing
 * \brief gives the vertices of a mesh colours for one of their properties, as the property map
 * `"v:color"` that `write_mesh()` puts into the formats .ply and .vtp.
 *
 * \details Zero is white, negative values are blue and positive ones red. The full colours stand
 * for the absolute value that is exceeded only on the given part of the area, so that a few sharp
 * places do not leave the rest pale. Vertices whose property `"v:regular"` is `false` are grey.
 *
 * \param mesh the mesh
 * \param name the name of a property map with values `double`, such as `"v:mean_curvature"`
 * \param outliers the part of the area on which colours may be cut off
 * \return the absolute value of the full colours, or 0 if there is no such property and nothing was
 * done
 */
inline double color_by_property(Shape_mesh::Surface_mesh& mesh, const std::string& name,
                                double outliers = 0.1)
{
  using Vertex = Shape_mesh::Surface_mesh::Vertex_index;
  const auto values = internal::find_map<Vertex, double>(mesh, name);
  if (!values)
    return 0;
  const auto regular = internal::find_map<Vertex, bool>(mesh, "v:regular");
  const std::vector<double> areas = internal::areas_at_vertices(mesh);
  std::vector<std::pair<double, double>> sorted; // absolute values with their areas
  double left = 0;
  for (const Vertex v : mesh.vertices())
    if (!regular || (*regular)[v])
    {
      sorted.emplace_back(std::abs((*values)[v]), areas[v.idx()]);
      left += areas[v.idx()] * outliers;
    }
  std::sort(sorted.rbegin(), sorted.rend());
  double range = 0;
  for (const auto& value : sorted)
  {
    range = value.first;
    left -= value.second;
    if (left < 0)
      break;
  }
  auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for (const Vertex v : mesh.vertices())
    colors[v] = regular && !(*regular)[v]
                  ? CGAL::IO::Color(128, 128, 128)
                  : internal::diverging_color(range > 0 ? (*values)[v] / range : 0);
  return range;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_COLOR_BY_PROPERTY_H
