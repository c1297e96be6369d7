// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_WRITE_SVG_H
#define CGAL_SHAPE_INTERROGATION_IO_WRITE_SVG_H

// Writes a picture of a divided parameter domain: regions, contour curves, unresolved places.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/IO/internal/Svg_picture.h>
#include <CGAL/Shape_interrogation/IO/internal/replace_file.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Trichotomy.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <locale>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief says how a picture of a parameter domain looks.
 */
struct Svg_options
{
  std::string title = {};                     //!< a line above the picture
  //! the names of the regions from 0, for the legend; without a name, its number stands there
  std::vector<std::string> region_names = {};
  double size = 480;                          //!< the side of the square in pixels
  //! the intervals of u and v that the unit square stands for, at the axes
  std::array<std::array<double, 2>, 2> parameters{{{0, 1}, {0, 1}}};
};

//! \ingroup PkgShapeInterrogationIO
//! \brief returns the names of the values of `Region`, for the legend of a trichotomy.
inline std::vector<std::string> trichotomy_names()
{
  std::vector<std::string> names;
  for (const Region region : {Region::CONVEX, Region::CONCAVE, Region::SADDLE, Region::FLAT})
    names.push_back(to_string(region));
  return names;
}

namespace internal {

// Colours by Okabe and Ito, which people with any colour vision tell apart; grey is the fourth.
inline std::string region_color(int region)
{
  constexpr const char* colors[] = {"#E69F00", "#56B4E9", "#009E73", "#DDDDDD",
                                    "#F0E442", "#0072B2", "#CC79A7"};
  return region < 0 ? "url(#unresolved)" : colors[region % 7];
}

inline std::string region_name(int region, const std::vector<std::string>& names)
{
  if (region < 0)
    return "unresolved";
  return static_cast<std::size_t>(region) < names.size() ? names[region]
                                                         : "region " + std::to_string(region);
}

inline void write_svg(std::ostream& out, const Divided_domain& domain, const Contour_2& contour,
                      const Svg_options& options)
{
  const std::set<int> regions(domain.regions.begin(), domain.regions.end());
  Svg_picture picture(out, options.size,
                      static_cast<int>(regions.size()) + !contour.unresolved.empty());
  if (!options.title.empty())
    picture.text(picture.x(0.5), 28, "middle", options.title, " font-size=\"18\"");
  std::map<int, std::vector<const std::vector<std::array<double, 2>>*>> loops; // of the parts
  std::map<int, int> region_of_part;
  for (const Region_loop& loop : domain.loops)
  {
    loops[loop.part].push_back(&loop.points);
    region_of_part[loop.part] = loop.region;
  }
  for (const auto& part : loops)
    picture.area(part.second, region_color(region_of_part[part.first]));
  picture.axes(options.parameters);
  for (const Contour_edge_2& e : contour.edges)
  {
    std::vector<std::array<double, 2>> ends(2);
    for (int k = 0; k < 2; ++k)
    {
      ends[k][e.axis] = e.end;
      ends[k][1 - e.axis] = k;
    }
    picture.line(ends, false, 4);
  }
  for (const Contour_curve_2& curve : contour.curves)
    picture.line(curve.points, curve.is_closed, 1.5);
  for (const auto& p : contour.isolated_points)
    picture.dot(p);
  for (const Unresolved_box_2& box : contour.unresolved)
    picture.mark(box.low, box.high);
  int line = 0;
  for (const int region : regions)
    picture.legend(line++, region_color(region), region_name(region, options.region_names));
  if (!contour.unresolved.empty())
    picture.mark_legend(line, "place where the curves are not resolved");
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationIO
 * \brief writes a picture of a divided parameter domain to a file in the format SVG.
 *
 * \details Regions are filled with colours that people with any colour vision can tell apart, and
 * named in a legend; triangles without a region are hatched. The curves of the contour are black,
 * thicker where an edge of the square belongs to it; isolated points are dots. Unresolved places,
 * however small, are marked by rectangles. The file does not depend on the locale, and is written
 * whole or not at all: a file that was there stays as it was when writing fails.
 *
 * \param file the name of the file, with the extension .svg
 * \param domain the divided domain
 * \param contour the contour that divides it
 * \param options title, names and size
 * \param reason is set to one sentence that tells why nothing was written, or made empty
 * \return `true` if the file was written
 * \pre `options.size` is positive
 */
inline bool write_svg(const std::string& file, const Divided_domain& domain,
                      const Contour_2& contour, const Svg_options& options, std::string& reason)
{
  CGAL_precondition_msg(options.size > 0, "the size of a picture must be positive");
  const std::string extension = internal::extension_of(file);
  if (extension != ".svg")
    reason = "cannot write " + file + ": the extension must be .svg, not " +
             (extension.empty() ? "missing" : extension);
  else
    reason = internal::replace_file(file, [&](std::ostream& out) {
      out.imbue(std::locale::classic());
      internal::write_svg(out, domain, contour, options);
      return std::string();
    });
  return reason.empty();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_WRITE_SVG_H
