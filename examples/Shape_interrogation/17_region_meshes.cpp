// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// A bicubic patch divided into its convex, concave and saddle parts: certified areas in the domain,
// a mesh with the part of each triangle, trimming loops, and a picture of the domain.

#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/IO/write_svg.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_regions.h>

#include <cstdlib>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

int main()
{
  const int heights[4][4] = {{0, 1, -1, 0}, {1, 6, 0, -2}, {-1, 0, -7, 1}, {0, -2, 1, 0}};
  std::vector<std::vector<Coordinates<NT, 3>>> points(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points[i].push_back({NT(i), NT(j), NT(heights[i][j]) / NT(2)});

  const auto result = mesh_trichotomy(Bezier_surface_3<NT>(points));
  if (!result)
  {
    std::cout << result.refusal().evidence() << '\n';
    return EXIT_FAILURE;
  }
  const Trichotomy& parts = result->trichotomy;
  const Region_mesh& regions = result->regions;
  std::cout << parts.boundary.curves.size() << " curves divide the patch, their topology is "
            << (parts.boundary.has_certified_topology() ? "" : "not ") << "proved\n";
  bool is_right = true;
  for (const Region region : {Region::CONVEX, Region::CONCAVE, Region::SADDLE, Region::FLAT})
  {
    const double area = regions.domain.area(static_cast<int>(region)),
                 lower = CGAL::to_double(parts.area(region).lower),
                 upper = CGAL::to_double(parts.area(region).upper);
    std::cout << to_string(region) << ": between " << lower << " and " << upper
              << " of the domain, " << area << " in triangles\n";
    is_right = is_right && lower - 1e-3 < area && area < upper + 1e-3;
  }
  for (const Region_loop& loop : regions.domain.loops)
    std::cout << (loop.signed_area > 0 ? "boundary" : "hole") << " of part " << loop.part << " ("
              << to_string(static_cast<Region>(loop.region)) << "): " << loop.points.size()
              << " points\n";

  Svg_options options;
  options.title = "Convex, concave and saddle parts";
  options.region_names = trichotomy_names();
  std::string reason;
  is_right = is_right && write_mesh("trichotomy.ply", regions.mesh.surface_mesh, reason) &&
             write_svg("trichotomy.svg", regions.domain, parts.boundary, options, reason);
  std::cout << (is_right ? "trichotomy.ply and trichotomy.svg are written\n" : reason);
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
