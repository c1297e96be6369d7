// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_H

// What is known of the convex, concave and saddle parts of a patch.

#include <CGAL/Shape_interrogation/Bernstein/decide_nonnegative.h>
#include <CGAL/Shape_interrogation/Contours/Contour_2.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief names the kinds of places of a surface, for its own normal.
 */
enum class Region
{
  CONVEX,  //!< both principal curvatures are positive, or one is and the surface is developable
  CONCAVE, //!< both are negative, or one is and the surface is developable
  SADDLE,  //!< they have different signs
  FLAT     //!< both vanish
};

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief returns the name of `region` as it stands in reports, `"convex"` and so on.
inline const char* to_string(Region region)
{
  constexpr const char* names[] = {"convex", "concave", "saddle", "flat"};
  return names[static_cast<int>(region)];
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief is a certified interval of an area in the parameter domain.
 */
struct Area_range
{
  Exact_rational lower = 0; //!< a lower bound
  Exact_rational upper = 0; //!< an upper bound
};

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief holds where a patch is not regular, that is \f$ S_u \times S_v = 0 \f$ or there is a pole.
 */
struct Regularity
{
  Verdict verdict = Verdict::UNDECIDED;     //!< whether the patch is regular everywhere
  std::vector<Contour_edge_2> edges;        //!< edges on which it is not, such as collapsed ones
  std::vector<std::array<double, 2>> points; //!< further points at which it is not, exactly
  std::vector<Unresolved_box_2> boxes;      //!< small boxes in which it perhaps is not
  Contour_2 poles;                          //!< where the common weight vanishes
};

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief is the division of a patch into convex, concave, saddle and flat parts.
 */
struct Trichotomy
{
  //! whether the Gaussian curvature vanishes identically: a proof
  bool is_developable = false;
  //! the boundary between the parts: where the Gaussian curvature vanishes or, on developable
  //! surfaces, the mean curvature
  Contour_2 boundary;
  std::array<Area_range, 4> areas; //!< the areas, indexed by `Region`
  Regularity regularity;           //!< where the patch is regular

  //! returns the area of a region.
  const Area_range& area(Region region) const { return areas[static_cast<int>(region)]; }
};

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief holds how well areas must be known, and what may be spent on it.
 */
struct Trichotomy_options
{
  Contour_options contour;       //!< for the boundary
  double open_area = 1e-3;       //!< the area that may remain without a class, of the unit square
  std::size_t max_cells = 20000; //!< the number of cells that are cut for it at most
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_TRICHOTOMY_H
