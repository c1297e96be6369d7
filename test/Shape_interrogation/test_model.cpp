// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The reader of models: exact numbers, messages with the place, and mutated models that must be
// read or refused, quickly and without anything else.

#include "evaluate_numbers.h"
#include "Model_error.h"
#include "read_model.h"
#include "run_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace interrogate;

// The message for a model that cannot be used, empty for one that can.
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

void expect_message(const std::string& text, const std::string& part)
{
  const std::string message = message_for(text);
  EXPECT_NE(message.find(part), std::string::npos)
    << "model:    " << text.substr(0, 300) << "\nmessage:  " << message << "\nexpected: " << part;
}

std::string with_sphere(const std::string& tasks)
{
  return R"({"surfaces":{"s":{"kind":"implicit","f":"x^2+y^2+z^2-1"}},"tasks":[)" + tasks + "]}";
}

std::string with_mesh(const std::string& file_and_more)
{
  return with_sphere(R"({"task":"mesh","surface":"s","file":)" + file_and_more + "}");
}

std::string at_point(const std::string& x)
{
  return with_sphere(R"({"task":"curvature","surface":"s","at":{"point":[)" + x + ",0,0]}}");
}

Number read_x(const std::string& x)
{
  return std::get<Curvature_task>(read_model(at_point(x)).tasks[0].data).at[0];
}

TEST(Model, numbers_are_exact)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"0.1", "1/10"}, {"\"0.1\"", "1/10"}, {"-0", "0"}, {"1e-3", "1/1000"}, {"1E+2", "100"},
    {"\"2/4\"", "1/2"}, {"123456789012345678901234567890", "123456789012345678901234567890"},
    {"0.12345678901234567890123", "12345678901234567890123/100000000000000000000000"},
    {"\"2^70\"", "1180591620717411303424"}, {"18446744073709551615", "18446744073709551615"},
    {"-9223372036854775808", "-9223372036854775808"}, {"\" 3 / ( 2 * 4 ) \"", "3/8"}};
  for (const auto& [text, value] : cases)
  {
    const Number x = read_x(text);
    ASSERT_TRUE(x.is_constant()) << text;
    EXPECT_EQ(x.constant(), Rational(value)) << text;
  }
  EXPECT_EQ(evaluate<Quadratic>(read_x("\"3/(2*sqrt(17))\"")),
            Quadratic(Rational(0), Rational("3/34"), Rational(17)));
  EXPECT_FALSE(read_x("1e-400").constant() == 0); // below the smallest double
}

class Comma_decimals : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Model, locale_has_no_influence)
{
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new Comma_decimals));
  const Rational x = read_x("1234567.5").constant();
  const Report_json scalar = to_json(Scalar{1234567.5, "", std::make_pair(0.1, 0.1)});
  std::locale::global(before);
  EXPECT_EQ(x, Rational("2469135/2"));
  EXPECT_EQ(scalar.dump(), R"({"approx":1234567.5,"interval":["1e-1","1.0000000000000001e-1"]})");
}

TEST(Model, syntax_errors_have_line_and_column)
{
  expect_message("", "line 1, column 1");
  expect_message("{\n \"tasks\": [,] }", "line 2, column 12");
  expect_message(at_point("NaN"), "invalid literal");
  expect_message(at_point("Infinity"), "invalid literal");
  expect_message(at_point("01"), "line 1, column");
  expect_message(at_point("1e400"), "too large for a JSON number");
  expect_message(at_point("\"\xff\""), "UTF-8");
  expect_message("{\"tasks\": []} {}", "line 1, column 15");
  expect_message("// comment\n{\"tasks\": []}", "line 1, column 1");
}

TEST(Model, limits)
{
  expect_message(std::string(100, '['), "nested more than 64 deep");
  expect_message("{\"tasks\": " + std::string(100, '[') + std::string(100, ']') + "}",
                 "tasks[0][0]");
  Json_limits limits;
  limits.values = 10;
  EXPECT_THROW(parse_json("[1,2,3,4,5,6,7,8,9,10,11]", limits), Model_error);
  limits.bytes = 5;
  EXPECT_THROW(parse_json("[1,2,3]", limits), Model_error);
  expect_message(at_point("\"" + std::string(5000, '9') + "\""), "point[0]");
  expect_message(at_point("\"1e99999\""), "point[0]");
  expect_message(at_point("\"" + std::string(1000, '(') + "1" + std::string(1000, ')') + "\""),
                 "nested deeper");
}

