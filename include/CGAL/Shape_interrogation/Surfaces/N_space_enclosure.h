// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_ENCLOSURE_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_ENCLOSURE_H

// Points of a surface in n-space that are proved to exist, by Krawczyk's test on an independent
// subset of the equations with two coordinates held fixed.

#include <CGAL/Shape_interrogation/Surfaces/N_space_corrector.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Krawczyk_operator.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/free_coordinates.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief is a box in n-space with the proof of what it contains.
 *
 * For the fixed coordinates at their values there is exactly one point in the box at which all of
 * `equations` vanish. The other equations are enclosed there by intervals that contain zero; that
 * they vanish is an assumption, which intervals cannot prove. Where the equations come from
 * constraints, `prove_by_identities()` does.
 */
struct N_space_enclosure
{
  std::vector<Interval_nt<false>> box;  //!< one interval for each variable
  std::array<int, 2> fixed{};           //!< the indices of the coordinates that are held fixed
  std::array<CGAL::Exact_rational, 2> values; //!< their values
  std::vector<int> equations;           //!< the indices of the `n - 2` equations of the proof
  //! the indices of the other equations that are proved to vanish at the point
  std::vector<int> others_proved;
  //! the indices of those of which only is known that their enclosures contain zero
  std::vector<int> others_contain_zero;
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief says which two coordinates a proof shall hold fixed, and at which values.
 */
struct Fixed_coordinates
{
  std::array<int, 2> indices{};               //!< two different variables
  std::array<CGAL::Exact_rational, 2> values; //!< their values
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief proves a point of the solution of a system near an approximate one.
 *
 * The point is corrected in floating point. Without `fixed`, the two coordinates that turn least
 * out of the tangent plane are then held at the values that they have. A subset of n - 2 equations
 * that is independent there and Krawczyk's test on it prove exactly one common zero in a box, which
 * is made as small as the test can in double precision.
 *
 * Refused with the codes of `N_space_corrector`; with `RANK_DEFICIENT` where the equations do not
 * determine the other coordinates; with `NOT_ON_SOLUTION` where one of the other equations
 * certainly does not vanish; and with `UNDECIDED` where no box passes the test. Sets the rounding
 * mode for the call. Thread-safe.
 * \param system the system
 * \param start an approximate point of its solution
 * \param fixed the coordinates to hold fixed, and their exact values
 * \pre the fixed indices are different variables
 *
 * Source: Krawczyk's operator as in Neumaier, "Interval methods for systems of equations".
 * Complexity: cubic in the number of variables for the inverse of a matrix of doubles, besides the
 * product of that inverse with the sparse Jacobian in interval arithmetic, a few times.
 */
inline Result<N_space_enclosure>
enclose_solution(const N_space_system& system, const std::vector<double>& start,
                 const std::optional<Fixed_coordinates>& fixed = std::nullopt)
{
  const int n = system.number_of_variables();
  N_space_corrector correct(system);
  std::vector<N_space_condition> conditions;
  if (fixed)
    for (int i = 0; i < 2; ++i)
    {
      CGAL_precondition_msg(0 <= fixed->indices[i] && fixed->indices[i] < n &&
                              fixed->indices[0] != fixed->indices[1],
                            "two different variables must be fixed");
      conditions.push_back(N_space_condition::fixed(n, fixed->indices[i],
                                                    number_cast<double>(fixed->values[i])));
    }
  const Result<N_space_point> p = correct(start, conditions);
  if (!p)
    return p.refusal();
  N_space_enclosure e;
  if (fixed)
  {
    e.fixed = fixed->indices;
    e.values = fixed->values;
  }
  else
  {
    e.fixed = internal::free_coordinates(correct.tangent_basis());
    for (int i = 0; i < 2; ++i)
      e.values[i] = number_cast<CGAL::Exact_rational>(p->point[e.fixed[i]]);
  }
  return internal::refuse_errors<N_space_enclosure>([&]() -> Result<N_space_enclosure> {
    internal::Krawczyk_operator krawczyk(system, e.fixed);
    std::vector<double> near = p->point;
    for (int i = 0; i < 2; ++i)
      near[e.fixed[i]] = number_cast<double>(e.values[i]);
    if (auto refusal = krawczyk.linearise(near))
      return *refusal;
    krawczyk.polish(near);
    Interval_nt<false>::Protector protector;
    std::array<Interval_nt<false>, 2> values;
    for (int i = 0; i < 2; ++i)
      values[i] = number_cast<Interval_nt<false>>(e.values[i]);
    if (auto refusal = krawczyk.enclose(near, values, e.box))
      return *refusal;
    e.equations = krawczyk.equations();
    for (int k = 0; k < system.number_of_equations(); ++k)
      if (!std::binary_search(e.equations.begin(), e.equations.end(), k))
        e.others_contain_zero.push_back(k);
    return e;
  });
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_ENCLOSURE_H
