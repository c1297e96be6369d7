// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BATCH_H
#define CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BATCH_H

// The second-order data of a system at many points in double: the computation of the evaluator on
// several points at once, one in each lane of a vector.

#include <CGAL/Shape_interrogation/Surfaces/internal/N_space_forms.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/orient_n_space_shape.h>
#include <CGAL/Shape_interrogation/Surfaces/internal/Pack.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief holds the answers of `N_space_batch`.
 */
struct N_space_batch_result
{
  //! the data at each point; meaningless where the point was refused
  std::vector<Local_shape_3<double>> shapes;
  //! the points that were refused, by increasing index, and why
  std::vector<std::pair<std::size_t, Refusal>> refusals;
};

/*!
 * \ingroup PkgShapeInterrogationSurfaces
 * \brief evaluates the surface of one system in n-space at many points in `double`, several at a
 * time.
 *
 * \details The operations of `N_space_evaluator` are carried out in the lanes of vectors, each lane
 * for one point, in an order of elimination that is common to all points: that of
 * `N_space_system::prepare()`, else one from the first point that has the rank \f$ n - 2 \f$. A
 * point for which a check fails (a pivot too small, another rank, a singular projection, redundant
 * equations that disagree, a division by zero, an overflow) is evaluated by an
 * `N_space_evaluator<double>`, which has the last word; so the answers and the refusals are its
 * own. Where the system is prepared the numbers are the same too, unless the compiler contracts
 * products and sums into one operation; otherwise they may differ in rounding and in the length of
 * the normal.
 *
 * A batch evaluator is not thread-safe; use one in each thread. It keeps a reference to the system.
 *
 * Complexity: linear in the number of points, each at the cost of `N_space_evaluator`, divided by
 * the gain from vectors.
 */
class N_space_batch
{
public:
  //! constructs an evaluator for `system`, which must outlive it.
  explicit N_space_batch(const N_space_system& system)
    : m_system(system), m_evaluate(system), m_lanes(system.number_of_variables())
  {}

  /*!
   * \brief computes the second-order data at points given by arrays of coordinates.
   * \param coordinates for each variable its values at all points
   * \pre there is one array for each variable, and all have the same length
   */
  N_space_batch_result operator()(const std::vector<std::vector<double>>& coordinates)
  {
    N_space_batch_result result;
    (*this)(coordinates, result);
    return result;
  }

  //! computes the same into `result`, whose memory is reused.
  void operator()(const std::vector<std::vector<double>>& coordinates,
                  N_space_batch_result& result)
  {
    CGAL_precondition_msg(int(coordinates.size()) == m_system.number_of_variables(),
                          "an array of coordinates is needed for each variable");
    const std::size_t size = coordinates.front().size();
    CGAL_precondition_msg(std::all_of(coordinates.begin(), coordinates.end(),
                                      [&](auto& x) { return x.size() == size; }),
                          "there must be as many coordinates of each variable as points");
    result.shapes.resize(size);
    result.refusals.clear();
    m_coordinates = &coordinates;
    m_result = &result;
    const internal::Elimination_plan* plan = find_plan(size);
    for (std::size_t first = 0; first < size; first += width)
      evaluate_lanes(plan, first, (std::min)(size - first, width));
  }

private:
  static constexpr std::size_t width = 4; // 8 spill more registers than they save
  using Pack = internal::Pack<width>;
  using Lanes = std::array<double, width>;

  const internal::Elimination_plan* find_plan(std::size_t size)
  {
    if (m_system.elimination_plan())
      return m_system.elimination_plan();
    for (std::size_t k = 0; k < size; ++k)
    {
      gather(k);
      if (auto plan = m_system.plan_at(m_point))
      {
        m_plan = std::move(*plan);
        return &m_plan;
      }
    }
    return nullptr;
  }

  void gather(std::size_t k)
  {
    m_point.resize(m_coordinates->size());
    for (std::size_t i = 0; i < m_point.size(); ++i)
      m_point[i] = (*m_coordinates)[i][k];
  }

  // The points from `first` on, at most as many as there are lanes.
  void evaluate_lanes(const internal::Elimination_plan* plan, std::size_t first, std::size_t size)
  {
    Lanes good{};
    std::array<Lanes, 9> frames;
    if (plan)
    {
      load(first, size);
      good = try_lanes(*plan, frames);
    }
    for (std::size_t lane = 0; lane < size; ++lane)
      if (good[lane] != 1 || !scatter(frames, lane, first + lane))
        evaluate_alone(first + lane);
  }

