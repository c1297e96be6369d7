// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elber and Cohen's trichotomy of the teapot: which parts of its 32 patches are convex, concave or
// saddle-shaped, with certified areas. That it has no concave part comes out as a theorem.

#include <CGAL/Shape_interrogation.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>
#include <CGAL/Shape_interrogation/Property_surfaces/trichotomy_of_patch.h>

#include <boost/property_tree/json_parser.hpp>
#include <iostream>

using namespace CGAL::Shape_interrogation;
using NT = CGAL::Exact_rational;

// A bicubic patch of a model file; all that is read of it are the control points.
Bezier_surface_3<NT> read_patch(const boost::property_tree::ptree& surface)
{
  std::vector<Coordinates<NT, 3>> points;
  for (const auto& row : surface.get_child("control_points"))
    for (const auto& point : row.second)
    {
      points.emplace_back();
      auto x = points.back().begin();
      for (const auto& coordinate : point.second)
        *x++ = parse_decimal(coordinate.second.data()).value();
    }
  return Bezier_surface_3<NT>(3, 3, points);
}

int main()
{
  boost::property_tree::ptree model;
  boost::property_tree::read_json("data/teapot.json", model);
  bool is_nowhere_concave = true, is_certified = true;
  for (const auto& surface : model.get_child("surfaces"))
  {
    // The patches of the file have S_u x S_v inward, the transposed ones outward.
    const auto parts = trichotomy_of_patch(read_patch(surface.second).transposed());
    if (!parts)
    {
      std::cout << surface.first << ": " << parts.refusal().evidence() << '\n';
      return EXIT_FAILURE;
    }
    std::cout << surface.first << ": convex " << CGAL::to_double(parts->area(Region::CONVEX).lower)
              << ", saddle " << CGAL::to_double(parts->area(Region::SADDLE).lower) << ", "
              << parts->boundary.curves.size() << " parabolic curves";
    if (parts->regularity.verdict != Verdict::YES)
      std::cout << ", collapsed edges " << parts->regularity.edges.size();
    std::cout << '\n';
    is_nowhere_concave = is_nowhere_concave && parts->area(Region::CONCAVE).upper == 0;
    is_certified = is_certified && parts->boundary.has_certified_topology();
  }
  std::cout << (is_nowhere_concave ? "The teapot is nowhere concave: proved.\n" : "Not proved.\n");
  return is_nowhere_concave && is_certified ? EXIT_SUCCESS : EXIT_FAILURE;
}
