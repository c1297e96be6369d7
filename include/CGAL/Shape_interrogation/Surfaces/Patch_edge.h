// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_PATCH_EDGE_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_PATCH_EDGE_H

// The four edges of a patch and their names.

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief names an edge of the rectangular parameter domain of a patch.
 */
enum class Patch_edge
{
  U0, //!< \f$ u \f$ is least
  U1, //!< \f$ u \f$ is greatest
  V0, //!< \f$ v \f$ is least
  V1  //!< \f$ v \f$ is greatest
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief returns the name of `edge` as it stands in reports, for example `"u0"`.
 */
inline const char* to_string(Patch_edge edge)
{
  static const char* const names[] = {"u0", "u1", "v0", "v1"};
  return names[static_cast<int>(edge)];
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_PATCH_EDGE_H
