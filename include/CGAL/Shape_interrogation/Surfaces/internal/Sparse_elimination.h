// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_SPARSE_ELIMINATION_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_SPARSE_ELIMINATION_H

// Replays an elimination plan on the values at a point: factors, kernel, left kernel, and the
// multipliers of a row combination. Zero factors are skipped where a product is dear.

#include <CGAL/Shape_interrogation/Surfaces/internal/Elimination_plan.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Pack.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
class Sparse_elimination
{
public:
  enum class Status { OK, BAD_PIVOT, RANK_TOO_HIGH };

  // Factors the matrix whose pattern entries are `values`. BAD_PIVOT asks for another plan. A plan
  // made from these values has judged the redundant rows already. A pack always answers OK and
  // marks the lanes for which that is so.
  Status factor(const Elimination_plan& plan, const std::vector<NT>& values,
                bool plan_is_from_values = false)
  {
    m_plan = &plan;
    m_slots.resize(plan.slots);
    std::copy(values.begin(), values.end(), m_slots.begin());
    std::fill(m_slots.begin() + values.size(), m_slots.end(), NT(0));
    m_inverse.resize(plan.pivots.size());
    if constexpr (Is_pack<NT>::value)
      m_good = NT(1);
    for (std::size_t k = 0; k < plan.pivots.size(); ++k)
    {
      const Elimination_plan::Pivot& pivot = plan.pivots[k];
      if (!is_good_pivot(pivot))
        return Status::BAD_PIVOT;
      m_inverse[k] = NT(1) / m_slots[pivot.slot];
      for (int r = pivot.first_reduction; r < pivot.last_reduction; ++r)
        reduce(plan.reductions[r], m_inverse[k]);
    }
    return plan_is_from_values || remainders_vanish(values) ? Status::OK : Status::RANK_TOO_HIGH;
  }

  // 1 in the lanes of a pack that were factored, 0 in the others.
  const NT& good_lanes() const { return m_good; }

  // The kernel vector that is 1 in the free column `index` and 0 in the others.
  void kernel_vector(int index, std::vector<NT>& v) const
  {
    const Elimination_plan& plan = *m_plan;
    v.assign(plan.columns, NT(0));
    v[plan.free_columns[index]] = NT(1);
    for (std::size_t k = plan.pivots.size(); k-- > 0;)
    {
      const Elimination_plan::Pivot& pivot = plan.pivots[k];
      NT sum(0);
      for (int e = pivot.first_entry; e < pivot.last_entry; ++e)
        add_product(sum, m_slots[plan.entries[e].slot], v[plan.entries[e].column]);
      if (!is_skippable(sum))
        v[pivot.column] = -(sum * m_inverse[k]);
    }
  }

  // x with J x = right_hand_side (destroyed) in the pivot rows, zero in the free columns.
  void solve(std::vector<NT>& right_hand_side, std::vector<NT>& x) const
  {
    const Elimination_plan& plan = *m_plan;
    for (const Elimination_plan::Pivot& pivot : plan.pivots)
      for (int r = pivot.first_reduction; r < pivot.last_reduction; ++r)
        right_hand_side[plan.reductions[r].row] -=
          m_slots[plan.reductions[r].factor] * right_hand_side[pivot.row];
    x.assign(plan.columns, NT(0));
    for (std::size_t k = plan.pivots.size(); k-- > 0;)
    {
      const Elimination_plan::Pivot& pivot = plan.pivots[k];
      NT sum = right_hand_side[pivot.row];
      for (int e = pivot.first_entry; e < pivot.last_entry; ++e)
        sum -= m_slots[plan.entries[e].slot] * x[plan.entries[e].column];
      x[pivot.column] = sum * m_inverse[k];
    }
  }

  // alpha with J^T alpha = right_hand_side (destroyed), zero at redundant rows. The right hand side
  // must be orthogonal to the kernel.
  void multipliers(std::vector<NT>& right_hand_side, std::vector<NT>& alpha) const
  {
    const Elimination_plan& plan = *m_plan;
    alpha.assign(plan.rows, NT(0));
    for (std::size_t k = 0; k < plan.pivots.size(); ++k)
    {
      const Elimination_plan::Pivot& pivot = plan.pivots[k];
      if (is_skippable(right_hand_side[pivot.column]))
        continue;
      const NT y = right_hand_side[pivot.column] * m_inverse[k];
      alpha[pivot.row] = y;
      for (int e = pivot.first_entry; e < pivot.last_entry; ++e)
        right_hand_side[plan.entries[e].column] -= y * m_slots[plan.entries[e].slot];
    }
    apply_transposed_factors(alpha);
  }

