// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The constructions of the model file against their closed forms, as tasks of one model; bounds,
// and what is said about points and models that are wrong.

#include "random_rationals.h"

#include "Model_error.h"
#include "read_model.h"
#include "run_tasks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace interrogate;
using testing_shapes::Q;
using testing_shapes::Random;
using Values = std::vector<Q>;

constexpr int number_of_points = 6;
const char* const torus = R"f("kind":"implicit","f":"(x^2+y^2+z^2+8)^2-36*(x^2+y^2)")f";

std::array<Q, 2> on_circle(const Q& t)
{
  const Q w = 1 + t * t;
  return {Q((1 - t * t) / w), Q(2 * t / w)};
}

std::string json(const Values& values)
{
  std::ostringstream out;
  for (const Q& x : values)
    out << (out.tellp() > 0 ? "," : "") << '"' << x << '"';
  return "[" + out.str() + "]";
}

Task_result run(const Model& model, const Task& task, Number_type type)
{
  Progress_bar no_progress(false);
  return run_task(model, task, type, ".", no_progress);
}

// A construction, the same surface in another form, and points of both.
struct Pair
{
  std::string built, closed; // the fields of both surfaces
  std::string locator;       // of the closed form
  std::vector<std::pair<Values, Values>> points;

  std::string text(const std::string& others, const std::string& curves) const
  {
    std::string tasks;
    for (const auto& [p, q] : points)
      tasks += std::string(tasks.empty() ? "" : ",") +
               R"({"task":"curvature","surface":"built","at":{"point":)" + json(p) +
               R"(}},{"task":"curvature","surface":"closed","at":{")" + locator + "\":" + json(q) +
               "}}";
    return R"({"surfaces":{"built":{)" + built + R"(},"closed":{)" + closed + "}," + others +
           R"(},"curves":{)" + curves + R"(},"tasks":[)" + tasks + "]}";
  }
};

// What both say alike, whatever the length and the sign of the normal.
void expect_same(const Task_result& a, const Task_result& b)
{
  ASSERT_EQ("ok", a.status) << a.text;
  ASSERT_EQ("ok", b.status) << b.text;
  for (const char* field : {"point", "gaussian_curvature", "umbilic", "planar"})
    EXPECT_EQ(a.fields[field], b.fields[field]) << field;
  EXPECT_EQ(a.fields["mean_curvature"]["squared"], b.fields["mean_curvature"]["squared"]);
}

// Intervals may leave the side of the normal open, and then say nothing; a filter may not.
void expect_near(const Task_result& exact, const Task_result& other)
{
  if (other.number_type == "interval" && other.status == "undecided" && other.fields.empty())
    return;
  ASSERT_EQ(other.number_type == "interval" ? other.status : "ok", other.status) << other.text;
  ASSERT_TRUE(other.fields.contains("gaussian_curvature")) << other.text;
  const double k = exact.fields["gaussian_curvature"]["approx"];
  const double approx = other.fields["gaussian_curvature"]["approx"];
  EXPECT_NEAR(k, approx, 1e-9 * (1 + std::abs(k)));
}

void expect_closed_form(const Pair& pair)
{
  const Model model = read_model(pair.text(
    R"("plane":{"kind":"implicit","f":"z"},"wall":{"kind":"implicit","f":"y"},
       "sheet":{"kind":"bezier","control_points":[[[-90,-90,0],[-90,90,0]],[[90,-90,0],[90,90,0]]]},
       "ball":{"kind":"implicit","f":"x^2+y^2+z^2-1"})",
    R"("parabola":{"kind":"bezier_3","control_points":[[0,0,1],["1/2",0,1],[1,1,1]]},
       "slow":{"kind":"nurbs_3","degree":2,"knots":[2,2,2,4,4,4],
               "control_points":[[0,0,1],["1/2",0,1],[1,1,1]]},
       "arc":{"kind":"bezier_3","control_points":[[3,0,0,1],[3,3,0,1],[0,3,0,2]]},
       "line":{"kind":"parametric_3","x":["4*t","9*t","t"]})"));
  ASSERT_FALSE(model.tasks.empty());
  for (std::size_t i = 0; i < model.tasks.size(); i += 2)
  {
    const Task_result exact = run(model, model.tasks[i], Number_type::EXACT);
    ASSERT_NO_FATAL_FAILURE(
      expect_same(exact, run(model, model.tasks[i + 1], Number_type::EXACT)));
    for (Number_type type : {Number_type::INTERVAL, Number_type::DOUBLE, Number_type::FILTERED})
      expect_near(exact, run(model, model.tasks[i], type));
    if (testing::Test::HasFailure())
      return;
  }
}

