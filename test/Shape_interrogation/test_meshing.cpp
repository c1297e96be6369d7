// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes of patches: topology, common edges, degenerate patches, certified distances, properties
// against exact evaluation, limits and cancelling.

#include "meshed_patches.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace meshed_patches;
using Mesh = Shape_mesh::Surface_mesh;
using Vertex = Mesh::Vertex_index;
using Position = std::array<double, 3>;

Position position(const Mesh& mesh, Vertex v)
{
  const Shape_mesh::Point_3& p = mesh.point(v);
  return {p.x(), p.y(), p.z()};
}

Shape_mesh meshed(const std::vector<Patch>& patches, const Patch_mesh_options& options)
{
  const Result<Shape_mesh> mesh = mesh_patches(patches, options);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.refusal().evidence());
  return mesh ? *mesh : Shape_mesh();
}

Patch_mesh_options with_tolerance(double tolerance)
{
  Patch_mesh_options options;
  options.tolerance = tolerance;
  return options;
}

const Shape_mesh& teapot_mesh()
{
  static const Shape_mesh mesh = meshed(teapot(), with_tolerance(0.02));
  return mesh;
}

// Every triangle has an area, and the report is that of the mesh.
void expect_sound(const Shape_mesh& mesh)
{
  const Mesh& m = mesh.surface_mesh;
  EXPECT_TRUE(m.is_valid(false));
  EXPECT_EQ(mesh.report.vertices, m.number_of_vertices());
  EXPECT_EQ(mesh.report.faces, m.number_of_faces());
  EXPECT_TRUE(mesh.report.face_distance_certified);
  EXPECT_TRUE(mesh.report.vertex_distance_certified);
  EXPECT_LE(mesh.report.max_vertex_distance, mesh.report.max_face_distance);
  EXPECT_LE(mesh.report.max_face_distance, mesh.report.tolerance);
  for (const auto f : m.faces())
  {
    const auto h = m.halfedge(f);
    const auto &a = m.point(m.source(h)), &b = m.point(m.target(h)),
               &c = m.point(m.target(m.next(h)));
    EXPECT_FALSE(CGAL::collinear(a, b, c)) << "face " << f;
  }
}

// The number of pairs of boundary edges that have the same ends: places that are not watertight.
std::size_t open_seams(const Mesh& mesh)
{
  std::map<std::set<Position>, int> seen;
  std::size_t seams = 0;
  for (const auto e : mesh.edges())
    if (mesh.is_border(e))
      seams += seen[{position(mesh, mesh.vertex(e, 0)), position(mesh, mesh.vertex(e, 1))}]++;
  return seams;
}

TEST(Mesh_patches, Teapot_is_watertight_where_its_patches_meet)
{
  const Shape_mesh& mesh = teapot_mesh();
  expect_sound(mesh);
  EXPECT_TRUE(mesh.report.manifold);
  EXPECT_EQ(mesh.report.components, 4u); // body, handle, spout, lid
  EXPECT_EQ(mesh.report.euler_characteristic, 2); // disk, tube, tube, disk
  EXPECT_EQ(open_seams(mesh.surface_mesh), 0u);
  Mesh copy = mesh.surface_mesh;
  const Patch_property_maps where(copy);
  std::set<int> patches;
  for (const auto f : copy.faces())
    patches.insert(where.face_patch[f]);
  EXPECT_EQ(patches.size(), teapot().size());
}

TEST(Mesh_patches, Teapot_poles_have_a_normal_and_are_reported)
{
  Shape_mesh mesh = teapot_mesh();
  const Shape_property_maps maps(mesh.surface_mesh);
  ASSERT_EQ(mesh.report.refused_places.size(), 2u);
  for (const Refused_place& place : mesh.report.refused_places)
  {
    EXPECT_EQ(place.code, Refusal_code::IRREGULAR_PARAMETRISATION);
    const Vertex v(static_cast<Mesh::size_type>(place.vertex));
    EXPECT_FALSE(maps.regular[v]);
    EXPECT_EQ(maps.gaussian_curvature[v], 0);
    // The patches are oriented inward.
    EXPECT_EQ(maps.normal[v], Shape_mesh::Vector_3(0, 0, place.point[2] > 1 ? -1 : 1));
  }
  std::size_t irregular = 0;
  for (const Vertex v : mesh.surface_mesh.vertices())
    irregular += !maps.regular[v];
  EXPECT_EQ(irregular, 2u);
}

