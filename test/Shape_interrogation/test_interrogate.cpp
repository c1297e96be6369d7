// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The program as its users call it: exit status, messages, reports, and the number types.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path examples = fs::path(SHAPE_INTERROGATION_TEST_DATA).parent_path().parent_path()
                            .parent_path() / "examples/Shape_interrogation/data";

struct Outcome
{
  int status;
  std::string output; // of both streams
};

Outcome run(const std::string& arguments)
{
  const std::string command = "'" SHAPE_INTERROGATION_PROGRAM "' " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Outcome result{-1, ""};
  for (char block[4096]; std::size_t n = std::fread(block, 1, sizeof block, pipe);)
    result.output.append(block, n);
  const int status = pclose(pipe);
  if (WIFEXITED(status))
    result.status = WEXITSTATUS(status);
  return result;
}

// A directory of its own for each test.
class Program : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "interrogate-XXXXXX").string();
    ASSERT_NE(mkdtemp(&name[0]), nullptr);
    m_directory = name;
  }
  void TearDown() override { fs::remove_all(m_directory); }

  fs::path write(const std::string& name, const std::string& text) const
  {
    std::ofstream(m_directory / name) << text;
    return m_directory / name;
  }

  // Runs the model and returns the report; the status is expected.
  Json report(const fs::path& model, int status, const std::string& options = "") const
  {
    const fs::path out = m_directory / "out";
    const Outcome r = run("'" + model.string() + "' --out '" + out.string() + "' " + options);
    EXPECT_EQ(r.status, status) << r.output;
    std::ifstream in(out / "report.json");
    EXPECT_TRUE(in.good()) << r.output;
    return Json::parse(in, nullptr, false);
  }

  void expect_unusable(const std::string& arguments, const std::string& part) const
  {
    const Outcome r = run(arguments);
    EXPECT_EQ(r.status, 2) << arguments << "\n" << r.output;
    EXPECT_NE(r.output.find(part), std::string::npos) << arguments << "\n" << r.output;
  }

  fs::path m_directory;
};

const char* const sphere_model = R"({"surfaces":{"s":{"kind":"implicit","f":"x^2+y^2+z^2-9"}},
  "tasks":[{"task":"curvature","surface":"s","at":{"point":[1,2,2]}}]})";

TEST_F(Program, appendix_of_chuang_and_hoffmann)
{
  const Json tasks = report(examples / "appendix.json", 0)["tasks"];
  ASSERT_EQ(tasks.size(), 2u);
  for (const Json& t : tasks)
  {
    EXPECT_EQ(t["status"], "ok");
    EXPECT_EQ(t["number_type"], "exact");
    EXPECT_EQ(t["gaussian_curvature"]["exact"], "0");
    EXPECT_EQ(t["sign_of_gaussian_curvature"], 0);
    EXPECT_EQ(t["normal_curvature"]["sign"], 0);
    EXPECT_EQ(t["normal_curvature"]["squared"]["exact"], "0");
    EXPECT_EQ(t["mean_curvature"]["sign"], 1);
    EXPECT_EQ(t["mean_curvature"]["squared"]["exact"],
              "349664/10994427+3056032/560715777*sqrt(17)");
    EXPECT_DOUBLE_EQ(t["mean_curvature"]["approx"], 0.232971325173270299);
    EXPECT_EQ(t["umbilic"], false);
    EXPECT_EQ(t["planar"], false);
    EXPECT_EQ(t["normal"][0]["exact"], "32");
  }
}

// The same surface from its two cylinders and the circle.
TEST_F(Program, ruled_surface_from_constraints)
{
  const Json written = report(examples / "appendix.json", 0)["tasks"][0];
  const Json stated = report(examples / "ruled.json", 0)["tasks"][0];
  for (const char* field : {"status", "number_type", "point", "normal", "gaussian_curvature",
                            "mean_curvature", "principal_curvatures", "principal_directions",
                            "shape_operator", "normal_curvature", "umbilic", "planar"})
    EXPECT_EQ(written[field], stated[field]) << field;
}

