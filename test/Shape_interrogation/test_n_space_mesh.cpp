// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes of surfaces in n-space: against closed forms at every vertex, their topology, bounds,
// folds, and what is refused.

#include "n_space_meshes.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Constraints/equal_distance.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/parametric_graph.h>
#include <CGAL/Shape_interrogation/Constraints/rolling_ball.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_n_space_surface.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using Mesh = Shape_mesh::Surface_mesh;

Result<N_space_mesh> mesh_of(const N_space_system& system, const std::vector<Point>& starts,
                             double edge_length, const std::vector<N_space_bound>& bounds = {})
{
  N_space_mesh_options options;
  options.edge_length = edge_length;
  options.bounds = bounds;
  return mesh_n_space_surface(system, starts, options);
}

N_space_bound range(const N_space_system& system, const std::string& variable, const Q& lower,
                    const Q& upper)
{
  for (int i = 0; i < system.number_of_variables(); ++i)
    if (system.variables()[i] == variable)
      return {i, lower, upper};
  ADD_FAILURE() << "there is no variable " << variable;
  return {0, lower, upper};
}

void expect_whole(const N_space_mesh& mesh, int euler_characteristic, std::size_t components)
{
  EXPECT_TRUE(mesh.report.manifold);
  EXPECT_EQ(mesh.report.euler_characteristic, euler_characteristic);
  EXPECT_EQ(mesh.report.components, components);
  EXPECT_TRUE(mesh.rims.empty());
  EXPECT_TRUE(mesh.stops.empty());
  EXPECT_EQ(mesh.report.unmeasured_samples, 0u);
  EXPECT_LE(mesh.max_turning, 0.6); // about 0.5 was asked for
  EXPECT_LE(mesh.max_residual, 1e-12);
  EXPECT_TRUE(mesh.surface_mesh.is_valid());
}

// Calls f with the n-space point, K and H at every vertex with data, and counts them.
template <class Function>
std::size_t for_each_vertex(const N_space_mesh& result, Function f)
{
  Mesh mesh = result.surface_mesh;
  const Shape_property_maps maps(mesh);
  const N_space_property_maps more(mesh);
  std::size_t count = 0;
  for (const auto v : mesh.vertices())
    if (maps.regular[v])
    {
      f(more.n_space_point[v], maps.gaussian_curvature[v], maps.mean_curvature[v]);
      ++count;
    }
  return count;
}

Implicit_entity_3 plane_z() { return Implicit_entity_3([](auto, auto, auto z) { return z; }); }

// The curvatures of the offset from those of the base at the foot point.
template <class Function>
void expect_offset(const Function& f, double d, const std::vector<Point>& starts,
                   const std::vector<std::array<Q, 2>>& z_range, int euler_characteristic)
{
  const N_space_system system =
    offset_system(Implicit_entity_3(f), Q(d)).n_space_system();
  std::vector<N_space_bound> bounds;
  for (const auto& z : z_range)
    bounds.push_back({2, z[0], z[1]});
  const auto mesh = mesh_of(system, starts, 0.3, bounds);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, euler_characteristic, 1);
  const Implicit_surface_3<Function> base(f);
  const std::size_t n = for_each_vertex(*mesh, [&](const Point& p, double k, double h) {
    const auto s = base(Coordinates<double, 3>{p[3], p[4], p[5]});
    ASSERT_TRUE(s);
    double side = 0, square = 0;
    for (int i = 0; i < 3; ++i)
    {
      side += (p[i] - p[3 + i]) * s->normal()[i];
      square += (p[i] - p[3 + i]) * (p[i] - p[3 + i]);
    }
    const double t = side > 0 ? std::sqrt(square) : -std::sqrt(square);
    EXPECT_NEAR(std::fabs(t), d, 1e-10);
    const double kb = gaussian_curvature(*s), hb = mean_curvature(*s);
    const double factor = 1 + 2 * t * hb + t * t * kb;
    EXPECT_NEAR(k, kb / factor, 1e-10 * (1 + std::fabs(k)));
    EXPECT_NEAR(std::fabs(h), std::fabs((hb + t * kb) / factor), 1e-10 * (1 + std::fabs(h)));
  });
  EXPECT_GT(n, 100u);
}

} // namespace

