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
 * A model is a map from two numbers to three that works in every number type. What
 * `ImplicitFunction_3` requires of the computation is required here as well.
 *
 * A map of one number to two, which is what `Parametric_curve_2` takes, has the same requirements.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Shape_interrogation::Expression_function<2\,3>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Shape_interrogation::Parametric_surface_3`
 */
class ParametricMap_3
{
public:
  //! returns the three coordinates of the point with the parameters `u` and `v`.
  template <class NT>
  std::array<NT, 3> operator()(const NT& u, const NT& v) const;
};
