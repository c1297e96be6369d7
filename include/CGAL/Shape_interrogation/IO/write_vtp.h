// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_WRITE_VTP_H
#define CGAL_SHAPE_INTERROGATION_IO_WRITE_VTP_H

// VTK's XML format for polygonal data, with all vertex and face properties.

#include <CGAL/Shape_interrogation/IO/write_ply.h>

#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline const char* vtk_name(Column_type type)
{
  static const char* const names[] = {"UInt8", "Int32", "Float64"};
  return names[static_cast<int>(type)];
}

// A name as the value of an XML attribute.
inline std::string xml_escaped(const std::string& name)
{
  std::string escaped;
  for (const char c : name)
    switch (c)
    {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '"': escaped += "&quot;"; break;
      default: escaped += c;
    }
  return escaped;
}

// One DataArray element. The numbers come from `fill`, which is called with a function that takes
// them one by one.
template <class T, class Fill>
void write_vtk_array(std::ostream& out, Number_encoding encoding, const std::string& type,
                     const std::string& name, int components, Fill fill)
{
  const bool text = encoding == Number_encoding::TEXT;
  out << "        <DataArray type=\"" << type << "\" Name=\"" << xml_escaped(name)
      << "\" NumberOfComponents=\"" << std::to_string(components) << "\" format=\""
      << (text ? "ascii" : "binary") << "\">\n          ";
  if (text)
  {
    int column = 0;
    fill([&](double x) {
      write_text(out, static_cast<T>(x));
      out << (++column % (3 * components) == 0 ? "\n          " : " ");
    });
  }
  else
  {
    std::string numbers, bytes;
    fill([&](double x) { append_little_endian(numbers, static_cast<T>(x)); });
    append_little_endian(bytes, static_cast<std::uint64_t>(numbers.size()));
    out << to_base64(bytes + numbers);
  }
  out << "\n        </DataArray>\n";
}

template <class Index, class Range>
void write_vtk_column(std::ostream& out, Number_encoding encoding, const Column<Index>& column,
                      const std::string& name, const Range& range)
{
  const auto fill = [&](auto put) {
    for (const Index i : range)
      for (int k = 0; k < column.components; ++k)
        put(column.value(i, k));
  };
  const std::string type = vtk_name(column.type);
  if (column.type == Column_type::DOUBLE)
    write_vtk_array<double>(out, encoding, type, name, column.components, fill);
  else if (column.type == Column_type::INT)
    write_vtk_array<std::int32_t>(out, encoding, type, name, column.components, fill);
  else
    write_vtk_array<unsigned char>(out, encoding, type, name, column.components, fill);
}

template <class Mesh>
void write_vtk_polygons(std::ostream& out, Number_encoding encoding, const Mesh& mesh)
{
  const std::vector<std::size_t> position = positions_of_vertices(mesh);
  out << "      <Polys>\n";
  write_vtk_array<std::int64_t>(out, encoding, "Int64", "connectivity", 1, [&](auto put) {
    for (const auto f : mesh.faces())
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        put(double(position[v.idx()]));
  });
  write_vtk_array<std::int64_t>(out, encoding, "Int64", "offsets", 1, [&](auto put) {
    double end = 0;
    for (const auto f : mesh.faces())
      put(end += mesh.degree(f));
  });
  out << "      </Polys>\n";
}

// The attribute of PointData that names what is shown first.
template <class Index>
std::string vtk_default_arrays(const std::vector<Column<Index>>& columns)
{
  std::string attributes;
  for (const Column<Index>& column : columns)
    if (column.name == "normal" && column.components == 3)
      attributes += " Normals=\"normal\"";
    else if (column.name == "mean_curvature" && column.components == 1)
      attributes += " Scalars=\"mean_curvature\"";
  return attributes;
}

template <class Mesh>
std::string write_vtp_reason(std::ostream& out, const Mesh& mesh, Number_encoding encoding)
{
  using Vertex = typename Mesh::Vertex_index;
  using Face = typename Mesh::Face_index;
  const auto columns = columns_of<Vertex>(mesh);
  const auto face_columns = columns_of<Face>(mesh);
  const std::vector<Column<Vertex>> points{point_column(mesh)};
  for (const std::string& reason : {find_not_finite(points, mesh.vertices(), "vertex"),
                                    find_not_finite(columns, mesh.vertices(), "vertex"),
                                    find_not_finite(face_columns, mesh.faces(), "face")})
    if (!reason.empty())
      return reason;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\""
         " byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PolyData>\n"
         "    <Piece NumberOfPoints=\"" << std::to_string(mesh.number_of_vertices())
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << std::to_string(mesh.number_of_faces()) << "\">\n";
  out << "      <PointData" << vtk_default_arrays(columns) << ">\n";
  for (const auto& column : columns)
    write_vtk_column(out, encoding, column, column.name, mesh.vertices());
  out << "      </PointData>\n      <CellData>\n";
  for (const auto& column : face_columns)
    write_vtk_column(out, encoding, column, column.name, mesh.faces());
  out << "      </CellData>\n      <Points>\n";
  write_vtk_column(out, encoding, points.front(), "Points", mesh.vertices());
  out << "      </Points>\n";
  write_vtk_polygons(out, encoding, mesh);
  out << "    </Piece>\n  </PolyData>\n</VTKFile>\n";
  return {};
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes a mesh with its vertex and face properties in VTK's XML format for polygonal data,
 * which ParaView reads.
 *
 * \details Written are the same properties as by `write_ply()`, each as one array of its own name.
 * Doubles read back to the same bits, whatever the locale. A mesh with a number that is not finite
 * is not written.
 *
 * \param out the stream
 * \param mesh the mesh
 * \param encoding how numbers are written
 * \return `true` if all was written
 */
inline bool write_vtp(std::ostream& out, const Shape_mesh::Surface_mesh& mesh,
                      Number_encoding encoding = Number_encoding::BINARY)
{
  return internal::write_vtp_reason(out, mesh, encoding).empty() && out.good();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_WRITE_VTP_H
