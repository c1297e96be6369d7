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
#include <type_traits>
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
 * <b>Queries off the surface.</b> A decision about an implicit surface is one about the level set
 * through the query point (see `Shape_chain`); `shape()` refuses points that are certainly off the
 * surface. A decision about a system supposes that the query solves it, redundant equations
 * included: a filter refuses only queries that certainly do not, as no enclosure proves a zero.
 * Where this is open, ask `shape()` with exact traits once.
 *
 * Numbers that are not finite, in the query or the surface, are refused (`LIMIT_EXCEEDED`) wherever
 * a decision needs their exact values.
 *
 * Const calls are thread-safe if those of the source are. Not so with numbers of type `CORE::Expr`,
 * whose copies share a counter: there each thread needs a surface and queries of its own. An
 * interrogation can be copied, but not assigned to.
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
    : m_data(std::move(source)), m_filters(statistics)
  {}

  //! returns the surface.
  const Source& source() const
  {
    if constexpr (is_prepared)
      return m_data.data();
    else
      return m_data;
  }

  //! returns the second-order data in the number type of the traits.
  template <class Query>
  Result<Local_shape_3<FT>> shape(const Query& query) const
  {
    return refuse_conversions([&] { return source()(coordinates(query)); });
  }

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

  //! returns the sign of the normal curvature in a direction, which is a vector of the kernel or
  //! given by three coordinates. One that is not exactly tangent stands for its orthogonal
  //! projection on the tangent plane. \pre the direction is not zero
  template <class Query, class Direction = Coordinates<FT, 3>>
  Sign_result sign_of_normal_curvature(const Query& query, const Direction& direction) const
  {
    return decide<Sign_of_normal_curvature>(query, coordinates(direction));
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

  static constexpr bool is_filtered = Traits::Is_filtered::value;
  // Data in numbers are converted for the filter once; functions pass as they are.
  static constexpr bool is_prepared =
    is_filtered && internal::Has_cast<Interval_nt<false>, Source>::value;

  // One filter for each question: a filter remembers which of its stages are of use.
  template <class... Question>
  struct Filters_for : std::tuple<Filter<Question>...>
  {
    explicit Filters_for(Filter_statistics* statistics)
      : std::tuple<Filter<Question>...>(Filter<Question>({}, statistics)...)
    {}
  };
  struct No_filters
  {
    explicit No_filters(Filter_statistics*) {}
  };

  static Coordinates<FT, 3> coordinates(const Point_3& p) { return Traits::coordinates(p); }
  static Coordinates<FT, 3> coordinates(const typename Traits::Vector_3& v)
  {
    return Traits::coordinates(v);
  }
  template <class Query>
  static const Query& coordinates(const Query& query) { return query; }

  template <class Question, class Query, class... Args>
  auto decide(const Query& query, const Args&... args) const
  {
    if constexpr (is_filtered)
      return refuse_conversions([&] {
        return std::get<Filter<Question>>(m_filters)(m_data, coordinates(query), args...);
      });
    else
      return refuse_conversions(
        [&] { return Shape_chain<Question>()(m_data, coordinates(query), args...); });
  }

  // What no number of an exact type stands for.
  template <class Evaluation>
  static auto refuse_conversions(Evaluation evaluation) -> decltype(evaluation())
  {
    try
    {
      return evaluation();
    }
    catch (const Conversion_error& e) { return Refusal(Refusal_code::LIMIT_EXCEEDED, e.what()); }
  }

  std::conditional_t<is_prepared, Prepared<Source>, Source> m_data;
  std::conditional_t<is_filtered,
                     Filters_for<Sign_of_gaussian_curvature, Sign_of_mean_curvature,
                                 Sign_of_normal_curvature, Is_umbilic, Is_planar, Is_parabolic>,
                     No_filters> m_filters;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_TRAITS_INTERROGATION_3_H
