// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The tasks mesh and line of the program on systems: topology and ends that are known, files,
// refusals, and messages about fields.

#include "Model_error.h"
#include "read_model.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/IO/read_ply.h>
#include <CGAL/Shape_interrogation/IO/write_polylines.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace interrogate;
namespace fs = std::filesystem;

const char* const surfaces = R"json({
  "sphere": { "kind": "implicit", "f": "x^2+y^2+z^2-4" },
  "plane": { "kind": "implicit", "f": "z", "variables": ["x", "y", "z"] },
  "ellipsoid": { "kind": "implicit", "f": "x^2/4+y^2+z^2-1" },
  "saddle": { "kind": "bezier", "control_points": [[[0,0,0], [0,1,1]], [[1,0,1], [1,1,0]]] },
  "pieces": { "kind": "nurbs", "degree": [1, 1], "knots": [[0,0,1,2,2], [0,0,1,1]],
    "control_points": [[[0,0,0], [0,1,0]], [[1,0,1], [1,1,1]], [[2,0,0], [2,1,0]]] },
  "strip": { "kind": "parametric", "x": ["u", "v", "u*v"], "domain": [[-1, 1], [-2, 2]] },
  "offset": { "kind": "offset_system", "of": "sphere", "distance": "1/2" },
  "turned": { "kind": "offset_system", "of": "sphere", "distance": "1/2", "flip": true },
  "upward": { "kind": "offset_system", "of": "plane", "distance": 1, "orient": [0, 0, -1],
    "bounds": { "x": [0, 1], "y": [0, 1] } },
  "folded": { "kind": "offset_system", "of": "ellipsoid", "distance": "3/4" },
  "three": { "kind": "equal_distance", "of": [{ "point": [0, 0, 1] },
    { "kind": "implicit", "f": "z+1" }, { "kind": "implicit", "f": "x+1" }] },
  "both": { "kind": "system", "variables": ["x", "y", "z", "t"],
    "equations": ["t-(x^2+y^2+z^2-1)", "t*((x-3)^2+y^2+z^2-1)"] },
  "cone": { "kind": "system", "variables": ["x", "y", "z"], "equations": ["x^2+y^2-z^2"],
    "bounds": { "z": [-1, 1] } },
  "square": { "kind": "system", "variables": ["x", "y", "z", "nx", "_nx", "u"],
    "equations": ["z", "nx-x", "_nx-y", "u-1"],
    "bounds": { "x": [0, 1], "y": [0, 1], "z": [-1, 1] } },
  "empty": { "kind": "system", "variables": ["x", "y", "z"], "equations": ["x^2+y^2+z^2+1"] },
  "root": { "kind": "bezier", "control_points": [[[0,0,0], [0,1,1]], [[1,0,1], [1,1,"sqrt(2)"]]] },
  "pole": { "kind": "parametric", "x": ["u", "1/v", "u*v"] },
  "later": { "kind": "offset", "of": "sphere", "distance": 1 } })json";

std::string model_with(const std::string& task)
{
  return std::string("{\"surfaces\":") + surfaces + ",\"tasks\":[" + task + "]}";
}

std::string mesh_of(const std::string& surface, const std::string& rest,
                    const std::string& file = "m.ply")
{
  return R"({"task":"mesh","surface":")" + surface + R"(","file":")" + file + "\"," + rest + "}";
}

std::string line_of(const std::string& kind, const std::string& surface_field,
                    const std::string& rest)
{
  return R"({"task":"line","kind":")" + kind + R"(","surface)" + surface_field + "," + rest + "}";
}

void expect_message(const std::string& task, const std::string& part)
{
  try
  {
    read_model(model_with(task));
    ADD_FAILURE() << "this was read: " << task;
  }
  catch (const Model_error& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
      << "message:  " << error.what() << "\nexpected: " << part;
  }
}

