// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Number types: conversions, the quadratic field, elementary functions of intervals. Truth comes
// from exact comparisons, from CORE::Expr, and from MPFR with 300 bits.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Number_types/reduced_square_root.h>

#include <gtest/gtest.h>

#include <mpfr.h>

#include <cfenv>
#include <cmath>
#include <limits>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using Interval = CGAL::Interval_nt<false>;
using Real = CORE::Expr;
using Field = Quadratic_field;

const double infinity = std::numeric_limits<double>::infinity();
const double smallest = std::numeric_limits<double>::denorm_min();
const double largest = std::numeric_limits<double>::max();

template <class Exact>
bool contains(const Interval& x, const Exact& value)
{
  return (std::isinf(x.inf()) || Exact(x.inf()) <= value) &&
         (std::isinf(x.sup()) || Exact(x.sup()) >= value);
}

Q power_of_two(int n)
{
  Q x(1);
  for (int i = 0; i < std::abs(n); ++i)
    x = x * 2;
  return n < 0 ? Q(1 / x) : x;
}

// Sets a rounding mode for a scope.
class Rounding
{
public:
  explicit Rounding(int mode) : m_old(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(m_old); }

private:
  int m_old;
};

// --- Conversions ---------------------------------------------------------------------------------

// No double is nearer to x than d.
template <class Exact>
void expect_nearest(const Exact& x, double d)
{
  ASSERT_TRUE(std::isfinite(d));
  const auto distance = [&](double e) { return Exact(CGAL::abs(Exact(x - Exact(e)))); };
  for (const double other : {std::nextafter(d, -infinity), std::nextafter(d, infinity)})
    if (std::isfinite(other))
    {
      EXPECT_LE(distance(d), distance(other)) << d;
    }
}

TEST(Number_cast, rational_to_nearest_double)
{
  Random random(11);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
  {
    const Rounding rounding(mode);
    for (int i = 0; i < 400; ++i)
    {
      Q x = random.rational(1 << 30) * power_of_two(random.integer(-1100, 900));
      x = x + random.rational(1 << 30) * power_of_two(random.integer(-1100, 900));
      expect_nearest(x, number_cast<double>(x));
    }
  }
}

TEST(Number_cast, rational_between_two_doubles)
{
  for (const double d : {1.0, -1.0, 0.1, 1e300, smallest, 3 * smallest, 2.2250738585072014e-308})
  {
    const double next = std::nextafter(d, infinity);
    const Q gap = Q(next) - Q(d);
    for (const int k : {1, 3, 4, 5, 7})
    {
      const Q x = Q(d) + gap * k / 8;
      const double nearest = number_cast<double>(x);
      EXPECT_TRUE(nearest == d || nearest == next);
      expect_nearest(x, nearest); // halfway either will do
    }
  }
}

TEST(Number_cast, rational_beyond_the_doubles)
{
  EXPECT_EQ(number_cast<double>(Q(power_of_two(-1200))), 0);
  EXPECT_EQ(number_cast<double>(Q(-power_of_two(-1200))), 0);
  EXPECT_EQ(number_cast<double>(Q(power_of_two(1200))), infinity);
  EXPECT_EQ(number_cast<double>(Q(-power_of_two(1200))), -infinity);
  EXPECT_EQ(number_cast<double>(Q(Q(largest))), largest);
  EXPECT_EQ(number_cast<double>(Q(power_of_two(-1074))), smallest);
  EXPECT_EQ(number_cast<double>(Q(power_of_two(-1074) * 3 / 4)), smallest);
  EXPECT_EQ(number_cast<double>(Q(power_of_two(-1074) / 4)), 0);
}

TEST(Number_cast, doubles_are_exact)
{
  for (const double d : {0.0, 0.1, -1e-300, smallest, largest, 1.0 / 3})
  {
    EXPECT_EQ(number_cast<double>(number_cast<Q>(d)), d);
    EXPECT_EQ(number_cast<Field>(d), Field(Q(d)));
    EXPECT_TRUE(number_cast<Interval>(d).is_point());
    EXPECT_EQ(number_cast<Interval>(d).inf(), d);
  }
}