// K and H of the offset at the distance d are K / (1 + 2 d H + d^2 K) and (H + d K) / the same.
TEST_F(Program, examples_of_constructions)
{
  const auto exact = [](const Json& task, const char* field) {
    EXPECT_EQ(task["status"], "ok") << task;
    return task[field]["exact"].get<std::string>();
  };
  const Json offset = report(examples / "offset.json", 0)["tasks"];
  EXPECT_EQ(exact(offset[0], "gaussian_curvature"), "9604/28561");
  EXPECT_EQ(exact(offset[0], "mean_curvature"), "1526/2197");
  EXPECT_EQ(exact(offset[1], "gaussian_curvature"), "2401/12700");
  EXPECT_EQ(exact(offset[1], "mean_curvature"), "308/635");
  EXPECT_EQ(exact(offset[2], "gaussian_curvature"), "2401/2781");
  EXPECT_EQ(exact(offset[2], "mean_curvature"), "1253/927");
  const Json bisector = report(examples / "bisector.json", 0)["tasks"];
  EXPECT_EQ(exact(bisector[0], "gaussian_curvature"), "-4/81"); // of z = (y^2 - x^2) / 4
  EXPECT_EQ(exact(bisector[1], "gaussian_curvature"), "1/9");   // of z = (x^2 + y^2) / 4
  const Json torus = report(examples / "rolling_ball.json", 0)["tasks"];
  EXPECT_EQ(exact(torus[0], "gaussian_curvature"), "3/23");
  EXPECT_EQ(torus[0]["principal_curvatures"][0]["exact"], "3/23");
  EXPECT_EQ(torus[0]["principal_curvatures"][1]["exact"], "1");
}

TEST_F(Program, meshes_and_lines_of_the_examples)
{
  const Json ruled = report(examples / "ruled.json", 0)["tasks"];
  EXPECT_EQ(ruled[1]["euler_characteristic"], 1);
  EXPECT_EQ(ruled[2]["ends"][0]["text"], "lambda is 0");
  EXPECT_EQ(ruled[2]["ends"][1]["text"], "lambda is 1");
  EXPECT_EQ(ruled[3]["ended"], Json({"bound", "bound"}));
  const Json folded = report(examples / "offset.json", 0)["tasks"][3];
  EXPECT_EQ(folded["euler_characteristic"], 2);
  EXPECT_EQ(folded["boundary_edges"], 0);
  EXPECT_EQ(folded["folds"].size(), 4u);
  const Json bisector = report(examples / "bisector.json", 0)["tasks"];
  EXPECT_EQ(bisector[2]["euler_characteristic"], 1);
  EXPECT_EQ(bisector[3]["closed"], true);
  const Json torus = report(examples / "rolling_ball.json", 0)["tasks"];
  EXPECT_EQ(torus[1]["euler_characteristic"], 0);
  EXPECT_EQ(torus[1]["boundary_edges"], 0);
  EXPECT_EQ(torus[2]["closed"], true);
  for (const Json& t : report(examples / "paper_figures.json", 0)["tasks"])
  {
    EXPECT_EQ(t["status"], "ok") << t["id"];
    EXPECT_TRUE(fs::exists(m_directory / "out" / t["file"].get<std::string>())) << t["id"];
  }
}

