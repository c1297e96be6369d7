// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_REFINEMENT_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_REFINEMENT_H

// The box of a proved point, made as small as many bits allow: Krawczyk's operator with the inverse
// and the defect of double precision, which contracts by many bits in each step.

#include <CGAL/Shape_interrogation/Number_types/Wide_interval.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Krawczyk_operator.h>
#include <CGAL/Shape_interrogation/Waist/internal/refuse.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief encloses one proved point of a system in n-space more and more narrowly.
 *
 * \f$ K(X) = m - C g(m) + D (X - m) \f$ with an approximate inverse \f$ C \f$ of the Jacobian of
 * the equations of the proof, the middle \f$ m \f$ of the box \f$ X \f$, and an enclosure
 * \f$ D \f$ of \f$ I - C g' \f$ over the box of double precision, contains every zero in \f$ X \f$.
 * \f$ C \f$ and \f$ D \f$ are computed once, in `double`; only \f$ g(m) \f$ needs many bits. For a
 * system of good condition each step gains about forty bits.
 *
 * An object keeps what it has reached, so that more bits continue from there. It keeps a reference
 * to the system and is not thread-safe; use one in each thread. Calls set the precision and restore
 * it.
 */
class N_space_refinement
{
public:
  //! constructs the refinement of `enclosure`, a result of `enclose_solution()` for `system`, which
  //! must outlive it. \pre the enclosure has one interval for each variable, and as many equations
  //! as unknowns
  N_space_refinement(const N_space_system& system, const N_space_enclosure& enclosure)
    : m_system(system), m_enclosure(enclosure)
  {
    CGAL_precondition_msg(int(enclosure.box.size()) == system.number_of_variables() &&
                            enclosure.equations.size() + 2 == enclosure.box.size(),
                          "the enclosure is not one of this system");
  }

  /*!
   * \brief returns a box that contains the point, no interval of which is wider than
   * \f$ 2^{-bits} \f$ times the largest coordinate.
   *
   * The fixed coordinates are enclosed in the same precision. Refused with `UNDECIDED` where the
   * steps do not lead there, which ill-conditioned equations can cause, and with `NOT_ON_SOLUTION`
   * if the box turns out to contain no zero of the equations, as that of another system.
   * \pre `bits` is at least 2
   *
   * Complexity: for each step, of which there are about \f$ bits/40 \f$, the equations
   * and the square of the number of variables, in numbers of that many bits
   */
  Result<std::vector<Wide_interval>> operator()(int bits)
  {
    return internal::refuse_errors<std::vector<Wide_interval>>([&] { return refine(bits); });
  }

private:
  using Wide = Wide_interval;

  Result<std::vector<Wide>> refine(int bits)
  {
    if (m_box.empty())
      if (auto refusal = start())
        return *refusal;
    for (int guard = 32; guard <= 512; guard *= 2)
    {
      // Never wider than the box of double precision, over which the defect was computed.
      const Wide_precision precision((std::max)(bits + guard, 64));
      const Wide wanted = Wide(m_scale) * power_of_half(bits);
      for (int i = 0; i < 2; ++i)
        m_box[m_enclosure.fixed[i]] = Wide(m_enclosure.values[i]);
      for (Wide width = largest_width();;)
      {
        if ((wanted - width).sign().inf() != CGAL::NEGATIVE)
          return m_box;
        if (auto refusal = step())
          return *refusal;
        const Wide before = width;
        width = largest_width();
        if ((width + width - before).sign().sup() != CGAL::NEGATIVE)
          break; // nothing more to gain in this precision
      }
    }
    return Refusal(Refusal_code::UNDECIDED, "the point is not enclosed in " + std::to_string(bits) +
                                              " bits: the equations are ill-conditioned there");
  }

  // What double precision contributes.
  std::optional<Refusal> start()
  {
    internal::Krawczyk_operator krawczyk(m_system, m_enclosure.fixed);
    std::vector<double> middle;
    m_scale = 0;
    for (const Interval_nt<false>& x : m_enclosure.box)
    {
      middle.push_back(internal::middle(x.inf(), x.sup()));
      m_scale = (std::max)({m_scale, std::fabs(x.inf()), std::fabs(x.sup())});
    }
    if (auto refusal = krawczyk.linearise(middle, m_enclosure.equations))
      return refusal;
    const Wide_precision exact(53);
    m_unknowns = krawczyk.unknowns();
    m_inverse = krawczyk.inverse();
    {
      Interval_nt<false>::Protector protector;
      m_defect = krawczyk.defect(m_enclosure.box);
    }
    for (const Interval_nt<false>& x : m_enclosure.box)
      m_box.push_back(Wide(x));
    return std::nullopt;
  }

  // The common part of X and K(X).
  std::optional<Refusal> step()
  {
    std::vector<Wide> middle = m_box;
    for (int j : m_unknowns)
      middle[j] = m_box[j].middle();
    std::vector<Wide> values(m_system.number_of_equations()), workspace;
    m_system.tape().evaluate(middle.data(), values.data(), workspace);
    const std::size_t size = m_unknowns.size();
    std::vector<Wide> offset(size);
    for (std::size_t i = 0; i < size; ++i)
      offset[i] = m_box[m_unknowns[i]] - middle[m_unknowns[i]];
    for (std::size_t i = 0; i < size; ++i)
      if (!m_box[m_unknowns[i]].intersect(middle[m_unknowns[i]] + correction(i, values, offset)))
      {
        m_box.clear();
        return Refusal(Refusal_code::NOT_ON_SOLUTION,
                       "the box contains no zero of the equations of the proof");
      }
    return std::nullopt;
  }

  // Component i of K(X) - m. It is small, so that few bits are enough.
  Wide correction(std::size_t i, const std::vector<Wide>& values,
                  const std::vector<Wide>& offset) const
  {
    const Wide_precision few(128);
    Wide sum(0);
    for (std::size_t k = 0; k < offset.size(); ++k)
    {
      sum -= Wide(m_inverse(i, k)) * values[m_enclosure.equations[k]];
      sum += Wide(m_defect[i * offset.size() + k]) * offset[k];
    }
    return sum;
  }

  Wide largest_width() const
  {
    Wide largest(0);
    for (int j : m_unknowns)
    {
      const Wide width = m_box[j].width();
      if ((width - largest).sign().sup() == CGAL::POSITIVE)
        largest = width;
    }
    return largest;
  }

  static Wide power_of_half(int exponent)
  {
    Wide power(1);
    for (; exponent > 0; exponent -= 512)
      power *= Wide(std::ldexp(1., -(std::min)(exponent, 512)));
    return power;
  }

  const N_space_system& m_system;
  N_space_enclosure m_enclosure;
  std::vector<int> m_unknowns;
  Eigen::MatrixXd m_inverse;
  std::vector<Interval_nt<false>> m_defect; // row by row
  std::vector<Wide> m_box;
  double m_scale = 0; // the largest coordinate
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief returns a box that contains the point of `enclosure`, to a stated number of bits: see
 * `N_space_refinement`, which is cheaper for more than one precision.
 */
inline Result<std::vector<Wide_interval>>
refine_enclosure(const N_space_system& system, const N_space_enclosure& enclosure, int bits)
{
  return N_space_refinement(system, enclosure)(bits);
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_REFINEMENT_H
