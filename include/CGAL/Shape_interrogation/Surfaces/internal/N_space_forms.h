// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_N_SPACE_FORMS_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_N_SPACE_FORMS_H

// What the curvature of a system at a point is made of, step by step and without a decision: the
// Jacobian, the tangent basis, the second forms of the equations and their combinations.

#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Sparse_elimination.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The steps are taken in the order in which they are declared; the elimination in between is the
// caller's. Memory is kept from point to point.
template <class NT>
class N_space_forms
{
public:
  using Vector = Coordinates<NT, 3>;

  // Values and gradients at p.
  void differentiate(const N_space_system& system, const NT* p)
  {
    m_system = &system;
    const Expression_tape& tape = system.tape();
    m_values.resize(system.number_of_equations());
    m_gradient.resize(tape.gradient_pattern().number_of_entries());
    tape.evaluate_with_gradient(p, m_values.data(), m_gradient.data(), m_workspace);
  }

  const std::vector<NT>& values() const { return m_values; }
  const std::vector<NT>& gradient() const { return m_gradient; }
  Sparse_elimination<NT>& elimination() { return m_elimination; }

  // The kernel of the Jacobian, and the normal of its projection.
  void span_tangent_plane()
  {
    for (int i = 0; i < 2; ++i)
      m_elimination.kernel_vector(i, m_basis[i]);
    m_normal = cross(projected(0), projected(1));
  }

  const std::array<std::vector<NT>, 2>& basis() const { return m_basis; }
  Vector projected(int i) const { return {m_basis[i][0], m_basis[i][1], m_basis[i][2]}; }
  const Vector& normal() const { return m_normal; }

  // The forms v_i' H_k v_j of all equations, from one pass of second-order jets along the basis.
  void bend(const NT* p)
  {
    const std::size_t n = m_basis[0].size();
    m_moving.resize(n);
    m_jets.resize(m_values.size());
    for (std::size_t i = 0; i < n; ++i)
      m_moving[i] = J::along(p[i], {m_basis[0][i], m_basis[1][i]});
    m_system->tape().evaluate(m_moving.data(), m_jets.data(), m_jet_workspace);
  }

  // The form of the combination of gradients that vanishes and has redundant equation `index` once.
  std::array<NT, 3> redundant_form(int index)
  {
    m_elimination.left_kernel_vector(index, m_beta);
    return combine(m_beta);
  }

  // The weights of the last redundant_form().
  const std::vector<NT>& redundant_weights() const { return m_beta; }

  // How large the terms were that redundant_form() added up, where that is not certain otherwise.
  // The sizes of the equations are measured for the first redundant one.
  NT size_of_redundant_form(int index)
  {
    using std::fabs;
    if (index == 0)
      measure_equations();
    NT size(0);
    for (std::size_t k = 0; k < m_beta.size(); ++k)
      size += fabs(m_beta[k]) * m_sizes[k];
    return size;
  }

  // The second fundamental form times the length of the normal.
  std::array<NT, 3> normal_form()
  {
    m_right_hand_side.assign(m_basis[0].size(), NT(0));
    for (int i = 0; i < 3; ++i)
      m_right_hand_side[i] = m_normal[i];
    m_elimination.multipliers(m_right_hand_side, m_alpha);
    return combine(m_alpha);
  }

  // Those of normal_form().
  const std::vector<NT>& multipliers() const { return m_alpha; }

private:
  using J = Jet<NT, 2, 2>;

  std::array<NT, 3> combine(const std::vector<NT>& weights) const
  {
    std::array<NT, 3> h{NT(0), NT(0), NT(0)};
    for (std::size_t k = 0; k < weights.size(); ++k)
    {
      if (Number_type_traits<NT>::is_exact && CGAL::certainly(is_zero_decision(weights[k])))
        continue;
      h[0] += weights[k] * m_jets[k].derivative(0, 0);
      h[1] += weights[k] * m_jets[k].derivative(0, 1);
      h[2] += weights[k] * m_jets[k].derivative(1, 1);
    }
    return h;
  }

  void measure_equations()
  {
    using std::fabs;
    NT step(0);
    for (const auto& v : m_basis)
      for (const NT& x : v)
        step += x * x;
    const Sparse_pattern& pattern = m_system->tape().gradient_pattern();
    m_sizes.resize(m_jets.size());
    for (std::size_t k = 0; k < m_jets.size(); ++k)
    {
      NT slope(0);
      for (std::size_t e = pattern.row_starts[k]; e < pattern.row_starts[k + 1]; ++e)
        slope += fabs(m_gradient[e]);
      m_sizes[k] = slope * step + fabs(m_jets[k].derivative(0, 0)) +
                   fabs(m_jets[k].derivative(0, 1)) + fabs(m_jets[k].derivative(1, 1));
    }
  }

  const N_space_system* m_system = nullptr;
  Sparse_elimination<NT> m_elimination;
  std::vector<NT> m_values, m_gradient, m_workspace, m_right_hand_side, m_alpha, m_beta, m_sizes;
  std::array<std::vector<NT>, 2> m_basis;
  Vector m_normal;
  std::vector<J> m_moving, m_jets, m_jet_workspace;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_N_SPACE_FORMS_H
