// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_MESHED_PATCHES_H
#define SHAPE_INTERROGATION_TEST_MESHED_PATCHES_H

// Patches that the tests of meshing and of mesh files use.

#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace meshed_patches {

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;
using Point = Coordinates<Q, 3>;
using Patch = Bezier_surface_3<Q>;
using Points = std::vector<std::vector<Point>>;
using Weights = std::vector<std::vector<Q>>;

// The 32 patches of the model file of the examples.
inline const std::vector<Patch>& teapot()
{
  static const std::vector<Patch> patches = [] {
    std::ifstream file(SHAPE_INTERROGATION_TEST_DATA
                       "/../../../examples/Shape_interrogation/data/teapot.json");
    const auto model = nlohmann::ordered_json::parse(file);
    std::vector<Patch> read;
    for (const auto& surface : model.at("surfaces"))
    {
      Points points;
      for (const auto& row : surface.at("control_points"))
      {
        points.emplace_back();
        for (const auto& p : row)
          points.back().push_back({parse_decimal(p.at(0).get<std::string>()).value(),
                                   parse_decimal(p.at(1).get<std::string>()).value(),
                                   parse_decimal(p.at(2).get<std::string>()).value()});
      }
      read.emplace_back(points);
    }
    return read;
  }();
  return patches;
}

// An eighth of the unit sphere, turned by quarters around the z axis and perhaps mirrored in the
// plane z = 0. The edge u = 1 is collapsed to the pole. S_u x S_v points inward, outward if
// mirrored.
inline Patch sphere_octant(int quarters, bool is_mirrored)
{
  const int circle[3][2] = {{1, 0}, {1, 1}, {0, 1}}, weight[3] = {1, 1, 2};
  Points points(3);
  Weights weights(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      int x = circle[j][0] * circle[i][0], y = circle[j][1] * circle[i][0];
      for (int k = 0; k < quarters; ++k)
      {
        const int old = x;
        x = -y;
        y = old;
      }
      points[i].push_back({Q(x), Q(y), Q(is_mirrored ? -circle[i][1] : circle[i][1])});
      weights[i].push_back(Q(weight[i] * weight[j]));
    }
  return Patch(points, weights);
}

// The whole unit sphere, and which patches must be flipped for outward normals.
inline std::vector<Patch> sphere(std::vector<bool>& flipped)
{
  std::vector<Patch> patches;
  for (int k = 0; k < 8; ++k)
  {
    patches.push_back(sphere_octant(k % 4, k >= 4));
    flipped.push_back(k < 4);
  }
  return patches;
}

// The bilinear patch with these corners, for (u, v) = (0,0), (0,1), (1,0), (1,1).
inline Patch bilinear(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return Patch(Points{{a, b}, {c, d}});
}

} // namespace meshed_patches

#endif // SHAPE_INTERROGATION_TEST_MESHED_PATCHES_H