TEST_F(Program, number_types_and_decisions)
{
  // A sphere is umbilic everywhere; at this point only exact arithmetic can say so.
  const fs::path model = write("m.json", R"({
    "surfaces": { "s": { "kind": "implicit", "f": "x^2/3+y^2/3+z^2/3-1/3" },
                  "e": { "kind": "implicit", "f": "exp(x)*y+z" } },
    "tasks": [
      { "task": "curvature", "surface": "s", "at": { "point": ["1/3", "2/3", "2/3"] } },
      { "task": "curvature", "surface": "s", "at": { "point": ["1/3", "2/3", "2/3"] },
        "number_type": "interval" },
      { "task": "curvature", "surface": "s", "at": { "point": ["1/3", "2/3", "2/3"] },
        "number_type": "filtered" },
      { "task": "curvature", "surface": "s", "at": { "point": ["1/3", "2/3", "2/3"] },
        "number_type": "double" },
      { "task": "curvature", "surface": "e", "at": { "point": [0, 1, -1] } },
      { "task": "curvature", "surface": "e", "at": { "point": [0, 1, -1] },
        "number_type": "exact" } ] })");
  const Json t = report(model, 1)["tasks"];
  EXPECT_EQ(t[0]["number_type"], "exact");
  EXPECT_EQ(t[0]["umbilic"], true);
  EXPECT_EQ(t[0]["principal_curvatures"][0]["exact"], "1");
  EXPECT_FALSE(t[0].contains("principal_directions"));
  EXPECT_EQ(t[1]["status"], "undecided");
  EXPECT_EQ(t[1]["umbilic"], "undecided");
  EXPECT_EQ(t[1]["mean_curvature"]["sign"], 1);
  EXPECT_TRUE(t[1]["mean_curvature"].contains("interval"));
  EXPECT_EQ(t[2]["status"], "ok");
  EXPECT_EQ(t[2]["umbilic"], true);
  EXPECT_EQ(t[2]["gaussian_curvature"], Json::parse(R"({"approx":1.0,"sign":1})"));
  EXPECT_DOUBLE_EQ(t[3]["gaussian_curvature"]["approx"], 1);
  EXPECT_EQ(t[4]["number_type"], "filtered");
  EXPECT_EQ(t[4]["status"], "ok");
  EXPECT_EQ(t[5]["status"], "refused");
  EXPECT_EQ(t[5]["reason"]["code"], "not_algebraic");
}

TEST_F(Program, refusals_have_their_codes)
{
  const fs::path model = write("m.json", R"json({
    "surfaces": { "cone": { "kind": "implicit", "f": "x^2+y^2-z^2" },
                  "fold": { "kind": "parametric", "x": ["u^2", "u*v", "v^2"] },
                  "s": { "kind": "system", "variables": ["x","y","z","w"],
                         "equations": ["x-w"] } },
    "tasks": [
      { "task": "curvature", "surface": "cone", "at": { "point": [0, 0, 0] } },
      { "task": "curvature", "surface": "cone", "at": { "point": [0, 0, "1e-30"] } },
      { "task": "curvature", "surface": "fold", "at": { "parameters": [0, 0] } },
      { "task": "curvature", "surface": "s", "at": { "point": [0, 0, 0, 0] } },
      { "task": "curvature", "surface": "cone", "at": { "point": [3, 4, 5] },
        "direction": [1, 0, 0] },
      { "task": "curvature", "surface": "fold", "at": { "parameters": ["sqrt(2)", "sqrt(3)"] } },
      { "task": "shape_operator", "normal": [0, 0, 1], "curvatures": [1, 1, 1],
        "directions": [[1, 0, 0], [0, 1, 0], [2, 0, 0]] },
      { "task": "curvature", "surface": "cone", "at": { "point": [3, 4, 5] } } ] })json");
  const Json t = report(model, 1)["tasks"];
  const char* const codes[] = {"singular_point", "not_on_surface", "irregular_parametrisation",
                               "underdetermined", "not_tangent", "not_algebraic",
                               "dependent_directions"};
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_EQ(t[i]["status"], "refused") << i;
    EXPECT_EQ(t[i]["reason"]["code"], codes[i]);
    EXPECT_GT(t[i]["reason"]["text"].get<std::string>().size(), 5u);
  }
  EXPECT_EQ(t[7]["status"], "ok");
}

// --- Points that are proved ----------------------------------------------------------------------