TEST(Number_cast, numbers_that_are_not_finite_have_no_enclosure)
{
  for (const double d : {infinity, -infinity, std::nan("")})
  {
    EXPECT_THROW(number_cast<Interval>(d), Conversion_error);
    EXPECT_THROW(number_cast<CGAL::Interval_nt<true>>(d), Conversion_error);
    EXPECT_THROW(number_cast<Interval>(static_cast<float>(d)), Conversion_error);
  }
}

// Quotients of integers that are doubles: a point or two neighbours, in every rounding mode.
TEST(Number_cast, interval_of_small_quotient_is_narrowest)
{
  Random random(18);
  int points = 0;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (int i = 0; i < 2000; ++i)
    {
      const double n = std::floor(random.real(-std::ldexp(1, i % 54), std::ldexp(1, i % 54)));
      const double d = 1 + std::floor(random.real(0, std::ldexp(1, i / 54 % 53)));
      const Q x = Q(n) / Q(d);
      Interval y;
      {
        const Rounding rounding(mode);
        y = number_cast<Interval>(x);
      }
      ASSERT_TRUE(contains(y, x)) << y;
      points += y.is_point();
      EXPECT_EQ(y.is_point(), Q(y.inf()) == x);
      EXPECT_LE(y.sup(), std::nextafter(y.inf(), infinity));
    }
  EXPECT_GE(points, 200);
}

TEST(Number_cast, interval_of_rational_is_tight)
{
  Random random(12);
  for (const int mode : {FE_TONEAREST, FE_UPWARD})
  {
    const Rounding rounding(mode);
    for (int i = 0; i < 300; ++i)
    {
      const Q x = random.rational(1 << 30) * power_of_two(random.integer(-1100, 1000));
      const Interval y = number_cast<Interval>(x);
      ASSERT_TRUE(contains(y, x)) << y;
      EXPECT_LE(std::nextafter(std::nextafter(y.inf(), infinity), infinity), infinity);
      EXPECT_GE(std::nextafter(std::nextafter(y.inf(), infinity), infinity), y.sup()) << y;
    }
  }
  EXPECT_TRUE(contains(number_cast<Interval>(Q(power_of_two(1200))), Q(power_of_two(1200))));
  EXPECT_TRUE(contains(number_cast<Interval>(Q(power_of_two(-1200))), Q(power_of_two(-1200))));
}

TEST(Number_cast, wide_integers)
{
  const long wide = (1l << 53) + 1;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD})
  {
    const Rounding rounding(mode);
    const Interval x = number_cast<Interval>(wide), y = number_cast<Interval>(-wide);
    EXPECT_FALSE(x.is_point());
    EXPECT_TRUE(contains(x, Q(wide)));
    EXPECT_TRUE(contains(y, Q(-wide)));
    EXPECT_TRUE(contains(number_cast<Interval>(static_cast<unsigned long long>(wide)), Q(wide)));
    EXPECT_TRUE(number_cast<Interval>(7).is_point());
  }
}

template <class Integer>
void expect_exact(Integer x, const Q& value)
{
  EXPECT_EQ(number_cast<Q>(x), value);
  EXPECT_EQ(Field(x), Field(value));
  EXPECT_EQ(Field(Q(1), Q(1), Q(2)) * x, Field(value, value, Q(2))) << "without a cast";
}

TEST(Number_cast, every_built_in_integer)
{
  const Q two_to_63 = power_of_two(63);
  expect_exact(std::numeric_limits<long long>::min(), Q(-two_to_63));
  expect_exact(std::numeric_limits<long long>::max(), Q(two_to_63 - 1));
  expect_exact(std::numeric_limits<unsigned long long>::max(), Q(2 * two_to_63 - 1));
  expect_exact(-((1ll << 53) + 1), Q(-power_of_two(53) - 1));
  expect_exact(std::size_t(5000000000), Q(Q(50000) * 100000));
  expect_exact(std::numeric_limits<unsigned>::max(), Q(power_of_two(32) - 1));
  expect_exact(std::numeric_limits<int>::min(), Q(-power_of_two(31)));
  expect_exact(short(-7), Q(-7));
}