std::string contents_of(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class System_tasks : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "systems-XXXXXX").string();
    ASSERT_NE(mkdtemp(&name[0]), nullptr);
    m_directory = name;
  }
  void TearDown() override { fs::remove_all(m_directory); }

  Task_result run(const std::string& task) const
  {
    const Model model = read_model(model_with(task));
    Progress_bar no_progress(false);
    return run_task(model, model.tasks.front(), {}, m_directory, no_progress);
  }

  // The fields of a task that has an answer.
  Report_json answer(const std::string& task) const
  {
    const Task_result result = run(task);
    EXPECT_EQ(result.status, "ok") << task << "\n" << result.text;
    EXPECT_EQ(result.number_type, "double");
    return result.fields;
  }

  void expect_whole(const Report_json& mesh, int euler_characteristic, std::size_t components) const
  {
    EXPECT_EQ(mesh["manifold"], true);
    EXPECT_EQ(mesh["euler_characteristic"], euler_characteristic);
    EXPECT_EQ(mesh["components"], components);
    EXPECT_EQ(mesh["rims"].size(), 0u);
    EXPECT_EQ(mesh["stops"]["number"], 0);
    EXPECT_LE(mesh["max_residual"]["approx"], 1e-12);
    EXPECT_LE(mesh["max_turning"]["approx"], 0.6);
    EXPECT_EQ(mesh["max_face_distance"]["certified"], false);
  }

  void expect_refused(const std::string& task, const std::string& status, const std::string& code,
                      const std::string& part) const
  {
    const Task_result result = run(task);
    EXPECT_EQ(result.status, status) << task;
    EXPECT_EQ(result.code, code) << task << "\n" << result.text;
    EXPECT_NE(result.text.find(part), std::string::npos) << result.text;
    EXPECT_FALSE(result.fields.contains("file")) << task;
  }

  si::Shape_mesh::Surface_mesh written_mesh(const std::string& file = "m.ply") const
  {
    si::Shape_mesh::Surface_mesh mesh;
    std::string reason;
    std::ifstream in(m_directory / file, std::ios::binary);
    EXPECT_TRUE(si::read_ply(in, mesh, reason)) << reason;
    return mesh;
  }

  fs::path m_directory;
};

const char* const sphere_start = R"("start":{"point":["5/2",0,0,2,0,0]},"edge_length":"1/2")";

TEST_F(System_tasks, offset_of_a_sphere)
{
  const Report_json mesh = answer(mesh_of("offset", sphere_start));
  expect_whole(mesh, 2, 1);
  EXPECT_EQ(mesh["boundary_edges"], 0);
  EXPECT_EQ(mesh["folds"].size(), 0u);
  EXPECT_EQ(mesh["refused_places"].size(), 0u);
  EXPECT_EQ(mesh["file"], "m.ply");
  EXPECT_FALSE(mesh.contains("tolerance"));
  const auto written = written_mesh();
  EXPECT_EQ(written.number_of_vertices(), mesh["vertices"].get<std::size_t>());
  // The foot points: p_x, p_y and p_z are read as a vector.
  using Mesh = si::Shape_mesh::Surface_mesh;
  const auto p =
    si::internal::find_map<Mesh::Vertex_index, si::Shape_mesh::Vector_3>(written, "v:p");
  ASSERT_TRUE(p.has_value());
  for (const auto v : written.vertices())
    EXPECT_LE(((*p)[v] * 1.25 - (written.point(v) - CGAL::ORIGIN)).squared_length(), 1e-20);
}

// "flip" turns normals, triangles and the signs of curvatures.
TEST_F(System_tasks, orientation)
{
  double sign[2];
  for (int i = 0; i < 2; ++i)
  {
    answer(mesh_of(i == 0 ? "offset" : "turned", sphere_start));
    auto mesh = written_mesh();
    const si::Shape_property_maps maps(mesh);
    const auto f = *mesh.faces().begin();
    const auto h = mesh.halfedge(f);
    const auto a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)),
               c = mesh.point(mesh.target(mesh.next(h)));
    sign[i] = maps.normal[mesh.source(h)] * (a - CGAL::ORIGIN) > 0 ? 1 : -1;
    EXPECT_GT(sign[i] * (CGAL::cross_product(b - a, c - a) * (a - CGAL::ORIGIN)), 0);
    for (const auto v : mesh.vertices())
    {
      EXPECT_GT(sign[i] * (maps.normal[v] * (mesh.point(v) - CGAL::ORIGIN)), 0);
      EXPECT_NEAR(maps.mean_curvature[v], sign[i] * 0.4, 1e-10);
      EXPECT_LE(maps.kmin[v], maps.kmax[v]);
    }
  }
  EXPECT_EQ(sign[0], -sign[1]);

  const Report_json planes =
    answer(mesh_of("upward", R"("start":[{"point":["1/2","1/2",1,"1/2","1/2",0]},)"
                             R"({"point":["1/2","1/2",-1,"1/2","1/2",0]}],"edge_length":"1/4")"));
  EXPECT_EQ(planes["components"], 2);
  auto mesh = written_mesh();
  const si::Shape_property_maps maps(mesh);
  for (const auto v : mesh.vertices())
    EXPECT_NEAR(maps.normal[v].z(), -1, 1e-12);
}

