// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Meshes of implicit surfaces: topology, vertices on the surface, curvatures, certified distances,
// the cut at the box, and what is refused.

#include <CGAL/Shape_interrogation/Meshing/mesh_implicit_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using namespace CGAL::Shape_interrogation;
using Mesh = Shape_mesh::Surface_mesh;
using Vertex = Mesh::Vertex_index;
using CGAL::Bbox_3;

// Several surfaces in one type, so that the mesher is compiled once.
struct Test_function
{
  enum Kind
  {
    SPHERE, TORUS, TWO_SPHERES, PLANE, HYPERBOLOID, CONE, CATENOID, NOTHING, ROOT, SQUARE,
    EXPANDED_SQUARE, CROSSING_PLANES
  };

  Kind kind;

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT r2 = x * x + y * y;
    switch (kind)
    {
      case SPHERE: return r2 + z * z - NT(1);
      case TORUS: return square(r2 + z * z + NT(3) / NT(4)) - NT(4) * r2;
      case TWO_SPHERES:
        return (square(x - NT(1)) + y * y + z * z - NT(1) / NT(4)) *
               (square(x + NT(1)) + y * y + z * z - NT(1) / NT(4));
      case PLANE: return NT(2) * z - x - y;
      case HYPERBOLOID: return r2 - z * z - NT(1) / NT(4);
      case CONE: return r2 - z * z;
      case CATENOID:
      {
        const NT e = Elementary_functions<NT>::exp(z);
        return r2 - square((e + NT(1) / e) / NT(2));
      }
      case SQUARE: return square(r2 + z * z - NT(1));
      case EXPANDED_SQUARE: // near the sphere its values are rounding errors of both signs
        return square(r2) + square(z * z) + NT(2) * r2 * z * z - NT(2) * r2 - NT(2) * z * z + NT(1);
      case CROSSING_PLANES: return x * y;
      case ROOT: return Elementary_functions<NT>::sqrt(x);
      default: return r2 + z * z + NT(1);
    }
  }

private:
  template <class NT>
  static NT square(const NT& x) { return x * x; }
};

using Surface = Implicit_surface_3<Test_function>;

Surface surface_of(Test_function::Kind kind) { return Surface(Test_function{kind}); }

Bbox_3 cube(double half) { return Bbox_3(-half, -half, -half, half, half, half); }

Implicit_mesh_options coarse(double edge_length, double tolerance)
{
  Implicit_mesh_options options;
  options.edge_length = edge_length;
  options.tolerance = tolerance;
  options.seed_cells = 16;
  return options;
}

Shape_mesh meshed(Test_function::Kind kind, double half, const Implicit_mesh_options& options)
{
  const auto mesh = mesh_implicit_surface(surface_of(kind), cube(half), options);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.refusal().evidence());
  return mesh ? *mesh : Shape_mesh();
}

// The triangles are turned along the normals at their corners, and the report is that of the mesh.
void expect_sound(Shape_mesh mesh, bool is_certified = true)
{
  const Mesh& m = mesh.surface_mesh;
  const Mesh_report& report = mesh.report;
  EXPECT_TRUE(m.is_valid(false));
  EXPECT_TRUE(report.manifold);
  EXPECT_EQ(report.vertices, m.number_of_vertices());
  EXPECT_EQ(report.faces, m.number_of_faces());
  EXPECT_EQ(report.face_distance_certified, is_certified);
  EXPECT_LE(report.max_face_distance, report.tolerance);
  const Shape_property_maps maps(mesh.surface_mesh);
  for (const auto f : m.faces())
  {
    const auto h = m.halfedge(f);
    const Vertex a = m.source(h), b = m.target(h), c = m.target(m.next(h));
    const auto normal = CGAL::cross_product(m.point(b) - m.point(a), m.point(c) - m.point(a));
    EXPECT_GT(normal * (maps.normal[a] + maps.normal[b] + maps.normal[c]), 0);
  }
}

