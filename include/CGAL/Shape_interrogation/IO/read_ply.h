// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_READ_PLY_H
#define CGAL_SHAPE_INTERROGATION_IO_READ_PLY_H

// Reads a PLY file back into a mesh with all its properties, the inverse of write_ply().

#include <CGAL/Shape_interrogation/IO/internal/mesh_columns.h>
#include <CGAL/Shape_interrogation/IO/internal/ply_input.h>

#include <array>
#include <istream>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The numbers of one element: the scalar properties as columns, the lists (corners) by row.
struct Ply_table
{
  std::vector<std::string> names;
  std::vector<Ply_type> types;
  std::vector<std::vector<double>> columns;
  std::vector<std::vector<double>> lists;
};

inline std::vector<double> read_ply_list(Ply_input& in, const Ply_property& property)
{
  const double count = in.number(property.count_type);
  if (!(count >= 0 && count <= 1e6 && count == std::floor(count)))
    throw Ply_error("a list has the impossible length " + std::to_string(count));
  std::vector<double> list;
  for (int i = 0; i < static_cast<int>(count); ++i)
    list.push_back(in.number(property.type));
  return list;
}

inline Ply_table read_ply_table(Ply_input& in, const Ply_element& element)
{
  Ply_table table;
  for (const Ply_property& property : element.properties)
    if (!property.is_list)
    {
      table.names.push_back(property.name);
      table.types.push_back(property.type);
    }
  table.columns.resize(table.names.size());
  if (element.properties.empty() && element.count > 0)
    throw Ply_error("the element '" + element.name + "' has no properties");
  for (std::size_t row = 0; row < element.count; ++row)
  {
    std::size_t column = 0;
    for (const Ply_property& property : element.properties)
      if (property.is_list)
        table.lists.push_back(read_ply_list(in, property));
      else
        table.columns[column++].push_back(in.number(property.type));
  }
  return table;
}

// Whether the columns from `first` on are the components of one property, and of which.
inline bool starts_property(const Ply_table& table, std::size_t first, const std::string& name,
                            int components)
{
  const std::vector<std::string> expected = component_names(name, components);
  if (first + expected.size() > table.names.size())
    return false;
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (table.names[first + k] != expected[k] || table.types[first + k] != table.types[first])
      return false;
  return true;
}

template <class Index, class T, class Mesh, class Range, class Value>
void fill_property(Mesh& mesh, const std::string& name, const Range& range, Value value)
{
  auto map = mesh.template add_property_map<Index, T>(name, T()).first;
  std::size_t row = 0;
  for (const Index i : range)
    map[i] = value(row++);
}

// Adds the property that starts at a column; returns how many columns it took.
template <class Index, class Mesh, class Range>
std::size_t add_property(Mesh& mesh, const Ply_table& table, std::size_t first,
                         const std::string& prefix, const Range& range)
{
  using Vector_3 = Shape_mesh::Vector_3;
  using Point_2 = Shape_mesh::Point_2;
  using Color = CGAL::IO::Color;
  const auto& c = table.columns;
  const std::size_t i = first;
  const auto vector = [&](std::size_t r) { return Vector_3(c[i][r], c[i + 1][r], c[i + 2][r]); };
  const auto color = [&](std::size_t r) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(c[i + k][r]); };
    return Color(byte(0), byte(1), byte(2));
  };
  std::string name = table.names[i];
  const std::string stem = name.size() > 2 ? name.substr(0, name.size() - 2) : name;
  const bool real = table.types[i] == Ply_type::DOUBLE || table.types[i] == Ply_type::FLOAT ||
                    table.types[i] == Ply_type::UINT32; // does not fit an int
  if (table.types[i] == Ply_type::UINT8 && starts_property(table, i, "color", 3))
    return fill_property<Index, Color>(mesh, prefix + "color", range, color), 3;
  if (real && starts_property(table, i, "normal", 3))
    return fill_property<Index, Vector_3>(mesh, prefix + "normal", range, vector), 3;
  if (real && starts_property(table, i, stem, 3))
    return fill_property<Index, Vector_3>(mesh, prefix + stem, range, vector), 3;
  for (const std::string& plane : {std::string("parameter"), stem})
    if (real && starts_property(table, i, plane, 2))
      return fill_property<Index, Point_2>(mesh, prefix + plane, range, [&](std::size_t r) {
               return Point_2(c[i][r], c[i + 1][r]);
             }), 2;
  name = prefix + name;
  if (real)
    fill_property<Index, double>(mesh, name, range, [&](std::size_t r) { return c[i][r]; });
  else if (table.types[i] == Ply_type::UINT8)
    fill_property<Index, bool>(mesh, name, range, [&](std::size_t r) { return c[i][r] != 0; });
  else
    fill_property<Index, int>(mesh, name, range,
                              [&](std::size_t r) { return static_cast<int>(c[i][r]); });
  return 1;
}

