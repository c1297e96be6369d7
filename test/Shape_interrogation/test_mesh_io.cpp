// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Mesh files: what is written is read back to the bit, other programs' rules are kept, and what
// cannot be written or read is told in a sentence.

#include "meshed_patches.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/IO/read_ply.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace meshed_patches;
using Mesh = Shape_mesh::Surface_mesh;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
namespace fs = std::filesystem;

// A directory for the files of one test, removed at its end.
class Mesh_file : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    m_directory = fs::path(testing::TempDir()) / (std::string("mesh_io_") + info->name());
    fs::remove_all(m_directory);
    fs::create_directories(m_directory);
  }
  void TearDown() override { fs::remove_all(m_directory); }

  std::string file(const std::string& name) const { return (m_directory / name).string(); }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_directory), {}));
  }

private:
  fs::path m_directory;
};

// The sphere in few triangles, with colours.
const Mesh& small_mesh()
{
  static const Mesh mesh = [] {
    Patch_mesh_options options;
    options.tolerance = 0.03;
    const std::vector<Patch> patches = sphere(options.flipped);
    Mesh m = mesh_patches(patches, options)->surface_mesh;
    color_by_property(m, "v:mean_curvature");
    return m;
  }();
  return mesh;
}

std::string written(const Mesh& mesh, Number_encoding encoding)
{
  std::ostringstream out;
  EXPECT_TRUE(write_ply(out, mesh, encoding));
  return out.str();
}

Mesh read(const std::string& text)
{
  Mesh mesh;
  std::string reason;
  std::istringstream in(text);
  EXPECT_TRUE(read_ply(in, mesh, reason)) << reason;
  return mesh;
}

template <class Index, class T, class Range>
void expect_same_property(const Mesh& a, const Mesh& b, const std::string& name, const Range& range)
{
  const auto x = internal::find_map<Index, T>(a, name), y = internal::find_map<Index, T>(b, name);
  ASSERT_TRUE(x && y) << name;
  for (const Index i : range)
    EXPECT_EQ((*x)[i], (*y)[i]) << name << " of " << i;
}

void expect_same(const Mesh& a, const Mesh& b)
{
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (const Vertex v : a.vertices())
    EXPECT_EQ(a.point(v), b.point(v));
  for (const char* name : {"v:normal", "v:direction_min", "v:direction_max"})
    expect_same_property<Vertex, Shape_mesh::Vector_3>(a, b, name, a.vertices());
  for (const char* name : {"v:gaussian_curvature", "v:mean_curvature", "v:kmin", "v:kmax"})
    expect_same_property<Vertex, double>(a, b, name, a.vertices());
  expect_same_property<Vertex, bool>(a, b, "v:regular", a.vertices());
  expect_same_property<Vertex, int>(a, b, "v:patch", a.vertices());
  expect_same_property<Vertex, Shape_mesh::Point_2>(a, b, "v:parameter", a.vertices());
  expect_same_property<Vertex, CGAL::IO::Color>(a, b, "v:color", a.vertices());
  expect_same_property<Face, int>(a, b, "f:patch", a.faces());
}

// The corners of all faces.
std::vector<std::vector<Vertex>> faces_of(const Mesh& mesh)
{
  std::vector<std::vector<Vertex>> faces;
  for (const Face f : mesh.faces())
  {
    faces.emplace_back();
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      faces.back().push_back(v);
  }
  return faces;
}

TEST_F(Mesh_file, Ply_is_read_back_to_the_bit)
{
  for (const Number_encoding encoding : {Number_encoding::BINARY, Number_encoding::TEXT})
  {
    const Mesh again = read(written(small_mesh(), encoding));
    expect_same(small_mesh(), again);
    EXPECT_EQ(faces_of(again), faces_of(small_mesh()));
  }
}

