// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The tasks property, bound, contour and trichotomy of the program: values, coefficients, verdicts,
// curves, areas, files, refusals, and messages about fields.

#include "Model_error.h"
#include "read_model.h"
#include "run_tasks.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace interrogate;
namespace fs = std::filesystem;

const char* const surfaces = R"json({
  "bowl": { "kind": "parametric", "x": ["u", "v", "3*u^2/10+2*v^2/5"], "domain": [[0, 1], [0, 1]] },
  "sphere": { "kind": "parametric", "x": ["2*u/(1+u^2+v^2)", "2*v/(1+u^2+v^2)",
    "1-2/(1+u^2+v^2)"], "domain": [[-1, "1/2"], [0, 2]] },
  "open": { "kind": "parametric", "x": ["u", "v", "u*v"] },
  "wave": { "kind": "parametric", "x": ["u", "v", "v*sin(u)"], "domain": [[0, 1], [0, 1]] },
  "steep": { "kind": "parametric", "x": ["u", "v", "u^40+v"], "domain": [[0, 1], [0, 1]] },
  "root": { "kind": "bezier", "control_points": [[[0,0,0], [0,1,"sqrt(2)"]], [[1,0,0], [1,1,1]]] },
  "two_roots": { "kind": "bezier",
    "control_points": [[[0,0,"sqrt(3)"], [0,1,"sqrt(2)"]], [[1,0,0], [1,1,1]]] },
  "saddle": { "kind": "bezier", "flip": true,
    "control_points": [[[0,0,0], [0,1,0]], [[1,0,0], [1,1,1]]] },
  "knots": { "kind": "nurbs", "degree": [2, 1], "knots": [[0,0,0,1,2,2,2], [0,0,1,1]],
    "control_points": [[[0,0,0], [0,1,0]], [[1,0,0], [1,1,0]], [[2,0,1], [2,1,1]],
                       [[3,0,0], [3,1,0]]] },
  "turned_gutter": { "kind": "nurbs", "flip": true, "degree": [2, 1],
    "knots": [[0,0,0,1,2,2,2], [0,0,1,1]],
    "control_points": [[[0,0,0], [0,1,0]], [[1,0,0], [1,1,0]], [[2,0,1], [2,1,1]],
                       [[3,0,3], [3,1,3]]] },
  "ball": { "kind": "implicit", "f": "x^2+y^2+z^2-4" } })json";

std::string model_with(const std::string& task)
{
  return std::string("{\"surfaces\":") + surfaces + ",\"tasks\":[" + task + "]}";
}

std::string task_of(const std::string& kind, const std::string& surface,
                    const std::string& property, const std::string& rest)
{
  return R"({"task":")" + kind + R"(","surface":")" + surface + R"(","property":")" + property +
         "\"" + (rest.empty() ? "" : "," + rest) + "}";
}

std::string at(const std::string& u, const std::string& v)
{
  return R"("at":{"parameters":[")" + u + R"(",")" + v + R"("]})";
}

Task_result run(const std::string& task, const fs::path& directory = fs::temp_directory_path())
{
  const Model model = read_model(model_with(task));
  Progress_bar no_progress(false);
  return run_task(model, model.tasks.front(), {}, directory, no_progress);
}

Report_json property(const std::string& surface, const std::string& name,
                     const std::string& rest = "")
{
  const Task_result result = run(task_of("property", surface, name, rest));
  EXPECT_EQ(result.status, "ok") << result.text;
  return result.fields;
}

