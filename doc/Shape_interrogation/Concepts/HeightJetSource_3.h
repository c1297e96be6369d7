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
 * A model is a surface that can be written, near a regular point, as the graph of a height function
 * over its tangent plane, to more than second order. Questions about the change of curvature need
 * this beside the waist: ridges, types of umbilics, continuity of higher order.
 *
 * For a surface `s`, a query `q` in the number type `NT` and an order `k` from 2 to 4, the call
 *
 *     height_jet<k>(s, q)
 *
 * returns a `Result` of `Height_jet_3<NT, k>`: the frame, and the Taylor polynomial of the height to
 * order `k`, exact if `NT` is. The second-order part is minus the form of `Local_shape_3` in that
 * frame: a sphere with outward normal has negative height. What the call operator refuses is refused.
 *
 * \cgalRefines{ShapeSource_3}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Shape_interrogation::Implicit_surface_3}
 * \cgalHasModels{CGAL::Shape_interrogation::Parametric_surface_3}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Shape_interrogation::height_jet()`
 */
class HeightJetSource_3
{};