TEST(N_space_mesh, Offsets_of_quadrics_and_torus)
{
  expect_offset([](auto x, auto y, auto z) { return x * x + y * y + z * z - 4; }, 0.5,
                {{2.5, 0, 0, 2, 0, 0}}, {}, 2);
  expect_offset([](auto x, auto y, auto) { return x * x + y * y - 1; }, 0.5,
                {{1.5, 0, 0, 1, 0, 0}}, {{{-1, 1}}}, 0);
  expect_offset([](auto x, auto y, auto z) {
    auto a = x * x + y * y + z * z + 3;
    return a * a - 16 * (x * x + y * y);
  }, 0.25, {{3.25, 0, 0, 3, 0, 0}}, {}, 0);
  expect_offset([](auto x, auto y, auto z) { return 4 * x * x + 9 * y * y + 36 * z * z - 36; },
                0.5, {{3.5, 0, 0, 3, 0, 0}}, {}, 2);
}

TEST(N_space_mesh, Point_and_plane_are_equally_far_from_a_paraboloid)
{
  const N_space_system system = equal_distance(Constraint_point_3{"a", {0, 0, 1}}, plane_z())
                                  .n_space_system();
  const auto mesh = mesh_of(system, {Point(system.number_of_variables(), 0.3)}, 0.2,
                            {range(system, "x", -1, 1), range(system, "y", -1, 1)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 1, 1);
  const std::size_t n = for_each_vertex(*mesh, [&](const Point& p, double k, double h) {
    const double r2 = p[0] * p[0] + p[1] * p[1]; // z = (r^2 + 1) / 2
    EXPECT_NEAR(2 * p[2], r2 + 1, 1e-10);
    EXPECT_NEAR(k, 1 / ((1 + r2) * (1 + r2)), 1e-10);
    EXPECT_NEAR(std::fabs(h), (2 + r2) / (2 * std::pow(1 + r2, 1.5)), 1e-10);
  });
  EXPECT_EQ(n, mesh->report.vertices);
}

TEST(N_space_mesh, Two_lines_are_equally_far_from_a_hyperbolic_paraboloid)
{
  const Curve_entity_3 a([](auto t) { using T = decltype(t); return std::array<T, 3>{t, 0, 1}; });
  const Curve_entity_3 b([](auto t) { using T = decltype(t); return std::array<T, 3>{0, t, -1}; });
  const N_space_system system = equal_distance(a, b).n_space_system();
  const auto mesh = mesh_of(system, {Point(system.number_of_variables(), 0.1)}, 0.2,
                            {range(system, "x", -1, 1), range(system, "y", -1, 1)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 1, 1);
  const std::size_t n = for_each_vertex(*mesh, [&](const Point& p, double k, double) {
    const double x = p[0], y = p[1]; // y^2 + (z-1)^2 = x^2 + (z+1)^2
    EXPECT_NEAR(4 * p[2], y * y - x * x, 1e-10);
    EXPECT_NEAR(k, -0.25 / std::pow(1 + (x * x + y * y) / 4, 2), 1e-10);
  });
  EXPECT_EQ(n, mesh->report.vertices);
}

TEST(N_space_mesh, Sphere_and_plane_are_equally_far_from_a_paraboloid)
{
  // From the unit sphere around (0,0,3) and the plane z = 0: |p - (0,0,3)| - 1 = z.
  const Implicit_entity_3 sphere([](auto x, auto y, auto z) {
    return x * x + y * y + (z - 3) * (z - 3) - 1;
  });
  const N_space_system system = equal_distance(sphere, plane_z()).n_space_system();
  const auto mesh = mesh_of(system, {{0.1, 0, 1, 0, 0, 2, 0.1, 0, 0}}, 0.2,
                            {range(system, "x", -1, 1), range(system, "y", -1, 1)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 1, 1);
  for_each_vertex(*mesh, [&](const Point& p, double, double) {
    EXPECT_NEAR(8 * p[2], p[0] * p[0] + p[1] * p[1] + 8, 1e-10);
  });
}

TEST(N_space_mesh, Rolling_balls)
{
  const Implicit_entity_3 wall([](auto x, auto, auto) { return x; });
  const Implicit_entity_3 sphere([](auto x, auto y, auto z) {
    return x * x + y * y + (z + 2) * (z + 2) - 16;
  });
  // Plane and sphere: the ball's centre is at the height 1 and at the distance 5 from (0,0,-2).
  const N_space_system torus = rolling_ball(plane_z(), sphere, 1).n_space_system();
  const auto mesh =
    mesh_of(torus, {{4.6, 0, 1.8, 4, 0, 1, 4, 0, 0, 3.2, 0, 0.4}}, 0.3);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 0, 1);
  const std::size_t n = for_each_vertex(*mesh, [&](const Point& p, double k, double) {
    const double r = std::hypot(p[0], p[1]);
    EXPECT_NEAR((r - 4) * (r - 4) + (p[2] - 1) * (p[2] - 1), 1, 1e-10);
    EXPECT_NEAR(k, (r - 4) / r, 1e-10);
  });
  EXPECT_EQ(n, mesh->report.vertices);

  const N_space_system tube = rolling_ball(plane_z(), wall, 1).n_space_system();
  const auto tube_mesh = mesh_of(tube, {{0.3, 0, 0.3, 1, 0, 1, 1, 0, 0, 0, 0, 1}}, 0.2,
                                 {range(tube, "y", -1, 1)});
  ASSERT_TRUE(tube_mesh) << tube_mesh.refusal().evidence();
  expect_whole(*tube_mesh, 0, 1);
  for_each_vertex(*tube_mesh, [&](const Point& p, double k, double h) {
    EXPECT_NEAR((p[0] - 1) * (p[0] - 1) + (p[2] - 1) * (p[2] - 1), 1, 1e-10);
    EXPECT_NEAR(k, 0, 1e-10);
    EXPECT_NEAR(std::fabs(h), 0.5, 1e-10);
  });
}

TEST(N_space_mesh, Rolling_ball_between_parallel_cylinders_is_a_cylinder)
{
  const Implicit_entity_3 left([](auto x, auto y, auto) { return (x + 2) * (x + 2) + y * y - 1; });
  const Implicit_entity_3 right([](auto x, auto y, auto) { return (x - 2) * (x - 2) + y * y - 1; });
  const double c = std::sqrt(5.), u = 2 - 4. / 3, w = c / 3; // the centre (0,c), feet at 1/3 of 3
  const N_space_system system = rolling_ball(left, right, 2).n_space_system();
  const auto mesh = mesh_of(system, {{0, c - 2, 0, 0, c, 0, -u - 2. / 3, w, 0, u + 2. / 3, w, 0}},
                            0.4, {range(system, "z", -1, 1)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 0, 1);
  for_each_vertex(*mesh, [&](const Point& p, double k, double h) {
    EXPECT_NEAR(p[0] * p[0] + (p[1] - c) * (p[1] - c), 4, 1e-10);
    EXPECT_NEAR(k, 0, 1e-10);
    EXPECT_NEAR(std::fabs(h), 0.25, 1e-10);
  });
}

TEST(N_space_mesh, Ruled_surface_of_the_paper)
{
  const N_space_system k = ruled_surface_of_the_paper();
  const auto mesh = mesh_of(k, {start_of_ruled_surface()}, 0.1,
                            {range(k, "r", -1, 1), range(k, "lambda", 0, 1)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 1, 1);
  EXPECT_TRUE(mesh->folds.empty());
  const int lambda = range(k, "lambda", 0, 1).variable, r = range(k, "r", 0, 1).variable;
  N_space_evaluator<double> evaluate(k);
  std::set<std::pair<double, double>> corners;
  const std::size_t n = for_each_vertex(*mesh, [&](const Point& p, double, double) {
    const auto s = evaluate(p);
    ASSERT_TRUE(s);
    Coordinates<double, 3> ruling;
    for (int i = 0; i < 3; ++i)
      ruling[i] = p[6 + i] - p[9 + i]; // from p2 to p1
    EXPECT_NEAR(internal::dot(ruling, internal::multiply(s->form(), ruling)) /
                  (internal::dot(ruling, ruling) * s->form_denominator() *
                   std::sqrt(s->normal_squared_length())), 0, 1e-12);
    EXPECT_TRUE(p[lambda] >= 0 && p[lambda] <= 1 && p[r] >= -1 && p[r] <= 1);
    for (int i = 0; i < 3 && (p[lambda] == 0 || p[lambda] == 1); ++i) // the projected curves
      EXPECT_NEAR(p[i], p[(p[lambda] == 1 ? 6 : 9) + i], 1e-12);
    if ((p[lambda] == 0 || p[lambda] == 1) && std::fabs(p[r]) == 1)
      corners.insert({p[lambda], p[r]});
  });
  EXPECT_EQ(n, mesh->report.vertices);
  EXPECT_EQ(corners.size(), 4u);
}

// Upstairs the offset is the ellipsoid: its foot points have no inverted triangle.
TEST(N_space_mesh, Inner_offsets_with_cuspidal_edges_are_ellipsoids_upstairs)
{
  for (const Q& distance : {Q(1), Q(2), Q(3, 4)})
  {
    const double d = distance.get_d();
    SCOPED_TRACE(d);
    const N_space_system system = offset_system(
      Implicit_entity_3([](auto x, auto y, auto z) {
        return 4 * x * x + 9 * y * y + 36 * z * z - 36;
      }), distance).n_space_system();
    const auto mesh = mesh_of(system, {{3 - d, 0, 0, 3, 0, 0}}, 0.15);
    ASSERT_TRUE(mesh) << mesh.refusal().evidence();
    expect_whole(*mesh, 2, 1);
    Mesh feet = mesh->surface_mesh;
    const N_space_property_maps maps(feet);
    double orientation = 0;
    for (const auto v : feet.vertices())
    {
      const Point& p = maps.n_space_point[v];
      feet.point(v) = Shape_mesh::Point_3(p[3], p[4], p[5]);
    }
    for (const auto f : feet.faces())
    {
      const auto h = feet.halfedge(f);
      const auto a = feet.point(feet.source(h)), b = feet.point(feet.target(h)),
                 c = feet.point(feet.target(feet.next(h)));
      const auto n = CGAL::cross_product(b - a, c - a);
      const auto m = CGAL::centroid(a, b, c);
      const double outward = n.x() * m.x() * 4 + n.y() * m.y() * 9 + n.z() * m.z() * 36;
      orientation = orientation == 0 ? outward : orientation;
      EXPECT_GT(outward * orientation, 0);
    }
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(feet));
    // On the cuspidal edges the distance is a radius of curvature of the ellipsoid.
    ASSERT_FALSE(mesh->folds.empty());
    for (const N_space_polyline& fold : mesh->folds)
    {
      EXPECT_TRUE(fold.closed);
      for (const Point& p : fold.points)
      {
        const double x = p[3], y = p[4], z = p[5];
        const auto s = Implicit_surface_3([](auto a, auto b, auto c) {
          return 4 * a * a + 9 * b * b + 36 * c * c - 36;
        })(Coordinates<double, 3>{x, y, z});
        ASSERT_TRUE(s);
        const auto k = principal_curvatures(*s);
        EXPECT_LT((std::min)(std::fabs(d * k[0] - 1), std::fabs(d * k[1] - 1)), 1e-3);
      }
    }
  }
}

// The folds of a closed surface are closed, however few triangles there are between them.
TEST(N_space_mesh, Folds_have_no_gaps_in_coarse_meshes)
{
  const Implicit_entity_3 ellipsoid([](auto x, auto y, auto z) {
    return 4 * x * x + 9 * y * y + 36 * z * z - 36;
  });
  const N_space_system system = offset_system(ellipsoid, Q(5) / 2).n_space_system();
  for (double edge_length : {0.25, 0.3, 0.5, 0.7})
  {
    SCOPED_TRACE(edge_length);
    const auto mesh = mesh_of(system, {{0.5, 0, 0, 3, 0, 0}}, edge_length);
    ASSERT_TRUE(mesh) << mesh.refusal().evidence();
    EXPECT_EQ(mesh->report.euler_characteristic, 2);
    EXPECT_EQ(mesh->folds.size(), 4u);
    for (const N_space_polyline& fold : mesh->folds)
      EXPECT_TRUE(fold.closed);
    for (const N_space_stop& stop : mesh->stops)
      EXPECT_NE(stop.evidence, "a fold could not be followed");
  }
}

// Where the plane turns fast, the vertices on the bound come as near to each other as those inside,
// in one row, and the mesh ends there only.
TEST(N_space_mesh, Coarse_saddle_on_a_disk_ends_at_the_bound)
{
  const std::vector<std::string> names{"x", "y", "z", "w"};
  const N_space_system system(names, {parse_expression("z - x^2 + y^2", names),
                                      parse_expression("w - x^2 - y^2", names)});
  Random random(7);
  for (double edge_length : {0.3, 0.4})
    for (int i = 0; i < 8; ++i)
    {
      const double x = random.real(-0.6, 0.6), y = random.real(-0.6, 0.6);
      SCOPED_TRACE(testing::Message() << edge_length << " from " << x << ", " << y);
      const auto mesh = mesh_of(system, {{x, y, x * x - y * y, x * x + y * y}}, edge_length,
                                {{3, -1, 1}});
      ASSERT_TRUE(mesh) << mesh.refusal().evidence();
      EXPECT_TRUE(mesh->rims.empty());
      EXPECT_TRUE(mesh->stops.empty());
      EXPECT_EQ(mesh->report.euler_characteristic, 1);
      Mesh copy = mesh->surface_mesh;
      const N_space_property_maps maps(copy);
      for (const auto v : copy.vertices())
        EXPECT_EQ(maps.n_space_point[v][3] == 1, copy.is_border(v, true));
    }
}

TEST(N_space_mesh, Patch_as_a_system)
{
  const auto map = [](auto u, auto v) {
    using T = decltype(u);
    return std::array<T, 3>{u, v, u * u * v + v * v / 2};
  };
  const N_space_system system = parametric_graph(Parametric_entity_3(map)).n_space_system();
  ASSERT_EQ(system.number_of_variables(), 5);
  const auto mesh = mesh_of(system, {Point(5, 0.)}, 0.1, {{3, -1, 1}, {4, 0, 1}});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 1, 1);
  for_each_vertex(*mesh, [&](const Point& p, double k, double) {
    const double u = p[3], v = p[4], zu = 2 * u * v, zv = u * u + v;
    EXPECT_NEAR(k, (2 * v - 4 * u * u) / std::pow(1 + zu * zu + zv * zv, 2), 1e-10);
    EXPECT_NEAR(p[2], u * u * v + v * v / 2, 1e-12);
  });
}

TEST(N_space_mesh, Search_finds_all_components)
{
  const N_space_system system = make_n_space_system(
    {"x", "y", "z", "t"},
    {"t - (x^2 + y^2 + z^2 - 1)", "t*((x-3)^2 + y^2 + z^2 - 1)"});
  N_space_mesh_options options;
  options.edge_length = 0.3;
  options.search_box = {{0, -2, 5}, {1, -2, 2}, {2, -2, 2}};
  const auto mesh = mesh_n_space_surface(system, {}, options);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 4, 2);
  // A start point in one component makes no difference to what is found.
  const auto again = mesh_n_space_surface(system, {{4, 0, 0, 15}}, options);
  ASSERT_TRUE(again);
  expect_whole(*again, 4, 2);
  options.search_box[0].upper = 1;
  const auto one = mesh_n_space_surface(system, {}, options);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->report.components, 1u);
}