// --- Closed forms --------------------------------------------------------------------------------

// The parabola (r, r^2, 1) projected onto the plane z = 0 and the plane y = -1.
TEST(Construction, ruled_by_projection)
{
  for (const bool slow : {false, true})
  {
    Pair pair{R"("kind":"ruled_by_projection","of":["plane",{"kind":"parametric",
                 "x":["u","-1","v"]}],"directrix":")" +
                std::string(slow ? "slow" : "parabola") + "\"",
              R"("kind":"parametric","x":["u","v*u^2-1+v","1-v"])", "parameters", {}};
    Random random(21);
    for (int i = 0; i < number_of_points; ++i)
    {
      const Q r = random.in_unit_interval(), l = random.nonzero_rational(), r2 = r * r;
      const Values p{r, Q(l * r2 - 1 + l), Q(1 - l), r,  r2, 1, r, r2,
                     0, r, -1, 1, slow ? Q(2 + 2 * r) : r, r, 1, l};
      pair.points.push_back({p, {r, l}});
    }
    expect_closed_form(pair);
  }
}

// A tube around an arc of a circle, and the offset of a torus.
TEST(Construction, offset_system)
{
  Pair tube{R"("kind":"offset_system","of":["arc"],"distance":1)", torus, "point", {}};
  Pair offset{R"f("kind":"offset_system","of":{"kind":"implicit",
                 "f":"(x^2+y^2+z^2+35/4)^2-36*(x^2+y^2)"},"distance":"-1/2")f", torus, "point", {}};
  Random random(22);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q t = random.in_unit_interval();
    const auto [c, s] = on_circle(t);
    const auto [a, b] = on_circle(random.rational());
    const Values q{Q((3 + a) * c), Q((3 + a) * s), b};
    const Values p{Q((3 + a / 2) * c), Q((3 + a / 2) * s), Q(b / 2)};
    tube.points.push_back({{q[0], q[1], q[2], t}, q});
    offset.points.push_back({{q[0], q[1], q[2], p[0], p[1], p[2]}, q});
  }
  expect_closed_form(tube);
  expect_closed_form(offset);
}

TEST(Construction, equal_distance)
{
  Pair pair{R"("kind":"equal_distance","of":[{"kind":"implicit","f":"x^2+y^2+(z-3)^2-1"},"sheet"])",
            R"("kind":"implicit","f":"x^2+y^2-8*z+8")", "point", {}};
  Random random(23);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational(), y = random.rational(), z = (x * x + y * y + 8) / 8;
    const Q f = 1 / (z + 1); // of the way from the centre to q
    const Values p{x, y, z, Q(f * x), Q(f * y), Q(3 + f * (z - 3)), Q(x / 180 + Q(1) / 2),
                   Q(y / 180 + Q(1) / 2)};
    pair.points.push_back({p, {x, y, z}});
  }
  expect_closed_form(pair);
}

TEST(Construction, rolling_ball)
{
  Pair pair{R"("kind":"rolling_ball","of":["plane",{"kind":"implicit","f":"x^2+y^2+(z+2)^2-16"}],
               "radius":"1")",
            R"f("kind":"implicit","f":"(x^2+y^2+(z-1)^2+15)^2-64*(x^2+y^2)")f", "point", {}};
  Random random(24);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [c, s] = on_circle(random.rational());
    const auto [a, b] = on_circle(random.rational());
    const Values q{Q((4 + a) * c), Q((4 + a) * s), Q(1 + b)}, m{Q(4 * c), Q(4 * s), 1};
    pair.points.push_back({{q[0], q[1], q[2], m[0], m[1], m[2], m[0], m[1], 0, Q(m[0] * 4 / 5),
                            Q(m[1] * 4 / 5), Q(-2 + Q(12) / 5)}, q});
  }
  expect_closed_form(pair);
}

