// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_H

// A property of a patch as a function of its parameters, a quotient of Bernstein polynomials.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <optional>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief is a property of a patch as a function on the unit square: numerator and denominator, and
 * for `Property::SPEED_SUPREMUM` a radicand, \f$ (p + \sqrt{r}) / q \f$.
 *
 * The polynomials have the formal degrees of the formulas and are not reduced: numerator and
 * denominator can have common factors, on a collapsed edge powers of \f$ u, 1 - u, v, 1 - v \f$.
 *
 * \tparam NT a field number type
 */
template <class NT>
class Property_surface
{
public:
  using FT = NT;                                 //!< the number type
  using Polynomial = Bernstein_polynomial_2<NT>; //!< a polynomial on the unit square
  using Parameters = Coordinates<NT, 2>;         //!< a point of the unit square

  //! constructs the property 0.
  Property_surface() : m_denominator(1) {}

  //! constructs a property from what it is made of.
  Property_surface(Property property, Polynomial numerator, Polynomial denominator,
                   std::optional<Polynomial> radicand = std::nullopt)
    : m_property(property), m_numerator(std::move(numerator)),
      m_denominator(std::move(denominator)), m_radicand(std::move(radicand))
  {}

  Property property() const { return m_property; }                  //!< returns its name.
  const Polynomial& numerator() const { return m_numerator; }       //!< returns \f$ p \f$.
  const Polynomial& denominator() const { return m_denominator; }   //!< returns \f$ q \f$.
  //! returns \f$ r \f$, or nothing if the property is rational.
  const std::optional<Polynomial>& radicand() const { return m_radicand; }

  //! tells whether the property vanishes identically: a proof, if `NT` is exact.
  typename Number_type_traits<NT>::Boolean is_identically_zero() const
  {
    if (m_radicand)
      return m_numerator.is_zero() & m_radicand->is_zero();
    return m_numerator.is_zero();
  }

  //! tells whether the denominator has no negative value because of what it is, whatever the patch.
  bool has_nonnegative_denominator() const
  {
    return m_property != Property::NORMAL_Z && m_property != Property::SILHOUETTE;
  }

  /*!
   * \brief returns the value at a point of the unit square.
   *
   * Refused where the denominator vanishes (`IRREGULAR_PARAMETRISATION`: the surface is not
   * regular there, or, for `SLOPE`, vertical), or where that is undecided, and where a root is
   * needed (`NOT_ALGEBRAIC`); `enclosure()` answers there.
   */
  Result<NT> value(const Parameters& uv) const
  {
    const NT q = m_denominator(uv);
    if (auto refusal = refuse_denominator(q))
      return *refusal;
    if (m_radicand && !CGAL::certainly(is_zero_decision((*m_radicand)(uv))))
      return Refusal(Refusal_code::NOT_ALGEBRAIC,
                     std::string(to_string(m_property)) + " is a root there: it has an enclosure");
    NT x = m_numerator(uv) / q;
    return x;
  }

  //! returns an enclosure of the value at a point of the unit square, refused where the denominator
  //! vanishes. For an `NT` that is neither exact nor an enclosure it encloses what `NT` found.
  Result<CGAL::Interval_nt<true>> enclosure(const Parameters& uv) const
  {
    using Interval = CGAL::Interval_nt<true>;
    const NT q = m_denominator(uv);
    if (auto refusal = refuse_denominator(q))
      return *refusal;
    const Interval x = number_cast<Interval>(NT(m_numerator(uv) / q));
    if (!m_radicand)
      return x;
    const NT square = (*m_radicand)(uv) / (q * q); // q is positive where there is a radicand
    return Interval(x + CGAL::sqrt(internal::nonnegative_part(number_cast<Interval>(square))));
  }

private:
  static std::optional<Refusal> refuse_denominator(const NT& q)
  {
    return internal::refuse_zero(q, Refusal_code::IRREGULAR_PARAMETRISATION,
                                 "the denominator of the property");
  }

  Property m_property = Property::NORMAL_Z;
  Polynomial m_numerator, m_denominator;
  std::optional<Polynomial> m_radicand;
};

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief holds a property of one Bezier patch of a spline surface and the parameters that it
 * covers. The property itself is a function on the unit square.
 */
template <class NT>
struct Property_surface_piece
{
  Property_surface<NT> surface; //!< the property
  Coordinates<NT, 2> u;         //!< the interval of \f$ u \f$
  Coordinates<NT, 2> v;         //!< the interval of \f$ v \f$

  //! returns the value at parameters of the spline surface, on the rational function that continues
  //! the piece where they are outside of it. The refusals are those of `surface`.
  Result<NT> value(const Coordinates<NT, 2>& uv) const { return surface.value(on_square(uv)); }

  //! returns the point of the unit square that belongs to parameters of the spline surface.
  Coordinates<NT, 2> on_square(const Coordinates<NT, 2>& uv) const
  {
    return {NT((uv[0] - u[0]) / (u[1] - u[0])), NT((uv[1] - v[0]) / (v[1] - v[0]))};
  }

  //! returns the parameters of the spline surface that belong to a point of the unit square.
  Coordinates<NT, 2> on_surface(const Coordinates<NT, 2>& st) const
  {
    return {NT(u[0] + st[0] * (u[1] - u[0])), NT(v[0] + st[1] * (v[1] - v[0]))};
  }
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_H
