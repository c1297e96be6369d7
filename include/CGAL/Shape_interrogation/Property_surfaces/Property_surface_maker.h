// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_MAKER_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_MAKER_H

// Property surfaces of Bezier patches and of spline surfaces, and properties at a point from the
// partial derivatives.

#include <CGAL/Shape_interrogation/Bernstein/internal/Scaled_polynomial.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface.h>
#include <CGAL/Shape_interrogation/Property_surfaces/internal/property_formulas.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief computes the properties of one patch symbolically, as functions of its parameters.
 *
 * What several properties have in common, such as the normal and the forms, is computed once. Over
 * rationals all formulas run in the integers.
 *
 * For a polynomial patch of bidegree (m, n), \f$ m, n \ge 2 \f$, the numerators have the degrees
 * (2m-1, 2n-1) for `NORMAL_Z`, (2m, 2n) for `SPEED`, (6m-4, 6n-4) for `SECOND_FORM_DETERMINANT` and
 * (10m-6, 10n-6) for `MEAN_SQUARED`, with a denominator of degree (12m-6, 12n-6) for the last one.
 *
 * \tparam NT a field number type; enclosures allowed
 *
 * Source: Elber and Cohen, section 3, for rational patches with weights of any sign as well.
 * Complexity: a fixed number of products of polynomials for each property.
 */
template <class NT>
class Property_surface_maker
{
  using R = internal::Polynomial_ring<NT, 2>;
  using Vector = Coordinates<R, 3>;

public:
  using FT = NT;                                 //!< the number type
  using Polynomial = Bernstein_polynomial_2<NT>; //!< a polynomial on the unit square

  //! prepares the properties of a patch with its parameters in the unit square.
  explicit Property_surface_maker(const Bezier_surface_3<NT>& patch)
    : Property_surface_maker({patch, {NT(0), NT(1)}, {NT(0), NT(1)}})
  {}

  //! prepares the properties of a patch with its parameters in the given intervals: derivatives are
  //! those by the parameters of the piece, although polynomials are on the unit square.
  explicit Property_surface_maker(const Surface_piece_3<NT>& piece) : m_forms(forms(piece)) {}

  //! returns a property of the patch.
  Property_surface<NT> operator()(Property property, const Property_inputs<NT>& inputs = {})
  {
    const internal::Property_terms<R> t = internal::property_terms(m_forms, property, inputs);
    std::optional<Polynomial> radicand;
    if (t.radicand)
      radicand = internal::result_polynomial(*t.radicand);
    return {property, internal::result_polynomial(t.numerator),
            internal::result_polynomial(t.denominator), std::move(radicand)};
  }

  /*!
   * \brief returns a polynomial with the sign of the property or, for a property that is the square
   * of a quantity with a sign, the sign of that quantity: for `MEAN_SQUARED` that of the mean
   * curvature, for `CURVATURE_U` that of the normal curvature, in the sign of the package, for
   * `SLOPE`, `NORMAL_Z_SQUARED` and `ISOPHOTE` that of the product of normal and direction.
   *
   * It is a polynomial of the lowest degree that the formulas give, for rational patches too.
   */
  Polynomial sign(Property property, const Property_inputs<NT>& inputs = {})
  {
    return internal::result_polynomial(internal::property_sign(m_forms, property, inputs));
  }

  //! returns \f$ W^6 |S_u \times S_v|^2 \f$, which vanishes where the patch is not regular, and at
  //! some poles.
  Polynomial normal_squared() { return internal::result_polynomial(m_forms.normal_squared()); }

  //! returns \f$ W \f$, the constant 1 if the patch has no weights.
  Polynomial weight() { return internal::result_polynomial(m_forms.times_weight(R(1), 1)); }