TEST(Mesh_implicit, Sphere)
{
  Shape_mesh mesh = meshed(Test_function::SPHERE, 1.5, coarse(0.3, 0.02));
  expect_sound(mesh);
  EXPECT_EQ(mesh.report.components, 1u);
  EXPECT_EQ(mesh.report.boundary_edges, 0u);
  EXPECT_EQ(mesh.report.euler_characteristic, 2);
  EXPECT_TRUE(mesh.report.vertex_distance_certified);
  EXPECT_LE(mesh.report.max_vertex_distance, 1e-15);
  EXPECT_TRUE(mesh.report.refused_places.empty());
  const Shape_property_maps maps(mesh.surface_mesh);
  double deepest = 1;
  for (const Vertex v : mesh.surface_mesh.vertices())
  {
    const auto p = mesh.surface_mesh.point(v) - CGAL::ORIGIN;
    EXPECT_NEAR((maps.normal[v] - p).squared_length(), 0, 1e-30);
    EXPECT_NEAR(maps.gaussian_curvature[v], 1, 1e-14);
    EXPECT_NEAR(maps.kmin[v], 1, 1e-14);
    EXPECT_NEAR(maps.kmax[v], 1, 1e-14);
    EXPECT_EQ(maps.direction_min[v], CGAL::NULL_VECTOR);
  }
  for (const auto f : mesh.surface_mesh.faces())
  {
    const auto h = mesh.surface_mesh.halfedge(f);
    const auto corner = [&](auto x) {
      return mesh.surface_mesh.point(mesh.surface_mesh.target(x)) - CGAL::ORIGIN;
    };
    const auto middle = (corner(h) + corner(mesh.surface_mesh.next(h)) +
                         corner(mesh.surface_mesh.prev(h))) / 3;
    deepest = (std::min)(deepest, std::sqrt(middle.squared_length()));
  }
  EXPECT_LE(1 - deepest, mesh.report.max_face_distance);
  EXPECT_GE(1 - deepest, mesh.report.max_face_distance / 2);
}

TEST(Mesh_implicit, Torus_has_the_curvatures_of_the_formula)
{
  Shape_mesh mesh = meshed(Test_function::TORUS, 2, coarse(0.3, 0.03));
  expect_sound(mesh);
  EXPECT_EQ(mesh.report.components, 1u);
  EXPECT_EQ(mesh.report.euler_characteristic, 0);
  const Shape_property_maps maps(mesh.surface_mesh);
  for (const Vertex v : mesh.surface_mesh.vertices())
  {
    const auto& p = mesh.surface_mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    const double around = 2 * (r - 1) / r; // cos / r with the tube's radius 1/2
    EXPECT_NEAR(maps.kmin[v], around, 1e-12);
    EXPECT_NEAR(maps.kmax[v], 2, 1e-12);
    EXPECT_NEAR(maps.gaussian_curvature[v], 2 * around, 1e-12);
    const Shape_mesh::Vector_3 circle(-p.y() / r, p.x() / r, 0);
    EXPECT_NEAR(std::abs(circle * maps.direction_min[v]), 1, 1e-12);
    EXPECT_NEAR((CGAL::cross_product(maps.direction_min[v], maps.direction_max[v]) -
                 maps.normal[v]).squared_length(), 0, 1e-28);
  }
}

TEST(Mesh_implicit, All_components_are_found)
{
  const Shape_mesh mesh = meshed(Test_function::TWO_SPHERES, 1.8, coarse(0.3, 0.03));
  expect_sound(mesh);
  EXPECT_EQ(mesh.report.components, 2u);
  EXPECT_EQ(mesh.report.euler_characteristic, 4);
}

TEST(Mesh_implicit, Plane_and_transcendental_surface_are_cut_at_the_box)
{
  const Shape_mesh plane = meshed(Test_function::PLANE, 1, coarse(0.4, 0.01));
  expect_sound(plane);
  EXPECT_EQ(plane.report.euler_characteristic, 1);
  Shape_mesh catenoid = meshed(Test_function::CATENOID, 1, coarse(0.4, 0.02));
  expect_sound(catenoid);
  const Shape_property_maps maps(catenoid.surface_mesh);
  for (const Vertex v : catenoid.surface_mesh.vertices())
    EXPECT_NEAR(maps.mean_curvature[v], 0, 1e-12); // a minimal surface
}

TEST(Mesh_implicit, Boundary_is_on_the_faces_of_the_box)
{
  for (const auto& [kind, half, characteristic] :
       {std::make_tuple(Test_function::SPHERE, 0.8, -4),
        std::make_tuple(Test_function::HYPERBOLOID, 1.0, 0)})
  {
    const Shape_mesh mesh = meshed(kind, half, coarse(0.25, 0.02));
    expect_sound(mesh);
    EXPECT_EQ(mesh.report.components, 1u);
    EXPECT_EQ(mesh.report.euler_characteristic, characteristic);
    EXPECT_LE(mesh.report.max_vertex_distance, 1e-14);
    const Mesh& m = mesh.surface_mesh;
    for (const Vertex v : m.vertices())
    {
      const auto& p = m.point(v);
      const double out = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
      EXPECT_LE(out, half);
      EXPECT_EQ(out == half, m.is_border(v)) << p;
    }
  }
}