// The offset of an ellipsoid, with three equations of rank two; a saddle with a vertical normal
// where x = 1/3; and a cylinder.
std::string enclosing_model(const std::string& tasks)
{
  return R"({ "surfaces": {
    "offset": { "kind": "system", "variables": ["x","y","z","p","q","s"], "equations": [
      "p^2/9 + q^2/4 + s^2 - 1", "(y-q)*2*s - (z-s)*q/2", "(z-s)*2*p/9 - (x-p)*2*s",
      "(x-p)*q/2 - (y-q)*2*p/9", "(x-p)^2 + (y-q)^2 + (z-s)^2 - 1/4"] },
    "saddle": { "kind": "system", "variables": ["x","y","z"],
                "equations": ["z + z^3 - 2*(x - 1/3)^2 + y^2"] },
    "tube": { "kind": "system", "variables": ["x","y","z","w"], "orient": [1,0,0],
              "equations": ["w - x/3", "9*w^2 + z^2 - 2"] },
    "wave": { "kind": "system", "variables": ["x","y","z"], "equations": ["z - sin(x)*y - x"] },
    "strip": { "kind": "system", "variables": ["x","y","z"], "equations": ["z - x*y"],
               "bounds": {"y": [0,1]} },
    "sphere": { "kind": "implicit", "f": "x^2 + y^2 + z^2 - 1" },
    "patch": { "kind": "bezier", "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]] } },
    "tasks": [)" + tasks + "] }";
}

TEST_F(Program, encloses_points_of_systems)
{
  const std::string at =
    R"({"task":"curvature","surface":"offset","at":{"point":[2.2,1.3,1,2,1.1,0.5],"enclose":true})";
  const Json t = report(write("m.json", enclosing_model(
    at + "}," + at + R"(,"number_type":"interval"},)" + at + R"(,"number_type":"filtered"},)" + at +
    R"(,"number_type":"double"})")), 0)["tasks"];
  ASSERT_EQ(t.size(), 4u);
  for (const Json& r : t)
  {
    EXPECT_EQ(r["status"], "ok");
    EXPECT_EQ(r["sign_of_gaussian_curvature"], 1);
    EXPECT_EQ(r["mean_curvature"]["sign"], 1);
    EXPECT_EQ(r["umbilic"], false);
    EXPECT_DOUBLE_EQ(r["gaussian_curvature"]["approx"], t[0]["gaussian_curvature"]["approx"]);
    const Json& e = r["enclosure"];
    ASSERT_EQ(e["box"].size(), 6u);
    for (const Json& x : e["box"])
    {
      const double low = std::stod(x["interval"][0].get<std::string>());
      const double high = std::stod(x["interval"][1].get<std::string>());
      EXPECT_LE(low, high);
      EXPECT_LT(high - low, 1e-14);
    }
    EXPECT_EQ(e["fixed"].size(), 2u);
    for (const auto& [name, value] : e["fixed"].items())
      EXPECT_TRUE(value.contains("exact")) << name;
    EXPECT_EQ(e["equations"].size(), 4u);
    EXPECT_EQ(e["others_contain_zero"], true);
    ASSERT_EQ(e["others"].size(), 1u);
    EXPECT_TRUE(e["others"][0] >= 2 && e["others"][0] <= 4); // of the projection
    EXPECT_TRUE(e["proved_by_identities"].empty()); // nothing is known of written equations
  }
  EXPECT_TRUE(t[0]["gaussian_curvature"].contains("interval"));
  EXPECT_TRUE(t[1]["gaussian_curvature"].contains("interval"));
  EXPECT_EQ(t[2]["gaussian_curvature"].size(), 2u); // approx and sign
  EXPECT_EQ(t[3]["gaussian_curvature"].size(), 2u);
}

// The same offset as a construction, which knows the identity of its projection.
TEST_F(Program, proves_redundant_equations_of_constructions)
{
  const std::string task =
    R"({"task":"curvature","surface":"offset","at":{"point":[2.2,1.3,1,2,1.1,0.5],"enclose":true})";
  const Json t = report(write("m.json", R"({ "surfaces": {
    "ellipsoid": { "kind": "implicit", "f": "x^2/9 + y^2/4 + z^2 - 1" },
    "offset": { "kind": "offset_system", "of": "ellipsoid", "distance": "1/2" } },
    "tasks": [)" + task + "}," + task + R"(,"number_type":"interval"}] })"), 0)["tasks"];
  for (const Json& r : t)
  {
    const Json& e = r["enclosure"];
    EXPECT_EQ(e["equations"].size(), 4u);
    ASSERT_EQ(e["proved_by_identities"].size(), 1u);
    EXPECT_TRUE(e["proved_by_identities"][0] >= 2 && e["proved_by_identities"][0] <= 4);
    EXPECT_TRUE(e["others"].empty());
  }
}