  //! returns the components of \f$ W^3 S_u \times S_v \f$.
  std::array<Polynomial, 3> normal()
  {
    const Vector& n = m_forms.normal();
    return {internal::result_polynomial(n[0]), internal::result_polynomial(n[1]),
            internal::result_polynomial(n[2])};
  }

private:
  static internal::Surface_forms<R> forms(const Surface_piece_3<NT>& piece)
  {
    const Bezier_surface_3<NT>& patch = piece.patch;
    std::array<std::vector<NT>, 4> coordinates;
    for (int i = 0; i <= patch.degree_u(); ++i)
      for (int j = 0; j <= patch.degree_v(); ++j)
      {
        const Coordinates<NT, 4> p = patch.homogeneous_control_point(i, j);
        for (int k = 0; k < (patch.is_rational() ? 4 : 3); ++k)
          coordinates[k].push_back(p[k]);
      }
    if (!patch.is_rational())
      coordinates[3].assign(coordinates[0].size(), NT(0)); // not used
    const std::array<R, 4> x = internal::polynomials_in_ring<NT, 4, 2>(
      {patch.degree_u(), patch.degree_v()}, coordinates);
    const auto jets = [&](int k) { return jet(x[k], piece); };
    const std::array<internal::Second_jet<R>, 3> a{jets(0), jets(1), jets(2)};
    std::optional<internal::Second_jet<R>> w;
    if (patch.is_rational())
      w = jets(3);
    const auto all = [&](R internal::Second_jet<R>::*part) {
      return Vector{a[0].*part, a[1].*part, a[2].*part};
    };
    using Jet = internal::Second_jet<R>;
    return internal::Surface_forms<R>({all(&Jet::x), all(&Jet::u), all(&Jet::v), all(&Jet::uu),
                                       all(&Jet::uv), all(&Jet::vv)},
                                      std::move(w));
  }

  // The derivatives by the parameters of the piece.
  static internal::Second_jet<R> jet(const R& x, const Surface_piece_3<NT>& piece)
  {
    const R u = derivative(x, 0, piece.u), v = derivative(x, 1, piece.v);
    return {x, u, v, derivative(u, 0, piece.u), derivative(u, 1, piece.v),
            derivative(v, 1, piece.v)};
  }

  static R derivative(const R& x, int axis, const Coordinates<NT, 2>& interval)
  {
    const NT length = interval[1] - interval[0];
    if (CGAL::certainly(is_zero_decision(NT(length - NT(1)))))
      return x.derivative(axis);
    R scaled = x.derivative(axis) * R(NT(NT(1) / length));
    return scaled;
  }

  internal::Surface_forms<R> m_forms;
};

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns one property of a patch as a function on the unit square, see
 * `Property_surface_maker`, which is the better way to several properties.
 */
template <class NT>
Property_surface<NT> property_surface(const Bezier_surface_3<NT>& patch, Property property,
                                      const Property_inputs<NT>& inputs = {})
{
  return Property_surface_maker<NT>(patch)(property, inputs);
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns one property of a spline surface: one piece for each pair of knot spans, in the
 * order of `Nurbs_surface_3::bezier_patches()`. Derivatives are by the parameters of the spline.
 */
template <class NT>
std::vector<Property_surface_piece<NT>> property_surface(const Nurbs_surface_3<NT>& surface,
                                                         Property property,
                                                         const Property_inputs<NT>& inputs = {})
{
  std::vector<Property_surface_piece<NT>> pieces;
  for (const Surface_piece_3<NT>& piece : surface.bezier_patches())
    pieces.push_back({Property_surface_maker<NT>(piece)(property, inputs), piece.u, piece.v});
  return pieces;
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns a property of any parametrised surface at a point with the given derivatives, as a
 * constant function: with its numerator, its denominator, and the radicand if it has one.
 */
template <class NT>
Property_surface<NT> property_at(const Surface_derivatives_3<NT>& d, Property property,
                                 const Property_inputs<NT>& inputs = {})
{
  internal::Surface_forms<NT> forms({d.s, d.u, d.v, d.uu, d.uv, d.vv});
  const internal::Property_terms<NT> t = internal::property_terms(forms, property, inputs);
  std::optional<Bernstein_polynomial_2<NT>> radicand;
  if (t.radicand)
    radicand = *t.radicand;
  return Property_surface<NT>(property, t.numerator, t.denominator, std::move(radicand));
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief returns the value of a property of any parametrised surface at a point with the given
 * derivatives. The refusals are those of `Property_surface::value()`.
 */
template <class NT>
Result<NT> property_value(const Surface_derivatives_3<NT>& d, Property property,
                          const Property_inputs<NT>& inputs = {})
{
  return property_at(d, property, inputs).value({NT(0), NT(0)});
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_SURFACE_MAKER_H