TEST(Model, messages_name_the_place)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"[]", "the model: expected an object, found an array of 0"},
    {"{}", "the field \"tasks\" is missing"},
    {R"({"tasks":[],"tasks":[]})", "the key \"tasks\" occurs twice"},
    {R"({"tasks":[{"task":"mesh","a":{"b":1,"b":2}}]})",
     "tasks[0].a: the key \"b\" occurs twice"},
    {R"({"tasks":1})", "tasks: expected an array of tasks, found the number 1"},
    {R"({"task":[],"tasks":[]})", "unknown field \"task\", the fields are: surfaces"},
    {R"({"tasks":[{"task":"curve"}]})", "tasks[0].task: expected the kind of a task (curvature"},
    {R"({"tasks":[{"id":"a"}]})", "tasks[0]: the field \"task\" is missing"},
    {R"({"surfaces":{"a b":{"kind":"spline"}},"tasks":[]})",
     "surfaces[\"a b\"].kind: expected the kind of a surface (implicit"},
    {R"({"surfaces":{"s":{"kind":"implicit","f":"x+"}},"tasks":[]})", "surfaces.s.f: this is not"},
    {R"({"surfaces":{"s":{"kind":"implicit","f":"x","variables":["x","x","z"]}},"tasks":[]})",
     "surfaces.s.variables: the variable name 'x' occurs twice"},
    {R"({"surfaces":{"s":{"kind":"parametric","x":["u","v"]}},"tasks":[]})",
     "surfaces.s.x: expected 3 functions, found an array of 2"},
    {R"({"surfaces":{"s":{"kind":"parametric","x":["u","v","u"],"domain":[[1,0],[0,1]]}},
        "tasks":[]})", "surfaces.s.domain[0]: the first number of a range must be less"},
    {R"({"surfaces":{"s":{"kind":"bezier","control_points":[[[0,0,0],[0,1,0]],[[0,0]]]}},
        "tasks":[]})", "surfaces.s.control_points[1]: expected a row"},
    {R"({"surfaces":{"s":{"kind":"system","variables":["x","y"],"equations":[]}},"tasks":[]})",
     "surfaces.s.variables: a system needs three variables"},
    {R"({"surfaces":{"s":{"kind":"system","variables":["x","y","z"],"equations":["x"],
        "bounds":{"w":[0,1]}}},"tasks":[]})", "surfaces.s.bounds.w: there is no variable"},
    {R"({"curves":{"c":{"kind":"nurbs_2","degree":2,"knots":[0,0,0,1,1],
        "control_points":[[0,0],[1,0],[1,1]]}},"tasks":[]})",
     "curves.c.knots: expected an array of 6 knots"},
    {R"({"curves":{"c":{"kind":"nurbs_2","degree":2,"knots":[0,0,1,0,1,1],
        "control_points":[[0,0],[1,0],[1,1]]}},"tasks":[]})", "curves.c.knots: "},
    {R"({"curves":{"c":{"kind":"nurbs_2","degree":3,"knots":[0,0,1,0,1,1],
        "control_points":[[0,0],[1,0],[1,1]]}},"tasks":[]})", "curves.c.degree: a degree of 3"},
    {at_point("true"), "tasks[0].at.point[0]: expected a number"},
    {at_point("\"1/0\""), "tasks[0].at.point[0]: this is not a number"},
    {at_point("\"sqrt(-2)\""), "tasks[0].at.point[0]: this is not a number"},
    {at_point("\"pi\""), "tasks[0].at.point[0]: this is not a number"},
    {at_point("1,1"), "tasks[0].at.point: expected an array of 3 numbers, found an array of 4"},
    {with_sphere(R"({"task":"curvature","surface":"t","at":{}})"),
     "tasks[0].surface: expected the name of a surface of the model (s)"},
    {with_sphere(R"({"task":"curvature","surface":"s","at":{"parameters":[0,0]}})"),
     "tasks[0].at: unknown field \"parameters\""},
    {with_sphere(R"({"task":"curvature","surface":"s","at":{"point":[1,0,0]},"direction":[1]})"),
     "tasks[0].direction: expected a vector of 3"},
    {with_sphere(R"({"task":"curvature","number_type":"float"})"),
     "tasks[0].number_type: expected a number type (exact"},
    {with_sphere(R"({"task":"mesh","surface":"s","file":"../s.ply","edge_length":1})"),
     "tasks[0].file: expected a file name relative"},
    {with_sphere(R"({"task":"mesh","surface":"s","file":"s.stl","edge_length":1})"),
     "tasks[0].file: expected the name of a file that ends in"},
    {with_sphere(R"({"task":"mesh","surface":"s","file":"s.ply","edge_length":0})"),
     "tasks[0].edge_length: expected a number greater than 0"},
    {with_mesh(R"("s.ply","edge_length":"1e-400")"), "tasks[0].edge_length: a length is used in"},
    {with_mesh(R"("s.ply","edge_length":1,"tolerance":"1e400")"),
     "tasks[0].tolerance: a length is used in floating point, where this one is zero or infinite"},
    {with_mesh(R"("s.ply","edge_length":1,"max_vertices":1.5)"),
     "tasks[0].max_vertices: expected an integer from 3"},
    {with_mesh(R"("s.ply","edge_length":1,"colour":"red")"),
     "tasks[0].colour: expected the name of a curvature (gaussian_curvature"},
    {with_mesh(R"("s.obj","edge_length":1,"colour":"kmin")"),
     "tasks[0].colour: a file .obj has no colours"},
    {with_sphere(R"({"task":"contact","id":"a"},{"task":"audit","id":"a"})"),
     "tasks: two tasks have the id \"a\""}};
  for (const auto& [model, message] : cases)
    expect_message(model, message);
}