// Balls around (t, t, t) with the radius t touch both planes and envelop a cone.
TEST(Construction, variable_radius_blend)
{
  const std::string start = R"("kind":"variable_radius_blend","of":["plane","wall"],"reference":)";
  const std::string cone = R"("kind":"implicit","f":"2*(x^2+y^2+z^2)-(x+y+z)^2")";
  Pair surface{start + R"({"kind":"parametric","x":["u","u","v"]})", cone, "point", {}};
  Pair line{start + R"("line")", cone, "point", {}};
  Random random(25);
  while (surface.points.size() < number_of_points)
  {
    // A second point of the conic on a line through (1, 1, 0).
    const auto d = random.nonzero_vector();
    const Q sum = d[0] + d[1] + d[2];
    const Q f = 2 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - sum * sum;
    const Q polar = 2 * (d[0] + d[1]) - 2 * sum;
    const Values q{Q(-f + 2 * polar * d[0]), Q(-f + 2 * polar * d[1]), Q(2 * polar * d[2])};
    const Q t = (q[0] + q[1] + q[2]) / 2;
    if (CGAL::is_zero(t))
      continue;
    surface.points.push_back({{q[0], q[1], q[2], t, t, t, t, 0, t, 0, t}, q});
    line.points.push_back({{q[0], q[1], q[2], t, t, t, t, t, 0, t, 0, t, Q(t / 7)}, q});
  }
  expect_closed_form(surface);
  expect_closed_form(line);
}

// The cone of the normals of a sphere along a parallel.
TEST(Construction, trimming_surface)
{
  const std::string cone = R"("kind":"implicit","f":"9*(x^2+y^2)-16*z^2")";
  Pair implicit{R"("kind":"trimming_surface","of":["ball",{"kind":"implicit","f":"z-3/5"}])", cone,
                "point", {}};
  Pair mixed{R"("kind":"trimming_surface","of":["ball",{"kind":"parametric",
                "x":["a+b","a-b","3/5"],"parameters":["a","b"]}])", cone, "point", {}};
  Random random(26);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [c, s] = on_circle(random.rational());
    const Q lambda = random.fraction(1, 5, 9), x = c * 4 / 5, y = s * 4 / 5, z = Q(3) / 5;
    const Q k = 1 + 2 * lambda;
    const Values q{Q(k * x), Q(k * y), Q(k * z)};
    implicit.points.push_back({{q[0], q[1], q[2], x, y, z, lambda}, q});
    mixed.points.push_back(
      {{q[0], q[1], q[2], x, y, z, Q((x + y) / 2), Q((x - y) / 2), lambda}, q});
  }
  expect_closed_form(implicit);
  expect_closed_form(mixed);
}

// A patch in 5-space against itself, as a Bezier patch and as a spline of one span. The patch is
// made of (u, v, u v) with another weight at a corner, by u' = u / (2 - u).
TEST(Construction, parametric_graph)
{
  const std::string points =
    R"("control_points":[[[0,0,0,2],[0,1,0,2],[0,2,1,2]],[[1,0,0],[1,1,"3/2"],[1,2,2]]])";
  const std::string patch = R"("kind":"bezier",)" + points;
  const std::string spline =
    R"("kind":"nurbs","degree":[1,2],"knots":[[3,3,5,5],[-1,-1,-1,1,1,1]],)" + points;
  Pair pair{R"("kind":"parametric_graph","of":{)" + patch + "}", patch, "parameters", {}};
  Pair pair_of_spline{R"("kind":"parametric_graph","of":[{)" + spline + "}]", spline,
                      "parameters", {}};
  Random random(27);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q u = random.in_unit_interval(), v = random.in_unit_interval();
    const Q w = 2 - u; // of the sum of the weighted control points
    const Q x = u / w, y = 2 * v;
    const Q first = 2 * v * v, second = 3 * v * (1 - v) + 2 * v * v;
    const Q z = ((1 - u) * first + u * second) / w;
    pair.points.push_back({{x, y, z, u, v}, {u, v}});
    const Q s = 3 + 2 * u, t = 2 * v - 1;
    pair_of_spline.points.push_back({{x, y, z, s, t}, {s, t}});
  }
  expect_closed_form(pair);
  expect_closed_form(pair_of_spline);
}

