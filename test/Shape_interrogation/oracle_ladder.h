// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H
#define SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H

// The same surface and point in intervals, doubles, exact reals, with one root and through the
// filter, held against the exact numbers of the case; and the tests that do so for a whole kind.

#include "oracle_checks.h"

#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

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
  // The projector on the direction of the larger curvature, where there is one and it is rational.
  std::optional<Symmetric_matrix_3<Interval>> projector;
  // The normal curvature in the direction of the case, if it has one.
  std::optional<Interval> kappa;
  CGAL::Uncertain<CGAL::Sign> sign_k, sign_h, sign_kappa;
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

template <class Exact>
void add_directions(Interval_answers& a, const Local_shape_3<Interval>& s, const Case& c)
{
  if (c.expected.has("projector_kappa_max"))
  {
    const auto projector = projector_on_max_direction(s);
    EXPECT_TRUE(projector || projector.refusal().code() == Refusal_code::UNDECIDED);
    if (projector)
      a.projector = *projector;
  }
  if (c.inputs.has("direction"))
  {
    const auto v = cast_argument<Interval>(point<Exact, 3>(c.inputs.texts("direction")));
    a.kappa = normal_curvature(s, v);
    a.sign_kappa = sign_of_normal_curvature(s, v);
  }
}

template <class Exact, class Surface, class Query>
Interval_answers answer_in_intervals(const Surface& surface, const Query& query, const Case& c)
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
  if (!c.is_refused())
  {
    add_zeros<Exact>(a, *s, c.expected);
    add_directions<Exact>(a, *s, c);
  }
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
  if (a.projector)
  {
    for (int i = 0; i < 9; ++i)
      EXPECT_TRUE(contains((*a.projector)(i / 3, i % 3),
                           number<Exact>(e.texts("projector_kappa_max").at(i))))
        << "projector " << i;
  }
  if (a.kappa)
  {
    const Real kappa = number<Real>(e.text("kappa_direction_hartmann"));
    EXPECT_TRUE(contains(*a.kappa, kappa)) << *a.kappa;
    expect_decision(a.sign_kappa, CGAL::sign(kappa), "sign of the normal curvature", count);
  }
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
  const Interval_answers a = answer_in_intervals<Exact>(surface, query, c);
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

// The direction of the larger curvature, free of its sign, and the other one across it.
inline void expect_near_directions(const Local_shape_3<double>& s, const Interval_answers& a,
                                   const Fields& e, Count& count)
{
  if (!a.projector)
    return count.pass_over("directions that the interval does not tell");
  const auto d = principal_directions(s);
  ASSERT_TRUE(d) << d.refusal().evidence();
  const auto& [low, high] = *d;
  for (int i = 0; i < 9; ++i)
  {
    const Interval enclosure = (*a.projector)(i / 3, i % 3);
    const double slack = 8 * (enclosure.sup() - enclosure.inf()) + 1e-15;
    const Q exact = number<Q>(e.texts("projector_kappa_max").at(i));
    EXPECT_NEAR(high[i / 3] * high[i % 3], CGAL::to_double(exact), slack) << "direction " << i;
  }
  EXPECT_NEAR(internal::dot(low, high), 0, 1e-15);
}

template <class Exact, class Surface, class Query>
void run_double(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const Interval_answers a = answer_in_intervals<Exact>(surface, query, c);
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
  if (e.has("projector_kappa_max"))
    expect_near_directions(*s, a, e, count);
  if (a.kappa)
  {
    const auto v = cast_argument<double>(point<Exact, 3>(c.inputs.texts("direction")));
    expect_near(normal_curvature(*s, v), *a.kappa,
                number<Real>(e.text("kappa_direction_hartmann")), "normal curvature", count);
  }
}

// --- The filter decides as the exact type --------------------------------------------------------

// The number type of a query.
template <class Query>
using Number_of = typename Query::value_type;

template <class Answer>
void expect_filtered(const Answer& answer, int truth, const Case& c, Count& count)
{
  count.decide(answer.has_value() || !is_no_claim(answer.refusal()));
  if (c.is_refused())
    return expect_refusal(answer, c.expected);
  ASSERT_TRUE(answer) << answer.refusal().evidence();
  EXPECT_EQ(int(*answer), truth);
}

struct Is_on_surface
{
  template <class Function, class NT>
  auto operator()(const Implicit_surface_3<Function>& surface, const Coordinates<NT, 3>& p) const
  {
    return is_zero_decision(surface.function()(p[0], p[1], p[2]));
  }
};

