// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ERRORS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ERRORS_H

// The exceptions of the package: what a number type cannot do, and limits that protect the caller.
// Geometry that has no answer is not an exception but a `Refusal` (Refusal.h).

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is the base of all exceptions thrown by this package.
 */
struct Shape_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when a function value does not exist in the number type it is asked in, for
 * example \f$ e^x \f$ in the rationals.
 */
struct Not_algebraic_error : Shape_error
{
  using Shape_error::Shape_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when an expression divides by something that is certainly zero.
 */
struct Division_by_zero_error : Shape_error
{
  using Shape_error::Shape_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when an argument is outside the domain of a function, for example the logarithm
 * of a number that is certainly not positive.
 */
struct Domain_error : Shape_error
{
  using Shape_error::Shape_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when an input exceeds a documented limit (size, nesting depth, exponent).
 */
struct Limit_error : Shape_error
{
  using Shape_error::Shape_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when numbers of two different quadratic fields meet in one operation.
 */
struct Mixed_roots_error : Shape_error
{
  using Shape_error::Shape_error;
};

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is thrown when a number has no exact image in the target number type, for example 1/3 in
 * a ring of dyadic numbers.
 */
struct Conversion_error : Shape_error
{
  using Shape_error::Shape_error;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_ERRORS_H
