// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

/*!
 * \ingroup PkgShapeInterrogationConcepts
 * \cgalConcept
 *
 * A model gives access to a surface as a set of points, which tracing, meshing and searches need
 * beside the waist. A representation offers what it can, and a question states what it needs of the
 * following:
 *
 * | expression | meaning |
 * | ---------- | ------- |
 * | `enclose_shape(s, box)` | encloses the second-order data over a box of queries: of all points of a box of parameters, of all level sets through a box of space |
 * | `project_to_surface(s, p)` | moves a point onto the surface, with the residual; nothing is proved |
 * | `s.domain()` | returns the parameter domain |
 *
 * The enclosure must hold for every query in the box, so that a decision on it is one for the whole
 * box, or undecided.
 *
 * \cgalRefines{ShapeSource_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModelsBare{`CGAL::Shape_interrogation::Implicit_surface_3` (no domain)}
 * \cgalHasModelsBare{`CGAL::Shape_interrogation::Parametric_surface_3` (enclosure only)}
 * \cgalHasModelsBare{`CGAL::Shape_interrogation::Bezier_surface_3` and
 * `CGAL::Shape_interrogation::Nurbs_surface_3` (enclosure and domain)}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Shape_interrogation::enclose_shape()`
 * \sa `CGAL::Shape_interrogation::project_to_surface()`
 */
class SurfaceAccess_3
{};
