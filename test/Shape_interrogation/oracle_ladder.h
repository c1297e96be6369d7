// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H
#define SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H

// The same surface and point in intervals, doubles, exact reals and through the filter, held
// against the exact numbers of the case.

#include "oracle_checks.h"

#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>

#include <cmath>

namespace oracles {

// --- Intervals: they contain the exact numbers, or say that they do not know ---------------------

template <class Exact>
bool contains(const Interval& x, const Exact& value)
{
  return (std::isinf(x.inf()) || Exact(x.inf()) <= value) &&
         (std::isinf(x.sup()) || Exact(x.sup()) >= value);
}

// What is asked of an interval shape; computed in one go under the protection of the rounding mode.
struct Interval_answers
{
  std::optional<Refusal> refusal;
  Interval k, h, h_squared, gap_squared, low, high;
  // Products that do not depend on the factor of the normal: N x N', and N_i B'_jk - B_jk N'_i.
  std::vector<Interval> zeros;
  std::vector<Interval> normal;
  CGAL::Uncertain<CGAL::Sign> sign_k, sign_h;
  CGAL::Uncertain<bool> umbilic, planar;
};

template <class Exact>
void add_zeros(Interval_answers& a, const Local_shape_3<Interval>& s, const Fields& e)
{
  const auto n = cast_argument<Interval>(point<Exact, 3>(e.texts("N")));
  for (int i = 0; i < 3; ++i)
    a.zeros.push_back(internal::cross(s.normal(), n)[i]);
  const auto b = s.shape_matrix();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = j; k < 3; ++k)
      {
        const Interval entry = number_cast<Interval>(number<Exact>(e.texts("B").at(3 * j + k)));
        a.zeros.push_back(s.normal()[i] * entry - b(j, k) * n[i]);
      }
}

template <class Exact, class Surface, class Query>
Interval_answers answer_in_intervals(const Surface& surface, const Query& query, const Fields& e)
{
  Interval_answers a;
  const Interval::Protector protector;
  const Result<Local_shape_3<Interval>> s = surface(cast_argument<Interval>(query));
  if (!s)
  {
    a.refusal = s.refusal();
    return a;
  }
  a.sign_k = sign_of_gaussian_curvature(*s);
  a.sign_h = sign_of_mean_curvature(*s);
  a.umbilic = is_umbilic(*s);
  a.planar = is_planar(*s);
  a.k = gaussian_curvature(*s);
  a.h = mean_curvature(*s);
  a.h_squared = squared_mean_curvature(*s);
  a.gap_squared = squared_curvature_gap(*s);
  const auto principal = principal_curvatures(*s);
  a.low = principal[0];
  a.high = principal[1];
  a.normal.assign(s->normal().begin(), s->normal().end());
  if (!e.has("reason"))
    add_zeros<Exact>(a, *s, e);
  return a;
}

template <class T>
void expect_decision(const CGAL::Uncertain<T>& decision, T truth, const char* what, Count& count)
{
  count.decide(decision.is_certain());
  if (decision.is_certain())
  {
    EXPECT_EQ(decision.make_certain(), truth) << what;
  }
}

template <class Exact>
void expect_enclosures(const Interval_answers& a, const Fields& e, Count& count)
{
  expect_decision(a.sign_k, CGAL::Sign(e.integer("sign_K")), "sign of K", count);
  expect_decision(a.sign_h, CGAL::Sign(e.integer("sign_H")), "sign of H", count);
  expect_decision(a.umbilic, e.flag("umbilic"), "umbilic", count);
  expect_decision(a.planar, e.flag("planar"), "planar", count);
  EXPECT_TRUE(contains(a.k, number<Exact>(e.text("K")))) << a.k;
  EXPECT_TRUE(contains(a.h_squared, number<Exact>(e.text("H_sq")))) << a.h_squared;
  EXPECT_TRUE(contains(a.gap_squared, number<Exact>(e.text("kappa_gap_sq")))) << a.gap_squared;
  EXPECT_TRUE(contains(a.h, number<Real>(e.text("H")))) << a.h;
  EXPECT_TRUE(contains(a.low, number<Real>(e.text("kappa_min")))) << a.low;
  EXPECT_TRUE(contains(a.high, number<Real>(e.text("kappa_max")))) << a.high;
  for (const Interval& zero : a.zeros)
    EXPECT_TRUE(contains(zero, Q(0))) << zero;
}

// Refusals that are no claim about the surface.
inline bool is_no_claim(const Refusal& refusal)
{
  return refusal.code() == Refusal_code::UNDECIDED ||
         refusal.code() == Refusal_code::LIMIT_EXCEEDED;
}

template <class Exact, class Surface, class Query>
void run_interval(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const Interval_answers a = answer_in_intervals<Exact>(surface, query, c.expected);
  count.run();
  if (a.refusal)
  {
    const bool no_claim = is_no_claim(*a.refusal);
    count.decide(!no_claim);
    if (no_claim)
      return;
    EXPECT_TRUE(c.is_refused()) << "wrongly refused: " << a.refusal->evidence();
    if (c.is_refused())
    {
      EXPECT_EQ(to_string(a.refusal->code()), c.expected.text("reason"));
    }
  }
  else if (c.is_refused())
  {
    // An enclosure of zero does not prove that a point is on the surface.
    EXPECT_EQ(c.expected.text("reason"), "not_on_surface");
    count.decide(false);
  }
  else
    expect_enclosures<Exact>(a, c.expected, count);
}