TEST(Model, what_this_version_does_not_offer_is_no_error_of_the_model)
{
  const Model model = read_model(R"({
    "surfaces": { "o": { "kind": "offset", "of": "s", "distance": 1 },
                  "n": { "kind": "system", "variables": ["x","y","z","w"], "equations": ["x-w"] } },
    "curves": { "c": { "kind": "offset", "of": "d", "distance": 1 } },
    "tasks": [ { "task": "continuity", "anything": [1] },
               { "task": "curvature", "surface": "o", "at": { "point": [0,0,0] } },
               { "task": "curvature", "curve": "c", "at": { "parameters": [0] } },
               { "task": "line", "kind": "ridge", "surface": "n" },
               { "task": "mesh", "surface": "n", "file": "n.ply", "edge_length": 1,
                 "start": { "point": [0,0,0,0] }, "tolerance": 1 } ] })");
  Progress_bar no_progress(false);
  for (const Task& task : model.tasks)
  {
    const Task_result result = run_task(model, task, {}, ".", no_progress);
    EXPECT_EQ(result.status, "error") << task.id;
    EXPECT_EQ(result.code, "unsupported") << task.id;
    EXPECT_NE(result.text.find("not available in this version"), std::string::npos) << result.text;
  }
}

// --- Mutations -----------------------------------------------------------------------------------

const char* const meshes = R"json({
  "surfaces": {
    "b": { "kind": "bezier", "control_points": [[[0, 0, 0], [0, 1, 0.5, 2]], [[1, 0, "1/3"],
           [1, 1, 1e-2]]] },
    "n": { "kind": "nurbs", "flip": true, "degree": [2, 1],
      "knots": [[0, 0, 0, "1/2", 1, 1, 1], [0, 0, 1, 1]],
      "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 1]], [[2, 0, 1], [2, 1, 1]],
                         [[3, 0, 0], [3, 1, 2]]] },
    "s": { "kind": "implicit", "f": "x^2+y^2/2+sin(z)-1" } },
  "tasks": [
    { "task": "mesh", "surfaces": ["b", "n"], "file": "bn.ply", "edge_length": 2,
      "tolerance": "1/8", "colour": "kmin" },
    { "task": "mesh", "surface": "s", "file": "s.vtp", "edge_length": "1/2", "tolerance": "1/5",
      "box": [[-1, 1], [-1, "3/2"], [-1, 0.5]], "number_type": "double" },
    { "task": "mesh", "surface": "s", "file": "nothing.ply", "edge_length": "1/2",
      "box": [[2, 3], [2, 3], [-1, 1]] } ]
})json";

const char* const systems = R"json({
  "surfaces": {
    "q": { "kind": "system", "variables": ["x", "y", "z", "w"], "equations": ["z-w", "w-x*y"],
      "bounds": { "w": [-1, 1] } },
    "o": { "kind": "offset_system", "of": "s", "distance": "1/2" },
    "s": { "kind": "implicit", "f": "x^2+y^2+z^2-1" } },
  "tasks": [
    { "task": "mesh", "surface": "q", "file": "q.ply", "edge_length": "1/2", "colour": "kmin",
      "start": [{ "point": [0, 0, 0, 0] }, { "point": { "x": 1, "y": 0, "z": 0, "w": 0 } }],
      "box": [[-1, 1], [-1, "3/2"], [-1, 0.5]], "folds_file": "f.vtp" },
    { "task": "mesh", "surface": "o", "file": "o.vtp", "edge_length": 1,
      "box": [[-2, 2], [-2, 2], [0, 2]] },
    { "task": "line", "kind": "section", "surface": "o", "plane": [0, 0, 1, "-1/4"], "step": "1/2",
      "start": { "point": [1.5, 0, 0, 1, 0, 0] }, "file": "l.ply" },
    { "task": "line", "kind": "intersection", "surfaces": ["q", "s"], "step": "1/4",
      "start": [{ "point": [1, 0, 0, 0] }, { "point": [1, 0, 0] }], "max_points": 100 } ]
})json";

