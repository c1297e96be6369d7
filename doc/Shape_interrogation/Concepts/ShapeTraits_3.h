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
 * A model connects the package to the number type, points and vectors of a kernel, and says how
 * certain decisions are.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Shape_interrogation::Shape_traits_3}
 * \cgalHasModels{CGAL::Shape_interrogation::Filtered_shape_traits_3}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Shape_interrogation::Interrogation_3`
 */
class ShapeTraits_3
{
public:
  /// \name Types
  /// @{

  //! the number type of coordinates and values: a model of the \cgal concept `FieldNumberType`.
  typedef unspecified_type FT;

  //! the points of space, in which queries are given.
  typedef unspecified_type Point_3;

  //! the vectors of space, in which directions are given.
  typedef unspecified_type Vector_3;

  //! the type of a decided sign: `CGAL::Sign` or `CGAL::Uncertain<CGAL::Sign>`.
  typedef unspecified_type Sign;

  //! the type of a decided yes or no: `bool` or `CGAL::Uncertain<bool>`.
  typedef unspecified_type Boolean;

  //! `CGAL::Tag_true` if decisions are made by `Filtered`, from numbers of `FT` over enclosures to
  //! `Exact`; `CGAL::Tag_false` if they are made in `FT`.
  typedef unspecified_type Is_filtered;

  //! an exact field, to which `number_cast()` converts every number of `FT` exactly.
  typedef unspecified_type Exact;

  /// @}
  /// \name Operations
  /// @{

  //! returns the coordinates of a point.
  static CGAL::Shape_interrogation::Coordinates<FT, 3> coordinates(const Point_3& p);

  //! returns the coordinates of a vector.
  static CGAL::Shape_interrogation::Coordinates<FT, 3> coordinates(const Vector_3& v);

  /// @}
};