// Both principal curvatures reach the distance twice, in circles around the long axis.
TEST_F(System_tasks, inner_offset_beyond_the_focal_points)
{
  const Report_json mesh = answer(mesh_of(
    "folded", R"("start":{"point":[0,"1/4",0,0,1,0]},"edge_length":"1/10","colour":"kmin",)"
              R"("folds_file":"folds.ply")"));
  expect_whole(mesh, 2, 1);
  ASSERT_EQ(mesh["folds"].size(), 4u);
  std::size_t points = 0;
  for (const Report_json& fold : mesh["folds"])
  {
    EXPECT_EQ(fold["closed"], true);
    points += fold["points"].size();
  }
  EXPECT_GT(mesh["colour"]["range"]["approx"], 1);
  const std::string folds = contents_of(m_directory / "folds.ply");
  EXPECT_NE(folds.find("element vertex " + std::to_string(points)), std::string::npos);
  EXPECT_NE(folds.find("element edge " + std::to_string(points)), std::string::npos);
  EXPECT_NE(folds.find("property double p_z"), std::string::npos);
}

TEST_F(System_tasks, search_in_a_box)
{
  const Report_json two =
    answer(mesh_of("both", R"("box":[[-2,5],[-2,2],[-2,2]],"edge_length":"1/3")"));
  expect_whole(two, 4, 2);
  // The box cuts, with "start" and without.
  const Report_json one =
    answer(mesh_of("both", R"("box":[[-2,"3/2"],[-2,2],[0,2]],"edge_length":"1/3")"));
  EXPECT_EQ(one["components"], 1);
  EXPECT_EQ(one["euler_characteristic"], 1);
  const Report_json half = answer(mesh_of("offset", std::string(sphere_start) +
                                            R"(,"box":[[-3,3],[-3,3],[0,3]])"));
  expect_whole(half, 1, 1);
  for (const auto v : written_mesh().vertices())
    EXPECT_GE(written_mesh().point(v).z(), 0);
}

// The names of variables that are taken in the file get underscores in front.
TEST_F(System_tasks, bounds_are_a_box_and_variables_are_properties)
{
  const Report_json mesh = answer(mesh_of("square", R"("edge_length":"1/3")"));
  expect_whole(mesh, 1, 1);
  const std::string text = contents_of(m_directory / "m.ply");
  for (const char* name : {"_nx", "__nx", "_u"})
    EXPECT_NE(text.find(std::string("property double ") + name + "\n"), std::string::npos) << name;
  EXPECT_EQ(text.find("property double u\n"), std::string::npos);
}

TEST_F(System_tasks, singular_points_are_reported)
{
  const Report_json mesh =
    answer(mesh_of("cone", R"("start":{"point":{"x":1,"y":0,"z":1}},"edge_length":"1/5")"));
  ASSERT_EQ(mesh["rims"].size(), 1u);
  EXPECT_EQ(mesh["rims"][0]["closed"], true);
  EXPECT_GT(mesh["stops"]["number"], 0);
  EXPECT_EQ(mesh["stops"]["first"][0]["code"], "rank_deficient");
  EXPECT_LE(mesh["stops"]["first"].size(), 10u);
}

