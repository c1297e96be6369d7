// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The Utah teapot as a mesh that is proved to be close to its 32 patches, with their curvatures at
// the vertices, and a colour for the Gaussian curvature: blue for saddles, red for domes and bowls.

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // Boost's JSON reader wants to be told
#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>

#include <boost/property_tree/json_parser.hpp>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

// The bicubic patches of a model file; all that is read of it are the control points.
std::vector<Bezier_surface_3<NT>> read_patches(const std::string& file)
{
  boost::property_tree::ptree model;
  boost::property_tree::read_json(file, model);
  std::vector<Bezier_surface_3<NT>> patches;
  for (const auto& surface : model.get_child("surfaces"))
  {
    std::vector<Coordinates<NT, 3>> points;
    for (const auto& row : surface.second.get_child("control_points"))
      for (const auto& point : row.second)
      {
        points.emplace_back();
        auto x = points.back().begin();
        for (const auto& coordinate : point.second)
          *x++ = parse_decimal(coordinate.second.data()).value();
      }
    patches.emplace_back(3, 3, points);
  }
  return patches;
}

int main()
{
  const auto result = mesh_patches(read_patches("data/teapot.json")); // to 1/1000 of its size
  if (!result)
  {
    std::cout << result.refusal().evidence() << '\n';
    return EXIT_FAILURE;
  }
  Shape_mesh teapot = *result;
  const Mesh_report& report = teapot.report;
  std::cout << report.vertices << " vertices, " << report.faces << " triangles, at most "
            << report.max_face_distance << " from the patches\n";
  for (const Refused_place& place : report.refused_places)
    std::cout << "no curvature at (" << place.point[0] << ", " << place.point[1] << ", "
              << place.point[2] << "): " << to_string(place.code) << '\n';

  const double range = color_by_property(teapot.surface_mesh, "v:gaussian_curvature");
  std::cout << "colours from " << -range << " (blue) to " << range << " (red)\n";
  return write_mesh("teapot_with_colors.ply", teapot.surface_mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