// Two sheets that meet in the projection are two components upstairs.
TEST(N_space_mesh, Sheets_that_cross_in_the_projection_are_kept_apart)
{
  // A sphere around each of (0,0,0) and (1,0,0), told apart by w = 0 or 1.
  const N_space_system system = make_n_space_system(
    {"x", "y", "z", "w"}, {"w*(w-1)", "(x-w)^2 + y^2 + z^2 - 1"});
  const auto mesh = mesh_of(system, {{1, 0, 0, 0}, {2, 0, 0, 1}}, 0.2);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 4, 2);
}

TEST(N_space_mesh, Bounds)
{
  // A ring whose inner border curves inward.
  const N_space_system ring =
    make_n_space_system({"x", "y", "z", "r"}, {"z", "r - (x^2 + y^2)"});
  const auto mesh = mesh_of(ring, {{1.5, 0, 0, 2.25}}, 0.2, {range(ring, "r", 1, 4)});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 0, 1);
  std::size_t on_bound = 0;
  for_each_vertex(*mesh, [&](const Point& p, double, double) {
    EXPECT_TRUE(p[3] >= 1 && p[3] <= 4);
    on_bound += p[3] == 1 || p[3] == 4;
  });
  EXPECT_EQ(on_bound, mesh->report.boundary_edges);

  const N_space_system plane = make_n_space_system({"x", "y", "z"}, {"x + y + z - 1"});
  const auto triangle = mesh_of(plane, {{0.3, 0.3, 0.4}}, 0.1,
                                {{0, 0, 2}, {1, 0, 2}, {2, 0, 2}});
  ASSERT_TRUE(triangle);
  expect_whole(*triangle, 1, 1);
  double area = 0;
  const Mesh& m = triangle->surface_mesh;
  for (const auto f : m.faces())
  {
    const auto h = m.halfedge(f);
    area += std::sqrt(CGAL::squared_area(m.point(m.source(h)), m.point(m.target(h)),
                                         m.point(m.target(m.next(h)))));
  }
  EXPECT_NEAR(area, std::sqrt(3.) / 2, 1e-12);
  // The start may lie on a bound, or a little beyond it.
  EXPECT_TRUE(mesh_of(plane, {{0, 0.5, 0.5}}, 0.1, {{0, 0, 2}, {1, 0, 2}, {2, 0, 2}}));
}