// One equation of three variables; the normal is the gradient, not the one that a system orients.
TEST_F(Program, encloses_points_of_implicit_surfaces)
{
  const std::string at = R"({"task":"curvature","surface":"well",
    "at":{"point":[-0.5,0,-0.9],"enclose":true},"direction":[0,1,0])";
  const Json t = report(write("m.json", R"({ "surfaces": {
    "well": { "kind": "implicit", "f": "x^2/4 + y^2 + z^2 - 1" },
    "inside": { "kind": "implicit", "f": "x^2/4 + y^2 + z^2 - 1", "flip": true },
    "wave": { "kind": "implicit", "f": "z - sin(x)*y" } },
    "tasks": [)" + at + "}," + at + R"(,"number_type":"interval"},)" + at +
    R"(,"number_type":"filtered"},)" + at + R"(,"number_type":"double"},
    {"task":"curvature","surface":"inside","at":{"point":[-0.5,0,-0.9],"enclose":true}},
    {"task":"curvature","surface":"wave","at":{"point":[0.5,1,0.4],"enclose":true}}] })"),
    0)["tasks"];
  ASSERT_EQ(t.size(), 6u);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(t[i]["status"], "ok") << t[i];
    const Json& e = t[i]["enclosure"];
    EXPECT_EQ(e["box"].size(), 3u);
    EXPECT_EQ(e["fixed"].size(), 2u);
    EXPECT_EQ(e["equations"], Json::array({1}));
    EXPECT_TRUE(e["others"].empty());
  }
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(t[i]["sign_of_gaussian_curvature"], 1);
    EXPECT_DOUBLE_EQ(t[i]["gaussian_curvature"]["approx"], t[0]["gaussian_curvature"]["approx"]);
    EXPECT_LT(t[i]["normal"][0]["approx"], 0);
    EXPECT_EQ(t[i]["mean_curvature"]["sign"], t[0]["mean_curvature"]["sign"]);
    EXPECT_TRUE(t[i].contains("normal_curvature"));
  }
  EXPECT_EQ(t[4]["mean_curvature"]["sign"].get<int>(), -t[0]["mean_curvature"]["sign"].get<int>());
  EXPECT_EQ(t[5]["sign_of_gaussian_curvature"], -1);
}