  // The combination of rows that vanishes and contains the redundant row `index` once.
  void left_kernel_vector(int index, std::vector<NT>& beta) const
  {
    beta.assign(m_plan->rows, NT(0));
    beta[m_plan->redundant_rows[index]] = NT(1);
    apply_transposed_factors(beta);
  }

private:
  // Exact zeros are worth a test where products allocate.
  static bool is_skippable(const NT& x)
  {
    if constexpr (Number_type_traits<NT>::is_exact && !Number_type_traits<NT>::is_light)
      return is_zero_decision(x);
    else
      return false;
  }

  static void add_product(NT& sum, const NT& a, const NT& b)
  {
    if (!is_skippable(a) && !is_skippable(b))
      sum += a * b;
  }

  bool is_good_pivot(const Elimination_plan::Pivot& pivot)
  {
    if constexpr (Is_pack<NT>::value)
    {
      NT largest(0);
      for (int e = pivot.first_entry; e < pivot.last_entry; ++e)
        largest = larger(fabs(m_slots[m_plan->entries[e].slot]), largest);
      m_good *= is_greater(fabs(m_slots[pivot.slot]) * NT(1024), largest);
      return true;
    }
    else
      return is_large_enough(pivot);
  }

  bool is_large_enough(const Elimination_plan::Pivot& pivot) const
  {
    const double quality = pivot_quality(m_slots[pivot.slot]);
    if constexpr (Number_type_traits<NT>::is_exact || Number_type_traits<NT>::is_enclosure)
      return quality != 0;
    double largest = 0;
    for (int e = pivot.first_entry; e < pivot.last_entry; ++e)
      largest = (std::max)(largest, pivot_quality(m_slots[m_plan->entries[e].slot]));
    return quality != 0 && quality * 1024 > largest;
  }

  void reduce(const Elimination_plan::Reduction& reduction, const NT& inverse)
  {
    NT& factor = m_slots[reduction.factor];
    if (is_skippable(factor))
      return;
    factor = factor * inverse;
    for (int u = reduction.first; u < reduction.last; ++u)
      m_slots[m_plan->updates[u].target] -= factor * m_slots[m_plan->updates[u].source];
  }

  bool remainders_vanish(const std::vector<NT>& values)
  {
    if constexpr (Is_pack<NT>::value)
    {
      NT scale(0);
      for (const NT& x : values)
        scale = larger(fabs(x), scale);
      for (int slot : m_plan->remainders)
        m_good *= NT(1) - is_greater(fabs(m_slots[slot]), NT(numerical_rank_tolerance) * scale);
    }
    else if constexpr (Number_type_traits<NT>::is_exact || Number_type_traits<NT>::is_enclosure)
    {
      for (int slot : m_plan->remainders)
        if (!CGAL::possibly(is_zero_decision(m_slots[slot])))
          return false;
    }
    else if (!m_plan->remainders.empty())
    {
      double scale = 0;
      for (const NT& x : values)
        scale = (std::max)(scale, pivot_quality(x));
      for (int slot : m_plan->remainders)
        if (pivot_quality(m_slots[slot]) > numerical_rank_tolerance * scale)
          return false;
    }
    return true;
  }

  void apply_transposed_factors(std::vector<NT>& x) const
  {
    const Elimination_plan& plan = *m_plan;
    for (std::size_t k = plan.pivots.size(); k-- > 0;)
    {
      const Elimination_plan::Pivot& pivot = plan.pivots[k];
      for (int r = pivot.first_reduction; r < pivot.last_reduction; ++r)
      {
        const Elimination_plan::Reduction& reduction = plan.reductions[r];
        if (!is_skippable(m_slots[reduction.factor]) && !is_skippable(x[reduction.row]))
          x[pivot.row] -= m_slots[reduction.factor] * x[reduction.row];
      }
    }
  }

  const Elimination_plan* m_plan = nullptr;
  std::vector<NT> m_slots, m_inverse;
  NT m_good;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_INTERNAL_SPARSE_ELIMINATION_H