TEST(Mesh_patches, Patches_one_by_one_have_the_vertices_of_the_whole)
{
  Shape_mesh whole = teapot_mesh();
  const Patch_property_maps where(whole.surface_mesh);
  std::vector<std::set<Position>> in_whole(teapot().size());
  for (const auto f : whole.surface_mesh.faces())
    for (const Vertex v : whole.surface_mesh.vertices_around_face(whole.surface_mesh.halfedge(f)))
      in_whole[where.face_patch[f]].insert(position(whole.surface_mesh, v));
  for (std::size_t i = 0; i < teapot().size(); ++i)
  {
    const Shape_mesh alone = meshed({teapot()[i]}, with_tolerance(0.02));
    EXPECT_EQ(alone.report.components, 1u);
    EXPECT_EQ(alone.report.euler_characteristic, 1);
    std::set<Position> vertices;
    for (const Vertex v : alone.surface_mesh.vertices())
      vertices.insert(position(alone.surface_mesh, v));
    EXPECT_EQ(vertices, in_whole[i]) << "patch " << i;
  }
}

TEST(Mesh_patches, Properties_are_those_of_the_exact_patch)
{
  Shape_mesh mesh = teapot_mesh();
  const Shape_property_maps maps(mesh.surface_mesh);
  const Patch_property_maps where(mesh.surface_mesh);
  std::size_t compared = 0;
  for (const Vertex v : mesh.surface_mesh.vertices())
  {
    if (v.idx() % 7 != 0 || !maps.regular[v])
      continue;
    ++compared;
    const Patch& patch = teapot()[where.vertex_patch[v]];
    const auto uv = where.parameter[v];
    const auto shape = patch({Q(uv.x()), Q(uv.y())});
    ASSERT_TRUE(shape);
    const double k = number_cast<double>(gaussian_curvature(*shape));
    const double h = std::sqrt(number_cast<double>(squared_mean_curvature(*shape))) *
                     sign_of_mean_curvature(*shape);
    const double scale = (std::max)(std::abs(maps.kmin[v]), std::abs(maps.kmax[v]));
    EXPECT_NEAR(maps.gaussian_curvature[v], k, 1e-12 * scale * scale);
    EXPECT_NEAR(maps.mean_curvature[v], h, 1e-12 * scale);
    EXPECT_NEAR(maps.kmin[v] + maps.kmax[v], 2 * h, 1e-12 * scale);
    EXPECT_NEAR(maps.kmin[v] * maps.kmax[v], k, 1e-12 * scale * scale);
    EXPECT_LE(maps.kmin[v], maps.kmax[v]);
    const auto cast = shape->cast<double>();
    const auto n = maps.normal[v], a = maps.direction_min[v], b = maps.direction_max[v];
    const auto as_coordinates = [](const auto& x) {
      return Coordinates<double, 3>{x.x(), x.y(), x.z()};
    };
    EXPECT_NEAR(normal_curvature(cast, as_coordinates(a)), maps.kmin[v], 1e-11 * scale);
    EXPECT_NEAR(normal_curvature(cast, as_coordinates(b)), maps.kmax[v], 1e-11 * scale);
    EXPECT_NEAR((CGAL::cross_product(a, b) - n).squared_length(), 0, 1e-28);
    const double length = std::sqrt(cast.normal_squared_length());
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(n[d], cast.normal()[d] / length, 1e-13);
  }
  EXPECT_GT(compared, 300u);
}