TEST(N_space_mesh, Singular_points_leave_a_rim)
{
  const N_space_system cone = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 - z^2"});
  const auto mesh = mesh_of(cone, {{1, 0, 1}}, 0.2, {{2, -1, 1}});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  EXPECT_TRUE(mesh->report.manifold);
  EXPECT_EQ(mesh->report.euler_characteristic, 0);
  ASSERT_EQ(mesh->rims.size(), 1u);
  EXPECT_TRUE(mesh->rims[0].closed);
  for (const Point& p : mesh->rims[0].points)
    EXPECT_LT(std::hypot(p[0], p[1], p[2]), 0.05);
  ASSERT_FALSE(mesh->stops.empty());
  EXPECT_EQ(mesh->stops[0].code, Refusal_code::RANK_DEFICIENT);
  EXPECT_FALSE(mesh->stops[0].evidence.empty());
}

// Near each other, or behind an edge that is sharper than the edges are long.
TEST(N_space_mesh, Near_sheets)
{
  const N_space_system spheres = make_n_space_system(
    {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - 441/400)"});
  const auto mesh = mesh_of(spheres, {{1, 0, 0}, {1.05, 0, 0}}, 0.1);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 4, 2);
  const N_space_system flat = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 + 100*z^2 - 1"});
  const auto ellipsoid = mesh_of(flat, {{0, 0, 0.1}}, 0.2);
  ASSERT_TRUE(ellipsoid) << ellipsoid.refusal().evidence();
  expect_whole(*ellipsoid, 2, 1);
  const N_space_system tube = make_n_space_system(
    {"x", "y", "z"}, {"(x^2 + y^2 + z^2 + 1 - 1/400)^2 - 4*(x^2 + y^2)"});
  for (double edge_length : {0.05, 0.0612522, 0.0802891})
  {
    const auto torus = mesh_of(tube, {{1.05, 0, 0}}, edge_length);
    ASSERT_TRUE(torus) << torus.refusal().evidence();
    EXPECT_EQ(torus->report.euler_characteristic, 0) << edge_length;
    EXPECT_TRUE(torus->rims.empty()) << edge_length;
  }
}