TEST_F(Program, leaves_open_what_an_enclosure_does_not_decide)
{
  const std::string saddle =
    R"({"task":"curvature","surface":"saddle","at":{"point":["1/3",0,1e-7],"enclose":true})";
  const Json t = report(write("m.json", enclosing_model(
    saddle + R"(,"number_type":"interval"},)" + saddle + R"(},
      {"task":"curvature","surface":"tube","at":{"point":[1,0,1,"0.3"],"enclose":true},
       "direction":[0,1,0]},
      {"task":"curvature","surface":"wave","at":{"point":[0.5,1,1],"enclose":true}})")),
    1)["tasks"];
  // The first component of the normal, which orients it, is hardly not zero.
  EXPECT_EQ(t[0]["status"], "undecided");
  EXPECT_EQ(t[0]["mean_curvature"]["sign"], "undecided");
  EXPECT_EQ(t[0]["sign_of_gaussian_curvature"], -1);
  EXPECT_EQ(t[0]["umbilic"], false);
  EXPECT_FALSE(t[0].contains("principal_directions"));
  EXPECT_EQ(t[1]["status"], "ok");
  EXPECT_NEAR(std::abs(t[1]["mean_curvature"]["approx"].get<double>()), 1, 1e-12);
  EXPECT_EQ(t[2]["mean_curvature"]["sign"], 1);
  EXPECT_TRUE(t[2]["sign_of_gaussian_curvature"] == 0 ||
              t[2]["sign_of_gaussian_curvature"] == "undecided");
  EXPECT_EQ(t[3]["status"], "ok"); // transcendental: filtered, by enclosures
  EXPECT_EQ(t[3]["number_type"], "filtered");
  EXPECT_EQ(t[3]["sign_of_gaussian_curvature"], -1);
}

TEST_F(Program, does_not_guess_at_the_enclosed_point_of_the_appendix)
{
  std::ifstream in(examples / "appendix.json");
  Json model = Json::parse(in);
  Json task = model["tasks"][0];
  task.erase("id");
  task["at"]["enclose"] = true;
  model["tasks"] = Json::array();
  for (const char* type : {"exact", "interval", "filtered", "double"})
  {
    task["number_type"] = type;
    model["tasks"].push_back(task);
  }
  for (const Json& t : report(write("m.json", model.dump()), 1)["tasks"])
  {
    EXPECT_EQ(t["status"], "undecided") << t["number_type"];
    EXPECT_EQ(t["sign_of_gaussian_curvature"], "undecided");
    EXPECT_EQ(t["mean_curvature"]["sign"], 1);
    EXPECT_EQ(t["umbilic"], false);
    EXPECT_EQ(t["enclosure"]["equations"].size(), 14u);
    EXPECT_EQ(t["enclosure"]["others"].size(), 1u);
  }
}

TEST_F(Program, encloses_points_within_the_bounds)
{
  const std::string task = R"({"task":"curvature","surface":"strip","at":{"enclose":true,"point":)";
  for (const char* type : {"exact", "double", "interval", "filtered"})
  {
    const std::string in_type = std::string(R"(]},"number_type":")") + type + "\"}";
    const Json t = report(write("m.json", enclosing_model(
      task + "[1,0.5,0.5" + in_type + "," + task + "[1,1,1" + in_type + "," + task + "[1,2,2" +
      in_type)), 1)["tasks"];
    EXPECT_EQ(t[0]["status"], "ok") << type << t[0];
    EXPECT_EQ(t[1]["status"], "ok") << type << t[1];
    EXPECT_EQ(t[2]["status"], "refused") << type << t[2];
    EXPECT_EQ(t[2]["reason"]["code"], "outside_domain") << type << t[2];
  }
}

TEST_F(Program, refuses_what_it_cannot_enclose)
{
  const Json t = report(write("m.json", enclosing_model(
    R"({"task":"curvature","surface":"offset","at":{"point":[0,0,0,0,0,0],"enclose":true}},
       {"task":"curvature","surface":"offset",
        "at":{"point":["1e200",0,0,"1e200",0,0],"enclose":true}},
       {"task":"curvature","surface":"sphere","at":{"point":[0,0,0],"enclose":true}},
       {"task":"curvature","surface":"sphere","at":{"point":[1,0,0],"enclose":false}})")),
    1)["tasks"];
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(t[i]["status"], "refused") << i;
    EXPECT_FALSE(t[i].contains("enclosure"));
  }
  EXPECT_EQ(t[3]["status"], "ok");
  const auto unusable = [&](const std::string& task, const std::string& part) {
    const fs::path model = write("w.json", enclosing_model(task));
    expect_unusable("'" + model.string() + "' --out '" + (m_directory / "o").string() + "'", part);
  };
  unusable(R"({"task":"curvature","surface":"offset","at":{"point":[0,0,0,0,0,0],"enclose":1}})",
           "tasks[0].at.enclose: expected true or false");
  unusable(R"({"task":"curvature","surface":"patch","at":{"parameters":[0,0],"enclose":true}})",
           "tasks[0].at.enclose: a place with parameters is on the surface");
}

TEST_F(Program, both_sides_of_a_knot_are_reported)
{
  const fs::path model = fs::path(SHAPE_INTERROGATION_TEST_DATA) / "models/curves.json";
  const Json t = report(model, 0)["tasks"];
  EXPECT_EQ(t[0]["number_type"], "filtered"); // exp and sin
  EXPECT_EQ(t[2]["curvature"]["exact"], "2");
  ASSERT_EQ(t[3]["one_sided"].size(), 2u);
  EXPECT_EQ(t[3]["one_sided"][0]["side"], Json::parse(R"(["left"])"));
  EXPECT_EQ(t[3]["one_sided"][1]["curvature"], t[3]["curvature"]);
  EXPECT_NE(t[3]["one_sided"][0]["curvature"], t[3]["curvature"]);
}

TEST_F(Program, orientation)
{
  const fs::path model = write("m.json", R"({
    "surfaces": {
      "a": { "kind": "implicit", "f": "z-x^2-y^2" },
      "b": { "kind": "implicit", "f": "z-x^2-y^2", "flip": true },
      "c": { "kind": "system", "variables": ["x","y","z"], "equations": ["3*z-3*x^2-3*y^2"] },
      "d": { "kind": "system", "variables": ["x","y","z"], "equations": ["3*z-3*x^2-3*y^2"],
             "orient": [1, 0, -1] },
      "e": { "kind": "system", "variables": ["x","y","z"], "equations": ["3*z-3*x^2-3*y^2"],
             "orient": [1, 0, 0] } },
    "tasks": [
      { "task": "curvature", "surface": "a", "at": { "point": [0, 0, 0] } },
      { "task": "curvature", "surface": "b", "at": { "point": [0, 0, 0] } },
      { "task": "curvature", "surface": "c", "at": { "point": [0, 0, 0] } },
      { "task": "curvature", "surface": "d", "at": { "point": [0, 0, 0] } },
      { "task": "curvature", "surface": "e", "at": { "point": [0, 0, 0] } } ] })");
  const Json t = report(model, 1)["tasks"];
  const int normal[] = {1, -1, 1, -1}, sign[] = {-1, 1, -1, 1};
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(t[i]["normal"][2]["exact"], std::to_string(normal[i])) << i;
    EXPECT_EQ(t[i]["mean_curvature"]["sign"], sign[i]) << i;
  }
  EXPECT_EQ(t[4]["reason"]["code"], "ambiguous");
}