// --- Doubles: compared where the interval shows that they are well conditioned -------------------

// `value` comes from the operations that led to `enclosure`, which contains the exact number: both
// lie in it, unless a pivot was chosen otherwise; hence the factor.
inline void expect_near(double value, const Interval& enclosure, const Real& exact,
                        const char* what, Count& count)
{
  const double width = enclosure.sup() - enclosure.inf();
  const double size = CGAL::to_interval(CGAL::abs(enclosure)).second;
  if (!(width <= 1e-6 * size) && width != 0)
  {
    count.pass_over("ill conditioned, the interval is wider than 1e-6 of its size");
    return;
  }
  const double error = std::fabs(CGAL::to_double(Real(value) - exact));
  EXPECT_LE(error, 8 * width + 8e-16 * size) << what << " " << value << " in " << enclosure;
}

template <class Exact, class Surface, class Query>
void run_double(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const Interval_answers a = answer_in_intervals<Exact>(surface, query, c.expected);
  if (a.refusal && is_no_claim(*a.refusal))
    return count.skip(c.id, "ill conditioned, the interval says: " + a.refusal->evidence());
  if (c.is_refused() && !a.refusal)
    return count.skip(c.id, "doubles do not claim that a point is on the surface");
  const Result<Local_shape_3<double>> s = surface(cast_argument<double>(query));
  count.run();
  ASSERT_EQ(bool(s), !c.is_refused()) << (s ? "an answer" : s.refusal().evidence());
  if (!s)
    return expect_refusal(s, c.expected);
  const Fields& e = c.expected;
  expect_near(gaussian_curvature(*s), a.k, number<Real>(e.text("K")), "K", count);
  expect_near(mean_curvature(*s), a.h, number<Real>(e.text("H")), "H", count);
  const auto principal = principal_curvatures(*s);
  EXPECT_LE(principal[0], principal[1]);
  expect_near(principal[0], a.low, number<Real>(e.text("kappa_min")), "kappa_min", count);
  expect_near(principal[1], a.high, number<Real>(e.text("kappa_max")), "kappa_max", count);
}

// --- The filter decides as the exact type --------------------------------------------------------

// The number type of a query.
template <class Query>
using Number_of = typename Query::value_type;

struct Decide_sign_of_k
{
  template <class Surface, class Query>
  auto operator()(const Surface& surface, const Query& p) const
  {
    using Answer = Result<typename Number_type_traits<Number_of<Query>>::Sign>;
    const auto s = surface(p);
    return s ? Answer(sign_of_gaussian_curvature(*s)) : Answer(s.refusal());
  }
};

struct Decide_sign_of_h
{
  template <class Surface, class Query>
  auto operator()(const Surface& surface, const Query& p) const
  {
    using Answer = Result<typename Number_type_traits<Number_of<Query>>::Sign>;
    const auto s = surface(p);
    return s ? Answer(sign_of_mean_curvature(*s)) : Answer(s.refusal());
  }
};

struct Decide_umbilic
{
  template <class Surface, class Query>
  auto operator()(const Surface& surface, const Query& p) const
  {
    using Answer = Result<typename Number_type_traits<Number_of<Query>>::Boolean>;
    const auto s = surface(p);
    return s ? Answer(is_umbilic(*s)) : Answer(s.refusal());
  }
};

template <class Answer>
void expect_filtered(const Answer& answer, int truth, const Case& c, Count& count)
{
  count.decide(answer.has_value() || !is_no_claim(answer.refusal()));
  if (c.is_refused())
    return expect_refusal(answer, c.expected);
  ASSERT_TRUE(answer) << answer.refusal().evidence();
  EXPECT_EQ(int(*answer), truth);
}

template <class Exact, class Surface, class Query>
void run_filtered(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const bool refused = c.is_refused();
  count.run();
  const Fields& e = c.expected;
  expect_filtered(Filtered<Decide_sign_of_k, Exact>()(surface, query),
                  refused ? 0 : e.integer("sign_K"), c, count);
  expect_filtered(Filtered<Decide_sign_of_h, Exact>()(surface, query),
                  refused ? 0 : e.integer("sign_H"), c, count);
  expect_filtered(Filtered<Decide_umbilic, Exact>()(surface, query),
                  refused ? 0 : e.flag("umbilic"), c, count);
}

// --- Exact reals: all signs ----------------------------------------------------------------------

template <class Surface, class Query>
void run_real(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const Result<Local_shape_3<Real>> s = surface(cast_argument<Real>(query));
  count.run();
  if (c.is_refused())
    return expect_refusal(s, c.expected);
  ASSERT_TRUE(s) << s.refusal().evidence();
  expect_decisions(*s, c.expected);
  EXPECT_EQ(compare_principal_curvatures(*s, Principal::MIN, *s, Principal::MAX),
            c.expected.flag("umbilic") ? CGAL::EQUAL : CGAL::SMALLER);
  expect_equal(mean_curvature(*s), c.expected, "H");
}

} // namespace oracles

#endif // SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H
