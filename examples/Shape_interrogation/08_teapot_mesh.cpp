// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The Utah teapot as a mesh that is proved to be close to its 32 patches, with curvature computed on the
// patches at the vertices, and a colour for the mean curvature: blue concave, white flat, red convex.

#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>

#include <boost/property_tree/json_parser.hpp>

#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;
using Patch = Bezier_surface_3<NT>;

// The patches of a model file; all that it knows of the format is the list of control points.
std::vector<Patch> read_patches(const std::string& file)
{
  boost::property_tree::ptree model;
  boost::property_tree::read_json(file, model);
  std::vector<Patch> patches;
  for (const auto& surface : model.get_child("surfaces"))
  {
    std::vector<std::vector<Coordinates<NT, 3>>> points;
    for (const auto& row : surface.second.get_child("control_points"))
    {
      points.emplace_back();
      for (const auto& point : row.second)
      {
        points.back().emplace_back();
        int i = 0;
        for (const auto& coordinate : point.second)
          points.back().back().at(i++) = parse_decimal(coordinate.second.data()).value();
      }
    }
    patches.emplace_back(points);
  }
  return patches;
}

int main()
{
  Patch_mesh_options options;
  options.tolerance = 0.005;
  const auto result = mesh_patches(read_patches("data/teapot.json"), options);
  if (!result)
  {
    std::cout << result.refusal().evidence() << '\n';
    return EXIT_FAILURE;
  }
  Shape_mesh teapot = *result;
  const Mesh_report& report = teapot.report;
  std::cout << report.vertices << " vertices, " << report.faces << " triangles, "
            << report.components << " components\ndistance from the patches at most "
            << report.max_face_distance << '\n';
  for (const Refused_place& place : report.refused_places)
    std::cout << "no curvature at (" << place.point[0] << ", " << place.point[1] << ", "
              << place.point[2] << "): " << to_string(place.code) << '\n';

  const Shape_property_maps maps(teapot.surface_mesh);
  auto color = teapot.surface_mesh.add_property_map<Shape_property_maps::Vertex, CGAL::IO::Color>(
    "v:color", CGAL::IO::Color(128, 128, 128)).first;
  for (const auto v : teapot.surface_mesh.vertices())
  {
    const double h = maps.mean_curvature[v], pale = 255 / (1 + std::fabs(h));
    const auto byte = [](double x) { return static_cast<unsigned char>(x); };
    if (maps.regular[v])
      color[v] = CGAL::IO::Color(byte(h > 0 ? 255 : pale), byte(pale), byte(h > 0 ? pale : 255));
  }
  return write_mesh("teapot_colored.ply", teapot.surface_mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
