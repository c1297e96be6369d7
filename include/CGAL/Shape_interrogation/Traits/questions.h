// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_TRAITS_QUESTIONS_H
#define CGAL_SHAPE_INTERROGATION_TRAITS_QUESTIONS_H

// The questions of Analysis as function objects, and the chain from a source and a query to a
// decision, which is what a filter must wrap.

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/internal/Has_level_set.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks for the sign of the Gaussian curvature.
struct Sign_of_gaussian_curvature
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const { return sign_of_gaussian_curvature(s); }
};

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks for the sign of the mean curvature.
struct Sign_of_mean_curvature
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const { return sign_of_mean_curvature(s); }
};

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks for the sign of the normal curvature in a tangent direction.
struct Sign_of_normal_curvature
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s, const Coordinates<NT, 3>& direction) const
  {
    return sign_of_normal_curvature(s, direction);
  }
};

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks whether the point is umbilic.
struct Is_umbilic
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const { return is_umbilic(s); }
};

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks whether the point is planar.
struct Is_planar
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const { return is_planar(s); }
};

//! \ingroup PkgShapeInterrogationTraits
//! \brief asks whether the point is parabolic.
struct Is_parabolic
{
  //! answers.
  template <class NT>
  auto operator()(const Local_shape_3<NT>& s) const { return is_parabolic(s); }
};

namespace internal {

template <class Source, class Query, class = void>
struct Has_shape_at_origin : std::false_type {};
template <class Source, class Query>
struct Has_shape_at_origin<Source, Query,
                           std::void_t<decltype(std::declval<const Source&>().shape_at_origin(
                             std::declval<const Query&>()))>> : std::true_type {};

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationTraits
 * \brief is the whole way from a source and a query to a decision, in any number type.
 *
 * Where the source has level sets, the decision is about the level set through the query point, so
 * that it means something for a point that is only approximately on the surface; a point exactly on
 * the surface is on its own level set. Patches are evaluated without the division by the weight
 * that only the point needs (`Bezier_surface_3::shape_at_origin()`), other sources at the query.
 *
 * \tparam Question a function object that answers for a `Local_shape_3` (and further arguments)
 */
template <class Question>
struct Shape_chain
{
  //! returns the answer, or the refusal of the source.
  template <class Source, class Query, class... Args>
  auto operator()(const Source& source, const Query& query, const Args&... args) const
  {
    const auto shape = evaluate(source, query);
    using Answer = std::decay_t<decltype(Question()(*shape, args...))>;
    if (!shape)
      return Result<Answer>(shape.refusal());
    return Result<Answer>(Question()(*shape, args...));
  }

private:
  template <class Source, class Query>
  static auto evaluate(const Source& source, const Query& query)
  {
    if constexpr (internal::Has_level_set<Source, Query>::value)
      return source.level_set_shape(query);
    else if constexpr (internal::Has_shape_at_origin<Source, Query>::value)
      return source.shape_at_origin(query);
    else
      return source(query);
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_TRAITS_QUESTIONS_H
