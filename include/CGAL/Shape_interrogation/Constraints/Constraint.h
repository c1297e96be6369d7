// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_H
#define CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_H

// One geometric statement: what it says in words, the equations that it stands for, how many of
// them are independent, and the identities by which the others follow.

#include <CGAL/Shape_interrogation/Differentiation/Expression.h>

#include <CGAL/assertions.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief is a geometric statement about points and numbers, as equations.
 *
 * The sentence has a subject and a predicate, "p1" and "the projection of p0 onto f". A redundant
 * constraint has more equations than its rank, on purpose: no special position makes all of those
 * useless that are independent elsewhere. Then there are identities between the equations, which
 * hold for all values of the variables: coefficients \f$ c_k \f$ with
 * \f$ \sum_k c_k e_k \equiv 0 \f$ for the equations \f$ e_k = 0 \f$. Where the others vanish, they
 * prove that an equation vanishes whose coefficient is not zero. `verify_identities()` checks them.
 *
 * Source: Chuang and Hoffmann, section 2.
 */
class Constraint
{
public:
  using Identity = std::vector<Expression>; //!< the coefficients of the equations, in their order

  //! constructs a constraint whose equations are independent in general.
  Constraint(std::string subject, std::string predicate, std::vector<Expression> equations)
    : Constraint(std::move(subject), std::move(predicate), std::move(equations), 0, {})
  {
    m_rank = static_cast<int>(m_equations.size());
  }

  /*!
   * \brief constructs a redundant constraint.
   * \param subject what the sentence is about
   * \param predicate what it is said to be
   * \param equations the left hand sides
   * \param rank the number of them that are independent where the constraint holds, in general
   * \param identities the identities between them; each has one coefficient for each equation
   */
  Constraint(std::string subject, std::string predicate, std::vector<Expression> equations,
             int rank, std::vector<Identity> identities)
    : m_subject(std::move(subject)), m_predicate(std::move(predicate)),
      m_equations(std::move(equations)), m_rank(rank), m_identities(std::move(identities))
  {
    CGAL_precondition_msg(0 <= m_rank && m_rank <= int(m_equations.size()),
                          "the rank is at most the number of equations");
    for ([[maybe_unused]] const Identity& identity : m_identities)
      CGAL_precondition_msg(identity.size() == m_equations.size(),
                            "an identity has one coefficient for each equation");
  }

  //! returns the sentence, such as "p1 is the projection of p0 onto f".
  std::string statement() const { return m_subject + " is " + m_predicate; }
  //! returns its negation, such as "p1 is not the projection of p0 onto f".
  std::string violation() const { return m_subject + " is not " + m_predicate; }

  //! returns the left hand sides of the equations.
  const std::vector<Expression>& equations() const { return m_equations; }
  //! returns how many of the equations are independent where the constraint holds, in general.
  int rank() const { return m_rank; }
  //! tells whether there are more equations than that.
  bool is_redundant() const { return m_rank < static_cast<int>(m_equations.size()); }
  //! returns the identities between the equations.
  const std::vector<Identity>& identities() const { return m_identities; }

private:
  std::string m_subject, m_predicate;
  std::vector<Expression> m_equations;
  int m_rank;
  std::vector<Identity> m_identities;
};

/*!
 * \ingroup PkgShapeInterrogationConstraints
 * \brief tells that a constraint does not hold, and by how much.
 */
template <class NT>
struct Violation
{
  int constraint;            //!< the index of the constraint in its system
  std::string sentence;      //!< what is not so, in words
  std::vector<NT> residuals; //!< the values of all its equations
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_CONSTRAINTS_CONSTRAINT_H