template <class Mesh>
void add_vertices(Mesh& mesh, const Ply_table& table)
{
  if (table.names.size() < 3 || table.names[0] != "x" || table.names[1] != "y" ||
      table.names[2] != "z")
    throw Ply_error("the element 'vertex' must begin with the properties x, y, z");
  for (std::size_t row = 0; row < table.columns[0].size(); ++row)
    mesh.add_vertex(typename Mesh::Point(table.columns[0][row], table.columns[1][row],
                                         table.columns[2][row]));
  for (std::size_t column = 3; column < table.names.size(); )
    column += add_property<typename Mesh::Vertex_index>(mesh, table, column, "v:",
                                                        mesh.vertices());
}

template <class Mesh>
void add_faces(Mesh& mesh, const Ply_table& table)
{
  const double size = double(mesh.number_of_vertices());
  const std::size_t rows = table.columns.empty() ? table.lists.size() : table.columns[0].size();
  if (table.lists.size() != rows)
    throw Ply_error("the element 'face' must have exactly one list of corners");
  for (std::size_t row = 0; row < table.lists.size(); ++row)
  {
    std::vector<typename Mesh::Vertex_index> corners;
    for (const double i : table.lists[row])
    {
      if (!(i >= 0 && i < size && i == std::floor(i)))
        throw Ply_error("the face " + std::to_string(row) + " has a corner that is no vertex");
      corners.emplace_back(typename Mesh::size_type(i));
    }
    if (corners.size() < 3 || mesh.add_face(corners) == Mesh::null_face())
      throw Ply_error("the face " + std::to_string(row) + " does not fit a manifold mesh");
  }
  for (std::size_t column = 0; column < table.names.size(); )
    column += add_property<typename Mesh::Face_index>(mesh, table, column, "f:", mesh.faces());
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief reads a mesh with its vertex and face properties from the format PLY.
 *
 * \details Reads what `write_ply()` writes, in both encodings, and every other file of these
 * encodings whose vertices begin with x, y, z and whose faces have one list of corners. Properties
 * get the names and types that `write_ply()` has written; of other files real numbers become
 * `double`, unsigned bytes become `bool` (three of them colours), other integers `int`.
 *
 * \param in the stream; it must have been opened as a binary one
 * \param mesh receives the mesh; it is cleared first, and left empty on failure
 * \param reason is set to one sentence that tells why nothing was read, or made empty
 * \return `true` if a mesh was read
 */
inline bool read_ply(std::istream& in, Shape_mesh::Surface_mesh& mesh, std::string& reason)
{
  mesh = Shape_mesh::Surface_mesh();
  reason.clear();
  try
  {
    const internal::Ply_header header = internal::read_ply_header(in);
    internal::Ply_input input(in, header.text);
    for (const internal::Ply_element& element : header.elements)
    {
      const internal::Ply_table table = internal::read_ply_table(input, element);
      if (element.name == "vertex")
        internal::add_vertices(mesh, table);
      else if (element.name == "face")
        internal::add_faces(mesh, table);
    }
  }
  catch (const internal::Ply_error& error)
  {
    mesh = Shape_mesh::Surface_mesh();
    reason = std::string("cannot read the mesh: ") + error.what();
  }
  return reason.empty();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_READ_PLY_H