TEST_F(Mesh_file, Teapot_read_back_is_that_of_the_patches)
{
  Patch_mesh_options options;
  options.tolerance = 0.03;
  const auto meshed = mesh_patches(teapot(), options);
  ASSERT_TRUE(meshed);
  ASSERT_TRUE(write_mesh(file("teapot.ply"), meshed->surface_mesh));
  Mesh mesh;
  std::string reason;
  std::ifstream in(file("teapot.ply"), std::ios::binary);
  ASSERT_TRUE(read_ply(in, mesh, reason)) << reason;
  const Shape_property_maps maps(mesh);
  const Patch_property_maps where(mesh);
  std::vector<Bezier_surface_3<double>> patches;
  for (const Patch& patch : teapot())
    patches.push_back(patch.cast<double>());
  std::size_t compared = 0;
  for (const Vertex v : mesh.vertices())
  {
    if (!maps.regular[v])
      continue;
    const auto uv = where.parameter[v];
    const auto shape = patches[where.vertex_patch[v]]({uv.x(), uv.y()});
    ASSERT_TRUE(shape);
    const double scale = std::max(1.0, std::max(std::abs(maps.kmin[v]), std::abs(maps.kmax[v])));
    EXPECT_NEAR(maps.gaussian_curvature[v], gaussian_curvature(*shape), 1e-12 * scale * scale);
    EXPECT_NEAR(maps.mean_curvature[v], mean_curvature(*shape), 1e-12 * scale);
    const double length = std::sqrt(shape->normal_squared_length());
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(mesh.point(v)[d], shape->point()[d], 1e-12);
      EXPECT_NEAR(maps.normal[v][d], shape->normal()[d] / length, 1e-12);
    }
    ++compared;
  }
  EXPECT_GT(compared, 3000u);
}

TEST_F(Mesh_file, Ply_header_has_the_names_of_the_format)
{
  const std::string text = written(small_mesh(), Number_encoding::TEXT);
  EXPECT_EQ(text.find("ply\nformat ascii 1.0\nelement vertex "), 0u);
  for (const char* line : {"property double x", "property double nx", "property double kmin",
                           "property double direction_max_z", "property uchar red",
                           "property double u", "property list uchar int vertex_indices"})
    EXPECT_NE(text.find(std::string("\n") + line + "\n"), std::string::npos) << line;
}

struct Comma_punctuation : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

TEST_F(Mesh_file, Locale_does_not_matter)
{
  const std::string plain = written(small_mesh(), Number_encoding::TEXT);
  ASSERT_TRUE(write_mesh(file("plain.off"), small_mesh()));
  ASSERT_TRUE(write_mesh(file("plain.vtp"), small_mesh()));
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma_punctuation));
  const std::string other = written(small_mesh(), Number_encoding::TEXT);
  EXPECT_TRUE(write_mesh(file("other.off"), small_mesh()));
  EXPECT_TRUE(write_mesh(file("other.vtp"), small_mesh()));
  const Mesh again = read(plain);
  std::locale::global(before);
  EXPECT_EQ(plain, other);
  expect_same(small_mesh(), again);
  const auto content = [&](const std::string& name) {
    std::ifstream in(file(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(content("plain.off"), content("other.off"));
  EXPECT_EQ(content("plain.vtp"), content("other.vtp"));
}

// What stands between the tags of the first DataArray of the name.
std::string data_array(const std::string& xml, const std::string& name)
{
  const std::size_t tag = xml.find("Name=\"" + name + "\"");
  if (tag == std::string::npos)
    return "";
  const std::size_t begin = xml.find('>', tag) + 1;
  return xml.substr(begin, xml.find('<', begin) - begin);
}

std::string from_base64(const std::string& text)
{
  static const std::string digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text)
  {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos)
      continue;
    bits = bits << 6 | static_cast<unsigned>(digit);
    if (++count % 4 != 1)
      bytes.push_back(static_cast<char>(bits >> (6 - 2 * ((count - 1) % 4)) & 0xff));
  }
  return bytes;
}