// --- Bounds --------------------------------------------------------------------------------------

const System_model& system_in(const Model& model, const std::string& name)
{
  return std::get<System_model>(model.surfaces.at(name).data);
}

std::string bounds_of(const Model& model, const std::string& name)
{
  std::ostringstream out;
  const System_model& system = system_in(model, name);
  for (const auto& bound : system.bounds)
    out << system.variables[bound.variable] << " in [" << bound.lower << "," << bound.upper << "] ";
  return out.str();
}

TEST(Bounds, given_and_from_domains)
{
  const Model model = read_model(R"json({
    "surfaces": {
      "patch": { "kind": "bezier", "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]] },
      "plane": { "kind": "parametric", "x": ["u","v","1"], "domain": [["1/3",2],[0,"2^70"]] },
      "graph": { "kind": "parametric_graph", "of": "patch" },
      "other": { "kind": "parametric_graph", "of": "patch", "bounds": { "t": [-1, 3] } },
      "ruled": { "kind": "ruled_by_projection", "of": ["patch", "plane"], "directrix": "c",
                 "bounds": { "lambda": [0, 1], "x": ["-0.5", "1e3"] } },
      "canal": { "kind": "variable_radius_blend", "of": [{ "kind": "implicit", "f": "x" }, "plane"],
                 "reference": "c" },
      "sheet": { "kind": "variable_radius_blend", "of": ["plane", "plane"], "reference": "patch" },
      "cut": { "kind": "trimming_surface", "of": ["plane", "patch"] },
      "written": { "kind": "system", "variables": ["x", "y", "z", "w"], "equations": ["x", "w"],
                   "bounds": { "w": [0, 1], "y": [2, 3] } } },
    "curves": { "c": { "kind": "parametric_3", "x": ["t", "0", "0"], "domain": [-1, "1/7"] } },
    "tasks": [] })json");
  EXPECT_EQ("s in [0,1] t in [0,1] ", bounds_of(model, "graph"));
  EXPECT_EQ("s in [0,1] t in [-1,3] ", bounds_of(model, "other"));
  EXPECT_EQ("x in [-1/2,1000] r in [-1,1/7] p1_s in [0,1] p1_t in [0,1] p2_s in [1/3,2] "
            "p2_t in [0,1180591620717411303424] lambda in [0,1] ",
            bounds_of(model, "ruled"));
  EXPECT_EQ("p_B_s in [1/3,2] p_B_t in [0,1180591620717411303424] p_R_r in [-1,1/7] ",
            bounds_of(model, "canal"));
  EXPECT_EQ(0u, bounds_of(model, "sheet").find("c_s in [0,1] c_t in [0,1] p_A_s in [1/3,2]"));
  EXPECT_EQ(0u, bounds_of(model, "cut").find("p_s in [1/3,2] p_t in"));
  EXPECT_NE(std::string::npos, bounds_of(model, "cut").find("t_s in [0,1] t_t in [0,1] "));
  EXPECT_EQ("y in [2,3] w in [0,1] ", bounds_of(model, "written"));
}

// On a bound is inside; 2^-70 beyond it is outside, as far as the number type can tell.
TEST(Bounds, of_points)
{
  const Model model = read_model(R"json({
    "surfaces": { "s": { "kind": "system", "variables": ["x","y","z","w"],
                         "equations": ["x-w", "z-y^2-x^2"], "bounds": { "w": ["1/3", 1] } } },
    "tasks": [
      { "task": "curvature", "surface": "s", "at": { "point": ["1/3", 0, "1/9", "1/3"] } },
      { "task": "curvature", "surface": "s", "at": { "point": [2, 0, 4, 2] } },
      { "task": "curvature", "surface": "s", "at": { "point": ["1+2^-70", 0, "(1+2^-70)^2",
                                                               "1+2^-70"] } } ] })json");
  for (Number_type type : {Number_type::EXACT, Number_type::INTERVAL, Number_type::DOUBLE,
                           Number_type::FILTERED})
  {
    EXPECT_EQ("ok", run(model, model.tasks[0], type).status);
    const Task_result outside = run(model, model.tasks[1], type);
    EXPECT_EQ("outside_domain", outside.code);
    EXPECT_NE(std::string::npos, outside.text.find("w = "));
    EXPECT_NE(std::string::npos, outside.text.find("is outside of the bounds [1/3, 1]"));
    EXPECT_EQ(type == Number_type::EXACT ? "outside_domain" : "",
              run(model, model.tasks[2], type).code);
  }
}

