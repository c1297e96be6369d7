// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Parts of the public interface that tests with a greater theme pass by, and that random tests tell
// their seed.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/Fundamental_forms.h>
#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Number_types/Filter_answer.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace testing_shapes;

// --- Traits --------------------------------------------------------------------------------------

struct Saddle
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return z - x * y;
  }
};

template <class Traits>
void expect_saddle()
{
  using FT = typename Traits::FT;
  EXPECT_FALSE(bool(Traits::Is_filtered::value));
  const typename Traits::Point_3 origin(FT(0), FT(0), FT(0));
  EXPECT_EQ(Traits::point(Traits::coordinates(origin)), origin);
  const typename Traits::Vector_3 v(FT(1), FT(-2), FT(3));
  EXPECT_EQ(Traits::vector(Traits::coordinates(v)), v);
  const auto s = Implicit_surface_3<Saddle>()(Traits::coordinates(origin));
  ASSERT_TRUE(s) << s.refusal().evidence();
  const typename Traits::Sign sign = sign_of_gaussian_curvature(*s);
  const typename Traits::Boolean umbilic = is_umbilic(*s);
  EXPECT_TRUE(CGAL::certainly(sign == CGAL::NEGATIVE));
  EXPECT_FALSE(CGAL::possibly(umbilic));
}

TEST(Traits, of_all_number_types)
{
  expect_saddle<Approximate_shape_traits_3>();
  expect_saddle<Exact_shape_traits_3>();
  expect_saddle<Quadratic_shape_traits_3>();
  expect_saddle<Exact_real_shape_traits_3>();
  const CGAL::Interval_nt<false>::Protector protector;
  expect_saddle<Interval_shape_traits_3>();
  EXPECT_TRUE(bool(Filtered_shape_traits_3<>::Is_filtered::value));
}

// --- Jets ----------------------------------------------------------------------------------------

TEST(Interface_of_jets, composition_reciprocal_and_higher_terms)
{
  using J = Jet<Q, 2, 3>;
  const J x = J::variable(0, 2), y = J::variable(1, 3), a = x * y - 5 * J(Q(1));
  ASSERT_EQ(a.value(), 1);
  const J cube = a * a * a, composed = a.compose({Q(1), Q(3), Q(3), Q(1)}); // t^3 at 1
  const J one = a * a.reciprocal(), higher = cube.without_affine_part();
  for (int k = 0; k < J::size; ++k)
  {
    EXPECT_EQ(composed.coefficient(k), cube.coefficient(k)) << k;
    EXPECT_EQ(one.coefficient(k), Q(k == 0)) << k;
    EXPECT_EQ(higher.coefficient(k), k < 3 ? Q(0) : cube.coefficient(k)) << k;
  }
  EXPECT_THROW((a - a).reciprocal(), Division_by_zero_error);
}

// --- Expressions ---------------------------------------------------------------------------------

TEST(Interface_of_expressions, identity_and_division)
{
  const Expression x = Expression::variable(0), y = Expression::variable(1);
  const Expression sum = x + y, copy = sum;
  EXPECT_TRUE(sum.is_identical(copy));
  EXPECT_FALSE(sum.is_identical(x - y));
  const Expression_tape polynomials({sum, x * y}, 2), quotients({sum, x / y, x}, 2);
  EXPECT_EQ(polynomials.number_of_outputs(), 2);
  EXPECT_EQ(quotients.number_of_outputs(), 3);
  EXPECT_TRUE(polynomials.is_division_free());
  EXPECT_FALSE(quotients.is_division_free());
}

// --- Knots ---------------------------------------------------------------------------------------

using Spans = std::vector<std::pair<Side, int>>;

Spans spans_at(const Knot_vector<Q>& knots, const Q& t)
{
  Spans spans;
  for (const auto& span : *knots.spans_at(t))
    spans.emplace_back(span.side, span.index);
  return spans;
}

