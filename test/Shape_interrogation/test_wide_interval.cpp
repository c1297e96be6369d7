// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Intervals of many bits: they contain the exact values, are as narrow as their bits, and say when
// they do not know.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Number_types/Wide_interval.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Wide = Wide_interval;

bool contains(const Wide& x, const Q& value)
{
  return !CGAL::certainly_not((x - Wide(value)).sign() == CGAL::ZERO);
}

TEST(Wide_interval, contains_the_exact_value_in_every_precision)
{
  Random random(20261201);
  for (int bits : {53, 106, 500})
  {
    const Wide_precision precision(bits);
    EXPECT_EQ(Wide_precision::bits(), bits);
    for (int i = 0; i < 200; ++i)
    {
      const Q a = random.rational(), b = random.nonzero_rational(), c = random.rational();
      Wide x(a);
      x += Wide(b) * Wide(c);
      x -= Wide(c) / Wide(b);
      x *= -Wide(b);
      x /= Wide(b);
      const Q exact = -(a + b * c - c / b);
      EXPECT_TRUE(contains(x, exact)) << x;
      EXPECT_FALSE(contains(x, exact + Q(1) / 1000000)) << x;
      // Narrow: at most a few units in the last of its bits.
      Q bound(1000);
      for (int k = 0; k < bits; ++k)
        bound /= 2;
      EXPECT_TRUE(CGAL::certainly((Wide(bound) - x.width()).sign() == CGAL::POSITIVE));
    }
  }
  EXPECT_EQ(Wide_precision::bits(), 106); // as before
}

TEST(Wide_interval, decides_what_it_can)
{
  const Wide zero = Wide(1) - Wide(1), around = Wide(Q(1) / 3) - Wide(Q(1) / 3);
  EXPECT_TRUE(CGAL::certainly(zero.sign() == CGAL::ZERO));
  EXPECT_FALSE(around.sign().is_certain());
  EXPECT_FALSE(is_zero_decision(around).is_certain());
  EXPECT_TRUE(CGAL::certainly(sign_decision(around - 1) == CGAL::NEGATIVE));
  EXPECT_FALSE((Wide(1) / around).is_finite());
  EXPECT_FALSE((Wide(0) * (Wide(1) / around)).sign().inf() == CGAL::POSITIVE);
  EXPECT_FALSE(Wide(std::nan("")).sign().is_certain());
  // A twin beside zero, which 53 bits do not tell from it.
  const Q third = Q(1) / 3, twin = third + Q(1) / Q(1e30);
  EXPECT_TRUE(CGAL::certainly((Wide(twin) - Wide(third)).sign() == CGAL::POSITIVE));
  const Wide_precision precision(53);
  EXPECT_FALSE((Wide(twin) - Wide(third)).sign().is_certain());
}

TEST(Wide_interval, converts)
{
  const Wide third(Q(1) / 3);
  EXPECT_EQ(number_cast<double>(third), 1. / 3);
  const auto interval = number_cast<CGAL::Interval_nt<false>>(third);
  EXPECT_TRUE(Q(interval.inf()) < Q(1) / 3 && Q(interval.sup()) > Q(1) / 3);
  EXPECT_LT(interval.sup() - interval.inf(), 1e-16);
  EXPECT_TRUE(contains(Wide(interval), Q(1) / 3));
  EXPECT_TRUE(contains(number_cast<Wide>(Q(22) / 7), Q(22) / 7));
  const Quadratic_field root(Q(1), Q(2), Q(17)); // 1 + 2 sqrt(17)
  const Wide x = (number_cast<Wide>(root) - 1) / 2;
  EXPECT_TRUE(contains(x * x, Q(17)));
  EXPECT_EQ(third.middle().width().ends(), (std::pair<double, double>(0, 0)));
  std::ostringstream text;
  text << Wide(2);
  EXPECT_EQ(text.str(), "[2;2]");
}