TEST_F(System_tasks, meshes_that_are_refused)
{
  expect_refused(mesh_of("empty", R"("box":[[-1,1],[-1,1],[-1,1]],"edge_length":1)"), "refused",
                 "not_on_solution", "no start point");
  expect_refused(mesh_of("offset", R"("start":{"point":[1,0,0,2,0,0]},"edge_length":"1/100",)"
                                   R"("max_vertices":100)"),
                 "refused", "limit_exceeded", "more than 100 vertices");
  expect_refused(mesh_of("cone", R"("start":[{"point":[1,0,1]},{"point":[3,0,3]}],)"
                                 R"("edge_length":1)"),
                 "refused", "outside_domain", "start point 2");
  expect_refused(mesh_of("cone", R"("box":[[0,1],[0,1],[2,3]],"edge_length":1)"), "refused",
                 "limit_exceeded", "bounds of z are empty");
  expect_refused(mesh_of("offset", std::string(sphere_start) + R"(,"tolerance":1)"), "error",
                 "unsupported", "\"tolerance\"");
  expect_refused(mesh_of("offset", std::string(sphere_start) + R"(,"number_type":"exact")"),
                 "error", "unsupported", "the mesh of a system in the number type");
  expect_refused(mesh_of("saddle", R"("start":{"parameters":[0,0]},"edge_length":1)"), "error",
                 "unsupported", "\"start\"");
  expect_refused(R"({"task":"mesh","surfaces":["offset","turned"],"file":"m.ply",)" +
                   std::string(sphere_start) + "}",
                 "error", "unsupported", "meshed alone");
  expect_refused(mesh_of("three", R"("start":{"point":[0,0,0,0,0,-1,-1,0,0]},"edge_length":1)"),
                 "refused", "not_two_dimensional", "");
}

const char* const three_start = R"("start":{"point":[0,0,0,0,0,-1,-1,0,0]},"step":"1/10")";

double length_of(const Report_json& line)
{
  const auto& points = line["polyline"];
  double sum = 0;
  for (std::size_t i = line["closed"] ? 0 : 1; i < points.size(); ++i)
  {
    const auto& p = points[i], & q = points[i == 0 ? points.size() - 1 : i - 1];
    sum += std::hypot(p[0].get<double>() - q[0].get<double>(),
                      p[1].get<double>() - q[1].get<double>(),
                      p[2].get<double>() - q[2].get<double>());
  }
  return sum;
}

TEST_F(System_tasks, line_of_one_system)
{
  // x^2 + y^2 = 4 x in the plane z = x.
  const Report_json line = answer(line_of("intersection", R"(":"three")", three_start));
  EXPECT_EQ(line["closed"], true);
  EXPECT_EQ(line["ended"], Report_json({"closed", "closed"}));
  EXPECT_EQ(line["variables"].size(), 9u);
  EXPECT_EQ(line["points"].size(), line["vertices"].get<std::size_t>());
  EXPECT_LE(line["max_residual"]["approx"], 1e-12);
  for (const Report_json& p : line["polyline"])
  {
    const double x = p[0], y = p[1], z = p[2];
    EXPECT_NEAR(x * x + y * y, 4 * x, 1e-10);
    EXPECT_NEAR(z, x, 1e-10);
  }
}

TEST_F(System_tasks, lines_of_two_surfaces)
{
  const double pi = std::acos(-1.);
  const Report_json equator = answer(line_of("intersection", R"(s":["sphere","plane"])",
                                             R"("start":{"point":[2,0,0]},"step":"1/10")"));
  EXPECT_EQ(equator["closed"], true);
  EXPECT_NEAR(length_of(equator), 4 * pi, 0.02);
  EXPECT_FALSE(equator.contains("points"));

  // A locator on each, or one of both with the names of intersection_system().
  const std::string size = R"("step":"1/10","file":"c.vtp")";
  const Report_json list = answer(line_of(
    "intersection", R"(s":["offset","folded"])",
    R"("start":[{"point":[0,"5/2",0,0,2,0]},{"point":[1.8,1.2,1.2,1.4,0.5,0.5]}],)" + size));
  EXPECT_EQ(list["variables"],
            Report_json({"x", "y", "z", "p_x", "p_y", "p_z", "_p_x", "_p_y", "_p_z"}));
  for (const Report_json& p : list["polyline"])
    EXPECT_NEAR(std::hypot(p[0].get<double>(), p[1].get<double>(), p[2].get<double>()), 2.5,
                1e-10);
  Report_json start;
  for (std::size_t i = 0; i < 9; ++i)
    start[list["variables"][i].get<std::string>()] = list["points"][0][i];
  const Report_json joint = answer(line_of("intersection", R"(s":["offset","folded"])",
                                           R"("start":{"point":)" + start.dump() + "}," + size));
  EXPECT_EQ(joint["closed"], list["closed"]);
  EXPECT_NEAR(length_of(joint), length_of(list), 0.01);

  // z = x + y - 2 x y = 1/2 in the domain: x = 1/2 or y = 1/2.
  const Report_json patch =
    answer(line_of("section", R"(":"saddle")",
                   R"("plane":[0,0,1,"-1/2"],"start":{"parameters":[0.1,0.5]},"step":"1/20")"));
  EXPECT_EQ(patch["ended"][0], "bound");
  EXPECT_EQ(patch["ended"][1], "singular");
  EXPECT_EQ(patch["ends"][1]["box"].size(), 5u);
  EXPECT_EQ(patch["ends"][1]["certified"], false); // the box is an estimate
  EXPECT_FALSE(patch["ends"][0].contains("certified"));
  const Report_json strip = answer(line_of(
    "intersection", R"(s":["strip","sphere"])",
    R"("start":[{"parameters":[1,1.3]},{"point":[1,1.3,1.3]}],"step":"1/10")"));
  EXPECT_EQ(strip["ended"], Report_json({"bound", "bound"}));
}