// A certified decision is about the level set of the point; whether that is the surface is asked
// apart.
template <class Exact, class Surface, class Query>
bool is_filtered_on_surface(const Case& c, const Surface& surface, const Query& query)
{
  if constexpr (internal::Has_level_set<Surface, Query>::value)
  {
    const bool is_on = Filtered<Is_on_surface, Exact>()(surface, query);
    EXPECT_EQ(is_on, !c.is_refused() || c.expected.text("reason") != "not_on_surface");
    return is_on;
  }
  else
    return true;
}

template <class Exact, class Surface, class Query>
void run_filtered(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  count.run();
  if (!is_filtered_on_surface<Exact>(c, surface, query))
    return;
  const bool refused = c.is_refused();
  const Fields& e = c.expected;
  const auto expect = [&](auto question, const char* field) {
    SCOPED_TRACE(field);
    const int truth = refused ? 0 : e.text(field) == "true" || e.text(field) == "false"
                                      ? int(e.flag(field)) : e.integer(field);
    const Filtered<Shape_chain<decltype(question)>, Exact> filtered;
    expect_filtered(filtered(surface, query), truth, c, count);
  };
  expect(Sign_of_gaussian_curvature(), "sign_K");
  expect(Sign_of_mean_curvature(), "sign_H");
  expect(Is_umbilic(), "umbilic");
  expect(Is_planar(), "planar");
  if (!refused && c.inputs.has("direction"))
  {
    const Filtered<Shape_chain<Sign_of_normal_curvature>, Exact> filtered;
    expect_filtered(filtered(surface, query, point<Exact, 3>(c.inputs.texts("direction"))),
                    CGAL::sign(number<Exact>(e.text("kappa_direction_hartmann"))), c, count);
  }
}

// --- Exact reals and one root --------------------------------------------------------------------

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
  if (c.inputs.has("kappa"))
    return count.pass_over("H and K of a solution for the shape, whose expressions are too deep");
  expect_equal(mean_curvature(*s), c.expected, "H");
  expect_equal(gaussian_curvature(*s), c.expected, "K");
}

template <class Surface, class Query>
void run_one_root(const Case& c, const Surface& surface, const Query& query, Count& count)
{
  const auto s = surface(cast_argument<Quadratic_field>(query));
  count.run();
  if (c.is_refused())
    return expect_refusal(s, c.expected);
  ASSERT_TRUE(s) << s.refusal().evidence();
  expect_block(*s, c.expected, false);
}

// --- The tests of a kind -------------------------------------------------------------------------

// A kind has a name, the number of its cases, and for_each(run), which calls run(case, surface,
// query) for each of them, with the query in the smallest exact field that has it.
template <class Kind>
class Surface_cases : public testing::Test
{
public:
  // Calls run(case, surface, query, exact), the latter being any number of the query's type.
  template <class Run>
  static void visit(Count& count, Run run)
  {
    Kind::for_each([&](const Case& c, const auto& surface, const auto& query) {
      SCOPED_TRACE(c.id);
      run(c, surface, query, Number_of<std::decay_t<decltype(query)>>());
    });
    EXPECT_EQ(count.visited(), Kind::number);
  }
};

TYPED_TEST_SUITE_P(Surface_cases);

TYPED_TEST_P(Surface_cases, interval)
{
  Count count(TypeParam::name, "intervals");
  this->visit(count, [&](const Case& c, const auto& surface, const auto& query, auto exact) {
    run_interval<decltype(exact)>(c, surface, query, count);
  });
  EXPECT_GT(count.decided(), count.undecided());
}

TYPED_TEST_P(Surface_cases, approximate)
{
  Count count(TypeParam::name, "double");
  this->visit(count, [&](const Case& c, const auto& surface, const auto& query, auto exact) {
    run_double<decltype(exact)>(c, surface, query, count);
  });
}

TYPED_TEST_P(Surface_cases, filtered)
{
  Count count(TypeParam::name, "filtered");
  this->visit(count, [&](const Case& c, const auto& surface, const auto& query, auto exact) {
    run_filtered<decltype(exact)>(c, surface, query, count);
  });
  EXPECT_EQ(count.undecided(), 0);
}

TYPED_TEST_P(Surface_cases, exact_real)
{
  Count count(TypeParam::name, "exact reals");
  this->visit(count, [&](const Case& c, const auto& surface, const auto& query, auto) {
    run_real(c, surface, query, count);
  });
}

TYPED_TEST_P(Surface_cases, one_root)
{
  Count count(TypeParam::name, "Q(sqrt c)");
  this->visit(count, [&](const Case& c, const auto& surface, const auto& query, auto) {
    run_one_root(c, surface, query, count);
  });
}

REGISTER_TYPED_TEST_SUITE_P(Surface_cases, interval, approximate, filtered, exact_real, one_root);

} // namespace oracles

#endif // SHAPE_INTERROGATION_TEST_ORACLE_LADDER_H