TEST(Interface_of_knots, spans)
{
  const Knot_vector<Q> knots(3, rationals({0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}));
  EXPECT_EQ(*knots.span(Q(0), Side::LEFT), 3) << "the inner one at the start";
  EXPECT_EQ(*knots.span(fraction(1, 2), Side::LEFT), 3);
  EXPECT_EQ(*knots.span(Q(1), Side::LEFT), 3);
  EXPECT_EQ(*knots.span(Q(1), Side::RIGHT), 4);
  EXPECT_EQ(*knots.span(Q(2), Side::LEFT), 4);
  EXPECT_EQ(*knots.span(Q(2), Side::RIGHT), 6);
  EXPECT_EQ(*knots.span(Q(3), Side::RIGHT), 6) << "the inner one at the end";
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, knots.span(Q(4), Side::LEFT));
  expect_refusal(Refusal_code::OUTSIDE_DOMAIN, knots.spans_at(Q(-1)));
  EXPECT_EQ(spans_at(knots, fraction(1, 2)), (Spans{{Side::RIGHT, 3}}));
  EXPECT_EQ(spans_at(knots, Q(1)), (Spans{{Side::RIGHT, 4}})) << "two derivatives are continuous";
  EXPECT_EQ(spans_at(knots, Q(2)), (Spans{{Side::LEFT, 4}, {Side::RIGHT, 6}})) << "one is";
  EXPECT_EQ(spans_at(knots, Q(3)), (Spans{{Side::LEFT, 6}}));
}

TEST(Interface_of_knots, inverse_lengths)
{
  const Knot_vector<Q> knots(3, rationals({0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}));
  EXPECT_EQ(knots.inverse_length(0, 1), 0);
  EXPECT_EQ(knots.inverse_length(3, 1), 1);
  EXPECT_EQ(knots.inverse_length(3, 2), fraction(1, 2));
  EXPECT_EQ(knots.inverse_length(4, 3), fraction(1, 2));
}

TEST(Interface_of_knots, of_a_surface)
{
  const Knot_vector<Q> u(1, rationals({0, 0, 1, 1})), v(2, rationals({0, 0, 0, 2, 2, 2}));
  const std::vector<std::vector<Coordinates<Q, 3>>> net{
    {{Q(0), Q(0), Q(0)}, {Q(0), Q(1), Q(1)}, {Q(0), Q(2), Q(0)}},
    {{Q(1), Q(0), Q(0)}, {Q(1), Q(1), Q(1)}, {Q(1), Q(2), Q(0)}}};
  const Nurbs_surface_3<Q> surface(u, v, net);
  EXPECT_EQ(surface.knots_u().degree(), 1);
  EXPECT_EQ(surface.knots_v().degree(), 2);
  EXPECT_EQ(surface.knots_v().domain()[1], 2);
}

// --- Answers of filters --------------------------------------------------------------------------

TEST(Interface_of_filters, answers)
{
  using Answer = Filter_answer<CGAL::Uncertain<bool>>;
  std::optional<bool> answer;
  EXPECT_FALSE(Answer::assign(answer, CGAL::Uncertain<bool>::indeterminate()));
  EXPECT_FALSE(answer);
  EXPECT_TRUE(Answer::assign(answer, CGAL::Uncertain<bool>(true)));
  EXPECT_EQ(answer, true);
  EXPECT_TRUE(Filter_answer<CGAL::Sign>::last(CGAL::POSITIVE) == CGAL::POSITIVE);
  EXPECT_THROW(Answer::last(CGAL::Uncertain<bool>::indeterminate()),
               CGAL::Uncertain_conversion_exception);
}

// --- Numbers and forms ---------------------------------------------------------------------------

TEST(Interface_of_quadratic_field, parts)
{
  const Quadratic_field x(Q(3), Q(-2), Q(5)), y(7);
  EXPECT_EQ(x.rational_part(), 3);
  EXPECT_EQ(x.root_coefficient(), -2);
  EXPECT_EQ(x.root(), 5);
  EXPECT_EQ(x.extension().a1(), -2);
  EXPECT_EQ(y.root_coefficient(), 0);
  EXPECT_EQ(y.root(), 0);
}

TEST(Interface_of_forms, mean_numerator)
{
  Random random(41);
  for (int i = 0; i < 20; ++i)
  {
    const Q e = random.fraction(1, 9, 9), g = random.fraction(1, 9, 9);
    const Quadratic_form_2<Q> first{e, Q(0), g},
      second{random.rational(), random.rational(), random.rational()};
    const Fundamental_forms<Q> forms{first, second};
    EXPECT_EQ(forms.mean_numerator(), Q(e * second.n + g * second.l));
    EXPECT_EQ(Q(2 * e * g * forms.mean_curvature()), forms.mean_numerator());
  }
}

// --- Seeds ---------------------------------------------------------------------------------------

TEST(Random_numbers, are_the_same_again_and_tell_their_seed_when_a_test_fails)
{
  Random random(4711), again(4711);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(random.rational(), again.rational());
  EXPECT_NONFATAL_FAILURE(
    {
      const Random failing(4712);
      EXPECT_EQ(1, 2);
    },
    "seed 4712");
}

} // namespace
