// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_WRITE_PLY_H
#define CGAL_SHAPE_INTERROGATION_IO_WRITE_PLY_H

// PLY with all vertex and face properties: CGAL's own writer drops vectors.

#include <CGAL/Shape_interrogation/IO/internal/mesh_columns.h>
#include <CGAL/Shape_interrogation/IO/internal/number_output.h>

#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief tells how numbers are written into files that leave the choice.
 */
enum class Number_encoding
{
  BINARY, //!< little-endian bytes, in base 64 where a format asks for text
  TEXT    //!< decimal numbers that read back to the same double
};

namespace internal {

inline const char* ply_name(Column_type type)
{
  static const char* const names[] = {"uchar", "int", "double"};
  return names[static_cast<int>(type)];
}

template <class Index>
void write_ply_properties(std::ostream& out, const std::vector<Column<Index>>& columns)
{
  for (const Column<Index>& column : columns)
    for (const std::string& name : component_names(column.name, column.components))
      out << "property " << ply_name(column.type) << ' ' << name << '\n';
}

// One number of a column: as text with a space behind it, or as bytes.
inline void write_ply_number(std::ostream& out, Number_encoding encoding, Column_type type,
                             double x)
{
  if (encoding == Number_encoding::TEXT)
  {
    if (type == Column_type::DOUBLE)
      write_text(out, x);
    else
      write_text(out, static_cast<int>(x));
    out.put(' ');
    return;
  }
  std::string bytes;
  if (type == Column_type::DOUBLE)
    append_little_endian(bytes, x);
  else if (type == Column_type::INT)
    append_little_endian(bytes, static_cast<std::int32_t>(x));
  else
    append_little_endian(bytes, static_cast<unsigned char>(x));
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

template <class Index>
void write_ply_row(std::ostream& out, Number_encoding encoding,
                   const std::vector<Column<Index>>& columns, Index i)
{
  for (const Column<Index>& column : columns)
    for (int k = 0; k < column.components; ++k)
      write_ply_number(out, encoding, column.type, column.value(i, k));
  if (encoding == Number_encoding::TEXT)
    out.put('\n');
}

// The corners of a face, with their number before them.
template <class Mesh>
void write_ply_face(std::ostream& out, Number_encoding encoding, const Mesh& mesh,
                    typename Mesh::Face_index f, const std::vector<std::size_t>& position)
{
  write_ply_number(out, encoding, Column_type::UCHAR, mesh.degree(f));
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
    write_ply_number(out, encoding, Column_type::INT, double(position[v.idx()]));
}

// The points are a column like the others, with names of their own.
template <class Mesh>
Column<typename Mesh::Vertex_index> point_column(const Mesh& mesh)
{
  return {"point", Column_type::DOUBLE, 3,
          [&mesh](typename Mesh::Vertex_index v, int k) { return mesh.point(v)[k]; }};
}

template <class Mesh>
std::string write_ply_reason(std::ostream& out, const Mesh& mesh, Number_encoding encoding)
{
  using Vertex = typename Mesh::Vertex_index;
  using Face = typename Mesh::Face_index;
  std::vector<Column<Vertex>> columns = columns_of<Vertex>(mesh);
  const std::vector<Column<Face>> face_columns = columns_of<Face>(mesh);
  std::vector<Column<Vertex>> all{point_column(mesh)};
  all.insert(all.end(), columns.begin(), columns.end());
  for (const std::string& reason : {find_not_finite(all, mesh.vertices(), "vertex"),
                                    find_not_finite(face_columns, mesh.faces(), "face")})
    if (!reason.empty())
      return reason;
  const bool text = encoding == Number_encoding::TEXT;
  out << "ply\nformat " << (text ? "ascii" : "binary_little_endian") << " 1.0\n";
  out << "element vertex " << std::to_string(mesh.number_of_vertices()) << '\n';
  out << "property double x\nproperty double y\nproperty double z\n";
  write_ply_properties(out, columns);
  out << "element face " << std::to_string(mesh.number_of_faces()) << '\n';
  out << "property list uchar int vertex_indices\n";
  write_ply_properties(out, face_columns);
  out << "end_header\n";
  for (const Vertex v : mesh.vertices())
    write_ply_row(out, encoding, all, v);
  const std::vector<std::size_t> position = positions_of_vertices(mesh);
  for (const Face f : mesh.faces())
  {
    write_ply_face(out, encoding, mesh, f, position);
    write_ply_row(out, encoding, face_columns, f);
  }
  return {};
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes a mesh with its vertex and face properties in the format PLY.
 *
 * \details Written are all properties whose values are `double`, `int`, `bool`, vectors, points of
 * the parameter plane or colours, without the prefix of their name. A vector `name` becomes the
 * three numbers `name_x`, `name_y`, `name_z`, but `normal` becomes `nx`, `ny`, `nz`, `color`
 * becomes `red`, `green`, `blue`, and `parameter` becomes `u`, `v`. Doubles read back to the same
 * bits, whatever the locale. A mesh with a number that is not finite is not written.
 *
 * \param out the stream; for `BINARY` it must have been opened so
 * \param mesh the mesh
 * \param encoding how numbers are written
 * \return `true` if all was written
 * \sa `read_ply()`
 */
inline bool write_ply(std::ostream& out, const Shape_mesh::Surface_mesh& mesh,
                      Number_encoding encoding = Number_encoding::BINARY)
{
  return internal::write_ply_reason(out, mesh, encoding).empty() && out.good();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_WRITE_PLY_H
