// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROVE_BY_IDENTITIES_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROVE_BY_IDENTITIES_H

// Redundant equations that are proved to vanish at an enclosed point, by the identities of their
// constraint.

#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The coefficients of all identities over a box, one after the other; empty where they have no
// values.
inline std::vector<Interval_nt<false>>
identity_coefficients(const Constraint_system& system, const std::vector<Interval_nt<false>>& box)
{
  std::vector<Expression> coefficients;
  for (const Constraint& c : system.constraints())
    for (const Constraint::Identity& identity : c.identities())
      coefficients.insert(coefficients.end(), identity.begin(), identity.end());
  const Expression_tape tape(coefficients, system.number_of_variables(),
                             Expression_tape::Derivatives::NONE);
  try
  {
    Interval_nt<false>::Protector protector;
    return tape.evaluate(box);
  }
  catch (const Shape_error&) { return {}; }
}

// The only one of the equations that is not known to vanish, if its coefficient is certainly not
// zero; else -1. Equations with the coefficient zero do not count. Where a coefficient may have a
// pole, the identity tells nothing.
inline int proved_by(const Interval_nt<false>* coefficients, std::size_t size, int first_equation,
                     const std::vector<bool>& vanishes)
{
  int open = -1;
  for (std::size_t k = 0; k < size; ++k)
  {
    if (!CGAL::is_finite(coefficients[k]))
      return -1;
    if (vanishes[first_equation + k] || CGAL::certainly(is_zero_decision(coefficients[k])))
      continue;
    if (open >= 0 || CGAL::possibly(is_zero_decision(coefficients[k])))
      return -1;
    open = first_equation + static_cast<int>(k);
  }
  return open;
}

} // namespace internal
#endif

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief proves redundant equations at an enclosed point, where the identities of the constraints
 * do.
 *
 * \details Krawczyk's test proves that n - 2 equations vanish at the point; that the others do is
 * more than intervals can tell. An identity \f$ \sum c_k e_k \equiv 0 \f$ of a constraint
 * tells it: if all its equations but one are known to vanish and \f$ c_k \f$ of that one is
 * certainly not zero in the box, then it vanishes too. The three equations
 * \f$ u \times \nabla f = 0 \f$ of a projection are proved by two of them, for example, as
 * \f$ \nabla f \f$ is orthogonal to them.
 *
 * Identities are taken for true: `verify_identities()` verifies them, once for each system.
 * \param system the constraints
 * \param enclosure a result of `enclose_solution()` for `system.n_space_system()`
 * \return the enclosure, with the equations that are proved moved from `others_contain_zero` to
 * `others_proved`
 * \pre the enclosure has one interval for each variable
 *
 * Complexity: linear in the identities, which are compiled in each call, and are looked through
 * again as long as one of them proves something
 */
inline N_space_enclosure prove_by_identities(const Constraint_system& system,
                                             N_space_enclosure enclosure)
{
  CGAL_precondition_msg(int(enclosure.box.size()) == system.number_of_variables(),
                        "the enclosure is not one of this system");
  std::vector<bool> vanishes(system.number_of_equations(), true);
  for (int k : enclosure.others_contain_zero)
    vanishes[k] = false;
  const auto coefficients = internal::identity_coefficients(system, enclosure.box);
  for (bool proved = !coefficients.empty(); proved;)
  {
    proved = false;
    const Interval_nt<false>* next = coefficients.data();
    for (std::size_t c = 0; c < system.constraints().size(); ++c)
      for (const Constraint::Identity& identity : system.constraints()[c].identities())
      {
        const int k = internal::proved_by(next, identity.size(),
                                          system.first_equation(static_cast<int>(c)), vanishes);
        next += identity.size();
        if (k < 0)
          continue;
        vanishes[k] = proved = true;
        enclosure.others_proved.push_back(k);
      }
  }
  std::sort(enclosure.others_proved.begin(), enclosure.others_proved.end());
  std::vector<int>& open = enclosure.others_contain_zero;
  open.erase(std::remove_if(open.begin(), open.end(), [&](int k) { return vanishes[k]; }),
             open.end());
  return enclosure;
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_PROVE_BY_IDENTITIES_H
