// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Patches divided into regions: triangles and trimming loops of the domain, meshes, pictures.

#include "meshed_patches.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Contours/contour.h>
#include <CGAL/Shape_interrogation/IO/write_svg.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_regions.h>

#include <CGAL/Polygon_mesh_processing/repair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace meshed_patches;
using P = Bernstein_polynomial_2<Q>;
using Point_2 = std::array<double, 2>;
using Mesh = Shape_mesh::Surface_mesh;

const P u = P::coordinate(0), v = P::coordinate(1);
const double pi = 3.14159265358979323846;

P constant(const Q& c) { return P(c); }
P x() { return u - constant(Q(1) / Q(2)); }
P y() { return v - constant(Q(1) / Q(2)); }

int index(Region region) { return static_cast<int>(region); }

// The graph of a polynomial over the unit square.
Patch graph(const P& f)
{
  const std::array<int, 2> degree{std::max(1, f.degree()[0]), std::max(1, f.degree()[1])};
  const P g = f.elevated(degree);
  Points points;
  for (int i = 0; i <= degree[0]; ++i)
  {
    points.emplace_back();
    for (int j = 0; j <= degree[1]; ++j)
      points.back().push_back({Q(i) / Q(degree[0]), Q(j) / Q(degree[1]), g.coefficient({i, j})});
  }
  return Patch(points);
}

// A quarter of the torus with radii 3 and 1, from the outermost circle to the angle 2 atan(end) of
// the profile: the topmost circle is at u = 1 / end.
Patch torus(int end)
{
  const Q e(end), e2 = e * e;
  const Q cosine[3] = {Q(1), Q(1), Q(1) - e2}, sine[3] = {Q(0), e, e + e},
          weight[3] = {Q(1), Q(1), Q(1) + e2};
  const int circle[3][3] = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
  Points points(3);
  Weights weights(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const Q r = Q(3) * weight[i] + cosine[i], w = weight[i] * Q(circle[j][2]);
      points[i].push_back({r * Q(circle[j][0]) / w, r * Q(circle[j][1]) / w,
                           sine[i] * Q(circle[j][2]) / w});
      weights[i].push_back(w);
    }
  return Patch(points, weights);
}