// --- What does not hold --------------------------------------------------------------------------

TEST(Construction, says_in_words_what_a_point_is_not)
{
  const Model model = read_model(R"json({
    "surfaces": {
      "f": { "kind": "implicit", "f": "x^2+y^2+z^2-1" },
      "o": { "kind": "offset_system", "of": "f", "distance": 1 },
      "three": { "kind": "equal_distance", "of": [{ "point": [0,0,0] }, { "point": [2,0,0] },
                                                  { "point": [0,2,0] }] } },
    "tasks": [
      { "task": "curvature", "surface": "o", "at": { "point": [2, 0, 0, 0, 1, 0] } },
      { "task": "curvature", "surface": "o", "at": { "point": [0, 0, 3, 0, 0, 2] } },
      { "task": "curvature", "surface": "three", "at": { "point": [1, 1, 0] } } ] })json");
  for (Number_type type : {Number_type::EXACT, Number_type::INTERVAL, Number_type::FILTERED})
  {
    const Task_result projection = run(model, model.tasks[0], type);
    EXPECT_EQ("not_on_solution", projection.code);
    EXPECT_EQ(0u, projection.text.find("p is not the projection of q onto f; the distance of q and"
                                       " p is not 1; equation "))
      << projection.text;
    EXPECT_EQ(0u, run(model, model.tasks[1], type).text.find("p is not on f; equation 1"));
    EXPECT_EQ("not_two_dimensional", run(model, model.tasks[2], type).code);
  }
}

std::string message_for(const std::string& text)
{
  try
  {
    read_model(text);
  }
  catch (const Model_error& error)
  {
    return error.what();
  }
  return "";
}

// A model with ingredients of all kinds, and the surface t.
std::string model_with(const std::string& surface)
{
  return R"json({"surfaces":{
      "i": { "kind": "implicit", "f": "z" },
      "p": { "kind": "parametric", "x": ["u","v","0"] },
      "root": { "kind": "bezier", "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,"sqrt(2)"]]] },
      "null": { "kind": "bezier", "control_points": [[[0,0,0,0],[0,1,0,0]],[[1,0,0,0],[1,1,0,0]]] },
      "knots": { "kind": "nurbs", "degree": [1,1], "knots": [[0,0,1,2,2],[0,0,1,1]],
                 "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]],[[2,0,0],[2,1,1]]] },
      "wide": { "kind": "parametric", "x": ["u","v","0"], "domain": [[0,1],[0,"sqrt(2)"]] },
      "sys": { "kind": "system", "variables": ["x","y","z"], "equations": ["x"] },
      "c": { "kind": "implicit", "f": "y" },
      "t": { )json" + surface + R"json( } },
      "curves": {
        "c": { "kind": "parametric_3", "x": ["t","t^2","t^3"] },
        "long": { "kind": "nurbs_3", "degree": 1, "knots": [0,0,1,1.5,2,2],
                  "control_points": [[0,0,0],[1,0,0],[2,0,1],[3,0,0]] },
        "flat": { "kind": "parametric_2", "x": ["t","t^2"] } },
      "tasks": [{"task":"curvature","surface":"t","at":{"point":[0]}}]})json";
}

