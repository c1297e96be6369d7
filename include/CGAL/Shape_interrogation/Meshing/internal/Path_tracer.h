// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_TRACER_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_TRACER_H

// Follows a curve in n-space by steps along the tangent and corrections in the hyperplane across:
// the solutions of a system of dimension 1, or of a surface with one linear condition more.

#include <CGAL/Shape_interrogation/Meshing/internal/Bound_side.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Branch_detector.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Path.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_corrector.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Path_tracer
{
public:
  // `fixed` holds one condition if the system is a surface, and none if it is a curve.
  Path_tracer(const N_space_system& system, std::vector<N_space_condition> fixed,
              const std::vector<Bound_side>& sides, const Path_limits& limits = {})
    : m_corrector(system, 1 + static_cast<int>(fixed.size())), m_fixed(std::move(fixed)),
      m_sides(sides), m_limits(limits),
      m_branches(system, m_fixed, system.number_of_variables() - 1)
  {}

  // The point of the curve near an approximate one, with a tangent.
  Result<Path_point> start(const std::vector<double>& p)
  {
    const Result<N_space_point> corrected = m_corrector(p, m_fixed);
    if (!corrected)
      return corrected.refusal();
    Path_point s{corrected->point, tangent()};
    if (s.tangent.empty())
      return Refusal(Refusal_code::RANK_DEFICIENT, "the curve has no tangent at the start");
    return s;
  }

  // Follows the curve from a start in the direction of its tangent. `unit(p)` is the length of a
  // step at most; `go_on()` is asked before every step.
  template <class Unit, class Go_on>
  Path trace(const Path_point& start, Unit unit, Go_on go_on)
  {
    Path path;
    Path_point p = start;
    double size = 1;
    while (path.points.size() < m_limits.max_points && go_on())
    {
      const double h = size * unit(p);
      std::optional<Path_point> q = step(p, h, path);
      const double cosine = q ? dot_product(q->tangent, p.tangent) : -1;
      if (cosine < m_limits.cos_turning)
      {
        size /= 2;
        if (size >= m_limits.least_size)
          continue;
        path.end = Path_end::SINGULAR;
        path.last_step = h;
        return path;
      }
      if (crosses_branch(p, *q))
      {
        if (end_at_branch(p, *q, h, path))
          return path;
        if (m_branches.is_square() && (size /= 2) >= m_limits.least_size)
          continue; // the step has jumped to another branch
      }
      if (end_at_bound(p, *q, path) || end_at_start(start, p, *q, path))
        return path;
      const double angle = std::acos((std::min)(cosine, 1.));
      size = (std::min)(1., size * (std::min)(2., 0.7 * std::acos(m_limits.cos_turning) /
                                                    (angle + 1e-9)));
      path.points.push_back(*q);
      p = std::move(*q);
    }
    return path;
  }

private:
  std::optional<Path_point> step(const Path_point& p, double h, Path& path)
  {
    std::vector<N_space_condition> conditions = m_fixed;
    conditions.push_back({p.tangent, dot_product(p.tangent, p.point) + h});
    std::vector<double> predicted = p.point;
    add_multiple(predicted, h, p.tangent);
    const Result<N_space_point> corrected = m_corrector(predicted, conditions);
    if (!corrected)
    {
      path.evidence = corrected.refusal().evidence();
      return std::nullopt;
    }
    Path_point q{corrected->point, tangent()};
    path.evidence = "the curve turns too fast or branches";
    if (q.tangent.empty() || distance(q.point, predicted) > 0.3 * h)
      return std::nullopt;
    if (dot_product(q.tangent, p.tangent) < 0)
      for (double& x : q.tangent)
        x = -x;
    return q;
  }

  bool crosses_branch(const Path_point& p, const Path_point& q) const
  {
    return m_limits.stops_at_branches && m_branches.is_able() &&
           m_branches.may_branch(p.point, {p.tangent}, q.point, {q.tangent});
  }

  // Comes nearer to a branch that the step from p to q crosses. Very near to it corrections may
  // lead to the other branch: so each round begins where the last one was sure, with shorter steps.
  bool end_at_branch(const Path_point& p, const Path_point& q, double h, Path& path)
  {
    const auto sizes = m_branches.row_sizes(p.point);
    const auto independence_at = [&](const Path_point& r) {
      return m_branches.independence(r.point, sizes);
    };
    const double usual = (std::max)(independence_at(p), independence_at(q));
    Path_point nearest = p;
    double rest = h;
    while (rest > 1e-7 * h)
    {
      double low = 0, high = rest;
      Path_point best = nearest;
      while (high - low > rest / 64)
      {
        const double middle = (low + high) / 2;
        const std::optional<Path_point> r = step(nearest, middle, path);
        if (!r || crosses_branch(nearest, *r))
          high = middle;
        else
        {
          low = middle;
          best = *r;
        }
      }
      // At a branch all rows become dependent, not only some of them.
      const double independence = independence_at(best);
      if (independence >= 0.9 * independence_at(nearest))
        break;
      nearest = best;
      rest = (std::max)(2 * (high - low), 2 * h * independence / usual);
      const std::optional<Path_point> beyond = step(nearest, rest, path);
      if (!beyond || !crosses_branch(nearest, *beyond))
        break;
    }
    const double independence = independence_at(nearest);
    if (independence > 0.1 * usual)
      return false;
    if (nearest.point != p.point)
      path.points.push_back(nearest);
    path.end = Path_end::SINGULAR;
    path.evidence = "the equations become dependent: branches cross, or the curve has a cusp";
    path.last_step = (std::max)(rest, 4 * h * independence / usual);
    return true;
  }

  // The first bound that the step from p to q crosses ends the path.
  bool end_at_bound(const Path_point& p, const Path_point& q, Path& path)
  {
    double least = 2;
    std::optional<Path_point> last;
    for (std::size_t i = 0; i < m_sides.size(); ++i)
    {
      const Bound_side& side = m_sides[i];
      const double dp = side.distance(p.point), dq = side.distance(q.point);
      // A curve in a bound leaves it by roundings only.
      if (is_fixed(side) || dq >= -1e-12 * (1 + std::fabs(side.value)) || dq >= dp)
        continue;
      const double part = (std::max)(dp, 0.) / ((std::max)(dp, 0.) - dq);
      if (part >= least)
        continue;
      std::vector<N_space_condition> conditions = m_fixed;
      conditions.push_back(side.condition(p.point.size()));
      std::vector<double> guess = p.point;
      for (std::size_t k = 0; k < guess.size(); ++k)
        guess[k] += part * (q.point[k] - p.point[k]);
      const Result<N_space_point> corrected = m_corrector(guess, conditions);
      if (corrected && !is_inside_others(corrected->point, side))
        continue; // another bound is met before
      least = part;
      path.side = static_cast<int>(i);
      last = Path_point{corrected ? corrected->point : guess, q.tangent};
      last->point[side.variable] = side.value;
    }
    if (!last)
      return false;
    path.points.push_back(*last);
    path.end = Path_end::BOUND;
    return true;
  }

  bool is_inside_others(const std::vector<double>& p, const Bound_side& side) const
  {
    return std::all_of(m_sides.begin(), m_sides.end(), [&](const Bound_side& other) {
      return &other == &side || is_fixed(other) ||
             other.distance(p) >= -1e-9 * (1 + std::fabs(other.value));
    });
  }

  // The start lies beside the step from p to q.
  bool end_at_start(const Path_point& start, const Path_point& p, const Path_point& q, Path& path)
  {
    if (path.points.size() < 2)
      return false;
    const double h = distance(p.point, q.point);
    double along = 0, square = 0;
    for (std::size_t i = 0; i < start.point.size(); ++i)
    {
      const double d = start.point[i] - p.point[i];
      along += d * p.tangent[i];
      square += d * d;
    }
    if (along < 0 || along > 1.2 * h || square - along * along > 0.1 * h * h ||
        dot_product(start.tangent, p.tangent) < 0.5 || !leads_to(start, p, along))
      return false;
    if (along < 0.5 * h)
      path.points.pop_back();
    path.end = Path_end::CLOSED;
    return true;
  }

  // Whether the step from p into the hyperplane of the start ends there, not on a branch near.
  bool leads_to(const Path_point& start, const Path_point& p, double along)
  {
    std::vector<N_space_condition> conditions = m_fixed;
    conditions.push_back({start.tangent, dot_product(start.tangent, start.point)});
    std::vector<double> predicted = p.point;
    add_multiple(predicted, along, p.tangent);
    const Result<N_space_point> corrected = m_corrector(predicted, conditions);
    double size = 0;
    for (double x : start.point)
      size = (std::max)(size, std::fabs(x));
    return corrected && distance(corrected->point, start.point) <= 1e-6 * along + 1e-12 * size;
  }

  bool is_fixed(const Bound_side& side) const
  {
    return std::any_of(m_fixed.begin(), m_fixed.end(), [&](const N_space_condition& c) {
      return c.value == side.value && c.coefficients[side.variable] == 1;
    });
  }

  // The unit vector of the kernel that the fixed condition leaves; none where it leaves a plane.
  std::vector<double> tangent() const
  {
    const auto& basis = m_corrector.tangent_basis();
    if (m_fixed.empty())
      return basis[0];
    const double a = dot_product(m_fixed[0].coefficients, basis[0]);
    const double b = dot_product(m_fixed[0].coefficients, basis[1]);
    const double length = std::hypot(a, b);
    if (!(length > 1e-9 * std::sqrt(dot_product(m_fixed[0].coefficients, m_fixed[0].coefficients))))
      return {};
    std::vector<double> t(basis[0].size(), 0.);
    add_multiple(t, -b / length, basis[0]);
    add_multiple(t, a / length, basis[1]);
    return t;
  }

  static double distance(const std::vector<double>& a, const std::vector<double>& b)
  {
    double square = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      square += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(square);
  }

  N_space_corrector m_corrector;
  std::vector<N_space_condition> m_fixed;
  const std::vector<Bound_side>& m_sides;
  Path_limits m_limits;
  Branch_detector m_branches;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_PATH_TRACER_H