// The distance of a point from a patch, by Gauss-Newton steps from parameters nearby.
double distance_from(const Bezier_surface_3<double>& patch, const Position& p,
                     std::array<double, 2> uv)
{
  double best = HUGE_VAL;
  for (int step = 0; step < 8; ++step)
  {
    const auto s = patch.derivatives(uv);
    if (!s)
      break;
    const Position r{p[0] - s->s[0], p[1] - s->s[1], p[2] - s->s[2]};
    best = (std::min)(best, std::hypot(r[0], r[1], r[2]));
    const auto dot = [](const Position& a, const Position& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double e = dot(s->u, s->u), f = dot(s->u, s->v), g = dot(s->v, s->v);
    const double a = dot(r, s->u), b = dot(r, s->v), d = e * g - f * f;
    if (!(d > 0))
      break;
    uv = {std::clamp(uv[0] + (a * g - b * f) / d, 0.0, 1.0),
          std::clamp(uv[1] + (b * e - a * f) / d, 0.0, 1.0)};
  }
  return best;
}

TEST(Mesh_patches, Certified_distance_holds_at_samples_and_is_not_empty)
{
  Shape_mesh mesh = teapot_mesh();
  const Mesh& m = mesh.surface_mesh;
  const Patch_property_maps where(mesh.surface_mesh);
  std::vector<Bezier_surface_3<double>> patches;
  for (const Patch& patch : teapot())
    patches.push_back(patch.cast<double>());
  double largest = 0;
  for (const auto f : m.faces())
  {
    std::vector<Vertex> v;
    for (const Vertex x : m.vertices_around_face(m.halfedge(f)))
      v.push_back(x);
    const int patch = where.face_patch[f];
    const bool all_here = std::all_of(v.begin(), v.end(), [&](Vertex x) {
      return where.vertex_patch[x] == patch;
    });
    if (!all_here)
      continue;
    for (const std::array<double, 3>& l : {std::array<double, 3>{1. / 3, 1. / 3, 1. / 3},
                                           {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}})
    {
      Position p{0, 0, 0};
      std::array<double, 2> uv{0, 0};
      for (int k = 0; k < 3; ++k)
      {
        for (int d = 0; d < 3; ++d)
          p[d] += l[k] * m.point(v[k])[d];
        uv[0] += l[k] * where.parameter[v[k]].x();
        uv[1] += l[k] * where.parameter[v[k]].y();
      }
      largest = (std::max)(largest, distance_from(patches[patch], p, uv));
    }
  }
  EXPECT_LE(largest, mesh.report.max_face_distance);
  EXPECT_GE(largest, 0.2 * mesh.report.max_face_distance);
}

TEST(Mesh_patches, No_point_of_a_patch_is_far_from_the_mesh)
{
  const Patch& patch = teapot()[20]; // with a collapsed edge
  const Shape_mesh mesh = meshed({patch}, with_tolerance(0.02));
  const Mesh& m = mesh.surface_mesh;
  std::vector<Shape_mesh::Kernel::Triangle_3> triangles;
  for (const auto f : m.faces())
  {
    const auto h = m.halfedge(f);
    triangles.emplace_back(m.point(m.source(h)), m.point(m.target(h)),
                           m.point(m.target(m.next(h))));
  }
  const Bezier_surface_3<double> rounded = patch.cast<double>();
  double largest = 0;
  for (int i = 0; i <= 12; ++i)
    for (int j = 0; j <= 12; ++j)
    {
      const auto p = *rounded.point({i * i / 144.0, j / 12.0}); // dense at the pole
      double least = HUGE_VAL;
      for (const auto& t : triangles)
        least = (std::min)(least, CGAL::squared_distance(Shape_mesh::Point_3(p[0], p[1], p[2]), t));
      largest = (std::max)(largest, std::sqrt(least));
    }
  EXPECT_LE(largest, mesh.report.max_face_distance);
}

TEST(Mesh_patches, Folds_and_random_nets_have_meshes)
{
  std::vector<Patch> patches;
  std::mt19937 random(20260);
  std::cout << "seed 20260\n";
  for (int k = 0; k < 12; ++k)
  {
    Points points(4);
    for (auto& row : points)
      for (int j = 0; j < 4; ++j)
        row.push_back({Q(int(random() % 4)), Q(int(random() % 4)), Q(int(random() % 4))});
    patches.emplace_back(points);
  }
  // Whitney's umbrella (u, u v, v^2) on [-1, 1]^2: singular at its centre.
  patches.push_back(Patch(Points{
    {{Q(-1), Q(1), Q(1)}, {Q(-1), Q(0), Q(-1)}, {Q(-1), Q(-1), Q(1)}},
    {{Q(1), Q(-1), Q(1)}, {Q(1), Q(0), Q(-1)}, {Q(1), Q(1), Q(1)}}}));
  for (const Patch& patch : patches)
    for (const double angle : {20.0, 0.0})
    {
      Patch_mesh_options options = with_tolerance(0.05);
      options.max_angle = angle;
      const Shape_mesh mesh = meshed({patch}, options);
      EXPECT_EQ(mesh.report.components, 1u);
      EXPECT_EQ(mesh.report.euler_characteristic, 1);
      EXPECT_LE(mesh.report.max_face_distance, 0.05);
    }
}

TEST(Mesh_patches, Unit_of_length_does_not_matter)
{
  const auto scaled = [](const Q& scale) {
    Points points(4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
      {
        Point p = teapot()[5].control_point(i, j);
        for (Q& x : p)
          x = x * scale;
        points[i].push_back(p);
      }
    return Patch(points);
  };
  const Shape_mesh mesh = meshed({teapot()[5]}, Patch_mesh_options());
  for (const int power : {-300, 300})
  {
    const Q two_power(std::ldexp(1.0, power));
    const Shape_mesh other = meshed({scaled(two_power)}, Patch_mesh_options());
    // Edges of equal length are ordered by rounding.
    EXPECT_NEAR(double(other.report.faces), double(mesh.report.faces), 0.05 * mesh.report.faces);
  }
}

TEST(Mesh_patches, Sphere_of_rational_patches_with_poles)
{
  Patch_mesh_options options = with_tolerance(0.005);
  const std::vector<Patch> patches = sphere(options.flipped);
  Shape_mesh mesh = meshed(patches, options);
  expect_sound(mesh);
  EXPECT_TRUE(mesh.report.manifold);
  EXPECT_EQ(mesh.report.boundary_edges, 0u);
  EXPECT_EQ(mesh.report.components, 1u);
  EXPECT_EQ(mesh.report.euler_characteristic, 2);
  EXPECT_EQ(mesh.report.refused_places.size(), 2u);
  const Shape_property_maps maps(mesh.surface_mesh);
  for (const Vertex v : mesh.surface_mesh.vertices())
  {
    const Shape_mesh::Vector_3 p = mesh.surface_mesh.point(v) - CGAL::ORIGIN;
    EXPECT_NEAR(p.squared_length(), 1, 1e-15);
    EXPECT_NEAR((maps.normal[v] - p).squared_length(), 0, 1e-28);
    EXPECT_EQ(maps.direction_min[v], CGAL::NULL_VECTOR); // an umbilic, or a pole
    if (maps.regular[v])
    {
      EXPECT_NEAR(maps.gaussian_curvature[v], 1, 1e-12);
      EXPECT_NEAR(maps.kmin[v], 1, 1e-12);
      EXPECT_NEAR(maps.kmax[v], 1, 1e-12);
    }
  }
  for (const auto f : mesh.surface_mesh.faces())
  {
    const auto h = mesh.surface_mesh.halfedge(f);
    const auto point = [&](auto x) { return mesh.surface_mesh.point(mesh.surface_mesh.target(x)); };
    EXPECT_EQ(CGAL::orientation(point(h), point(mesh.surface_mesh.next(h)),
                                point(mesh.surface_mesh.prev(h)), Shape_mesh::Point_3(0, 0, 0)),
              CGAL::NEGATIVE);
  }
}

TEST(Mesh_patches, Common_edges_may_be_reversed_and_rescaled)
{
  const Points bent{{{Q(0), Q(0), Q(0)}, {Q(0), Q(1), Q(0)}},
                    {{Q(1), Q(0), Q(2)}, {Q(1), Q(1), Q(2)}},
                    {{Q(3), Q(0), Q(0)}, {Q(3), Q(1), Q(1)}}};
  const Patch a(bent, Weights{{Q(1), Q(1)}, {Q(2), Q(3)}, {Q(1), Q(5)}});
  // Its edge v = 0 is the edge v = 1 of a, backwards, with three times the weights.
  Points other;
  for (int i = 0; i < 3; ++i)
    other.push_back({bent[2 - i][1], {Q(2 - i), Q(3), Q(i)}});
  const Patch b(other, Weights{{Q(15), Q(1)}, {Q(9), Q(2)}, {Q(3), Q(1)}});
  Patch_mesh_options options = with_tolerance(1e-3);
  options.flipped = {false, true};
  for (const bool is_transposed : {false, true})
  {
    const Shape_mesh mesh = meshed({a, is_transposed ? b.transposed() : b}, options);
    expect_sound(mesh);
    EXPECT_EQ(open_seams(mesh.surface_mesh) == 0, !is_transposed); // then orientations disagree
    EXPECT_EQ(mesh.report.manifold, !is_transposed);
    EXPECT_EQ(mesh.report.components, is_transposed ? 2u : 1u);
    EXPECT_EQ(mesh.report.euler_characteristic, is_transposed ? 2 : 1);
  }
}

TEST(Mesh_patches, Three_patches_at_one_edge_are_all_kept)
{
  const Point a{Q(0), Q(0), Q(0)}, b{Q(0), Q(0), Q(1)};
  std::vector<Patch> pages;
  for (int k = 0; k < 3; ++k)
    pages.push_back(bilinear(a, b, {Q(k - 1), Q(1), Q(0)}, {Q(k - 1), Q(1), Q(1)}));
  const Shape_mesh mesh = meshed(pages, with_tolerance(0.1));
  expect_sound(mesh);
  EXPECT_FALSE(mesh.report.manifold);
  EXPECT_EQ(mesh.report.faces, 24u);
  EXPECT_EQ(mesh.report.components, 3u);
}

TEST(Mesh_patches, Closed_patch_is_a_tube_at_every_tolerance)
{
  // Its edges u = 0 and u = 1 are the same curve, its edges along u are closed.
  const int ring[6][2] = {{1, 0}, {1, 3}, {-3, 2}, {-3, -2}, {1, -3}, {1, 0}};
  Points points;
  for (const auto& p : ring)
    points.push_back({{Q(p[0]), Q(p[1]), Q(0)}, {Q(p[0]), Q(p[1]), Q(3)}});
  for (const double tolerance : {1e-3, 0.1, 100.0})
  {
    Patch_mesh_options options = with_tolerance(tolerance);
    options.max_angle = 0;
    const Shape_mesh mesh = meshed({Patch(points)}, options);
    expect_sound(mesh);
    EXPECT_TRUE(mesh.report.manifold);
    EXPECT_EQ(mesh.report.components, 1u);
    EXPECT_EQ(mesh.report.euler_characteristic, 0);
  }
}

TEST(Mesh_patches, Plane_needs_eight_triangles)
{
  Shape_mesh mesh = meshed({bilinear({Q(0), Q(0), Q(0)}, {Q(0), Q(1), Q(0)}, {Q(1), Q(0), Q(0)},
                                     {Q(1), Q(1), Q(0)})}, with_tolerance(1e-6));
  expect_sound(mesh);
  EXPECT_EQ(mesh.report.faces, 8u);
  EXPECT_EQ(mesh.report.max_vertex_distance, 0);
  const Shape_property_maps maps(mesh.surface_mesh);
  for (const Vertex v : mesh.surface_mesh.vertices())
  {
    EXPECT_EQ(maps.kmin[v], 0);
    EXPECT_EQ(maps.kmax[v], 0);
    EXPECT_EQ(maps.direction_max[v], CGAL::NULL_VECTOR);
    EXPECT_EQ(maps.normal[v], Shape_mesh::Vector_3(0, 0, 1));
  }
}

TEST(Mesh_patches, Edge_lengths_and_angles_are_bounded)
{
  Patch_mesh_options options = with_tolerance(0.1);
  options.max_edge_length = 0.2;
  options.max_angle = 10;
  Shape_mesh mesh = meshed({teapot()[5]}, options);
  const Mesh& m = mesh.surface_mesh;
  const Shape_property_maps maps(mesh.surface_mesh);
  for (const auto e : m.edges())
  {
    const Vertex a = m.vertex(e, 0), b = m.vertex(e, 1);
    EXPECT_LE(CGAL::squared_distance(m.point(a), m.point(b)), 0.04);
    const bool is_inner = !m.is_border(a) && !m.is_border(b);
    if (is_inner && CGAL::squared_distance(m.point(a), m.point(b)) > 0.01)
    {
      EXPECT_GE(maps.normal[a] * maps.normal[b], std::cos(10 * CGAL_PI / 180) - 1e-12);
    }
  }
}

TEST(Mesh_patches, The_same_mesh_every_time)
{
  const Shape_mesh a = meshed({teapot()[0], teapot()[1]}, with_tolerance(0.01));
  const Shape_mesh b = meshed({teapot()[0], teapot()[1]}, with_tolerance(0.01));
  ASSERT_EQ(a.report.vertices, b.report.vertices);
  ASSERT_EQ(a.report.faces, b.report.faces);
  for (const Vertex v : a.surface_mesh.vertices())
    EXPECT_EQ(a.surface_mesh.point(v), b.surface_mesh.point(v));
  for (const auto f : a.surface_mesh.faces())
    EXPECT_EQ(a.surface_mesh.target(a.surface_mesh.halfedge(f)),
              b.surface_mesh.target(b.surface_mesh.halfedge(f)));
}

Refusal_code refusal_of(const std::vector<Patch>& patches, const Patch_mesh_options& options)
{
  const auto mesh = mesh_patches(patches, options);
  EXPECT_FALSE(mesh);
  if (!mesh)
  {
    EXPECT_FALSE(mesh.refusal().evidence().empty());
    return mesh.refusal().code();
  }
  return Refusal_code::UNDECIDED;
}

TEST(Mesh_patches, Patches_without_a_surface_are_refused)
{
  const Point o{Q(0), Q(0), Q(0)}, x{Q(1), Q(0), Q(0)}, y{Q(0), Q(1), Q(0)}, z{Q(0), Q(0), Q(1)};
  const Point x2{Q(2), Q(0), Q(0)}, x3{Q(3), Q(0), Q(0)};
  const auto options = with_tolerance(0.01);
  EXPECT_EQ(refusal_of({bilinear(o, x, x2, x3)}, options), Refusal_code::IRREGULAR_PARAMETRISATION);
  EXPECT_EQ(refusal_of({bilinear(x, x, x, x), bilinear(o, x, y, z)}, options),
            Refusal_code::IRREGULAR_PARAMETRISATION);
  EXPECT_EQ(refusal_of({Patch(Points{{o, o, o}, {o, x, y}, {o, y, z}})}, options),
            Refusal_code::IRREGULAR_PARAMETRISATION); // two edges that meet are collapsed
  EXPECT_EQ(refusal_of({}, options), Refusal_code::LIMIT_EXCEEDED);
  const Weights with_zero{{Q(1), Q(1)}, {Q(1), Q(-1)}};
  EXPECT_EQ(refusal_of({Patch(Points{{o, x}, {y, z}}, with_zero)}, options), Refusal_code::POLE);
}

TEST(Mesh_patches, Limits_are_kept)
{
  Patch_mesh_options options = with_tolerance(1e-3);
  options.max_vertices = 1000;
  EXPECT_EQ(refusal_of(teapot(), options), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(refusal_of(teapot(), with_tolerance(1e-16)), Refusal_code::LIMIT_EXCEEDED);
  Q huge(10);
  for (int k = 0; k < 9; ++k)
    huge = huge * huge;
  EXPECT_EQ(refusal_of({bilinear({Q(0), Q(0), Q(0)}, {huge, Q(0), Q(0)}, {Q(0), Q(1), Q(0)},
                                 {Q(1), Q(1), Q(0)})}, with_tolerance(1)),
            Refusal_code::LIMIT_EXCEEDED);
}

TEST(Mesh_patches, Progress_cancels)
{
  for (const int calls : {0, 3, 20})
  {
    int left = calls;
    const auto mesh = mesh_patches(teapot(), with_tolerance(1e-3),
                                   [&](std::size_t done, std::size_t total) {
                                     EXPECT_LE(done, total);
                                     EXPECT_EQ(total, teapot().size());
                                     return left-- > 0;
                                   });
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.refusal().code(), Refusal_code::CANCELLED);
    EXPECT_EQ(left, -1); // not asked again
  }
}

TEST(Color_by_property, Signs_have_their_colours)
{
  Shape_mesh mesh = teapot_mesh();
  Mesh& m = mesh.surface_mesh;
  EXPECT_EQ(color_by_property(m, "v:no_such_property"), 0);
  const double range = color_by_property(m, "v:gaussian_curvature");
  EXPECT_GT(range, 0);
  const Shape_property_maps maps(m);
  const auto colors = m.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for (const Vertex v : m.vertices())
  {
    const double k = maps.gaussian_curvature[v];
    const CGAL::IO::Color c = colors[v];
    if (!maps.regular[v])
    {
      EXPECT_EQ(c, CGAL::IO::Color(128, 128, 128));
    }
    else if (std::abs(k) > range / 10)
    {
      EXPECT_EQ(c.red() > c.blue(), k > 0);
    }
  }
  // The full colours are on a tenth of the area, up to one vertex.
  double full = 0, all = 0;
  for (const auto f : m.faces())
    for (const Vertex v : m.vertices_around_face(m.halfedge(f)))
    {
      const double area = CGAL::Polygon_mesh_processing::face_area(f, m);
      all += area;
      full += std::abs(maps.gaussian_curvature[v]) > range ? area : 0;
    }
  EXPECT_LE(full, 0.1 * all);
  EXPECT_GT(full, 0.08 * all);
}

} // namespace