void expect_verdict(const std::string& verdict, const std::string& surface,
                    const std::string& name, const std::string& bound)
{
  const Task_result result = run(task_of("bound", surface, name, bound));
  EXPECT_EQ(result.fields["verdict"], verdict) << result.text;
  EXPECT_EQ(result.status, verdict == "undecided" ? "undecided" : "ok");
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

TEST(Property_tasks, give_values)
{
  EXPECT_EQ("1/3", property("bowl", "gaussian", at("1/3", "1/2"))["value"]["exact"]);
  EXPECT_EQ("1", property("sphere", "mean_squared", at("1/3", "1/2"))["value"]["exact"]);
  EXPECT_EQ("3/2", property("saddle", "speed_supremum", at("1/2", "1/2"))["value"]["exact"]);
  const Report_json wave = property("wave", "gaussian", at("1/2", "1/3"));
  EXPECT_FALSE(wave["value"].contains("exact"));
  EXPECT_NEAR(-0.445088422648523, wave["value"]["approx"].get<double>(), 1e-14);
  EXPECT_FALSE(wave.contains("bounds"));
  EXPECT_FALSE(property("open", "speed", at("1", "2")).contains("numerator"));
  for (const char* type : {"interval", "double", "filtered"})
  {
    const Report_json speed = property(
      "bowl", "speed", at("1/3", "1") + R"(,"number_type":")" + type + "\"");
    EXPECT_NEAR(2.68, speed["value"]["approx"].get<double>(), 1e-14);
    EXPECT_EQ(std::string(type) == "interval", speed["value"].contains("interval"));
  }
}

TEST(Property_tasks, give_values_from_both_sides_of_knots)
{
  const Report_json knots = property("knots", "mean_squared", at("1", "1/2"));
  EXPECT_EQ("1/2", knots["value"]["exact"]); // from the right
  ASSERT_EQ(2u, knots["one_sided"].size());
  EXPECT_EQ("1/8", knots["one_sided"][0]["value"]["exact"]);
  EXPECT_EQ("left", knots["one_sided"][0]["side"][0]);
  ASSERT_EQ(2u, knots["spans"].size());
  EXPECT_EQ("2", knots["spans"][1]["u"][1]["exact"]);
  EXPECT_EQ(knots["degree"], knots["spans"][0]["numerator"]["degree"]);
}

TEST(Property_tasks, give_coefficients_and_bounds)
{
  const Report_json normal = property("saddle", "normal_z");
  EXPECT_EQ(Report_json({1, 1}), normal["degree"]);
  EXPECT_EQ("-1", normal["numerator"]["coefficients"][0][1]["exact"]); // it is flipped
  EXPECT_EQ("1", normal["denominator"]["coefficients"][0][0]["exact"]);
  EXPECT_EQ("-1", normal["bounds"][0]["exact"]);
  EXPECT_EQ(false, normal["identically_zero"]);
  EXPECT_EQ(true, property("sphere", "umbilic")["identically_zero"]);
  EXPECT_EQ("1", property("sphere", "gaussian")["bounds"][1]["exact"]);
  const Report_json twist = property("root", "normal_twist")["numerator"];
  EXPECT_EQ("1-1*sqrt(2)", twist["coefficients"][0][0]["exact"]);
  EXPECT_TRUE(property("saddle", "speed_supremum").contains("radicand"));
}

TEST(Bound_tasks, prove_and_refute)
{
  const std::string tiny = "1/1152921504606846976";
  expect_verdict("yes", "bowl", "slope", R"("at_most":1)");
  expect_verdict("yes", "bowl", "speed", R"("at_most":3)");
  expect_verdict("no", "bowl", "speed", R"("at_most":"3-)" + tiny + "\"");
  expect_verdict("yes", "bowl", "speed_supremum", R"("at_most":2)");
  expect_verdict("no", "bowl", "speed_supremum", R"("at_most":"2-)" + tiny + "\"");
  expect_verdict("yes", "sphere", "gaussian", R"("at_least":1)");
  expect_verdict("yes", "knots", "gaussian", R"("at_most":0)");
  expect_verdict("no", "root", "speed", R"x("at_most":"sqrt(2)")x");
  expect_verdict("yes", "bowl", "isophote", R"("light":[1,0,1],"level":"1/2","at_least":"-1/4")");
  const Report_json extreme = run(task_of("bound", "bowl", "speed", R"("at_least":2)")).fields;
  EXPECT_EQ("2", extreme["extreme"]["exact"]);
  EXPECT_EQ("0", extreme["at"]["parameters"][0]["exact"]);
}

