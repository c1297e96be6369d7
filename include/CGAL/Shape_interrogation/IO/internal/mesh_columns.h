// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_INTERNAL_MESH_COLUMNS_H
#define CGAL_SHAPE_INTERROGATION_IO_INTERNAL_MESH_COLUMNS_H

// The properties of a mesh as columns of numbers, the common view of all file formats that keep
// them: scalars, vectors, parameters, colours and flags.

#include <CGAL/Shape_interrogation/Meshing/Shape_mesh.h>

#include <CGAL/IO/Color.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The types that a column can have in a file.
enum class Column_type { UCHAR, INT, DOUBLE };

// One property of all vertices, or of all faces.
template <class Index>
struct Column
{
  std::string name; // without the prefix of its simplex
  Column_type type;
  int components;
  std::function<double(Index, int)> value;
};

template <class Index, class T, class Mesh, class Value>
bool try_column(const Mesh& mesh, const std::string& name, Column_type type, int components,
                Value value, std::vector<Column<Index>>& columns)
{
  const auto map = find_map<Index, T>(mesh, name);
  if (!map)
    return false;
  const std::string short_name = name.size() > 2 && name[1] == ':' ? name.substr(2) : name;
  columns.push_back({short_name, type, components,
                     [map = *map, value](Index i, int k) { return double(value(map[i], k)); }});
  return true;
}

// All properties of the mesh that have one of the known value types, in the order of creation.
template <class Index, class Mesh>
std::vector<Column<Index>> columns_of(const Mesh& mesh)
{
  using Vector_3 = Shape_mesh::Vector_3;
  using Point_2 = Shape_mesh::Point_2;
  using Color = CGAL::IO::Color;
  const auto scalar = [](auto x, int) { return x; };
  const auto coordinate = [](const auto& x, int k) { return x[k]; };
  std::vector<Column<Index>> c;
  for (const std::string& name : mesh.template properties<Index>())
  {
    if (name == "v:removed" || name == "f:removed")
      continue;
    try_column<Index, double>(mesh, name, Column_type::DOUBLE, 1, scalar, c) ||
      try_column<Index, Vector_3>(mesh, name, Column_type::DOUBLE, 3, coordinate, c) ||
      try_column<Index, Point_2>(mesh, name, Column_type::DOUBLE, 2, coordinate, c) ||
      try_column<Index, int>(mesh, name, Column_type::INT, 1, scalar, c) ||
      try_column<Index, bool>(mesh, name, Column_type::UCHAR, 1, scalar, c) ||
      try_column<Index, Color>(mesh, name, Column_type::UCHAR, 3, coordinate, c);
  }
  return c;
}

// The names of the components of a column, as far as a format has one name for each number.
inline std::vector<std::string> component_names(const std::string& name, int components)
{
  if (components == 1)
    return {name};
  if (name == "normal")
    return {"nx", "ny", "nz"};
  if (name == "color")
    return {"red", "green", "blue"};
  if (name == "parameter")
    return {"u", "v"};
  std::vector<std::string> names;
  for (int k = 0; k < components; ++k)
    names.push_back(name + "_" + "xyz"[k]);
  return names;
}

// The vertices in the order of the file, and the place of each in it.
template <class Mesh>
std::vector<std::size_t> positions_of_vertices(const Mesh& mesh)
{
  std::vector<std::size_t> position(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::size_t next = 0;
  for (const auto v : mesh.vertices())
    position[v.idx()] = next++;
  return position;
}

// A sentence when a number of the mesh is infinite or not a number: no file may contain it.
template <class Index, class Range>
std::string find_not_finite(const std::vector<Column<Index>>& columns, const Range& range,
                            const char* simplex)
{
  for (const Column<Index>& column : columns)
    for (const Index i : range)
      for (int k = 0; k < column.components; ++k)
        if (!std::isfinite(column.value(i, k)))
          return std::string("the property ") + column.name + " of the " + simplex + " " +
                 std::to_string(std::size_t(i)) + " is not a finite number";
  return {};
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_INTERNAL_MESH_COLUMNS_H
