// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_TRAITS_SHAPE_TRAITS_3_H
#define CGAL_SHAPE_INTERROGATION_TRAITS_SHAPE_TRAITS_3_H

// Traits classes: where a CGAL kernel's points, vectors and number type meet the waist.

#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationTraits
 * \brief connects the package to any \cgal kernel with Cartesian coordinates.
 *
 * Decisions are as certain as the number type of the kernel: exact for exact ones, `Uncertain` for
 * enclosures, and without claim for `double`. For certified decisions on `double` input see
 * `Filtered_shape_traits_3`.
 *
 * \tparam Kernel_ a \cgal kernel
 * \cgalModels{ShapeTraits_3}
 */
template <class Kernel_>
struct Shape_traits_3
{
  using Kernel = Kernel_;                                //!< the kernel
  using FT = typename Kernel::FT;                        //!< the number type
  using Point_3 = typename Kernel::Point_3;              //!< the points
  using Vector_3 = typename Kernel::Vector_3;            //!< the vectors
  using Sign = typename Number_type_traits<FT>::Sign;       //!< the type of a sign
  using Boolean = typename Number_type_traits<FT>::Boolean; //!< the type of a yes or no
  using Exact = CGAL::Exact_rational;                    //!< the exact companion

  //! whether decisions are made by a filter instead of in `FT` itself
  using Is_filtered = Tag_false;

  //! returns the coordinates of a point.
  static Coordinates<FT, 3> coordinates(const Point_3& p) { return {p.x(), p.y(), p.z()}; }
  //! returns the coordinates of a vector.
  static Coordinates<FT, 3> coordinates(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }
  //! returns the point with the given coordinates. (For callers: the concept does not ask for it.)
  static Point_3 point(const Coordinates<FT, 3>& c) { return Point_3(c[0], c[1], c[2]); }
  //! returns the vector with the given coordinates. (For callers, too.)
  static Vector_3 vector(const Coordinates<FT, 3>& c) { return Vector_3(c[0], c[1], c[2]); }
};

/*!
 * \ingroup PkgShapeInterrogationTraits
 * \brief has `double` in and out, and every decision certified: the traits class to meet first.
 *
 * \tparam Kernel_ a \cgal kernel over `double`
 * \tparam ExactNT the exact field used where floating point and intervals do not decide
 * \cgalModels{ShapeTraits_3}
 */
template <class Kernel_ = Exact_predicates_inexact_constructions_kernel,
          class ExactNT = CGAL::Exact_rational>
struct Filtered_shape_traits_3 : Shape_traits_3<Kernel_>
{
  static_assert(std::is_same_v<typename Kernel_::FT, double>,
                "the filtered traits need a kernel over double");
  using Sign = CGAL::Sign;     //!< decisions are certain
  using Boolean = bool;        //!< decisions are certain
  using Exact = ExactNT;       //!< the exact companion
  using Is_filtered = Tag_true; //!< decisions are made by a filter
};

//! \ingroup PkgShapeInterrogationTraits
//! Floating point without claims.
using Approximate_shape_traits_3 = Shape_traits_3<Simple_cartesian<double>>;

//! \ingroup PkgShapeInterrogationTraits
//! Enclosures; the caller holds an `Interval_nt<false>::Protector`.
using Interval_shape_traits_3 = Shape_traits_3<Simple_cartesian<Interval_nt<false>>>;

//! \ingroup PkgShapeInterrogationTraits
//! Exact rationals.
using Exact_shape_traits_3 = Shape_traits_3<Simple_cartesian<CGAL::Exact_rational>>;

//! \ingroup PkgShapeInterrogationTraits
//! Exact numbers with one square root.
using Quadratic_shape_traits_3 = Shape_traits_3<Simple_cartesian<Quadratic_field>>;

//! \ingroup PkgShapeInterrogationTraits
//! Exact reals with all square roots. Not thread-safe: copies of a `CORE::Expr` share a counter,
//! even in const calls.
using Exact_real_shape_traits_3 = Shape_traits_3<Simple_cartesian<CORE::Expr>>;

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_TRAITS_SHAPE_TRAITS_3_H