TEST(N_space_mesh, Bounds_that_are_nearer_than_an_edge)
{
  const N_space_system plane = make_n_space_system({"x", "y", "z"}, {"z"});
  for (const Q& width : {Q(1, 10), Q(1, 30), Q(1, 100), Q(1, 1000)})
    for (const Q& height : {Q(1), width})
    {
      SCOPED_TRACE(width.get_d());
      const auto mesh = mesh_of(plane, {{0, 0, 0}}, 0.1,
                                {{0, 0, width}, {1, 0, height}, {0, Q(-1), Q(2)}});
      ASSERT_TRUE(mesh) << mesh.refusal().evidence();
      expect_whole(*mesh, 1, 1);
      double area = 0;
      const Mesh& m = mesh->surface_mesh;
      for (const auto f : m.faces())
      {
        const auto h = m.halfedge(f);
        area += std::sqrt(CGAL::squared_area(m.point(m.source(h)), m.point(m.target(h)),
                                             m.point(m.target(m.next(h)))));
      }
      EXPECT_NEAR(area, width.get_d() * height.get_d(), 1e-9);
    }
}

// A Moebius strip: (p,q) is a multiple of the direction of half the angle.
TEST(N_space_mesh, Surface_that_cannot_be_oriented_is_cut_once)
{
  const N_space_system strip = make_n_space_system(
    {"x", "y", "z", "a", "b", "p", "q", "r"},
    {"a^2 + b^2 - 1", "x - (2+p)*a", "y - (2+p)*b", "z - q", "p*(1-a) - q*b", "p*b - q*(1+a)",
     "r - p^2 - q^2"});
  const auto mesh = mesh_of(strip, {{2.1, 0, 0, 1, 0, 0.1, 0, 0.01}}, 0.1,
                            {range(strip, "r", -1, Q(1, 4))});
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  EXPECT_TRUE(mesh->report.manifold);
  EXPECT_EQ(mesh->report.components, 1u);
  EXPECT_EQ(mesh->rims.size(), 1u);
}

