// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_KRAWCZYK_OPERATOR_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_KRAWCZYK_OPERATOR_H

// Krawczyk's operator K(X) = m - C g(m) + (I - C g'(X)) (X - m) for n - 2 equations g of a system
// in the n - 2 coordinates that are not fixed: K(X) inside X proves exactly one zero in X.

#include <CGAL/Shape_interrogation/Number_types/Answer_union.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/plan_elimination.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>

#include <CGAL/Interval_nt.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Krawczyk_operator
{
public:
  using Interval = Interval_nt<false>;
  using Box = std::vector<Interval>;

  Krawczyk_operator(const N_space_system& system, const std::array<int, 2>& fixed)
    : m_system(system), m_fixed(fixed), m_n(system.number_of_variables()), m_place(m_n, -1)
  {
    for (int i = 0; i < m_n; ++i)
      if (i != fixed[0] && i != fixed[1])
      {
        m_place[i] = static_cast<int>(m_unknowns.size());
        m_unknowns.push_back(i);
      }
  }

  const std::vector<int>& equations() const { return m_equations; }
  const std::vector<int>& unknowns() const { return m_unknowns; }
  const Eigen::MatrixXd& inverse() const { return m_inverse; } // C

  // Chooses equations that are independent at p, and inverts their Jacobian.
  std::optional<Refusal> linearise(const std::vector<double>& p)
  {
    const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
    const std::vector<double> gradient = m_system.tape().gradient(p);
    Elimination_limits limits;
    limits.max_rank = m_n - 2;
    limits.free_columns = {m_fixed[0], m_fixed[1]};
    Elimination_plan plan = plan_elimination(pattern, m_n, gradient_around(p), limits);
    if (plan.rank() < m_n - 2)
      plan = plan_elimination(pattern, m_n, gradient, limits);
    if (plan.rank() < m_n - 2)
      return Refusal(Refusal_code::RANK_DEFICIENT,
                     "with the variables " + m_system.variables()[m_fixed[0]] + " and " +
                       m_system.variables()[m_fixed[1]] + " fixed the Jacobian has rank " +
                       std::to_string(plan.rank()) + " of " + std::to_string(m_n - 2));
    m_equations.clear();
    for (const Elimination_plan::Pivot& pivot : plan.pivots)
      m_equations.push_back(pivot.row);
    std::sort(m_equations.begin(), m_equations.end());
    return invert(gradient);
  }

  // Inverts the Jacobian at p of equations that were chosen before.
  std::optional<Refusal> linearise(const std::vector<double>& p, const std::vector<int>& equations)
  {
    m_equations = equations;
    return invert(m_system.tape().gradient(p));
  }

  // Newton steps with the inverse as it is, as long as they become smaller.
  void polish(std::vector<double>& p) const
  {
    std::vector<double> values(m_system.number_of_equations()), workspace;
    Eigen::VectorXd residual(m_equations.size());
    for (double size, previous = HUGE_VAL;; previous = size)
    {
      m_system.tape().evaluate(p.data(), values.data(), workspace);
      for (std::size_t k = 0; k < m_equations.size(); ++k)
        residual(k) = values[m_equations[k]];
      const Eigen::VectorXd step = m_inverse * residual;
      size = step.lpNorm<Eigen::Infinity>();
      if (!(size < previous / 2))
        return;
      for (std::size_t j = 0; j < m_unknowns.size(); ++j)
        p[m_unknowns[j]] -= step(j);
    }
  }

  // I - C g'(box), row by row. Needs rounding upward.
  std::vector<Interval> defect(const Box& box)
  {
    const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
    m_gradient.resize(pattern.number_of_entries());
    m_system.tape().template evaluate_with_gradient<Interval>(box.data(), nullptr,
                                                              m_gradient.data(), m_workspace);
    const std::size_t size = m_unknowns.size();
    std::vector<Interval> defect(size * size, Interval(0));
    for (std::size_t i = 0; i < size; ++i)
      defect[i * size + i] = Interval(1);
    for (std::size_t k = 0; k < size; ++k)
      for_each_entry(static_cast<int>(k), [&](int column, std::size_t e) {
        for (std::size_t i = 0; i < size; ++i)
          defect[i * size + column] -= Interval(m_inverse(i, k)) * m_gradient[e];
      });
    return defect;
  }

  // The smallest box around p that the test reaches. Needs rounding upward.
  std::optional<Refusal> enclose(const std::vector<double>& p,
                                 const std::array<Interval, 2>& values, Box& box)
  {
    Box middle(m_n);
    for (int i = 0; i < m_n; ++i)
      middle[i] = Interval(p[i]);
    for (int i = 0; i < 2; ++i)
      middle[m_fixed[i]] = values[i];
    evaluate(middle);
    const Box newton = preconditioned_values();
    Box image(m_unknowns.size());
    for (std::size_t j = 0; j < image.size(); ++j)
      image[j] = middle[m_unknowns[j]] - newton[j];
    box = middle;
    set_unknowns(box, inflated(image, p));
    bool proved = false;
    for (int attempt = 0; attempt < 24; ++attempt)
    {
      image = apply(middle, newton, box);
      const bool is_inside = lies_inside(image, box);
      if (proved && !is_inside)
        break; // nothing more to gain
      const bool goes_on = !is_inside || total_width(image) < 0.9 * width_of_unknowns(box);
      set_unknowns(box, is_inside ? image : inflated(image, p));
      proved = is_inside;
      if (!goes_on)
        break;
    }
    if (!proved)
      return Refusal(Refusal_code::UNDECIDED,
                     "Krawczyk's test proves no zero of the chosen equations near the point");
    return check_others(box);
  }

private:
  std::optional<Refusal> invert(const std::vector<double>& gradient)
  {
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(m_n - 2, m_n - 2);
    for (int k = 0; k < m_n - 2; ++k)
      for_each_entry(k, [&](int column, std::size_t e) { jacobian(k, column) = gradient[e]; });
    m_inverse = jacobian.inverse();
    if (!m_inverse.allFinite())
      return Refusal(Refusal_code::RANK_DEFICIENT, "the Jacobian of the unknowns is singular");
    return std::nullopt;
  }

  // In a box around p that should contain the solution. Near it only intervals tell redundant
  // equations, and such without a gradient, from others that are small.
  Box gradient_around(const std::vector<double>& p) const
  {
    const double size = Eigen::Map<const Eigen::VectorXd>(p.data(), m_n).lpNorm<Eigen::Infinity>();
    Interval::Protector protector;
    Box box;
    for (double x : p)
    {
      const double radius = std::ldexp(std::fabs(x), -44) + std::ldexp(size, -50);
      box.push_back(Interval(x) + Interval(-radius, radius));
    }
    return m_system.tape().gradient(box);
  }

  // Calls f with the place of the unknown and the number of the entry, for a chosen equation.
  template <class Function>
  void for_each_entry(int k, Function f) const
  {
    const Sparse_pattern& pattern = m_system.tape().gradient_pattern();
    const int row = m_equations[k];
    for (std::size_t e = pattern.row_starts[row]; e < pattern.row_starts[row + 1]; ++e)
      if (m_place[pattern.columns[e]] >= 0)
        f(m_place[pattern.columns[e]], e);
  }

  void evaluate(const Box& at)
  {
    m_values.resize(m_system.number_of_equations());
    m_system.tape().evaluate(at.data(), m_values.data(), m_workspace);
  }

  // C g, for the values of the last evaluation.
  Box preconditioned_values() const
  {
    const std::size_t size = m_unknowns.size();
    Box product(size, Interval(0));
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        product[i] += Interval(m_inverse(i, k)) * m_values[m_equations[k]];
    return product;
  }

  // The unknowns of K(box).
  Box apply(const Box& middle, const Box& newton, const Box& box)
  {
    const std::size_t size = m_unknowns.size();
    // The mean value theorem needs the derivatives between the middle and the box, too.
    Box hull = box;
    for (int j : m_unknowns)
      hull[j] = Answer_union<Interval>::of(box[j], middle[j]);
    const std::vector<Interval> defect = this->defect(hull);
    Box image(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      image[i] = middle[m_unknowns[i]] - newton[i];
      for (std::size_t j = 0; j < size; ++j)
        image[i] += defect[i * size + j] * (box[m_unknowns[j]] - middle[m_unknowns[j]]);
    }
    return image;
  }

  Box inflated(Box unknowns, const std::vector<double>& p) const
  {
    for (std::size_t j = 0; j < unknowns.size(); ++j)
    {
      Interval& x = unknowns[j];
      const double more = 0.25 * (x.sup() - x.inf()) +
                          std::ldexp(std::fabs(p[m_unknowns[j]]), -50) + 1e-300;
      x += Interval(-more, more);
    }
    return unknowns;
  }

  bool lies_inside(const Box& image, const Box& box) const
  {
    for (std::size_t j = 0; j < image.size(); ++j)
      if (!(image[j].inf() > box[m_unknowns[j]].inf() && image[j].sup() < box[m_unknowns[j]].sup()))
        return false;
    return true;
  }

  static double total_width(const Box& image)
  {
    double w = 0;
    for (const Interval& x : image)
      w += x.sup() - x.inf();
    return w;
  }

  double width_of_unknowns(const Box& box) const
  {
    double w = 0;
    for (int j : m_unknowns)
      w += box[j].sup() - box[j].inf();
    return w;
  }

  void set_unknowns(Box& box, const Box& image) const
  {
    for (std::size_t j = 0; j < image.size(); ++j)
      box[m_unknowns[j]] = image[j];
  }

  std::optional<Refusal> check_others(const Box& box)
  {
    evaluate(box);
    for (int k = 0; k < m_system.number_of_equations(); ++k)
      if (!(m_values[k].inf() <= 0 && m_values[k].sup() >= 0))
        return Refusal(Refusal_code::NOT_ON_SOLUTION,
                       "equation " + std::to_string(k + 1) +
                         " certainly does not vanish where the chosen ones do");
    return std::nullopt;
  }

  const N_space_system& m_system;
  std::array<int, 2> m_fixed;
  int m_n;
  std::vector<int> m_place; // of a variable among the unknowns, or -1
  std::vector<int> m_unknowns, m_equations;
  Eigen::MatrixXd m_inverse;
  Box m_values, m_gradient, m_workspace;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_KRAWCZYK_OPERATOR_H