TEST(Number_cast, exact_reals)
{
  Random random(13);
  for (int i = 0; i < 50; ++i)
  {
    const Q x = random.rational(1 << 20), y = random.rational(1 << 20);
    const Real a = number_cast<Real>(x), b = number_cast<Real>(y);
    EXPECT_EQ(a * b, number_cast<Real>(Q(x * y)));
    EXPECT_EQ(CGAL::compare(a, b), CGAL::compare(x, y));
    const Field z(x, y, Q(7));
    const Real c = number_cast<Real>(z);
    EXPECT_EQ(c, a + b * CGAL::sqrt(Real(7)));
    EXPECT_TRUE(contains(number_cast<Interval>(z), c));
    expect_nearest(z, number_cast<double>(z));
  }
}

TEST(Number_cast, middle_of_an_interval)
{
  EXPECT_EQ(number_cast<double>(Interval(1, 3)), 2);
  EXPECT_EQ(number_cast<double>(Interval(-1, 1)), 0);
  EXPECT_EQ(number_cast<double>(Interval(smallest)), smallest);
  EXPECT_EQ(number_cast<double>(Interval(largest)), largest);
}

TEST(Number_cast, middle_of_the_widest_intervals)
{
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
  {
    const Rounding rounding(mode);
    EXPECT_EQ(number_cast<double>(Interval::largest()), 0);
    EXPECT_EQ(number_cast<double>(Interval(-largest, largest)), 0);
    EXPECT_EQ(number_cast<double>(Interval(0, infinity)), largest / 2);
    EXPECT_EQ(number_cast<double>(Interval(-infinity, 0)), -largest / 2);
    EXPECT_LE(number_cast<double>(Interval(1, std::nextafter(1, 2))), std::nextafter(1, 2));
    EXPECT_NEAR(number_cast<double>(Interval(-1e308, 1.5e308)), 0.25e308, 1e293);
  }
}

TEST(Number_cast, whole_arguments)
{
  const std::array<Q, 2> a{Q(1) / 4, Q(3)};
  EXPECT_EQ(cast_argument<double>(a), (std::array<double, 2>{0.25, 3}));
  const std::vector<std::array<Q, 2>> v{a, a};
  EXPECT_EQ(cast_argument<double>(v)[1][0], 0.25);
  const std::string other = "passed through";
  EXPECT_EQ(&cast_argument<double>(other), &other);
}

// --- The quadratic field -------------------------------------------------------------------------

Field random_field_number(Random& random, const Q& root)
{
  return Field(random.rational(), random.rational(), root);
}

TEST(Quadratic_field, arithmetic_is_that_of_exact_reals)
{
  Random random(21);
  for (const int root : {2, 3, 17, 1000003})
    for (int i = 0; i < 40; ++i)
    {
      Field x = random_field_number(random, Q(root));
      Real r = number_cast<Real>(x);
      for (int step = 0; step < 6; ++step)
      {
        const Field y = random_field_number(random, Q(root));
        const Real s = number_cast<Real>(y);
        switch (random.integer(0, 3))
        {
        case 0: x = x + y; r = r + s; break;
        case 1: x = x - y; r = r - s; break;
        case 2: x = x * y; r = r * s; break;
        default:
          if (y == Field(0))
            continue;
          x = x / y;
          r = r / s;
        }
      }
      EXPECT_EQ(number_cast<Real>(x), r);
      EXPECT_EQ(x.sign(), CGAL::sign(r));
      const Field y = random_field_number(random, Q(root));
      EXPECT_EQ(x.compare(y), CGAL::compare(r, number_cast<Real>(y)));
      EXPECT_EQ(x < y, r < number_cast<Real>(y));
    }
}

TEST(Quadratic_field, rational_numbers_forget_the_root)
{
  const Field a(Q(1), Q(2), Q(5)), b(Q(1), Q(-2), Q(5)), c(Q(0), Q(1), Q(3));
  EXPECT_TRUE((a + b).is_rational());
  EXPECT_EQ((a * b).rational_part(), Q(-19));
  EXPECT_NO_THROW((a * b) * c);
  EXPECT_NO_THROW((a - a) + c);
  EXPECT_EQ(Field(Q(3), Q(0), Q(5)) + c, Field(Q(3), Q(1), Q(3)));
}