TEST(N_space_mesh, Projection_to_a_point_has_no_curvature_anywhere)
{
  const N_space_system system = make_n_space_system(
    {"x", "y", "z", "u", "v", "w"}, {"u^2 + v^2 + w^2 - 1", "x", "y", "z"});
  const auto mesh = mesh_of(system, {{0, 0, 0, 1, 0, 0}}, 0.3);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  expect_whole(*mesh, 2, 1);
  EXPECT_EQ(mesh->report.refused_places.size(), mesh->report.vertices);
  EXPECT_EQ(mesh->report.refused_places[0].code, Refusal_code::PROJECTION_SINGULAR);
}

TEST(N_space_mesh, Equal_calls_give_equal_meshes)
{
  const N_space_system k = ruled_surface_of_the_paper();
  const std::vector<N_space_bound> bounds{range(k, "r", -1, 1), range(k, "lambda", 0, 1)};
  const auto a = mesh_of(k, {start_of_ruled_surface()}, 0.3, bounds);
  const auto b = mesh_of(k, {start_of_ruled_surface()}, 0.3, bounds);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->report.vertices, b->report.vertices);
  for (const auto v : a->surface_mesh.vertices())
    EXPECT_EQ(a->surface_mesh.point(v), b->surface_mesh.point(v));
}