TEST_F(System_tasks, sections)
{
  const double pi = std::acos(-1.);
  const Report_json circle = answer(line_of(
    "section", R"(":"offset")",
    R"("plane":[0,0,2,-3],"start":{"point":[2,0,1.5,1.6,0,1.2]},"step":"1/10","file":"c.obj")"));
  EXPECT_EQ(circle["closed"], true);
  EXPECT_NEAR(length_of(circle), 4 * pi, 0.02);
  const std::string obj = contents_of(m_directory / "c.obj");
  EXPECT_EQ(obj.substr(0, 2), "v ");
  EXPECT_EQ(obj.substr(obj.size() - 3), " 1\n"); // closed
  const Report_json fixed = answer(line_of(
    "section", R"(":"offset")",
    R"("fixed":{"p_z":"6/5"},"start":{"point":[2,0,1.5,1.6,0,1.2]},"step":"1/10")"));
  EXPECT_NEAR(length_of(fixed), length_of(circle), 1e-6);
  const Report_json cut = answer(line_of(
    "section", R"(":"plane")",
    R"("plane":[1,0,0,0],"start":{"point":[0,0,0]},"step":"1/10","box":[[-1,1],[-1,2],[-1,1]])"));
  EXPECT_NEAR(length_of(cut), 3, 1e-12);
  // The length of the normal makes no difference.
  for (const char* c : {"1e-300", "1e300"})
  {
    const Report_json scaled = answer(line_of(
      "section", R"(":"sphere")",
      std::string(R"("plane":[0,0,")") + c + R"(",0],"start":{"point":[2,0,0]},"step":"1/10")"));
    EXPECT_EQ(scaled["closed"], true);
  }
  const Report_json limited = answer(line_of(
    "section", R"(":"plane")",
    R"("plane":[1,0,0,0],"start":{"point":[0,0,0]},"step":"1/10","max_points":10)"));
  EXPECT_EQ(limited["ended"], Report_json({"limit", "limit"}));
  EXPECT_EQ(limited["vertices"], 21);
}

TEST_F(System_tasks, lines_that_are_refused)
{
  const std::string at = R"("start":{"point":[2,0,0]},"step":1)";
  expect_refused(line_of("intersection", R"(":"sphere")", at), "refused", "underdetermined", "");
  expect_refused(line_of("ridge", R"(":"sphere")", at), "error", "unsupported", "\"ridge\"");
  expect_refused(line_of("section", R"(":"later")", at), "error", "unsupported", "\"offset\"");
  expect_refused(line_of("section", R"(":"pieces")", R"("start":{"parameters":[0,0]},"step":1)"),
                 "error", "unsupported", "several knot spans");
  expect_refused(line_of("section", R"(":"root")", R"("plane":[1,0,0,0],)"
                                                   R"("start":{"parameters":[0,0]},"step":1)"),
                 "refused", "not_algebraic", "");
  expect_refused(line_of("section", R"(":"pole")", R"("plane":[1,0,0,0],)"
                                                   R"("start":{"parameters":[1,0]},"step":1)"),
                 "refused", "pole", "zero at this point");
  expect_refused(line_of("intersection", R"(":"three")",
                         std::string(three_start) + R"(,"number_type":"exact")"),
                 "error", "unsupported", "in \"double\"");
  expect_refused(line_of("intersection", R"(":"three")",
                         std::string(three_start) + R"(,"box":[[1,2],[1,2],[1,2]])"),
                 "refused", "outside_domain", "");
}

