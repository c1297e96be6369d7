// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_WRITE_POLYLINES_H
#define CGAL_SHAPE_INTERROGATION_IO_WRITE_POLYLINES_H

// Writes curves in n-space as polylines in space, with the other variables as properties.

#include <CGAL/Shape_interrogation/IO/internal/replace_file.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/N_space_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Calls put(i) for the positions of the points of each line, the first again for a closed one, and
// end() behind each line.
template <class Put, class End>
void for_each_corner(const std::vector<N_space_polyline>& lines, Put put, End end)
{
  std::size_t start = 0;
  for (const N_space_polyline& line : lines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
      put(start + i);
    if (line.closed && !line.points.empty())
      put(start);
    end();
    start += line.points.size();
  }
}

template <class Put>
void for_each_point(const std::vector<N_space_polyline>& lines, Put put)
{
  for (const N_space_polyline& line : lines)
    for (const std::vector<double>& p : line.points)
      put(p);
}

inline std::size_t number_of_points(const std::vector<N_space_polyline>& lines)
{
  std::size_t n = 0;
  for_each_point(lines, [&](const std::vector<double>&) { ++n; });
  return n;
}

inline void write_lines_vtp(std::ostream& out, const std::vector<N_space_polyline>& lines,
                            const std::vector<std::string>& variables)
{
  const Number_encoding encoding = Number_encoding::BINARY;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\""
         " byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PolyData>\n"
         "    <Piece NumberOfPoints=\"" << std::to_string(number_of_points(lines))
      << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << std::to_string(lines.size())
      << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n      <PointData>\n";
  for (std::size_t k = 3; k < variables.size(); ++k)
    write_vtk_array<double>(out, encoding, "Float64", variables[k], 1, [&](auto put) {
      for_each_point(lines, [&](const std::vector<double>& p) { put(p[k]); });
    });
  out << "      </PointData>\n      <Points>\n";
  write_vtk_array<double>(out, encoding, "Float64", "Points", 3, [&](auto put) {
    for_each_point(lines, [&](const std::vector<double>& p) {
      for (int k = 0; k < 3; ++k)
        put(p[k]);
    });
  });
  out << "      </Points>\n      <Lines>\n";
  write_vtk_array<std::int64_t>(out, encoding, "Int64", "connectivity", 1, [&](auto put) {
    for_each_corner(lines, [&](std::size_t i) { put(double(i)); }, [] {});
  });
  write_vtk_array<std::int64_t>(out, encoding, "Int64", "offsets", 1, [&](auto put) {
    double count = 0;
    for_each_corner(lines, [&](std::size_t) { ++count; }, [&] { put(count); });
  });
  out << "      </Lines>\n    </Piece>\n  </PolyData>\n</VTKFile>\n";
}

inline void write_lines_obj(std::ostream& out, const std::vector<N_space_polyline>& lines)
{
  for_each_point(lines, [&](const std::vector<double>& p) {
    out << 'v';
    for (int k = 0; k < 3; ++k)
      write_text(out << ' ', p[k]);
    out << '\n';
  });
  std::string line = "l";
  for_each_corner(lines, [&](std::size_t i) { line += " " + std::to_string(i + 1); }, [&] {
    out << line << '\n';
    line = "l";
  });
}

inline void write_lines_ply(std::ostream& out, const std::vector<N_space_polyline>& lines,
                            const std::vector<std::string>& variables)
{
  std::vector<std::array<std::size_t, 2>> edges;
  std::size_t before = 0;
  bool is_first = true;
  for_each_corner(lines, [&](std::size_t i) {
    if (!is_first)
      edges.push_back({before, i});
    before = i;
    is_first = false;
  }, [&] { is_first = true; });
  out << "ply\nformat ascii 1.0\nelement vertex " << std::to_string(number_of_points(lines))
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  std::set<std::string> taken{"x", "y", "z"};
  for (std::size_t k = 3; k < variables.size(); ++k)
  {
    std::string name = variables[k];
    while (!taken.insert(name).second)
      name = "_" + name;
    out << "property double " << name << '\n';
  }
  out << "element edge " << std::to_string(edges.size())
      << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  const std::size_t columns = (std::max<std::size_t>)(3, variables.size());
  for_each_point(lines, [&](const std::vector<double>& p) {
    for (std::size_t k = 0; k < columns; ++k)
    {
      write_text(out, p[k]);
      out.put(k + 1 < columns ? ' ' : '\n');
    }
  });
  for (const auto& [a, b] : edges)
    out << std::to_string(a) << ' ' << std::to_string(b) << '\n';
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes curves in n-space to a file, as polylines in space.
 *
 * \details The extension of the name tells the format: `.vtp` (lines) and `.ply` (edges) keep the
 * variables from the fourth on as properties of the points, `.obj` (lines) has the points alone. In
 * PLY, a name that is taken gets underscores in front. Doubles read back to the same bits. The file
 * is written whole or not at all: a file that was there stays as it was when writing fails.
 *
 * \param file the name of the file
 * \param lines the polylines, for example `N_space_mesh::folds` or an `N_space_curve`
 * \param variables the names of the coordinates of their points; without any, only the projections
 * of the points are written
 * \param reason is set to one sentence that tells why nothing was written, or made empty
 * \return `true` if the file was written
 * \pre points have at least three coordinates, and one for each name
 */
inline bool write_polylines(const std::string& file, const std::vector<N_space_polyline>& lines,
                            const std::vector<std::string>& variables, std::string& reason)
{
  bool is_finite = true;
  internal::for_each_point(lines, [&](const std::vector<double>& p) {
    CGAL_precondition_msg(p.size() >= 3 && p.size() >= variables.size(),
                          "a point has three coordinates or more, and one for each variable");
    is_finite = is_finite &&
                std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
  });
  const std::string extension = internal::extension_of(file);
  if (extension != ".vtp" && extension != ".ply" && extension != ".obj")
    reason = "cannot write " + file + ": the extension must be .vtp, .ply or .obj, not " +
             (extension.empty() ? "missing" : extension);
  else if (!is_finite)
    reason = "cannot write " + file + ": a coordinate is not a finite number";
  else
    reason = internal::replace_file(file, [&](std::ostream& out) {
      if (extension == ".vtp")
        internal::write_lines_vtp(out, lines, variables);
      else if (extension == ".ply")
        internal::write_lines_ply(out, lines, variables);
      else
        internal::write_lines_obj(out, lines);
      return std::string();
    });
  return reason.empty();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_WRITE_POLYLINES_H
