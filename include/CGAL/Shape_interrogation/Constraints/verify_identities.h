// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VERIFY_IDENTITIES_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VERIFY_IDENTITIES_H

// The identities that redundant constraints bring along, verified by exact evaluation.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The left hand sides of all identities: zero for all values of the variables.
inline std::vector<Expression> identity_sums(const Constraint_system& system)
{
  std::vector<Expression> sums;
  for (const Constraint& c : system.constraints())
    for (const Constraint::Identity& identity : c.identities())
    {
      Expression sum;
      for (std::size_t k = 0; k < identity.size(); ++k)
        sum += identity[k] * c.equations()[k];
      sums.push_back(sum);
    }
  return sums;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief verifies the identities of all constraints of a system.
 *
 * \details They are evaluated exactly at one random point more than their degree (at most 65), with
 * coordinates from \f$ 2^{32} \f$ integers; nothing is expanded. A value that is not zero refutes
 * an identity. A wrong one of degree \f$ d \f$ vanishes at each point with a probability of at most
 * \f$ d / 2^{32} \f$ (Schwartz and Zippel), and so is hardly ever missed even by one point. The
 * sequence of points is always the same.
 *
 * \return true if all vanish at all points, false if one does not; uncertain if the equations have
 * functions without rational values, or no values at the points
 *
 * Complexity: the degree times the length of the equations, in exact numbers
 */
inline CGAL::Uncertain<bool> verify_identities(const Constraint_system& system)
{
  const std::vector<Expression> sums = internal::identity_sums(system);
  const Expression_tape tape(sums, system.number_of_variables(),
                             Expression_tape::Derivatives::NONE);
  std::uint32_t degree = 0;
  for (const Expression& sum : sums)
    degree = (std::max)(degree, sum.degree_bound());
  std::mt19937 random(1992);
  std::vector<CGAL::Exact_rational> point(system.number_of_variables());
  int points = 0, tries = 0;
  const int wanted = static_cast<int>((std::min)(degree, std::uint32_t(64))) + 1;
  while (points < wanted && tries < 2 * wanted)
  {
    ++tries;
    for (CGAL::Exact_rational& x : point)
      x = CGAL::Exact_rational(static_cast<double>(random()));
    try
    {
      for (const CGAL::Exact_rational& value : tape.evaluate(point))
        if (!CGAL::is_zero(value))
          return false;
      ++points;
    }
    catch (const Division_by_zero_error&) {} // another point
    catch (const Shape_error&) { return CGAL::Uncertain<bool>::indeterminate(); }
  }
  return points == wanted ? CGAL::Uncertain<bool>(true) : CGAL::Uncertain<bool>::indeterminate();
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_VERIFY_IDENTITIES_H