// What has no bounds or no value is the whole line, and no number that is none comes out of it.
TEST(Wide_interval, is_unbounded_where_it_has_to_be)
{
  const double infinity = HUGE_VAL;
  const std::pair<double, double> line(-infinity, infinity);
  for (double x : {infinity, -infinity, std::nan("")})
  {
    EXPECT_EQ(Wide(x).ends(), line);
    EXPECT_EQ((Wide(x) - Wide(x)).ends(), line);
    EXPECT_EQ(internal::nonnegative_part(Wide(x)).ends(), (std::pair<double, double>(0, infinity)));
    EXPECT_EQ(number_cast<double>(Wide(x)), 0);
    EXPECT_EQ(Wide(x).middle().ends(), (std::pair<double, double>(0, 0)));
    Wide one(1);
    EXPECT_TRUE(one.intersect(Wide(x) - Wide(x)));
    EXPECT_EQ(one.ends(), (std::pair<double, double>(1, 1)));
  }
  const Wide ray(CGAL::Interval_nt<false>(1, infinity));
  EXPECT_EQ(ray.middle().ends(), (std::pair<double, double>(1, 1)));
  EXPECT_TRUE(std::isfinite(number_cast<double>(ray)));
  EXPECT_TRUE(std::isfinite(number_cast<double>(Elementary_functions<Wide>::exp(Wide(1e300)))));
  EXPECT_EQ((ray - ray).ends(), line);
}

TEST(Wide_interval, has_its_middle_inside)
{
  const auto third = [] {
    const Wide_precision precision(300);
    return Wide(Q(1) / 3);
  }();
  const Wide_precision precision(20);
  Wide middle = third.middle();
  const Wide_precision wide(400);
  EXPECT_TRUE(middle.intersect(third));
}

TEST(Wide_interval, unites_and_intersects)
{
  Wide x = hull(Wide(1), Wide(3));
  EXPECT_EQ(x.ends(), (std::pair<double, double>(1, 3)));
  EXPECT_TRUE(x.intersect(hull(Wide(2), Wide(5))));
  EXPECT_EQ(x.ends(), (std::pair<double, double>(2, 3)));
  EXPECT_FALSE(x.intersect(Wide(7)));
  const Wide u = Answer_union<Wide>::of(Wide(-1), Wide(1));
  EXPECT_FALSE(u.sign().is_certain());
  EXPECT_EQ(internal::nonnegative_part(u).ends(), (std::pair<double, double>(0, 1)));
  EXPECT_EQ(internal::nonnegative_part(Wide(-1)).ends(), (std::pair<double, double>(0, 0)));
}

TEST(Wide_interval, keeps_its_bits_when_copied)
{
  Wide fine;
  {
    const Wide_precision precision(400);
    fine = Wide(Q(1) / 3);
  }
  Wide copy = fine, assigned(7);
  assigned = fine;
  const Wide_precision precision(400);
  const Wide difference = assigned - copy;
  EXPECT_LT(difference.ends().second, 1e-110);
  const Wide moved = std::move(copy);
  EXPECT_TRUE(contains(moved, Q(1) / 3));
}

TEST(Wide_interval, has_functions)
{
  using F = Elementary_functions<Wide>;
  const Wide x(Q(1) / 3);
  EXPECT_TRUE(contains(F::exp(F::log(x)), Q(1) / 3));
  EXPECT_TRUE(contains(F::sqrt(x) * F::sqrt(x), Q(1) / 3));
  EXPECT_TRUE(contains(x.apply(mpfi_inv), Q(3)));
  EXPECT_TRUE(contains(F::sin(x) * F::sin(x) + F::cos(x) * F::cos(x), Q(1)));
  EXPECT_TRUE(contains(F::tan(F::atan(x)), Q(1) / 3));
  EXPECT_TRUE(contains(F::asin(x) + F::acos(x) - F::pi() / 2, Q(0)));
  EXPECT_THROW(F::sqrt(Wide(-1)), Domain_error);
  EXPECT_THROW(F::log(Wide(0)), Domain_error);
  EXPECT_THROW(F::acos(Wide(2)), Domain_error);
  EXPECT_FALSE(F::sqrt(hull(Wide(-1), Wide(1))).is_finite());
  EXPECT_FALSE(F::asin(hull(Wide(0), Wide(2))).is_finite());
}

} // namespace