TEST(Construction, messages_name_the_place)
{
  const std::string surfaces = "a surface (implicit, parametric, bezier, nurbs)";
  const std::string curves = "a curve in space (parametric_3, bezier_3, nurbs_3)";
  const std::vector<std::pair<std::string, std::string>> cases = {
    {R"("kind":"offset_system","of":"i")", "surfaces.t: the field \"distance\" is missing"},
    {R"("kind":"offset_system","distance":1)", "surfaces.t: the field \"of\" is missing"},
    {R"("kind":"offset_system","of":"i","radius":1)",
     "surfaces.t: unknown field \"radius\", the fields are: kind, of, distance, bounds"},
    {R"("kind":"offset_system","of":"i","distance":0)",
     "surfaces.t.distance: expected a number that is not 0, found the number 0"},
    {R"f("kind":"offset_system","of":"i","distance":"sqrt(2)-sqrt(2)")f",
     "surfaces.t.distance: expected a number that is not 0"},
    {R"("kind":"offset_system","of":"t","distance":1)",
     "surfaces.t.of: the surface is made from itself"},
    {R"("kind":"offset_system","of":"nothing","distance":1)",
     "surfaces.t.of: expected " + surfaces + ", " + curves +
       " or a point ({\"point\": [x,y,z]}), found the name \"nothing\", which no surface or curve"},
    {R"("kind":"offset_system","of":3,"distance":1)", "found the number 3"},
    {R"("kind":"offset_system","of":["i","i"],"distance":1)",
     "surfaces.t.of: expected an array of 1 member, a surface"},
    {R"("kind":"offset_system","of":"sys","distance":1)",
     "found a surface of the kind \"system\""},
    {R"("kind":"offset_system","of":"c","distance":1)",
     "surfaces.t.of: both a surface and a curve of the model have the name \"c\""},
    {R"("kind":"offset_system","of":{"kind":"offset_system","of":"i","distance":1},"distance":1)",
     "surfaces.t.of: expected " + surfaces},
    {R"("kind":"offset_system","of":{"kind":"spline"},"distance":1)",
     "surfaces.t.of.kind: expected the kind of a surface"},
    {R"("kind":"offset_system","of":{"point":[1,2]},"distance":1)",
     "surfaces.t.of.point: expected a point of 3 coordinates, found an array of 2"},
    {R"("kind":"offset_system","of":{"kind":"implicit","f":"x+"},"distance":1)",
     "surfaces.t.of.f: this is not a function"},
    {R"("kind":"offset_system","of":"root","distance":1)", "a control point has a root"},
    {R"("kind":"offset_system","of":"knots","distance":1)",
     "surfaces.t.of: the spline has 2 knot spans, and a construction takes one"},
    {R"("kind":"offset_system","of":"long","distance":1)", "the spline has 3 knot spans"},
    {R"("kind":"offset_system","of":"null","distance":1)", "surfaces.t: "},
    {R"("kind":"offset_system","of":"flat","distance":1)", "found a planar curve"},
    {R"("kind":"offset_system","of":"wide","distance":1)",
     "surfaces.t: the domain of the parameter p_t has a root, and bounds are rational"},
    {R"("kind":"offset_system","of":"i","distance":1,"bounds":{"lambda":[0,1]})",
     "surfaces.t.bounds.lambda: there is no variable of this name, the variables are: x, y, z, p"},
    {R"("kind":"offset_system","of":"i","distance":1,"bounds":{"p_x":[1,0]})",
     "surfaces.t.bounds.p_x: the first number of a range must be less than the second"},
    {R"f("kind":"offset_system","of":"i","distance":1,"bounds":{"p_x":[0,"sqrt(2)"]})f",
     "surfaces.t.bounds.p_x[1]: expected a rational number"},
    {R"("kind":"offset_system","of":"i","distance":1,"bounds":{"p_x":[0,"1/0"]})",
     "surfaces.t.bounds.p_x[1]: this is not a number"},
    {R"("kind":"rolling_ball","of":["i","p"],"radius":"-1/2")",
     "surfaces.t.radius: expected a number greater than 0, found the string \"-1/2\""},
    {R"("kind":"rolling_ball","of":["i"],"radius":1)",
     "surfaces.t.of: expected an array of 2 members, each " + surfaces},
    {R"("kind":"rolling_ball","of":"i","radius":1)",
     "surfaces.t.of: expected an array of 2 members"},
    {R"("kind":"equal_distance","of":["i","i","i","i"])",
     "surfaces.t.of: expected an array of 2 or 3 members"},
    {R"("kind":"ruled_by_projection","of":["i","p"],"directrix":"i")",
     "surfaces.t.directrix: expected " + curves + ", found a surface of the kind \"implicit\""},
    {R"("kind":"ruled_by_projection","of":["i","p"],"directrix":"flat")", "found a planar curve"},
    {R"("kind":"ruled_by_projection","of":["i","p"],"directrix":{"kind":"bezier_3",
        "control_points":[[0,0,0]]})", "surfaces.t.directrix.control_points: expected an array of"},
    {R"("kind":"variable_radius_blend","of":["i","p"],"reference":{"point":[0,0,0]})",
     "surfaces.t.reference: expected " + surfaces + " or " + curves + ", found a point"},
    {R"("kind":"trimming_surface","of":["i",{"kind":"parametric_3","x":["t","0","0"]}])",
     "surfaces.t.of[1]: expected " + surfaces + ", found a curve of the kind \"parametric_3\""},
    {R"("kind":"parametric_graph","of":"i")",
     "surfaces.t.of: expected a surface with parameters (parametric, bezier, nurbs), found a"
     " surface of the kind \"implicit\""},
    {R"("kind":"offset_system","of":"i","distance":1)",
     "tasks[0].at.point: expected an array of 6 numbers (x, y, z, p_x, p_y, p_z), found an array"}};
  for (const auto& [surface, message] : cases)
  {
    const std::string found = message_for(model_with(surface));
    EXPECT_NE(std::string::npos, found.find(message)) << surface << "\n" << found;
  }
}