TEST(Quadratic_field, different_roots_are_refused)
{
  const Field a(Q(1), Q(1), Q(2)), b(Q(1), Q(1), Q(3));
  Field x = a;
  EXPECT_THROW(x += b, Mixed_roots_error);
  EXPECT_THROW(x -= b, Mixed_roots_error);
  EXPECT_THROW(x *= b, Mixed_roots_error);
  EXPECT_THROW(x /= b, Mixed_roots_error);
  EXPECT_THROW(a.compare(b), Mixed_roots_error);
  EXPECT_THROW(static_cast<void>(a == b), Mixed_roots_error);
  EXPECT_THROW(static_cast<void>(a < b), Mixed_roots_error);
  EXPECT_EQ(x, a) << "a refused operation changes nothing";
}

TEST(Quadratic_field, division_by_zero)
{
  const Field zero(0), a(Q(1), Q(1), Q(2));
  EXPECT_THROW(a / zero, Division_by_zero_error);
  EXPECT_THROW(a / (a - a), Division_by_zero_error);
}

// A root that is rational is no root: 2 - sqrt(4) is zero, and 2 + sqrt(4) has an inverse.
TEST(Quadratic_field, square_under_the_root)
{
  EXPECT_EQ(Field(Q(2), Q(-1), Q(4)), Field(0));
  EXPECT_THROW(Field(1) / Field(Q(2), Q(-1), Q(4)), Division_by_zero_error);
  EXPECT_EQ(Field(1) / Field(Q(2), Q(1), Q(4)), Field(Q(Q(1) / 4)));
  EXPECT_EQ(Field(Q(0), Q(3), Q(Q(4) / 9)), Field(2));
  EXPECT_NO_THROW(Field(Q(2), Q(1), Q(4)) + Field(Q(2), Q(1), Q(3)));
}

TEST(Quadratic_field, square_roots_are_reduced)
{
  const auto root = [](const Q& x) { return Elementary_functions<Field>::sqrt(Field(x)); };
  EXPECT_EQ(root(Q(Q(9) / 4)), Field(Q(Q(3) / 2)));
  EXPECT_EQ(root(Q(0)), Field(0));
  EXPECT_EQ(root(Q(8)), Field(Q(0), Q(2), Q(2)));
  EXPECT_EQ(root(Q(Q(1) / 2)), Field(Q(0), Q(Q(1) / 2), Q(2)));
  EXPECT_EQ(root(Q(8)) * root(Q(2)), Field(4)) << "one field";
  EXPECT_EQ(root(Q(Q(17) / 4)) + root(Q(17 * 9)), Field(Q(0), Q(Q(7) / 2), Q(17)));
  EXPECT_THROW(root(Q(-1)), Domain_error);
  Random random(22);
  for (int i = 0; i < 60; ++i)
  {
    const Q x = Q(random.integer(1, 100000)) / random.integer(1, 100000);
    const Field r = root(x);
    EXPECT_EQ(r * r, Field(x));
    EXPECT_EQ(r.sign(), CGAL::POSITIVE);
  }
}

TEST(Quadratic_field, square_roots_in_the_field)
{
  Random random(23);
  const auto root = [](const Field& x) { return Elementary_functions<Field>::sqrt(x); };
  for (int i = 0; i < 60; ++i)
  {
    const Field x = random_field_number(random, Q(17));
    if (x.is_rational() || CGAL::is_zero(x.rational_part()))
      continue;
    EXPECT_EQ(root(x * x), x.sign() == CGAL::NEGATIVE ? -x : x);
  }
  EXPECT_THROW(root(Field(Q(425), Q(-96), Q(17))), Not_algebraic_error);
  EXPECT_THROW(root(Field(Q(1), Q(1), Q(17))), Not_algebraic_error);
  EXPECT_THROW(root(Field(Q(1), Q(-1), Q(17))), Domain_error);
}

