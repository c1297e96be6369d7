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
 * A model is a representation of a surface that answers a query with the second-order data of the
 * surface there. It is a value type; all const calls are thread-safe, unless it holds numbers that are
 * not themselves (`CORE::Expr`: copies share a counter).
 *
 * What a query is, depends on the representation: a point of space, a pair of parameters, a point of
 * n-space. The answer must satisfy:
 * - the data are those of the surface at the query, with the sign and orientation of
 *   `Local_shape_3`, for one orientation that the model documents;
 * - in an exact number type they are exact; in an enclosure they contain the data at every point that
 *   the enclosed query contains and that is on the surface;
 * - where the surface has no second-order data, the answer is a refusal; an enclosure that cannot tell
 *   refuses with `Refusal_code::UNDECIDED`;
 * - where the query is certainly not on the surface, the answer is a refusal. No enclosure can prove
 *   that a query <em>is</em> on the surface: it answers under this supposition, for the points of the
 *   enclosed query that are. An exact number type decides, and floating point makes no claim;
 * - what the number type throws becomes a refusal, with one exception: `Conversion_error` leaves the
 *   call, as it tells a filter that a stage is of no use. It arises where the surface or the query
 *   has a number without an exact value, such as an infinite one.
 *
 * A model that holds no numbers answers in every number type, and its call operator is a template. A
 * model that holds numbers is a class template over their type `FT`, answers in that type, and has the
 * member `cast()`.
 *
 * A model may also have a member `level_set_shape()` with the same argument and result, which answers
 * for the level set through any point instead of refusing points off the surface. Filtered decisions
 * then use it.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Shape_interrogation::Implicit_surface_3}
 * \cgalHasModels{CGAL::Shape_interrogation::Parametric_surface_3}
 * \cgalHasModels{CGAL::Shape_interrogation::Bezier_surface_3}
 * \cgalHasModels{CGAL::Shape_interrogation::Nurbs_surface_3}
 * \cgalHasModels{CGAL::Shape_interrogation::N_space_surface_3}
 * \cgalHasModelsEnd
 */
class ShapeSource_3
{
public:
  //! the type of a query in the number type `NT`.
  template <class NT>
  using Query = unspecified_type;

  //! returns the second-order data at `query`, or the reason why there are none.
  template <class NT>
  CGAL::Shape_interrogation::Result<CGAL::Shape_interrogation::Local_shape_3<NT>>
  operator()(const Query<NT>& query) const;

  /// \name Models That Hold Numbers
  /// @{

  //! the number type of the data. It decides which numbers a filter may start from.
  typedef unspecified_type FT;

  //! returns the same surface in another number type, its numbers converted by `number_cast()`.
  template <class To>
  unspecified_type cast() const;

  /// @}
};