TEST_F(System_tasks, messages_name_the_place)
{
  const std::string mesh_start = R"("edge_length":1,"start":)";
  const std::string three = R"(":"three")", sphere = R"(":"sphere")";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {mesh_of("offset", R"("edge_length":1)"), "tasks[0]: a system is meshed from \"start\""},
    {mesh_of("offset", mesh_start + "[]"), "tasks[0].start: expected one locator or more"},
    {mesh_of("offset", mesh_start + "7"), "tasks[0].start"},
    {mesh_of("offset", mesh_start + R"({"parameters":[1,2]})"), "tasks[0].start"},
    {mesh_of("offset", mesh_start + R"([{"point":[1,2]}])"),
     "tasks[0].start[0].point: expected an array of 6 numbers (x, y, z, p_x, p_y, p_z)"},
    {mesh_of("offset", mesh_start + R"({"point":{"x":1}})"), "tasks[0].start.point"},
    {mesh_of("offset", mesh_start + R"({"point":[1,2,3,4,5,"1e400"]})"),
     "tasks[0].start.point[5]: this number is used in floating point"},
    {mesh_of("offset", std::string(sphere_start) + R"(,"box":[[0,1],[0,1]])"), "tasks[0].box"},
    {mesh_of("offset", std::string(sphere_start) + R"(,"box":[[0,1],[0,1],[0,"1e400"]])"),
     "tasks[0].box[2][1]"},
    {mesh_of("offset", std::string(sphere_start) + R"(,"folds_file":"f.off")"),
     "ends in .vtp, .ply or .obj"},
    {mesh_of("offset", std::string(sphere_start) + R"(,"folds_file":"m.ply")"),
     "two tasks write the file m.ply"},
    {mesh_of("saddle", R"("edge_length":1,"folds_file":"f.ply")"), "tasks[0].folds_file"},
    {line_of("zigzag", three, three_start), "tasks[0].kind: expected the kind of a line"},
    {line_of("intersection", R"(":"nothing")", three_start), "tasks[0].surface"},
    {line_of("intersection", R"(s":["three","three","three"])", three_start), "tasks[0].surfaces"},
    {line_of("intersection", R"(s":["sphere","plane"])", R"("start":[{"point":[1,0,0]}],"step":1)"),
     "tasks[0].start"},
    {line_of("intersection", three, R"("start":{"point":[1,2,3]},"step":1)"),
     "tasks[0].start.point"},
    {line_of("intersection", three, R"("step":1)"), "start"},
    {line_of("intersection", three, std::string(three_start) + R"(,"plane":[1,0,0,0])"),
     "tasks[0]: unknown field \"plane\""},
    {line_of("section", sphere, R"("start":{"point":[2,0,0]},"step":0,"plane":[1,0,0,0])"),
     "tasks[0].step"},
    {line_of("section", sphere, R"("start":{"point":[2,0,0]},"step":1)"), "plane"},
    {line_of("section", sphere, R"("start":{"point":[2,0,0]},"step":1,"plane":[0,0,0,1])"),
     "tasks[0].plane: a plane [a,b,c,d] needs a normal"},
    {line_of("section", sphere,
             R"("start":{"point":[2,0,0]},"step":1,"plane":["1e-200",0,0,"1e200"])"),
     "tasks[0].plane: the plane is too far away"},
    {line_of("section", sphere, R"("start":{"point":[2,0,0]},"step":1,"fixed":{"w":1})"),
     "tasks[0].fixed.w: there is no variable of this name, the variables are: x, y, z"},
    {line_of("section", sphere, R"("start":{"point":[2,0,0]},"step":1,"fixed":{"x":1,"y":0})"),
     "tasks[0].fixed: expected one variable"},
    {line_of("section", sphere,
             R"("start":{"point":[2,0,0]},"step":1,"fixed":{"x":1},"plane":[1,0,0,0])"),
     "both \"plane\" and \"fixed\""},
    {line_of("section", sphere,
             R"("start":{"point":[2,0,0]},"step":1,"plane":[1,0,0,0],"file":"a.stl")"),
     "tasks[0].file"}};
  for (const auto& [task, message] : cases)
    expect_message(task, message);
}

// A file that cannot be written leaves what was there, and nothing beside it.
TEST_F(System_tasks, output_that_cannot_be_written)
{
  fs::create_directories(m_directory / "m.ply/inside");
  fs::create_directories(m_directory / "c.vtp/inside");
  expect_refused(mesh_of("offset", sphere_start), "error", "output", "it is a directory");
  expect_refused(line_of("intersection", R"(":"three")",
                         std::string(three_start) + R"(,"file":"c.vtp")"),
                 "error", "output", "it is a directory");
  std::ofstream(m_directory / "plain") << "text";
  expect_refused(line_of("intersection", R"(":"three")",
                         std::string(three_start) + R"(,"file":"plain/c.vtp")"),
                 "error", "output", "there is no directory");
  EXPECT_EQ(contents_of(m_directory / "plain"), "text");
  EXPECT_EQ(std::distance(fs::directory_iterator(m_directory), fs::directory_iterator()), 3);
}