TEST_F(Program, unusable_commands_and_models)
{
  expect_unusable("", "MODEL is required");
  expect_unusable("a.json b.json", "b.json");
  expect_unusable("a.json --number-type float", "exact");
  expect_unusable("'" + (m_directory / "no.json").string() + "'", "No such file");
  expect_unusable("'" + m_directory.string() + "'", "this is a directory");
  const std::string broken = write("broken.json", "{\"tasks\": [}").string();
  expect_unusable("'" + broken + "'", "broken.json: line 1, column 12");
  EXPECT_FALSE(fs::exists(m_directory / "broken"));
  const std::string model = write("m.json", sphere_model).string();
  expect_unusable("'" + model + "' --out '" + model + "'", "directory of the report");
  expect_unusable("'" + model + "' --out '" + model + "/below'", "directory of the report");
  expect_unusable("/dev/zero --out '" + m_directory.string() + "'", "byte 0");
}

TEST_F(Program, usual_calls)
{
  EXPECT_EQ(run("--help").status, 0);
  EXPECT_EQ(run("--version").status, 0);
  EXPECT_EQ(run("--version").output.rfind("interrogate ", 0), 0u);
  const std::string model = write("m.json", sphere_model).string();
  const Outcome loud = run("'" + model + "'");
  EXPECT_EQ(loud.status, 0);
  EXPECT_NE(loud.output.find("K = 1/9"), std::string::npos) << loud.output;
  EXPECT_TRUE(fs::exists(m_directory / "m/report.json"));
  const Outcome quiet = run("'" + model + "' --quiet --number-type double");
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.output, "");
  for (const auto& entry : fs::directory_iterator(m_directory / "m"))
    EXPECT_EQ(entry.path().filename(), "report.json"); // no temporary file stays
}

TEST_F(Program, zero_has_no_sign)
{
  const fs::path model = write("m.json", R"({ "tasks": [
    { "task": "shape_operator", "normal": [0, 0, 1],
      "directions": [[1, 0, 0], [0, 1, 0], [1, 1, 0]], "curvatures": ["-1e-400", 0, 0] } ] })");
  const Json report = Program::report(model, 0);
  EXPECT_EQ(report["tasks"][0]["mean_curvature"]["sign"], -1);
  EXPECT_EQ(report["tasks"][0]["mean_curvature"]["approx"], 0.0);
  EXPECT_EQ(report.dump().find("-0.0"), std::string::npos) << report;
}