// The models in data/models, and those with meshes and lines.
std::vector<std::string> seeds()
{
  std::vector<std::string> texts{meshes, systems};
  for (const char* name : {"constructions", "curves", "implicit", "patches", "system"})
  {
    const std::string file = SHAPE_INTERROGATION_TEST_DATA "/models/" + std::string(name) + ".json";
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_FALSE(text.str().empty()) << file;
    texts.push_back(text.str());
  }
  return texts;
}

const std::vector<std::string> tokens = {
  "{", "}", "[", "]", ",", ":", "\"", "null", "true", "-", "1e9", "1e-9", "0", "^", "(", ")", "/0",
  "sqrt(", "*", "x", "\\u0000", "\xc3", "[[", "}}", "99999999999999999999", "1e400", "\"kind\"",
  "^4096", "\"1/3\"", "\"sqrt(2)\"", "exp(", "\n", "0.5", "\"surface\"", "-1", "\\", "NaN"};

// Some changes: a byte, a token, a part left out or written twice, or the end of another model.
std::string mutated(std::string text, const std::string& other, std::mt19937& random)
{
  const auto below = [&](std::size_t n) { return random() % (std::max<std::size_t>)(n, 1); };
  for (std::size_t changes = 1 + below(3); changes > 0; --changes)
  {
    const std::size_t at = below(text.size()), length = below(12);
    switch (below(6))
    {
    case 0:
      if (!text.empty())
        text[at] = static_cast<char>(below(256));
      break;
    case 1: text.insert(at, tokens[below(tokens.size())]); break;
    case 2: text.erase(at, length); break;
    case 3: text.insert(at, text.substr(below(text.size()), length)); break;
    case 4: text.replace(at, length, tokens[below(tokens.size())]); break;
    default:
      if (below(20) == 0)
        text = text.substr(0, at) + other.substr((std::min)(at, other.size()));
    }
  }
  return text;
}

// Where the tasks of the mutated models write their meshes.
class Mutated_model : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "models-XXXXXX").string();
    ASSERT_NE(mkdtemp(&name[0]), nullptr);
    m_directory = name;
  }
  void TearDown() override { std::filesystem::remove_all(m_directory); }

  // Reads the model, runs its tasks, meshes with few vertices, and tells whether it was readable.
  bool read_and_run(const std::string& text)
  {
    Model model;
    try
    {
      model = read_model(text);
    }
    catch (const Model_error& error)
    {
      EXPECT_GT(std::string(error.what()).size(), 5u);
      return false;
    }
    Progress_bar no_progress(false);
    for (Task& task : model.tasks)
    {
      Mesh_task* mesh = std::get_if<Mesh_task>(&task.data);
      if (mesh)
        mesh->max_vertices = 400;
      if (Line_task* line = std::get_if<Line_task>(&task.data))
        line->max_points = 100;
      const Task_result result = run_task(model, task, {}, m_directory, no_progress);
      EXPECT_TRUE(result.status == "ok" || !result.text.empty());
      EXPECT_NE(result.code, "failure") << result.text;
      ++m_tasks_run;
      m_meshes_made += mesh && result.status == "ok";
      m_meshes_refused += mesh && result.status == "refused";
    }
    return true;
  }

  std::filesystem::path m_directory;
  std::size_t m_tasks_run = 0, m_meshes_made = 0, m_meshes_refused = 0;
};

TEST_F(Mutated_model, is_read_or_refused)
{
  const unsigned seed = 20260117;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  const std::vector<std::string> models = seeds();
  for (const std::string& text : models)
    ASSERT_EQ(message_for(text), "");
  std::size_t accepted = 0, refused = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const std::string text = mutated(models[i % models.size()],
                                     models[random() % models.size()], random);
    ++(read_and_run(text) ? accepted : refused);
    ASSERT_FALSE(HasFailure()) << text;
  }
  std::cout << accepted << " read, " << refused << " refused, " << m_tasks_run << " tasks run, "
            << m_meshes_made << " meshes made, " << m_meshes_refused << " refused\n";
  EXPECT_GT(accepted, 100u);
  EXPECT_GT(refused, 300u);
  EXPECT_GT(m_tasks_run, 100u);
  EXPECT_GT(m_meshes_made, 30u);
  EXPECT_GT(m_meshes_refused, 0u);
}

} // namespace