TEST_F(System_tasks, equal_calls_give_equal_files)
{
  const std::string mesh =
    mesh_of("both", R"("box":[[-2,5],[-2,2],[-2,2]],"edge_length":"1/3")", "m.vtp");
  const std::string line =
    line_of("intersection", R"(":"three")", std::string(three_start) + R"(,"file":"c.vtp")");
  const Report_json mesh_report = answer(mesh), line_report = answer(line);
  const std::string mesh_file = contents_of(m_directory / "m.vtp"),
                    line_file = contents_of(m_directory / "c.vtp");
  EXPECT_GT(mesh_file.size(), 1000u);
  EXPECT_NE(line_file.find("Name=\"p_B_x\""), std::string::npos);
  EXPECT_EQ(answer(mesh), mesh_report);
  EXPECT_EQ(answer(line), line_report);
  EXPECT_EQ(contents_of(m_directory / "m.vtp"), mesh_file);
  EXPECT_EQ(contents_of(m_directory / "c.vtp"), line_file);
}

TEST_F(System_tasks, polylines)
{
  const std::vector<si::N_space_polyline> lines{
    {{{0, 0, 0, 7}, {1, 0, 0, 8}, {0, 1, 0, 0.1}}, true}, {{{0, 0, 1, 1}, {0, 0, 2, 2}}, false}};
  const std::string file = (m_directory / "l").string();
  std::string reason;
  EXPECT_TRUE(si::write_polylines(file + ".obj", lines, {}, reason)) << reason;
  EXPECT_EQ(contents_of(file + ".obj"),
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 2\nl 1 2 3 1\nl 4 5\n");
  EXPECT_TRUE(si::write_polylines(file + ".ply", lines, {"x", "y", "z", "y"}, reason)) << reason;
  EXPECT_EQ(contents_of(file + ".ply"),
            "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
            "property double z\nproperty double _y\nelement edge 4\nproperty int vertex1\n"
            "property int vertex2\nend_header\n0 0 0 7\n1 0 0 8\n0 1 0 0.1\n0 0 1 1\n0 0 2 2\n"
            "0 1\n1 2\n2 0\n3 4\n");
  EXPECT_FALSE(si::write_polylines(file + ".off", lines, {}, reason));
  EXPECT_NE(reason.find("must be .vtp, .ply or .obj, not .off"), std::string::npos);
  EXPECT_FALSE(si::write_polylines(file + ".obj", {{{{0, 0, std::nan("")}}, false}}, {}, reason));
  EXPECT_NE(reason.find("not a finite number"), std::string::npos);
  EXPECT_TRUE(si::write_polylines(file + ".vtp", {}, {}, reason)) << reason;
}

} // namespace