TEST(N_space_mesh, Refusals)
{
  const N_space_system sphere = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"});
  const auto code = [](const Result<N_space_mesh>& r) { return r.refusal().code(); };
  EXPECT_EQ(code(mesh_of(sphere, {}, 0.1)), Refusal_code::NOT_ON_SOLUTION);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, 0)), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, std::nan(""))), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, 0.1, {{3, 0, 1}})), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, 0.1, {{0, 1, 0}})), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, 0.1, {{0, 1, 1}})), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_FALSE(mesh_of(sphere, {{1, 0, 0}}, 1e300));
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0, 0}}, 0.1, {{0, -1, 0}})), Refusal_code::OUTSIDE_DOMAIN);
  EXPECT_EQ(code(mesh_of(sphere, {{1, 0}}, 0.1)), Refusal_code::NOT_ON_SOLUTION);
  EXPECT_EQ(code(mesh_of(sphere, {{0, 0, 0}}, 0.1)), Refusal_code::RANK_DEFICIENT);
  const N_space_system circle = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 - 1", "z"});
  EXPECT_EQ(code(mesh_of(circle, {{1, 0, 0}}, 0.5)), Refusal_code::NOT_TWO_DIMENSIONAL);
  const N_space_system empty = make_n_space_system({"x", "y", "z"}, {"x^2 + y^2 + z^2 + 1"});
  EXPECT_FALSE(mesh_of(empty, {{1, 0, 0}}, 0.1));
  const N_space_system plane = make_n_space_system({"x", "y", "z"}, {"z"});
  N_space_mesh_options options;
  options.edge_length = 0.1;
  options.max_vertices = 500;
  EXPECT_EQ(code(mesh_n_space_surface(plane, {{0, 0, 0}}, options)),
            Refusal_code::LIMIT_EXCEEDED);
  const auto stop = [](std::size_t done, std::size_t) { return done < 50; };
  EXPECT_EQ(code(mesh_n_space_surface(sphere, {{1, 0, 0}}, options, stop)),
            Refusal_code::CANCELLED);
}