TEST(Property_tasks, are_refused_where_there_is_no_answer)
{
  const auto code = [](const std::string& task) { return run(task).code; };
  EXPECT_EQ("not_algebraic", code(task_of("property", "wave", "gaussian", "")));
  EXPECT_EQ("not_algebraic", code(task_of("bound", "wave", "gaussian", R"("at_most":1)")));
  EXPECT_EQ("not_algebraic", code(task_of("property", "two_roots", "speed", "")));
  EXPECT_EQ("outside_domain", code(task_of("property", "saddle", "speed", at("2", "0"))));
  EXPECT_EQ("irregular_parametrisation",
            code(task_of("property", "knots", "slope",
                         at("1/2", "0") + R"(,"up":["0","1","0"])")));
  EXPECT_EQ("limit_exceeded", code(task_of("property", "steep", "gaussian", "")));
  EXPECT_EQ("1603", property("steep", "speed", at("1", "0"))["value"]["exact"]); // the value stands
  EXPECT_EQ("unsupported", code(task_of("property", "ball", "speed", "")));
}

TEST(Property_tasks, write_files)
{
  std::string name = (fs::temp_directory_path() / "properties-XXXXXX").string();
  ASSERT_NE(mkdtemp(&name[0]), nullptr);
  const Task_result result =
    run(task_of("property", "bowl", "speed", R"("file":"speed.json")"), name);
  EXPECT_EQ("speed.json", result.fields["file"]);
  std::ifstream in(fs::path(name) / "speed.json");
  const Report_json written = Report_json::parse(in);
  EXPECT_EQ(result.fields["numerator"], written["numerator"]);
  in.close();
  fs::remove_all(name);
}

TEST(Property_tasks, explain_what_is_wrong)
{
  expect_message(task_of("property", "bowl", "beauty", ""), "the name of a property (normal_z");
  expect_message(task_of("property", "open", "speed", ""), "needs a \"domain\"");
  expect_message(task_of("bound", "bowl", "speed", ""), "at_most");
  expect_message(task_of("bound", "bowl", "speed", R"("at_most":1,"at_least":1)"), "one of them");
  expect_message(task_of("property", "bowl", "silhouette", ""), "view");
  expect_message(task_of("property", "bowl", "silhouette", R"("view":[0,0,0])"), "is zero");
  expect_message(task_of("property", "bowl", "silhouette", R"("view":[0,0,1],"eye":[0,0,1])"),
                 "one of them");
  expect_message(task_of("property", "bowl", "speed", R"("view":[0,0,1])"), "view");
}

Task_result contour(const std::string& surface, const std::string& rest)
{
  return run(R"({"task":"contour","surface":")" + surface + "\"," + rest + "}");
}

TEST(Contour_tasks, trace_properties_and_plane_sections)
{
  // The squared tangent is (3/5 u)^2 + (4/5 v)^2: a quarter of an ellipse.
  const Task_result slope = contour("bowl", R"("property":"slope","level":"1/4")");
  ASSERT_EQ(slope.status, "ok") << slope.text;
  ASSERT_EQ(slope.fields["curves"].size(), 1u);
  EXPECT_EQ(slope.fields["certified_topology"], true);
  const Report_json curve = slope.fields["curves"][0];
  EXPECT_EQ(curve["closed"], false);
  EXPECT_EQ(curve["ended"], Report_json::array({"boundary", "boundary"}));
  ASSERT_EQ(curve["points"].size(), curve["parameters"].size());
  for (const Report_json& p : curve["parameters"])
  {
    const double u = p[0], v = p[1];
    EXPECT_NEAR(u * u * 9 / 25 + v * v * 16 / 25, 0.25, 1e-12);
  }
  const Task_result plane = contour("bowl", R"("plane":[0,0,1,"-3/10"])");
  ASSERT_EQ(plane.status, "ok") << plane.text;
  for (const Report_json& x : plane.fields["curves"][0]["points"])
    EXPECT_NEAR(x[2].get<double>(), 0.3, 1e-12);
  EXPECT_EQ(contour("bowl", R"("plane":[0,0,1,1])").fields["curves"].size(), 0u);
}