// A header line of a .ply file.
bool has_line(const fs::path& file, const std::string& line)
{
  std::ifstream in(file, std::ios::binary);
  for (std::string text; std::getline(in, text) && text != "end_header";)
    if (text == line)
      return true;
  return false;
}

TEST_F(Program, meshes)
{
  const fs::path model = write("m.json", R"json({
    "surfaces": {
      "sphere": { "kind": "implicit", "f": "x^2+y^2+z^2-1" },
      "double": { "kind": "implicit", "f": "(x^2+y^2+z^2-1)^2" },
      "pole": { "kind": "implicit", "f": "1/a+b", "variables": ["a", "b", "c"] },
      "saddle": { "kind": "bezier", "control_points": [[[0,0,0], [0,1,1]], [[1,0,1], [1,1,0]]] },
      "root": { "kind": "bezier",
                "control_points": [[[0,0,0], [0,1,1]], [[1,0,1], [1,1,"sqrt(2)"]]] } },
    "tasks": [
      { "task": "mesh", "surface": "sphere", "file": "s.ply", "edge_length": "1/2",
        "tolerance": "1/10", "box": [[-2,2],[-2,2],[-2,2]], "colour": "kmax",
        "number_type": "double" },
      { "task": "mesh", "surface": "saddle", "file": "p.ply", "edge_length": "1/2",
        "number_type": "filtered", "colour": "gaussian_curvature" },
      { "task": "mesh", "surface": "sphere", "file": "n.ply", "edge_length": "1/2",
        "box": [[2,3],[2,3],[2,3]] },
      { "task": "mesh", "surface": "double", "file": "d.ply", "edge_length": "1/2",
        "box": [[-1,1],[-1,1],[-1,1]] },
      { "task": "mesh", "surface": "pole", "file": "o.ply", "edge_length": "1/2",
        "box": [[-1,1],[-1,1],[-1,1]] },
      { "task": "mesh", "surface": "root", "file": "r.ply", "edge_length": "1/2" },
      { "task": "mesh", "surface": "saddle", "file": "l.ply", "edge_length": "1/100",
        "max_vertices": 50 },
      { "task": "mesh", "surface": "saddle", "file": "e.ply", "edge_length": "1/2",
        "number_type": "exact" } ] })json");
  const Json t = report(model, 1)["tasks"];
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(t[i]["status"], "ok") << t[i];
    EXPECT_EQ(t[i]["number_type"], i == 0 ? "double" : "filtered");
    EXPECT_EQ(t[i]["unmeasured_samples"], 0);
    EXPECT_EQ(t[i]["max_face_distance"]["certified"], true);
    EXPECT_GT(t[i]["faces"], 4);
  }
  EXPECT_EQ(t[0]["colour"]["property"], "kmax");
  EXPECT_NEAR(t[0]["colour"]["range"]["approx"], 1, 1e-9);
  EXPECT_NEAR(t[1]["colour"]["range"]["approx"], 4, 3); // K = -4 at the middle
  EXPECT_TRUE(has_line(m_directory / "out/s.ply", "property uchar red"));
  EXPECT_TRUE(has_line(m_directory / "out/p.ply", "property uchar red"));
  const char* const reasons[][2] = {{"not_on_surface", "nothing was found in the box"},
                                    {"not_on_surface", "nothing was found in the box"},
                                    {"pole", "zero at this point: a"},
                                    {"not_algebraic", "a control point of root"},
                                    {"limit_exceeded", "more vertices"},
                                    {"unsupported", "it is made in \"filtered\""}};
  for (int i = 0; i < 6; ++i)
  {
    const Json& reason = t[i + 2]["reason"];
    EXPECT_EQ(reason["code"], reasons[i][0]) << t[i + 2];
    EXPECT_NE(reason["text"].get<std::string>().find(reasons[i][1]), std::string::npos) << reason;
    EXPECT_FALSE(t[i + 2].contains("file"));
  }
}

TEST_F(Program, no_byte_0_in_a_model)
{
  const std::string text("{\"tasks\":[]}\0{", 15);
  expect_unusable("'" + write("m.json", text).string() + "'", "byte 0");
}

} // namespace