TEST_F(Mesh_file, Vtp_has_the_same_numbers_in_both_encodings)
{
  std::ostringstream binary, text;
  ASSERT_TRUE(write_vtp(binary, small_mesh(), Number_encoding::BINARY));
  ASSERT_TRUE(write_vtp(text, small_mesh(), Number_encoding::TEXT));
  const std::map<std::string, std::size_t> arrays{
    {"normal", 3}, {"gaussian_curvature", 1}, {"direction_min", 3}, {"parameter", 2},
    {"Points", 3}};
  for (const auto& array : arrays)
  {
    const std::string bytes = from_base64(data_array(binary.str(), array.first));
    const std::size_t numbers = array.second * small_mesh().number_of_vertices();
    ASSERT_EQ(bytes.size(), 8 + 8 * numbers) << array.first;
    EXPECT_EQ(internal::from_little_endian<std::uint64_t>(bytes.data()), 8 * numbers);
    std::istringstream words(data_array(text.str(), array.first));
    for (std::size_t i = 0; i < numbers; ++i)
    {
      double x = 0;
      words >> x;
      ASSERT_TRUE(words);
      EXPECT_EQ(x, internal::from_little_endian<double>(bytes.data() + 8 + 8 * i));
    }
  }
  const std::string corners = from_base64(data_array(binary.str(), "connectivity"));
  ASSERT_EQ(corners.size(), 8 + 8 * 3 * small_mesh().number_of_faces());
  std::size_t i = 0;
  for (const auto& face : faces_of(small_mesh()))
    for (const Vertex v : face)
    {
      const char* const at = corners.data() + 8 + 8 * i++;
      EXPECT_EQ(internal::from_little_endian<std::int64_t>(at), std::int64_t(v.idx()));
    }
  EXPECT_NE(binary.str().find("Normals=\"normal\""), std::string::npos);
}

TEST_F(Mesh_file, Off_and_obj_have_the_geometry)
{
  for (const std::string name : {"mesh.off", "mesh.OBJ"})
  {
    ASSERT_TRUE(write_mesh(file(name), small_mesh()));
    std::vector<Shape_mesh::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    std::ifstream in(file(name));
    ASSERT_TRUE(name == "mesh.off" ? CGAL::IO::read_OFF(in, points, faces)
                                   : CGAL::IO::read_OBJ(in, points, faces));
    ASSERT_EQ(points.size(), small_mesh().number_of_vertices());
    ASSERT_EQ(faces.size(), small_mesh().number_of_faces());
    for (const Vertex v : small_mesh().vertices())
      EXPECT_EQ(points[v.idx()], small_mesh().point(v));
  }
}

TEST_F(Mesh_file, Removed_vertices_are_left_out)
{
  Mesh mesh = small_mesh();
  const Vertex last(static_cast<Mesh::size_type>(mesh.number_of_vertices()));
  mesh.add_vertex(Shape_mesh::Point_3(9, 9, 9));
  mesh.add_vertex(Shape_mesh::Point_3(8, 8, 8));
  mesh.remove_vertex(last);
  const Mesh again = read(written(mesh, Number_encoding::BINARY));
  ASSERT_EQ(again.number_of_vertices(), small_mesh().number_of_vertices() + 1);
  EXPECT_EQ(again.point(last), Shape_mesh::Point_3(8, 8, 8));
  EXPECT_EQ(faces_of(again), faces_of(small_mesh()));
}