TEST(Contour_tasks, turn_with_the_surface_and_name_spans)
{
  // n_z of the saddle is 1, of the flipped one -1.
  EXPECT_EQ(contour("saddle", R"("property":"normal_z","level":1)").fields["identically_zero"],
            false);
  EXPECT_EQ(contour("saddle", R"("property":"normal_z","level":-1)").fields["identically_zero"],
            true);
  const Task_result spans = contour("knots", R"("plane":[0,1,0,"-1/2"])");
  ASSERT_EQ(spans.fields["curves"].size(), 2u);
  EXPECT_EQ(spans.fields["curves"][0]["span"], 0);
  EXPECT_EQ(spans.fields["curves"][1]["span"], 1);
  EXPECT_NEAR(spans.fields["curves"][1]["parameters"][0][0].get<double>(), 1, 1e-12);
}

TEST(Contour_tasks, say_what_they_cannot_do)
{
  const Task_result cross = contour("saddle", R"("plane":[1,-1,0,0])");
  EXPECT_EQ(cross.status, "ok");
  const Task_result node = contour("saddle", R"("plane":[0,0,1,0])"); // u v = 0: two edges
  EXPECT_EQ(node.fields["edges"].size(), 2u);
  EXPECT_EQ(node.fields["edges"][0]["edge"], "u0");
  EXPECT_EQ(contour("bowl", R"("property":"speed_supremum","level":1)").code, "not_algebraic");
  EXPECT_EQ(contour("root", R"("property":"speed","level":1)").code, "not_algebraic");
  EXPECT_EQ(contour("wave", R"("property":"speed","level":1)").code, "not_algebraic");
  EXPECT_EQ(contour("ball", R"("property":"speed","level":1)").status, "error");
  const auto message = [](const std::string& rest, const std::string& text) {
    expect_message(R"({"task":"contour","surface":"bowl",)" + rest + "}", text);
  };
  message(R"("plane":[0,0,1])", "4 coefficients");
  message(R"("plane":[0,0,0,1])", "is zero");
  message(R"("property":"speed","plane":[0,0,1,0])", "property");
  message(R"("property":"speed","at_most":1)", "at_most");
}

TEST(Trichotomy_tasks, give_areas_in_the_domain)
{
  const auto divide = [](const std::string& surface) {
    return run(R"({"task":"trichotomy","surface":")" + surface + "\"}");
  };
  const Task_result bowl = divide("bowl");
  ASSERT_EQ(bowl.status, "ok") << bowl.text;
  EXPECT_EQ(bowl.fields["developable"], false);
  EXPECT_EQ(bowl.fields["regular"], true);
  EXPECT_EQ(bowl.fields["regions"]["concave"][0]["exact"], "1");
  EXPECT_EQ(bowl.fields["regions"]["convex"][1]["exact"], "0");
  // Turned by the file's flip; and the domain of the sphere has the area 3.
  EXPECT_EQ(divide("saddle").fields["regions"]["saddle"][0]["exact"], "1");
  const Report_json sphere = divide("sphere").fields["regions"];
  const bool is_convex = sphere["convex"][0]["exact"] == "3";
  EXPECT_EQ(sphere[is_convex ? "convex" : "concave"][0]["exact"], "3");
  EXPECT_EQ(sphere[is_convex ? "concave" : "convex"][1]["exact"], "0");
  // Generalised cylinders over two spans; the second one opens upward and is turned over.
  const Report_json knots = divide("knots").fields, turned = divide("turned_gutter").fields;
  EXPECT_EQ(turned["regions"]["convex"][0]["exact"], "2");
  EXPECT_EQ(turned["regions"]["concave"][1]["exact"], "0");
  EXPECT_EQ(knots["developable"], true);
  EXPECT_EQ(knots["regions"]["saddle"][1]["exact"], "0");
}

} // namespace
