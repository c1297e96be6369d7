// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_WRITE_MESH_H
#define CGAL_SHAPE_INTERROGATION_IO_WRITE_MESH_H

// Writes a mesh in the format that the file's name tells: all properties (.ply, .vtp) or the
// geometry alone (.off, .obj).

#include <CGAL/Shape_interrogation/IO/internal/replace_file.h>
#include <CGAL/Shape_interrogation/IO/write_ply.h>
#include <CGAL/Shape_interrogation/IO/write_vtp.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <locale>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The last part of the file name in lower case, with its dot.
inline std::string extension_of(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return extension;
}

// Points and corners alone, through CGAL's writers of polygon soups: those of meshes would add
// normals and colours in dialects that many readers refuse.
template <class Mesh>
std::string write_geometry(std::ostream& out, const Mesh& mesh, bool obj)
{
  const std::vector<std::size_t> position = positions_of_vertices(mesh);
  std::vector<typename Mesh::Point> points;
  for (const auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  std::vector<std::vector<std::size_t>> faces;
  for (const auto f : mesh.faces())
  {
    faces.emplace_back();
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      faces.back().push_back(position[v.idx()]);
  }
  out.imbue(std::locale::classic());
  const auto precise = parameters::stream_precision(17);
  const bool written = obj ? CGAL::IO::write_OBJ(out, points, faces, precise)
                           : CGAL::IO::write_OFF(out, points, faces, precise);
  return written ? std::string() : "the stream failed";
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes a mesh to a file.
 *
 * \details The extension of the name tells the format: `.ply` (`write_ply()`) and `.vtp`
 * (`write_vtp()`) keep all properties, `.off` and `.obj` the geometry alone, with 17 digits. The
 * file is written whole or not at all: a file that was there stays as it was when writing fails.
 *
 * \param file the name of the file
 * \param mesh the mesh
 * \param reason is set to one sentence that tells why nothing was written, or made empty
 * \param encoding how numbers are written in `.ply` and `.vtp`
 * \return `true` if the file was written
 */
inline bool write_mesh(const std::string& file, const Shape_mesh::Surface_mesh& mesh,
                       std::string& reason, Number_encoding encoding = Number_encoding::BINARY)
{
  const std::string extension = internal::extension_of(file);
  const std::array<const char*, 4> known{".ply", ".vtp", ".off", ".obj"};
  if (std::find(known.begin(), known.end(), extension) == known.end())
  {
    reason = "cannot write " + file + ": the extension must be .ply, .vtp, .off or .obj, not " +
             (extension.empty() ? "missing" : extension);
    return false;
  }
  reason = internal::replace_file(file, [&](std::ostream& out) {
    if (extension == ".ply")
      return internal::write_ply_reason(out, mesh, encoding);
    if (extension == ".vtp")
      return internal::write_vtp_reason(out, mesh, encoding);
    return internal::write_geometry(out, mesh, extension == ".obj");
  });
  return reason.empty();
}

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes a mesh to a file, without telling why when it cannot.
 * \return `true` if the file was written
 */
inline bool write_mesh(const std::string& file, const Shape_mesh::Surface_mesh& mesh,
                       Number_encoding encoding = Number_encoding::BINARY)
{
  std::string reason;
  return write_mesh(file, mesh, reason, encoding);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_WRITE_MESH_H