TEST(Reduced_square_root, factors_and_proof)
{
  EXPECT_EQ(reduced_square_root(Q(0)).factor, Q(0));
  const Q large_prime = 1000003; // its square is found, as all that is left is a square
  const Reduced_square_root a = reduced_square_root(large_prime * large_prime);
  EXPECT_EQ(a.factor, large_prime);
  EXPECT_EQ(a.radicand, Q(1));
  // 2 p^2 hides nothing, 7 p^2 q with two large primes may.
  const Reduced_square_root b = reduced_square_root(2 * large_prime * large_prime);
  EXPECT_EQ(b.factor, large_prime);
  EXPECT_EQ(b.radicand, Q(2));
  const Reduced_square_root c = reduced_square_root(large_prime * large_prime * 1000033);
  EXPECT_EQ(Q(c.factor * c.factor * c.radicand), Q(large_prime * large_prime * 1000033));
  EXPECT_FALSE(c.square_free);
  EXPECT_TRUE(reduced_square_root(Q(Q(12) / 35)).square_free);
}

// --- Elementary functions ------------------------------------------------------------------------

using Mpfr_function = int (*)(mpfr_t, mpfr_srcptr, mpfr_rnd_t);
using Interval_function = Interval (*)(const Interval&);

// The doubles around the value of a function, from MPFR.
Interval truth(Mpfr_function f, double x)
{
  mpfr_t value;
  mpfr_init2(value, 300);
  mpfr_set_d(value, x, MPFR_RNDN);
  f(value, value, MPFR_RNDN);
  const double lo = mpfr_get_d(value, MPFR_RNDD), hi = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return Interval(lo, hi);
}

struct Function
{
  const char* name;
  Mpfr_function mpfr;
  Interval_function interval;
  double low, high; // where it is tried
};

using E = Elementary_functions<Interval>;
const Function functions[] = {{"sqrt", mpfr_sqrt, E::sqrt, 0, 1e10},
                              {"exp", mpfr_exp, E::exp, -800, 800},
                              {"log", mpfr_log, E::log, 1e-9, 1e6},
                              {"sin", mpfr_sin, E::sin, -1e6, 1e6},
                              {"cos", mpfr_cos, E::cos, -30, 30},
                              {"tan", mpfr_tan, E::tan, -30, 30},
                              {"asin", mpfr_asin, E::asin, -1, 1},
                              {"acos", mpfr_acos, E::acos, -1, 1},
                              {"atan", mpfr_atan, E::atan, -1e3, 1e3}};

bool contains_interval(const Interval& x, const Interval& y)
{
  return x.inf() <= y.inf() && y.sup() <= x.sup();
}

TEST(Interval_functions, points)
{
  Random random(31);
  const Interval::Protector protector; // must not disturb MPFI
  for (const Function& f : functions)
    for (int i = 0; i < 200; ++i)
    {
      const double x = random.real(f.low, f.high);
      const Interval y = f.interval(Interval(x)), t = truth(f.mpfr, x);
      EXPECT_TRUE(contains_interval(y, t)) << f.name << "(" << x << ") in " << y;
      EXPECT_TRUE(y.sup() <= std::nextafter(t.sup(), infinity) &&
                  y.inf() >= std::nextafter(t.inf(), -infinity))
        << f.name << "(" << x << ") is not tight: " << y;
    }
}

TEST(Interval_functions, wide_arguments_contain_all_values)
{
  Random random(32);
  for (const Function& f : functions)
    for (int i = 0; i < 50; ++i)
    {
      const double a = random.real(f.low, f.high), b = random.real(f.low, f.high);
      const double lo = std::fmin(a, b), hi = std::fmin(std::fmax(a, b), lo + 8);
      const Interval y = f.interval(Interval(lo, hi));
      for (int k = 0; k <= 20; ++k)
      {
        const double x = k == 20 ? hi : std::fmin(hi, lo + (hi - lo) * k / 20);
        EXPECT_TRUE(contains_interval(y, truth(f.mpfr, x))) << f.name << "(" << x << ")";
      }
    }
}

