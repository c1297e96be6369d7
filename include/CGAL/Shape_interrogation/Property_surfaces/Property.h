// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_H
#define CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_H

// The properties of a surface that are surfaces themselves (Elber and Cohen, section 3): their
// names and what some of them need besides the surface.

#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>

#include <optional>
#include <string>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief names a function of the parameters that tells something about a parametrised surface.
 *
 * \f$ E, F, G \f$ are the coefficients of the first fundamental form,
 * \f$ \hat n = S_u \times S_v \f$ is the unnormalised normal and
 * \f$ \hat l_{ij} = \hat n \cdot S_{ij} \f$ are the coefficients of the second form for it, *in the
 * sign of Elber and Cohen*, which is the opposite of the package's. \f$ \kappa_1, \kappa_2 \f$ are
 * the principal curvatures. No property but one needs a root, because a quantity whose sign depends
 * on the length of the normal is squared; `Property_surface_maker::sign()` has its sign.
 */
enum class Property
{
  NORMAL_Z,                 //!< \f$ \hat n_z \f$
  NORMAL_Z_SQUARED,         //!< \f$ \hat n_z^2 / |\hat n|^2 \f$
  SLOPE,                    //!< the squared tangent of the angle between normal and `up`
  SPEED,                    //!< \f$ E + G \f$, a bound of the squared speed of unit directions
  SPEED_SUPREMUM,           //!< the squared speed itself,
                            //!< \f$ \frac12 (E + G + \sqrt{(E - G)^2 + 4 F^2}) \f$
  TWIST_SQUARED,            //!< \f$ |S_{uv}|^2 \f$
  NORMAL_TWIST,             //!< \f$ \hat l_{12} \f$
  TANGENTIAL_TWIST_SQUARED, //!< the squared length of the tangential part of \f$ S_{uv} \f$
  SECOND_FORM_DETERMINANT,  //!< \f$ \hat l_{11} \hat l_{22} - \hat l_{12}^2 \f$, its sign is that
                            //!< of the Gaussian curvature
  GAUSSIAN,                 //!< \f$ \kappa_1 \kappa_2 \f$
  MEAN_SQUARED,             //!< \f$ (\kappa_1 + \kappa_2)^2 / 4 \f$
  CURVATURE_BOUND,          //!< \f$ \kappa_1^2 + \kappa_2^2 \f$
  UMBILIC,                  //!< \f$ (\kappa_1 - \kappa_2)^2 \f$
  SILHOUETTE,               //!< \f$ \hat n \cdot view \f$, or \f$ \hat n \cdot (S - eye) \f$
  ISOPHOTE,                 //!< \f$ \cos^2 - level^2 \f$ for the angle between normal and `light`;
                            //!< where `level` is not zero, the part of the zero set counts where
                            //!< `sign()` is that of `level`
  ASYMPTOTIC_DISCRIMINANT,  //!< \f$ \hat l_{12}^2 - \hat l_{11} \hat l_{22} \f$
  CURVATURE_U,              //!< the square of the normal curvature of the lines v = const
  CURVATURE_V               //!< the square of the normal curvature of the lines u = const
};

namespace internal {

inline const char* const property_names[] = {
  "normal_z", "normal_z_squared", "slope", "speed", "speed_supremum", "twist_squared",
  "normal_twist", "tangential_twist_squared", "second_form_determinant", "gaussian",
  "mean_squared", "curvature_bound", "umbilic", "silhouette", "isophote",
  "asymptotic_discriminant", "curvature_u", "curvature_v"};

// Whether the property is a square or a sum of squares.
inline bool is_square(Property property)
{
  switch (property)
  {
  case Property::NORMAL_Z:
  case Property::NORMAL_TWIST:
  case Property::SECOND_FORM_DETERMINANT:
  case Property::GAUSSIAN:
  case Property::SILHOUETTE:
  case Property::ISOPHOTE:
  case Property::ASYMPTOTIC_DISCRIMINANT:
    return false;
  default:
    return true;
  }
}

} // namespace internal

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief returns the name of `property` as it stands in model files, such as `"gaussian"`.
inline const char* to_string(Property property)
{
  return internal::property_names[static_cast<int>(property)];
}

//! \ingroup PkgShapeInterrogationPropertySurfaces
//! \brief returns the property of that name, or nothing if there is none.
inline std::optional<Property> property_of_name(const std::string& name)
{
  for (int i = 0; i <= static_cast<int>(Property::CURVATURE_V); ++i)
    if (name == internal::property_names[i])
      return static_cast<Property>(i);
  return std::nullopt;
}

/*!
 * \ingroup PkgShapeInterrogationPropertySurfaces
 * \brief holds what some properties need besides the surface. Directions have any length but zero.
 * \tparam NT a ring number type
 */
template <class NT>
struct Property_inputs
{
  using Vector = Coordinates<NT, 3>; //!< a direction or a point

  Vector up{NT(0), NT(0), NT(1)};    //!< the direction from which `SLOPE` is measured
  Vector view{NT(0), NT(0), NT(1)};  //!< the direction of view for `SILHOUETTE`
  std::optional<Vector> eye;         //!< the eye for `SILHOUETTE` in perspective, not `view`
  Vector light{NT(0), NT(0), NT(1)}; //!< the direction of light for `ISOPHOTE`
  NT level{0};                       //!< the cosine for `ISOPHOTE`
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_PROPERTY_SURFACES_PROPERTY_H