TEST(Construction, none_is_made_from_others)
{
  const std::string start = R"({"tasks":[],"surfaces":{"i":{"kind":"implicit","f":"z"},)";
  const std::string distance = R"(,"distance":1})";
  EXPECT_EQ("surfaces.a.of: surfaces are made from each other in a circle: a, b, c, a",
            message_for(start + R"("a":{"kind":"offset_system","of":"b")" + distance +
                        R"(,"b":{"kind":"equal_distance","of":["i","c"]},"c":{)" +
                        R"("kind":"variable_radius_blend","of":["i","i"],"reference":"a"}}})"));
  const std::string message =
    message_for(start + R"("a":{"kind":"offset_system","of":"b")" + distance +
                R"(,"b":{"kind":"offset_system","of":"i")" + distance + "}}");
  EXPECT_EQ(0u, message.find("surfaces.a.of: expected a surface")) << message;
  EXPECT_NE(std::string::npos, message.find("found a surface of the kind \"offset_system\", which"
                                            " is a system itself"));
}

// Members that only a later version offers are no error of the model, nor are curves in space.
TEST(Construction, what_this_version_does_not_offer)
{
  const Model model = read_model(R"json({
    "surfaces": { "n": { "kind": "offset", "anything": 1 },
                  "o": { "kind": "offset_system", "of": "n", "distance": 1 } },
    "curves": { "c": { "kind": "parametric_3", "x": ["t", "0", "0"] } },
    "tasks": [ { "task": "curvature", "surface": "o", "at": { "point": [0, 0, 0] } },
               { "task": "curvature", "curve": "c", "at": { "parameters": [0] } } ] })json");
  for (const Task& task : model.tasks)
  {
    const Task_result result = run(model, task, Number_type::EXACT);
    EXPECT_EQ("unsupported", result.code);
    EXPECT_NE(std::string::npos, result.text.find("not available in this version"));
  }
}

TEST(Locator, of_a_system_by_names)
{
  const std::string start = R"({"surfaces":{"s":{"kind":"system","variables":["x","y","z","w"],
    "equations":["x-w","z"]}},"tasks":[{"task":"curvature","surface":"s","at":{"point":)";
  const Model model = read_model(start + R"({"w":"1/3","z":0,"y":5,"x":"1/3"}}}]})");
  const Curvature_task& task = std::get<Curvature_task>(model.tasks[0].data);
  EXPECT_EQ(Q(5), task.at[1].constant());
  EXPECT_EQ("ok", run(model, model.tasks[0], Number_type::EXACT).status);
  EXPECT_EQ("tasks[0].at.point: the field \"w\" is missing",
            message_for(start + R"({"x":0,"y":0,"z":0}}}]})"));
  EXPECT_EQ("tasks[0].at.point: unknown field \"v\", the fields are: x, y, z, w",
            message_for(start + R"({"x":0,"y":0,"z":0,"v":0}}}]})"));
}

} // namespace