TEST(Interval_functions, extrema_and_poles)
{
  EXPECT_EQ(E::sin(Interval(1, 2)).sup(), 1);
  EXPECT_EQ(E::sin(Interval(4, 5)).inf(), -1);
  EXPECT_EQ(E::cos(Interval(-0.5, 0.25)).sup(), 1);
  EXPECT_EQ(E::cos(Interval(3, 3.5)).inf(), -1);
  const Interval all = E::sin(Interval(-10, 10));
  EXPECT_TRUE(all.inf() == -1 && all.sup() == 1);
  const Interval pole = E::tan(Interval(1.5, 1.6));
  EXPECT_TRUE(pole.inf() < -1e300 && pole.sup() > 1e300) << pole;
  EXPECT_EQ(E::exp(Interval(1000)).sup(), infinity);
  EXPECT_GE(E::exp(Interval(1000)).inf(), 1e308);
  EXPECT_EQ(E::exp(Interval(-2000)).inf(), 0);
  EXPECT_GT(E::exp(Interval(-2000)).sup(), 0);
  EXPECT_TRUE(contains(E::log(Interval(0, 1)), Q(-100000)));
  EXPECT_TRUE(contains_interval(E::sqrt(Interval(0, 4)), Interval(0, 2)));
  EXPECT_TRUE(contains_interval(E::sqrt(Interval(-1e-20, 4)), Interval(0, 2)));
  EXPECT_TRUE(contains_interval(E::acos(Interval(-1, 1.0000001)), Interval(0, 3.1415926)));
}

TEST(Interval_functions, pi_is_the_pair_of_doubles_around_it)
{
  mpfr_t pi;
  mpfr_init2(pi, 300);
  mpfr_const_pi(pi, MPFR_RNDN);
  EXPECT_EQ(E::pi().inf(), mpfr_get_d(pi, MPFR_RNDD));
  EXPECT_EQ(E::pi().sup(), mpfr_get_d(pi, MPFR_RNDU));
  EXPECT_EQ(Elementary_functions<double>::pi(), mpfr_get_d(pi, MPFR_RNDN));
  mpfr_clear(pi);
}

TEST(Interval_functions, roots_contain_exact_reals)
{
  Random random(33);
  for (int i = 0; i < 60; ++i)
  {
    const Q x = CGAL::abs(random.rational(1 << 20));
    const Interval y = E::sqrt(number_cast<Interval>(x));
    EXPECT_TRUE(contains(y, Real(CGAL::sqrt(number_cast<Real>(x)))));
    EXPECT_EQ(Elementary_functions<Real>::sqrt(number_cast<Real>(x)),
              CGAL::sqrt(number_cast<Real>(x)));
  }
}

TEST(Elementary_functions, domains)
{
  EXPECT_THROW(E::sqrt(Interval(-2, -1)), Domain_error);
  EXPECT_THROW(E::log(Interval(-2, -1)), Domain_error);
  EXPECT_THROW(E::log(Interval(0)), Domain_error);
  EXPECT_THROW(E::asin(Interval(1.5, 2)), Domain_error);
  EXPECT_THROW(E::acos(Interval(-2, -1.5)), Domain_error);
  using D = Elementary_functions<double>;
  EXPECT_THROW(D::sqrt(-1), Domain_error);
  EXPECT_THROW(D::log(0), Domain_error);
  EXPECT_THROW(D::asin(1.0000001), Domain_error);
  EXPECT_THROW(D::acos(-1.0000001), Domain_error);
  EXPECT_THROW(Elementary_functions<Real>::sqrt(Real(-1)), Domain_error);
}

TEST(Elementary_functions, exact_fields_have_rational_roots_only)
{
  using F = Elementary_functions<Q>;
  EXPECT_EQ(F::sqrt(Q(Q(49) / 25)), Q(Q(7) / 5));
  EXPECT_EQ(F::sqrt(Q(0)), Q(0));
  EXPECT_THROW(F::sqrt(Q(2)), Not_algebraic_error);
  EXPECT_THROW(F::sqrt(Q(-4)), Domain_error);
  EXPECT_THROW(F::exp(Q(1)), Not_algebraic_error);
  EXPECT_THROW(F::pi(), Not_algebraic_error);
  EXPECT_THROW(Elementary_functions<Field>::sin(Field(1)), Not_algebraic_error);
  EXPECT_THROW(Elementary_functions<Real>::atan(Real(1)), Not_algebraic_error);
}

} // namespace
