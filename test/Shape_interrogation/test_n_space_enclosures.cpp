// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// What is decided at points that are known by an enclosure only.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;
using Names = std::vector<std::string>;
using Point = std::vector<double>;

N_space_system make_system(const Names& variables, const Names& equations)
{
  std::vector<Expression> expressions;
  for (const std::string& text : equations)
    expressions.push_back(parse_expression(text, variables));
  return N_space_system(variables, expressions);
}

struct Gaussian_sign
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const
  {
    return sign_of_gaussian_curvature(s);
  }
};
struct Mean_sign
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const
  {
    return sign_of_mean_curvature(s);
  }
};
struct Umbilic
{
  template <class NT> auto operator()(const Local_shape_3<NT>& s) const { return is_umbilic(s); }
};

// --- The side of the normal ----------------------------------------------------------------------

TEST(Unoriented_shape, answers_what_does_not_depend_on_the_side)
{
  // The normal is (0, 0, 1) or (0, 0, -1) at the origin: its first component says nothing.
  const N_space_surface_3 saddle(make_system({"y", "z", "x"}, {"x - 2*y^2 + z^2"}));
  const Interval tiny(-1e-12, 1e-12);
  Interval::Protector protector;
  const std::vector<Interval> box{tiny, tiny, tiny};
  ASSERT_FALSE(saddle(box));
  EXPECT_EQ(saddle(box).refusal().code(), Refusal_code::UNDECIDED);
  const auto s = saddle.unoriented(box);
  ASSERT_TRUE(s) << s.refusal().evidence();
  EXPECT_FALSE(s->is_oriented());
  EXPECT_TRUE(CGAL::certainly(s->ask(Gaussian_sign()) == CGAL::NEGATIVE));
  EXPECT_TRUE(CGAL::certainly(!s->ask(Umbilic())));
  EXPECT_FALSE(s->ask(Mean_sign()).is_certain());
  const auto square = [](const auto& shape) { return squared_mean_curvature(shape); };
  EXPECT_GT(s->ask(square).inf(), 0.99); // H = -+1
  const auto mean = [](const auto& shape) { return mean_curvature(shape); };
  const Interval h = s->ask(mean);
  EXPECT_TRUE(h.inf() <= -1 && h.sup() >= 1 && h.sup() < 1.001);
  // In the direction of y the curvature is -+4, of one sign on each side; never both.
  const auto in_y = [](const auto& shape) {
    using NT = typename std::decay_t<decltype(shape)>::FT;
    return sign_of_normal_curvature(shape, Coordinates<NT, 3>{NT(1), NT(0), NT(0)});
  };
  EXPECT_TRUE(s->ask(in_y).is_certain() == false && CGAL::is_certain(in_y(s->one_side())));
  EXPECT_TRUE(CGAL::is_certain(in_y(s->opposite().one_side())));
}

TEST(Unoriented_shape, is_oriented_where_the_side_is_decided)
{
  N_space_system system = make_system({"y", "z", "x"}, {"x - 2*y^2 + z^2"});
  const N_space_surface_3 plain(system);
  const auto exact = plain.unoriented(std::vector<Q>{Q(0), Q(0), Q(0)});
  ASSERT_TRUE(exact && exact->is_oriented());
  EXPECT_EQ(exact->ask(Mean_sign()), plain(std::vector<Q>{Q(0), Q(0), Q(0)})->trace_numerator() < 0
                                       ? CGAL::NEGATIVE : CGAL::POSITIVE);
  // A direction orients what the first component cannot.
  system.set_orientation({Q(0), Q(1), Q(-3)});
  Interval::Protector protector;
  const std::vector<Interval> box(3, Interval(-1e-12, 1e-12));
  const auto s = N_space_surface_3(system).unoriented(box);
  ASSERT_TRUE(s && s->is_oriented());
  EXPECT_EQ(s->ask(Mean_sign()), s->one_side().trace_numerator().inf() > 0
                                   ? CGAL::Uncertain<CGAL::Sign>(CGAL::POSITIVE)
                                   : CGAL::Uncertain<CGAL::Sign>(CGAL::NEGATIVE));
}

TEST(Answer_union, is_what_both_answers_imply)
{
  using Sign = CGAL::Uncertain<CGAL::Sign>;
  using Union = Answer_union<Result<Sign>>;
  const Result<Sign> plus(CGAL::POSITIVE), zero(CGAL::ZERO);
  const Result<Sign> singular(Refusal(Refusal_code::SINGULAR_POINT, "one"));
  const Result<Sign> pole(Refusal(Refusal_code::POLE, "two"));
  EXPECT_TRUE(CGAL::certainly(*Union::of(plus, plus) == CGAL::POSITIVE));
  EXPECT_EQ(Union::of(plus, zero)->inf(), CGAL::ZERO);
  EXPECT_EQ(Union::of(plus, zero)->sup(), CGAL::POSITIVE);
  EXPECT_EQ(Union::of(pole, pole).refusal().code(), Refusal_code::POLE);
  EXPECT_EQ(Union::of(pole, singular).refusal().code(), Refusal_code::UNDECIDED);
  EXPECT_EQ(Union::of(plus, singular).refusal().code(), Refusal_code::UNDECIDED);
}

} // namespace
