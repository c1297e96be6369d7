// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// An inner offset of an ellipsoid, farther than its smallest radius of curvature: in space it
// crosses itself and has cuspidal edges, in six variables it is a smooth closed surface, which is
// meshed. Then the curve in which it meets a plane.

#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_n_space_surface.h>
#include <CGAL/Shape_interrogation/Meshing/trace_n_space_curve.h>

#include <cstdlib>
#include <iostream>
#include <string>

using namespace CGAL::Shape_interrogation;

int main()
{
  const Implicit_entity_3 ellipsoid([](auto x, auto y, auto z) {
    return 4 * x * x + 9 * y * y + 36 * z * z - 36;
  }, "the ellipsoid");
  const N_space_system offset = offset_system(ellipsoid, 1).n_space_system();

  N_space_mesh_options options;
  options.edge_length = 0.15;
  // The point (2,0,0) has the foot point (3,0,0).
  const auto mesh = mesh_n_space_surface(offset, {{2, 0, 0, 3, 0, 0}}, options);
  if (!mesh)
  {
    std::cerr << mesh.refusal().evidence() << '\n';
    return EXIT_FAILURE;
  }
  const Mesh_report& report = mesh->report;
  std::cout << report.vertices << " vertices, Euler characteristic " << report.euler_characteristic
            << ", " << report.boundary_edges << " boundary edges\n";
  for (const N_space_polyline& fold : mesh->folds)
    std::cout << "a cuspidal edge through " << fold.points.size() << " points, "
              << (fold.closed ? "closed\n" : "open\n");
  std::string reason;
  if (!write_mesh("inner_offset.ply", mesh->surface_mesh, reason))
    std::cerr << reason << '\n';

  N_space_curve_options steps;
  steps.step = 0.05;
  // The plane z = 0 contains the long axes: there the offset meets it in a closed curve.
  const auto curve = trace_n_space_curve(offset, {2, 0, 0, 3, 0, 0}, steps,
                                         N_space_condition::fixed(6, 5, 0));
  if (!curve)
    return EXIT_FAILURE;
  std::cout << "the section has " << curve->points.size() << " points: " << curve->ends[1].evidence
            << '\n';
  return report.euler_characteristic == 2 && mesh->folds.size() == 2 && curve->closed
           ? EXIT_SUCCESS : EXIT_FAILURE;
}