double area(const std::vector<Point_2>& p)
{
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point_2 &a = p[i], &b = p[(i + 1) % p.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

// The triangle to the left of each edge.
using Left = std::map<std::pair<Point_2, Point_2>, std::size_t>;

Left left_of_edges(const Divided_domain& d)
{
  Left left;
  for (std::size_t t = 0; t < d.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
    {
      const bool is_new = left.emplace(std::make_pair(d.points[d.triangles[t][k]],
                                                      d.points[d.triangles[t][(k + 1) % 3]]),
                                       t).second;
      EXPECT_TRUE(is_new) << "two triangles on one side of an edge";
    }
  return left;
}

void check_triangles(const Divided_domain& d, double edge_length)
{
  using K = Shape_mesh::Kernel;
  double sum = 0;
  for (std::size_t t = 0; t < d.triangles.size(); ++t)
  {
    K::Point_2 p[3];
    for (int k = 0; k < 3; ++k)
    {
      const Point_2 &a = d.points[d.triangles[t][k]], &b = d.points[d.triangles[t][(k + 1) % 3]];
      p[k] = K::Point_2(a[0], a[1]);
      EXPECT_LE(std::hypot(b[0] - a[0], b[1] - a[1]), 2 * edge_length);
    }
    EXPECT_EQ(CGAL::orientation(p[0], p[1], p[2]), CGAL::LEFT_TURN) << "triangle " << t;
    sum += d.triangle_area(t);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

void check_loops(const Divided_domain& d, const Left& left)
{
  std::map<int, double> areas, parts;
  for (const Region_loop& loop : d.loops)
  {
    EXPECT_NEAR(area(loop.points), loop.signed_area, 1e-12);
    areas[loop.region] += loop.signed_area;
    parts[loop.part] += loop.signed_area;
    for (std::size_t i = 0; i < loop.points.size(); ++i)
    {
      const Point_2 &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
      const auto inside = left.find({a, b}), outside = left.find({b, a});
      ASSERT_TRUE(inside != left.end());
      EXPECT_EQ(d.parts[inside->second], loop.part);
      EXPECT_EQ(d.regions[inside->second], loop.region);
      EXPECT_TRUE(outside == left.end() || d.regions[outside->second] != loop.region);
    }
  }
  for (const auto& region : areas)
    EXPECT_NEAR(region.second, d.area(region.first), 1e-12) << "region " << region.first;
  for (const auto& part : parts)
    EXPECT_GT(part.second, 0) << "part " << part.first;
}

// That the segments of the curves are edges, and nothing else is a contour edge inside.
void check_contour_edges(const Divided_domain& d, const Contour_2& contour, const Left& left)
{
  std::size_t segments = 0;
  for (const Contour_curve_2& curve : contour.curves)
    for (std::size_t i = 0; i + !curve.is_closed < curve.points.size(); ++i)
    {
      const Point_2 &a = curve.points[i], &b = curve.points[(i + 1) % curve.points.size()];
      segments += a != b;
      EXPECT_TRUE(a == b || left.count({a, b}) || left.count({b, a}));
    }
  std::size_t to_boxes = 0, inside = 0;
  for (const Unresolved_box_2& box : contour.unresolved)
    to_boxes += box.branches;
  for (const auto& edge : d.contour_edges)
    inside += left.count({d.points[edge[0]], d.points[edge[1]]}) &&
              left.count({d.points[edge[1]], d.points[edge[0]]});
  EXPECT_GE(inside, segments);
  EXPECT_LE(inside, segments + to_boxes);
}

void check_domain(const Divided_domain& d, const Contour_2& contour, double edge_length)
{
  for (const Contour_curve_2& curve : contour.curves)
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      const Point_2 &a = curve.points[i], &b = curve.points[i + 1];
      edge_length = std::max(edge_length, std::hypot(b[0] - a[0], b[1] - a[1]));
    }
  const Left left = left_of_edges(d);
  check_triangles(d, edge_length);
  check_loops(d, left);
  check_contour_edges(d, contour, left);
}

void check_mesh(const Region_mesh& m)
{
  const Mesh& mesh = m.mesh.surface_mesh;
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_TRUE(m.mesh.report.manifold);
  std::vector<Mesh::Halfedge_index> pinched;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(pinched));
  EXPECT_TRUE(pinched.empty());
  EXPECT_EQ(m.mesh.report.components, 1u);
  EXPECT_EQ(m.mesh.report.euler_characteristic, 1);
  Mesh copy = mesh; // property maps of a mesh that is const have another type
  const Region_property_maps regions(copy);
  std::map<int, int> triangles;
  for (const auto f : copy.faces())
    ++triangles[regions.face_region[f]];
  for (const int region : m.domain.regions)
    EXPECT_TRUE(triangles.count(region));
  for (const auto e : copy.edges())
  {
    const auto h = copy.halfedge(e);
    EXPECT_TRUE(copy.is_border(e) || regions.contour_edge[e] ||
                regions.face_region[copy.face(h)] ==
                  regions.face_region[copy.face(copy.opposite(h))])
      << "regions meet beside the contour";
  }
}

// The angle between the triangles and the normals of the patch.
void check_orientation(const Region_mesh& m)
{
  Mesh mesh = m.mesh.surface_mesh;
  const Shape_property_maps maps(mesh);
  for (const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
               &c = mesh.point(mesh.target(mesh.next(h)));
    const auto n = CGAL::cross_product(b - a, c - a);
    if (n.squared_length() < 1e-20) // as small as rounding
      continue;
    EXPECT_GT(n * maps.normal[mesh.source(h)], 0.5 * std::sqrt(n.squared_length()));
  }
}

// Areas of the mesh beside the certified ones.
void check_areas(const Trichotomy_mesh& m, double tolerance)
{
  double sum = 0;
  for (const Region region : {Region::CONVEX, Region::CONCAVE, Region::SADDLE, Region::FLAT})
  {
    const double a = m.regions.domain.area(index(region));
    const Area_range& range = m.trichotomy.area(region);
    EXPECT_GE(a, CGAL::to_double(range.lower) - tolerance) << to_string(region);
    EXPECT_LE(a, CGAL::to_double(range.upper) + tolerance) << to_string(region);
    sum += a;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

Trichotomy_mesh checked_trichotomy(const Patch& patch, const Domain_options& options = {})
{
  const auto m = mesh_trichotomy(patch, options);
  EXPECT_TRUE(m) << m.refusal().evidence();
  check_domain(m->regions.domain, m->trichotomy.boundary, options.edge_length);
  check_mesh(m->regions);
  check_areas(*m, 1e-4);
  return *m;
}

Divided_domain checked_domain(const P& f, const Domain_options& options = {})
{
  const auto c = contour(f);
  EXPECT_TRUE(c);
  const auto d = divide_domain(*c, Sign_classifier(f), options);
  EXPECT_TRUE(d);
  check_domain(*d, *c, options.edge_length);
  EXPECT_EQ(d->area(unresolved_region), 0);
  return *d;
}

int number_of_parts(const Divided_domain& d)
{
  return 1 + *std::max_element(d.parts.begin(), d.parts.end());
}

TEST(Regions, of_a_graph_with_straight_parabolic_lines)
{
  // z = (u - 1/3)^3 + (v - 1/2)^3: K vanishes on u = 1/3 and v = 1/2, which cross.
  const P a = u - constant(Q(1) / Q(3)), b = y();
  const auto m = checked_trichotomy(graph(a * a * a + b * b * b));
  const Divided_domain& d = m.regions.domain;
  EXPECT_NEAR(d.area(index(Region::SADDLE)), 0.5, 1e-9);
  EXPECT_NEAR(d.area(index(Region::CONCAVE)), 1. / 3, 1e-9);
  EXPECT_NEAR(d.area(index(Region::CONVEX)), 1. / 6, 1e-9);
  EXPECT_EQ(number_of_parts(d), 4);
  EXPECT_EQ(d.loops.size(), 4u);
  check_orientation(m.regions);
}

TEST(Regions, of_tori)
{
  const auto m = checked_trichotomy(torus(2));
  EXPECT_NEAR(m.regions.domain.area(index(Region::SADDLE)), 0.5, 1e-9);
  EXPECT_EQ(number_of_parts(m.regions.domain), 2);
  check_orientation(m.regions);
  // The parabolic circle is an edge of the patch.
  const auto n = checked_trichotomy(torus(1));
  ASSERT_EQ(n.trichotomy.boundary.edges.size(), 1u);
  EXPECT_EQ(n.trichotomy.boundary.edges[0].end, 1);
  EXPECT_EQ(n.regions.domain.area(index(Region::SADDLE)), 0);
  double length = 0;
  for (const auto& e : n.regions.domain.contour_edges)
  {
    EXPECT_EQ(n.regions.domain.points[e[0]][0], 1);
    length += n.regions.domain.points[e[1]][1] - n.regions.domain.points[e[0]][1];
  }
  EXPECT_NEAR(length, 1, 1e-12);
}

TEST(Regions, of_developable_and_collapsed_patches)
{
  const auto m = checked_trichotomy(graph(x() * x() * x())); // a cylinder that turns over
  EXPECT_TRUE(m.trichotomy.is_developable);
  EXPECT_NEAR(m.regions.domain.area(index(Region::CONVEX)), 0.5, 1e-9);
  EXPECT_NEAR(m.regions.domain.area(index(Region::CONCAVE)), 0.5, 1e-9);
  const auto flat = checked_trichotomy(graph(u + v));
  EXPECT_NEAR(flat.regions.domain.area(index(Region::FLAT)), 1, 1e-12);
  EXPECT_EQ(flat.regions.domain.loops.size(), 1u);
  const auto octant = checked_trichotomy(sphere_octant(0, false)); // with a pole
  EXPECT_EQ(octant.regions.mesh.report.refused_places.size(), 1u);
  EXPECT_LT(octant.regions.mesh.surface_mesh.number_of_faces(),
            octant.regions.domain.triangles.size());
  check_orientation(octant.regions);
}

TEST(Regions, of_the_teapot)
{
  for (const int k : {0, 4, 8, 13, 16, 18, 20, 24, 28})
  {
    SCOPED_TRACE(testing::Message() << "patch " << k);
    checked_trichotomy(teapot()[k]);
  }
}

TEST(Regions, of_closed_and_touching_curves)
{
  const P r2 = x() * x() + y() * y();
  const Divided_domain disc = checked_domain(r2 - constant(Q(1) / Q(9)));
  EXPECT_NEAR(disc.area(0), pi / 9, 2e-3 * pi / 9);
  ASSERT_EQ(disc.loops.size(), 3u); // the outer part with its hole, the disc
  EXPECT_NEAR(disc.loops[0].signed_area, 1, 1e-12);
  EXPECT_NEAR(disc.loops[1].signed_area, -disc.area(0), 1e-12);
  EXPECT_EQ(number_of_parts(checked_domain(r2 - constant(Q(1) / Q(4)))), 5); // touches all sides
  EXPECT_EQ(number_of_parts(checked_domain(r2)), 1);                         // a point
  EXPECT_EQ(number_of_parts(checked_domain(x() * y())), 4);                  // a crossing
  EXPECT_EQ(number_of_parts(checked_domain((y() - x() * x()) * (y() + x() * x()))), 4);
  const P line = x() - y() * y(); // a curve without a change of sign
  EXPECT_EQ(number_of_parts(checked_domain(line * line)), 1);
  EXPECT_EQ(number_of_parts(checked_domain(u * (v - u * u))), 2); // with an edge of the square
  EXPECT_EQ(number_of_parts(checked_domain(constant(Q(-1)))), 1);
}

TEST(Regions, beside_branches_that_nearly_touch)
{
  for (const int sign : {-1, 1})
  {
    const Divided_domain d =
      checked_domain(x() * y() + constant(Q(sign) / Q(1000000) / Q(1000000)));
    EXPECT_EQ(number_of_parts(d), 3);
    EXPECT_NEAR(d.area(0), 0.5, 1e-6);
  }
}

TEST(Regions, are_right_beside_coarse_curves)
{
  // A curve in few pieces: the widest triangles are between it and its polygon.
  const P f = P::from_coefficients({3, 1}, {Q(9), Q(-8), Q(-7), Q(-9), Q(8), Q(5), Q(5), Q(5)});
  Contour_options coarse;
  coarse.step = 0.2;
  const auto c = contour(f, coarse);
  const auto d = divide_domain(*c, Sign_classifier(f));
  EXPECT_EQ(number_of_parts(*d), 2);
  EXPECT_NEAR(d->area(1), checked_domain(f).area(1), 0.05);
}

// All triangles without a corner on a curve have the sign at their centroids.
TEST(Regions, have_the_signs_of_random_polynomials)
{
  testing_shapes::Random random(271828);
  for (int i = 0; i < 12; ++i)
  {
    std::vector<Q> b;
    for (int k = 0; k < 20; ++k)
      b.push_back(random.rational());
    const P f = P::from_coefficients({3, 4}, b);
    const Divided_domain d = checked_domain(f);
    std::vector<bool> is_on_curve(d.points.size(), false);
    for (const auto& e : d.contour_edges)
      is_on_curve[e[0]] = is_on_curve[e[1]] = true;
    for (std::size_t t = 0; t < d.triangles.size(); ++t)
    {
      const auto& c = d.triangles[t];
      if (is_on_curve[c[0]] || is_on_curve[c[1]] || is_on_curve[c[2]])
        continue;
      std::array<Q, 2> middle{Q(0), Q(0)};
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 2; ++l)
          middle[l] += Q(d.points[c[k]][l]) / Q(3);
      EXPECT_EQ(d.regions[t], CGAL::is_positive(f(middle)) ? 1 : 0);
    }
  }
}

TEST(Regions, are_unresolved_in_large_boxes_and_where_nobody_knows)
{
  Contour_2 c;
  c.unresolved.push_back({{0.4, 0.25}, {0.6, 0.75}, 1});
  Contour_curve_2 curve;
  curve.points = {{0.6, 0.5}, {0.8, 0.6}, {1, 0.5}};
  curve.unresolved = {0, -1};
  c.curves.push_back(curve);
  const auto d = divide_domain(c, [](const Point_2&) { return 7; });
  ASSERT_TRUE(d);
  check_domain(*d, c, Domain_options().edge_length);
  EXPECT_NEAR(d->area(unresolved_region), 0.1, 1e-12);
  EXPECT_NEAR(d->area(7), 0.9, 1e-12);
  EXPECT_EQ(d->loops.size(), 3u);
  const auto nobody = divide_domain({}, [](const Point_2&) { return unresolved_region; });
  EXPECT_NEAR(nobody->area(unresolved_region), 1, 1e-12);
}

TEST(Regions, are_the_same_twice)
{
  const auto once = mesh_trichotomy(teapot()[16]), twice = mesh_trichotomy(teapot()[16]);
  const Divided_domain &a = once->regions.domain, &b = twice->regions.domain;
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.contour_edges, b.contour_edges);
  ASSERT_EQ(a.loops.size(), b.loops.size());
  for (std::size_t i = 0; i < a.loops.size(); ++i)
    EXPECT_EQ(a.loops[i].points, b.loops[i].points);
  const Mesh &m = once->regions.mesh.surface_mesh, &n = twice->regions.mesh.surface_mesh;
  for (const auto vertex : m.vertices())
    EXPECT_EQ(m.point(vertex), n.point(vertex));
}

TEST(Regions, refuse_what_cannot_be_meshed)
{
  Domain_options few;
  few.max_vertices = 100;
  const auto many = mesh_trichotomy(graph(u * v), few);
  ASSERT_FALSE(many);
  EXPECT_EQ(many.refusal().code(), Refusal_code::LIMIT_EXCEEDED);
  Contour_2 slit;
  slit.curves.push_back({{{0, 0.5}, {0.5, 0.5}}, false, {-1, -1}});
  const auto open_end = divide_domain(slit, [](const Point_2&) { return 0; });
  ASSERT_FALSE(open_end);
  EXPECT_EQ(open_end.refusal().code(), Refusal_code::UNDECIDED);
  const Point p{Q(1), Q(2), Q(3)}, q{Q(2), Q(2), Q(3)};
  const auto curve = mesh_regions(bilinear(p, p, q, q), {}, [](const Point_2&) { return 0; });
  ASSERT_FALSE(curve);
  EXPECT_EQ(curve.refusal().code(), Refusal_code::IRREGULAR_PARAMETRISATION);
  const Patch with_pole(Points{{p, q}, {q, p}}, Weights{{Q(1), Q(1)}, {Q(1), Q(-1)}});
  const auto pole = mesh_regions(with_pole, {}, [](const Point_2&) { return 0; });
  ASSERT_FALSE(pole);
  EXPECT_EQ(pole.refusal().code(), Refusal_code::POLE);
  const auto stopped = mesh_regions(graph(u * v), {}, [](const Point_2&) { return 0; }, {},
                                    [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.refusal().code(), Refusal_code::CANCELLED);
}

std::string contents(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// Numbers as people write them in some countries.
struct Other_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Regions, as_pictures)
{
  const auto directory = std::filesystem::path(testing::TempDir()) / "region_pictures";
  std::filesystem::create_directories(directory);
  const std::string file = (directory / "map.svg").string();
  const P f = u * (y() * y() - x() * x() * (x() + constant(Q(1) / Q(4))));
  const auto c = contour(f);
  const auto d = divide_domain(*c, Sign_classifier(f));
  Svg_options options;
  options.title = "a < b & c";
  options.region_names = {"negative"};
  std::string reason;
  ASSERT_TRUE(write_svg(file, *d, *c, options, reason)) << reason;
  const std::string text = contents(file);
  for (const char* part : {">a &lt; b &amp; c<", ">u<", ">v<", ">negative<", ">region 1<",
                           "not resolved", "#E69F00", "#56B4E9", ">0.25<"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
  EXPECT_FALSE(write_svg(file + ".png", *d, *c, options, reason));
  EXPECT_NE(reason.find("must be .svg"), std::string::npos) << reason;
  EXPECT_FALSE(write_svg((directory / "none" / "map.svg").string(), *d, *c, options, reason));
  EXPECT_NE(reason.find("no directory"), std::string::npos) << reason;
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new Other_numbers));
  EXPECT_TRUE(write_svg(file, *d, *c, options, reason));
  std::locale::global(before);
  EXPECT_EQ(contents(file), text);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
  EXPECT_EQ(trichotomy_names()[index(Region::SADDLE)], "saddle");
  std::filesystem::remove_all(directory);
}

} // namespace