TEST(Mesh_implicit, Singular_point_makes_the_distance_uncertified)
{
  Implicit_mesh_options options = coarse(0.4, 0.1);
  const auto mesh = mesh_implicit_surface(surface_of(Test_function::CONE), cube(1), options);
  ASSERT_TRUE(mesh) << mesh.refusal().evidence();
  EXPECT_FALSE(mesh->report.face_distance_certified);
  EXPECT_GT(mesh->report.faces, 50u);
}

TEST(Mesh_implicit, Singular_curve_ends_without_a_manifold)
{
  const Shape_mesh mesh = meshed(Test_function::CROSSING_PLANES, 1, coarse(0.5, 0.1));
  const Mesh_report& report = mesh.report;
  EXPECT_FALSE(report.manifold);
  EXPECT_FALSE(report.face_distance_certified);
  EXPECT_GT(report.faces, 50u);
  EXPECT_LT(report.vertices, 5000u);
  for (const auto f : mesh.surface_mesh.faces())
  {
    double farthest = 0; // the smaller coordinate is the distance of a corner
    for (const Vertex v : mesh.surface_mesh.vertices_around_face(mesh.surface_mesh.halfedge(f)))
    {
      const auto& p = mesh.surface_mesh.point(v);
      farthest = (std::max)(farthest, (std::min)(std::abs(p.x()), std::abs(p.y())));
    }
    EXPECT_LE(farthest, 1e-6);
  }
}

TEST(Mesh_implicit, What_has_no_way_to_the_surface_is_not_measured_as_zero)
{
  const auto positive = [](const auto& q) {
    return std::array<double, 4>{q[0] * q[0] + 1, 2 * q[0], 0, 0};
  };
  for (const double x : {0.0, 0.3}) // the gradient is zero; the steps run to and fro
  {
    Coordinates<double, 3> p{x, 0, 0};
    EXPECT_FALSE(internal::slide_to_surface(positive, p, 1.0));
  }
  Coordinates<double, 3> p{1, 0, 0};
  const auto square = [](const auto& q) {
    return std::array<double, 4>{q[0] * q[0], 2 * q[0], 0, 0};
  };
  EXPECT_TRUE(internal::slide_to_surface(square, p, 1.0)); // slow, but there it is
  EXPECT_LT(std::abs(p[0]), 1e-5);
}

TEST(Mesh_implicit, What_has_no_mesh_is_refused)
{
  const auto code = [](Test_function::Kind kind, const Bbox_3& box,
                       const Implicit_mesh_options& options) {
    const auto mesh = mesh_implicit_surface(surface_of(kind), box, options);
    EXPECT_FALSE(mesh);
    return mesh ? Refusal_code::UNDECIDED : mesh.refusal().code();
  };
  Implicit_mesh_options options = coarse(0.1, 0.01);
  EXPECT_EQ(code(Test_function::NOTHING, cube(1), options), Refusal_code::NOT_ON_SURFACE);
  EXPECT_EQ(code(Test_function::SQUARE, cube(1), options), Refusal_code::NOT_ON_SURFACE);
  EXPECT_EQ(code(Test_function::SQUARE, cube(1.3), options), Refusal_code::NOT_ON_SURFACE);
  EXPECT_EQ(code(Test_function::EXPANDED_SQUARE, cube(1), options), Refusal_code::NOT_ON_SURFACE);
  EXPECT_EQ(code(Test_function::SPHERE, Bbox_3(3, 3, 3, 4, 4, 4), options),
            Refusal_code::NOT_ON_SURFACE);
  EXPECT_EQ(code(Test_function::ROOT, cube(1), options), Refusal_code::OUTSIDE_DOMAIN);
  EXPECT_EQ(code(Test_function::SPHERE, Bbox_3(0, 0, 0, 0, 1, 1), options),
            Refusal_code::OUTSIDE_DOMAIN);
  EXPECT_EQ(code(Test_function::SPHERE, Bbox_3(), options), Refusal_code::OUTSIDE_DOMAIN);
  EXPECT_EQ(code(Test_function::TORUS, cube(1e200), options), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(code(Test_function::SPHERE, cube(1.5), coarse(1e-100, 0.01)),
            Refusal_code::LIMIT_EXCEEDED);
  options.max_vertices = 200;
  EXPECT_EQ(code(Test_function::SPHERE, cube(1.5), options), Refusal_code::LIMIT_EXCEEDED);
}

TEST(Mesh_implicit, Progress_cancels)
{
  for (const int calls : {0, 2, 20})
  {
    int left = calls;
    const auto mesh = mesh_implicit_surface(surface_of(Test_function::TORUS), cube(2),
                                            coarse(0.1, 0.01),
                                            [&](std::size_t, std::size_t) { return left-- > 0; });
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.refusal().code(), Refusal_code::CANCELLED);
    EXPECT_EQ(left, -1);
  }
}

} // namespace
