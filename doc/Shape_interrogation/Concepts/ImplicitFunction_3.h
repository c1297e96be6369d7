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
 * A model is a function of three numbers that works in every number type, so that it can be
 * evaluated in floating point, in enclosures and exactly, differentiated by evaluating it over jets,
 * and recorded as an expression.
 *
 * The call operator is a template, or the model is a generic lambda. It must
 * - use only `+ - * /`, integers, and functions found by argument-dependent lookup such as
 *   `square()`, `pow()` with an integer exponent, `sqrt()`, `exp()`, `log()` and the trigonometric
 *   functions, of which exact number types have few or none;
 * - not branch on the values of its arguments: a branch on an enclosure is undecided, and one in a
 *   recorded function is taken once and for all;
 * - not convert its arguments to `double`, and write constants so that they are exact: `NT(1) / 3`,
 *   not `NT(1.0 / 3)`, and an integer `n` that may exceed \f$ 2^{53} \f$ as `NT(n)`, since an
 *   enclosure times a built-in number takes that as a `double`.
 *
 * A function of two numbers that returns one, which is what `Implicit_curve_2` takes, has the same
 * requirements.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Shape_interrogation::Expression_function<3>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Shape_interrogation::Implicit_surface_3`
 */
class ImplicitFunction_3
{
public:
  //! returns the value of the function.
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const;
};