TEST_F(Mesh_file, What_cannot_be_written_is_told_and_leaves_nothing_behind)
{
  std::string reason;
  const auto expect_reason = [&](const std::string& name, const Mesh& mesh, const char* part) {
    const std::size_t before = number_of_files();
    EXPECT_FALSE(write_mesh(file(name), mesh, reason));
    EXPECT_NE(reason.find(part), std::string::npos) << reason;
    EXPECT_NE(reason.find(name), std::string::npos) << reason;
    EXPECT_EQ(number_of_files(), before);
    EXPECT_FALSE(write_mesh(file(name), mesh));
  };
  expect_reason("nowhere/mesh.ply", small_mesh(), "no directory");
  expect_reason("mesh.stl", small_mesh(), "the extension must be");
  expect_reason("mesh", small_mesh(), "the extension must be");
  fs::create_directory(file("taken.vtp"));
  expect_reason("taken.vtp", small_mesh(), "is a directory");
  std::ofstream(file("plain")) << "no directory";
  expect_reason("plain/mesh.ply", small_mesh(), "no directory");

  // A file that is there stays as it is.
  std::ofstream(file("old.ply")) << "old";
  std::ofstream(file("old.vtp")) << "old";
  Mesh broken = small_mesh();
  Shape_property_maps(broken).kmin[Vertex(5)] = std::numeric_limits<double>::quiet_NaN();
  expect_reason("old.ply", broken, "kmin of the vertex 5 is not a finite number");
  expect_reason("old.vtp", broken, "kmin of the vertex 5 is not a finite number");
  for (const char* name : {"old.ply", "old.vtp"})
  {
    std::string content;
    std::ifstream(file(name)) >> content;
    EXPECT_EQ(content, "old");
  }
  EXPECT_TRUE(write_mesh(file("old.ply"), small_mesh(), reason));
  EXPECT_EQ(reason, "");
  EXPECT_EQ(read([&] {
              std::ifstream in(file("old.ply"), std::ios::binary);
              return std::string(std::istreambuf_iterator<char>(in), {});
            }()).number_of_faces(),
            small_mesh().number_of_faces());
}

TEST_F(Mesh_file, Broken_ply_is_refused_with_a_sentence)
{
  const std::string vertices = "property double x\nproperty double y\nproperty double z\n";
  const std::string faces = "property list uchar int vertex_indices\n";
  const std::map<std::string, std::string> cases{
    {"", "the file ends"},
    {"solid\n", "not 'ply'"},
    {"ply\nformat binary_big_endian 1.0\n", "not understood"},
    {"ply\nformat ascii 1.0\nelement vertex many\nend_header\n", "not a number"},
    {"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "unknown type"},
    {"ply\nformat ascii 1.0\nelement vertex 1\nproperty\nend_header\n", "malformed"},
    {"ply\nformat ascii 1.0\nelement vertex 1\nend_header\n", "no properties"},
    {"ply\nformat ascii 1.0\nelement vertex 1\nproperty double y\nend_header\n1\n", "x, y, z"},
    {"ply\nformat ascii 1.0\nelement vertex 1\n" + vertices + "end_header\n1 2 c\n", "'c'"},
    {"ply\nformat ascii 1.0\nelement vertex 99999999999999\n" + vertices + "end_header\n1 2 3\n",
     "ends before"},
    {"ply\nformat ascii 1.0\nelement vertex 1\n" + vertices + "element face 1\n" + faces +
       "end_header\n0 0 0\n3 0 0 7\n", "no vertex"},
    {"ply\nformat ascii 1.0\nelement vertex 1\n" + vertices + "element face 1\n" + faces +
       "end_header\n0 0 0\n-3 0 0 0\n", "impossible length"},
    {"ply\nformat ascii 1.0\nelement vertex 3\n" + vertices + "element face 2\n" + faces +
       "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "manifold"}};
  for (const auto& broken : cases)
  {
    Mesh mesh = small_mesh();
    std::string reason;
    std::istringstream in(broken.first);
    EXPECT_FALSE(read_ply(in, mesh, reason)) << broken.first;
    EXPECT_NE(reason.find(broken.second), std::string::npos) << reason;
    EXPECT_EQ(mesh.number_of_vertices(), 0u);
  }
}

TEST_F(Mesh_file, Truncated_ply_is_refused_everywhere)
{
  for (const Number_encoding encoding : {Number_encoding::BINARY, Number_encoding::TEXT})
  {
    const std::string whole = written(small_mesh(), encoding);
    // The last characters of a text are the digits of a number and the end of the line.
    const std::size_t last = whole.size() - (encoding == Number_encoding::TEXT ? 4 : 1);
    for (std::size_t size = 0; size <= last; size += 1 + size / 23)
    {
      Mesh mesh;
      std::string reason;
      std::istringstream in(whole.substr(0, size));
      EXPECT_FALSE(read_ply(in, mesh, reason)) << size;
      EXPECT_FALSE(reason.empty());
    }
  }
}

} // namespace