  // The last point fills what is left over.
  void load(std::size_t first, std::size_t size)
  {
    for (std::size_t i = 0; i < m_lanes.size(); ++i)
    {
      const std::vector<double>& x = (*m_coordinates)[i];
      if (size == width)
      {
        m_lanes[i] = Pack::load(&x[first]);
        continue;
      }
      Lanes lanes;
      for (std::size_t k = 0; k < width; ++k)
        lanes[k] = x[first + (std::min)(k, size - 1)];
      m_lanes[i] = Pack::load(lanes.data());
    }
  }

  // The tangent vectors and the form in each lane; 1 for lanes that passed all checks.
  Lanes try_lanes(const internal::Elimination_plan& plan, std::array<Lanes, 9>& frames)
  {
    Lanes good{};
    try
    {
      good = lanes_of(evaluate(plan, frames));
    }
    catch (const Shape_error&) {}
    return good;
  }

  Pack evaluate(const internal::Elimination_plan& plan, std::array<Lanes, 9>& frames)
  {
    m_forms.differentiate(m_system, m_lanes.data());
    m_forms.elimination().factor(plan, m_forms.gradient());
    Pack good = m_forms.elimination().good_lanes(), overflow(0);
    for (const Pack& x : m_lanes)
      overflow += x * Pack(0); // not a number where x is not finite
    for (const Pack& x : m_forms.values())
      overflow += x * Pack(0);
    m_forms.span_tangent_plane();
    const auto& n = m_forms.normal();
    const Pack squared_length = internal::dot(n, n);
    good *= is_greater(squared_length, Pack(0));
    overflow += squared_length * Pack(0);
    m_forms.bend(m_lanes.data());
    for (std::size_t r = 0; r < plan.redundant_rows.size(); ++r)
    {
      const auto h = m_forms.redundant_form(static_cast<int>(r));
      const Pack noise = Pack(internal::numerical_rank_tolerance) *
                         m_forms.size_of_redundant_form(static_cast<int>(r));
      overflow += noise * Pack(0);
      for (const Pack& x : h)
      {
        good *= Pack(1) - is_greater(fabs(x), noise);
        overflow += x * Pack(0);
      }
    }
    const auto w1 = m_forms.projected(0), w2 = m_forms.projected(1), h = m_forms.normal_form();
    for (int i = 0; i < 3; ++i)
    {
      w1[i].store(frames[i].data());
      w2[i].store(frames[3 + i].data());
      h[i].store(frames[6 + i].data());
      overflow += h[i] * Pack(0);
    }
    return good + overflow;
  }

  static Lanes lanes_of(const Pack& x)
  {
    Lanes lanes;
    x.store(lanes.data());
    return lanes;
  }

  // Stores the data in one lane as those of point k; false if they have to be looked at again.
  bool scatter(const std::array<Lanes, 9>& f, std::size_t lane, std::size_t k)
  {
    const Coordinates<double, 3> w1{f[0][lane], f[1][lane], f[2][lane]};
    const Coordinates<double, 3> w2{f[3][lane], f[4][lane], f[5][lane]};
    internal::Normal_side side;
    if (internal::orient(m_system, internal::cross(w1, w2), side))
      return false;
    const auto& x = *m_coordinates;
    Local_shape_3<double>& s = m_result->shapes[k];
    s = Local_shape_3<double>::from_frame({x[0][k], x[1][k], x[2][k]}, w1, w2, f[6][lane],
                                          f[7][lane], f[8][lane]);
    if (side.is_to_be_turned)
      s = s.opposite();
    return true;
  }

  void evaluate_alone(std::size_t k)
  {
    gather(k);
    const Result<Local_shape_3<double>> s = m_evaluate(m_point);
    if (s)
      m_result->shapes[k] = *s;
    else
      m_result->refusals.push_back({k, s.refusal()});
  }

  const N_space_system& m_system;
  N_space_evaluator<double> m_evaluate;
  internal::N_space_forms<Pack> m_forms;
  internal::Elimination_plan m_plan;
  std::vector<Pack> m_lanes;
  std::vector<double> m_point;
  const std::vector<std::vector<double>>* m_coordinates = nullptr;
  N_space_batch_result* m_result = nullptr;
};

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_SURFACES_N_SPACE_BATCH_H
