// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_TRAITS_INTERROGATION_3_H
#define CGAL_SHAPE_INTERROGATION_TRAITS_INTERROGATION_3_H

// The front door: one surface and a traits class; questions by name at points of the kernel.

#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Number_types/Prepared.h>
#include <CGAL/Shape_interrogation/Traits/Shape_traits_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <tuple>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationTraits
 * \brief answers questions about one surface with the certainty that the traits class promises.
 *
 * With the default traits, input and values are `double` and every decision is certified, for the
 * data exactly as given: the chain from the input to the sign is filtered as a whole. With exact
 * traits values are exact as well. Queries are points of the kernel or coordinates for implicit
 * surfaces, two parameters for parametrised ones, and `n` coordinates for systems.
 *
 * A decision about an implicit surface is one about the level set through the query point (see
 * `Shape_chain`); `shape()` refuses points that are certainly off the surface.
 *
 * Const calls are thread-safe.
 *
 * \tparam Source a model of `ShapeSource_3`
 * \tparam Traits a model of `ShapeTraits_3`
 */
template <class Source, class Traits = Filtered_shape_traits_3<>>
class Interrogation_3
{
public:
  using FT = typename Traits::FT;                 //!< the number type
  using Point_3 = typename Traits::Point_3;       //!< the points of the kernel
  using Sign_result = Result<typename Traits::Sign>;       //!< a sign, or why there is none
  using Boolean_result = Result<typename Traits::Boolean>; //!< yes or no, or why neither

  //! constructs the interrogation of `source`; `statistics` counts the filter's stages and must
  //! outlive the object.
  explicit Interrogation_3(Source source, Filter_statistics* statistics = nullptr)
    : m_source(std::move(source)), m_prepared(prepare(m_source)),
      m_filters(Filter<Sign_of_gaussian_curvature>({}, statistics),
                Filter<Sign_of_mean_curvature>({}, statistics),
                Filter<Sign_of_normal_curvature>({}, statistics),
                Filter<Is_umbilic>({}, statistics), Filter<Is_planar>({}, statistics),
                Filter<Is_parabolic>({}, statistics))
  {}

  //! returns the surface.
  const Source& source() const { return m_source; }

  //! returns the second-order data in the number type of the traits.
  template <class Query>
  Result<Local_shape_3<FT>> shape(const Query& query) const { return m_source(coordinates(query)); }

  //! returns the sign of the Gaussian curvature.
  template <class Query>
  Sign_result sign_of_gaussian_curvature(const Query& query) const
  {
    return decide<Sign_of_gaussian_curvature>(query);
  }

  //! returns the sign of the mean curvature.
  template <class Query>
  Sign_result sign_of_mean_curvature(const Query& query) const
  {
    return decide<Sign_of_mean_curvature>(query);
  }

  //! returns the sign of the normal curvature in a direction. \pre the direction is tangent
  template <class Query>
  Sign_result sign_of_normal_curvature(const Query& query,
                                       const Coordinates<FT, 3>& direction) const
  {
    return decide<Sign_of_normal_curvature>(query, direction);
  }

  //! tells whether the point is umbilic.
  template <class Query>
  Boolean_result is_umbilic(const Query& query) const { return decide<Is_umbilic>(query); }

  //! tells whether the point is planar.
  template <class Query>
  Boolean_result is_planar(const Query& query) const { return decide<Is_planar>(query); }

  //! tells whether the point is parabolic.
  template <class Query>
  Boolean_result is_parabolic(const Query& query) const { return decide<Is_parabolic>(query); }

private:
  template <class Question>
  using Filter = Filtered<Shape_chain<Question>, typename Traits::Exact>;

  static Coordinates<FT, 3> coordinates(const Point_3& p) { return Traits::coordinates(p); }
  template <class Query>
  static const Query& coordinates(const Query& query) { return query; }

  template <class Question, class Query, class... Args>
  auto decide(const Query& query, const Args&... args) const
  {
    if constexpr (Traits::Is_filtered::value)
      return std::get<Filter<Question>>(m_filters)(m_prepared, coordinates(query), args...);
    else
      return Shape_chain<Question>()(m_source, coordinates(query), args...);
  }

  // Data in numbers are converted for the filter once; functions pass as they are.
  static auto prepare(const Source& source)
  {
    if constexpr (internal::Has_cast<Interval_nt<false>, Source>::value)
      return Prepared<Source>(source);
    else
      return source;
  }

  Source m_source;
  decltype(prepare(std::declval<const Source&>())) m_prepared;
  // One filter for each question: a filter remembers which of its stages are of use.
  std::tuple<Filter<Sign_of_gaussian_curvature>, Filter<Sign_of_mean_curvature>,
             Filter<Sign_of_normal_curvature>, Filter<Is_umbilic>, Filter<Is_planar>,
             Filter<Is_parabolic>> m_filters;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_TRAITS_INTERROGATION_3_H
