// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The filter: which stage decides, that decisions are those of exact arithmetic whatever the
// rounding mode and the range, that the rounding mode is restored on every path, and threads.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Shape_interrogation;
using testing_shapes::Q;
using testing_shapes::Random;
using internal::Exact_ring;
using internal::Magnitude;
using Interval = CGAL::Interval_nt<false>;
using Point = Coordinates<double, 3>;

const int rounding_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

// The mode in which doubles are in fact computed; std::fegetround() may look at another unit.
int effective_rounding()
{
  const volatile double one = 1, tiny = 1e-30;
  if (one + tiny > 1)
    return FE_UPWARD;
  if (one - tiny == 1)
    return FE_TONEAREST;
  return -one - tiny < -1 ? FE_DOWNWARD : FE_TOWARDZERO;
}

// Sets a rounding mode for a scope.
class Rounding
{
public:
  explicit Rounding(int mode) : m_old(effective_rounding()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(m_old); }

private:
  int m_old;
};

template <class Question, class Function, class Query>
auto exactly(const Function& f, const Query& p)
{
  return *Shape_chain<Question>()(Implicit_surface_3<Function>(f), cast_argument<Q>(p));
}

Point random_point(Random& random, double size = 2)
{
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

// --- Functions -----------------------------------------------------------------------------------

struct Torus
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT r = x * x + y * y;
    const NT s = r + z * z + NT(3);
    return s * s - NT(16) * r;
  }
};

struct Sphere // every point of every level set is umbilic
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return x * x + y * y + z * z - NT(9);
  }
};

struct Cylinder // K = 0
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT s = x + NT(2) * y + z, t = y - NT(3) * z;
    return s * s * s + NT(3) * s * t + NT(5) * t * t - NT(1);
  }
};

struct Plane // planar everywhere, by cancellation of large terms
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT s = x + y + z;
    return s * s * s - s * (x * x + y * y + z * z) - NT(2) * s * (x * y + y * z + z * x) + s;
  }
};

struct Sphere_with_third // constants that no double has
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT third = NT(1) / NT(3);
    return third * x * x + third * y * y + third * z * z - NT(1) / NT(7);
  }
};

struct Sphere_by_division // 1/r^2: divides by what depends on the point
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return NT(1) / (x * x + y * y + z * z) - NT(2);
  }
};

struct Sphere_by_logarithm
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return log(x * x + y * y + z * z);
  }
};

struct Waves
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return z - sin(x) * cos(y) + exp(x * y);
  }
};

// Ellipsoids of rotation that differ from a sphere by almost nothing.
struct Almost_sphere
{
  double c;

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    return x * x + y * y + number_cast<NT>(c) * z * z - NT(9);
  }
};

// --- The bounds of patches -----------------------------------------------------------------------

// A patch somewhere, in any size, of any degree, with doubles that have all their bits.
Bezier_surface_3<double> random_patch(Random& random, bool rational)
{
  const double size = std::ldexp(1., random.integer(-40, 40));
  const double offset = size * std::ldexp(random.real(-1, 1), random.integer(-10, 20));
  const int m = random.integer(1, 9), n = random.integer(1, 5);
  std::vector<std::vector<Point>> points(m + 1, std::vector<Point>(n + 1));
  std::vector<std::vector<double>> weights;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
    {
      points[i][j] = random_point(random, size);
      points[i][j][random.integer(0, 2)] += offset;
    }
  if (rational)
    for (int i = 0; i <= m; ++i)
    {
      weights.emplace_back();
      for (int j = 0; j <= n; ++j)
        weights.back().push_back(random.real(0.5, 2));
    }
  return Bezier_surface_3<double>(points, weights);
}

void expect_enclosed(const Q& exact, const Magnitude& x)
{
  const Q error = exact - Q(x.value());
  EXPECT_LE(CGAL::abs(error), Q(x.error())) << x;
}

TEST(Filter_magnitude, bounds_the_error_of_patches)
{
  Random random(20260901);
  for (int i = 0; i < 200; ++i)
  {
    const auto patch = random_patch(random, i % 2 == 1);
    const Coordinates<double, 2> uv{random.real(0, 1), random.real(0, 1)};
    const auto exact = patch.cast<Q>().shape_at_origin(cast_argument<Q>(uv));
    const auto quick = patch.cast<Magnitude>().shape_at_origin(cast_argument<Magnitude>(uv));
    ASSERT_TRUE(exact);
    if (!quick)
      continue; // an offset that leaves no digits of the derivatives
    for (int d = 0; d < 3; ++d)
      expect_enclosed(exact->normal()[d], quick->normal()[d]);
    expect_enclosed(exact->normal_squared_length(), quick->normal_squared_length());
    expect_enclosed(exact->trace_numerator(), quick->trace_numerator());
    expect_enclosed(exact->minors_numerator(), quick->minors_numerator());
    expect_enclosed(umbilic_discriminant(*exact), umbilic_discriminant(*quick));
  }
}

TEST(Filter_magnitude, decides_on_ordinary_patches)
{
  Random random(20260902);
  Filter_statistics statistics;
  for (int i = 0; i < 100; ++i)
  {
    std::vector<std::vector<Point>> points(4, std::vector<Point>(4));
    for (int u = 0; u < 4; ++u)
      for (int v = 0; v < 4; ++v)
        points[u][v] = {u + random.real(-.2, .2), v + random.real(-.2, .2), random.real(-1, 1)};
    const Interrogation_3 patch{Bezier_surface_3<double>(points), &statistics};
    EXPECT_FALSE(*patch.is_umbilic(Coordinates<double, 2>{random.real(0, 1), random.real(0, 1)}));
  }
  EXPECT_EQ(statistics.magnitude, 100u);
}

// A rational patch: the ring needs no division, so that no rationals are needed either.
TEST(Filter_stages, rational_patches_reach_the_exact_ring)
{
  // z = 1 at every point: planar, but with weights and in numbers that round.
  std::vector<std::vector<Point>> points(3, std::vector<Point>(3));
  std::vector<std::vector<double>> weights(3, std::vector<double>(3));
  Random random(20260903);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      points[i][j] = {i + random.real(0, .3), j + random.real(0, .3), 1};
      weights[i][j] = random.real(.5, 2);
    }
  Filter_statistics statistics;
  const Interrogation_3 patch{Bezier_surface_3<double>(points, weights), &statistics};
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(*patch.is_planar(Coordinates<double, 2>{.3, .25 * i}));
  EXPECT_EQ(statistics.exact_ring, 3u);
  EXPECT_EQ(statistics.exact, 0u);
}

// --- Which stage decides -------------------------------------------------------------------------

TEST(Filter_stages, generic_input_stays_in_floating_point)
{
  Random random(1);
  Filter_statistics statistics;
  const Implicit_surface_3<Torus> torus;
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign_k({}, &statistics);
  const Filtered<Shape_chain<Sign_of_mean_curvature>> sign_h({}, &statistics);
  const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &statistics);
  const int n = 2000;
  for (int i = 0; i < n; ++i)
  {
    const Point p = random_point(random);
    EXPECT_EQ(*sign_k(torus, p), exactly<Sign_of_gaussian_curvature>(Torus(), p));
    EXPECT_EQ(*sign_h(torus, p), exactly<Sign_of_mean_curvature>(Torus(), p));
    EXPECT_EQ(*umbilic(torus, p), exactly<Is_umbilic>(Torus(), p));
  }
  EXPECT_EQ(statistics.fallbacks(), 0u);
  EXPECT_EQ(statistics.magnitude + statistics.interval, 3u * n);
  EXPECT_GT(statistics.magnitude, 29u * n / 10);
  std::cout << "counts: filter, " << 3 * n << " decisions on generic input: "
            << statistics.magnitude << " by magnitude, " << statistics.interval
            << " by interval, " << statistics.fallbacks() << " exactly\n";
}

// Asks the filter n times and checks the answers.
template <class Question, class Function>
void ask(const Function& f, const Filtered<Shape_chain<Question>>& filter, int n)
{
  Random random(2);
  for (int i = 0; i < n; ++i)
  {
    const Point p = random_point(random);
    const auto answer = filter(Implicit_surface_3<Function>(f), p);
    ASSERT_TRUE(answer) << answer.refusal().evidence();
    EXPECT_EQ(*answer, exactly<Question>(f, p));
  }
}

TEST(Filter_stages, degenerate_input_reaches_the_exact_ring)
{
  const int n = 300;
  Filter_statistics umbilic, parabolic, planar;
  ask(Sphere(), Filtered<Shape_chain<Is_umbilic>>({}, &umbilic), n);
  ask(Cylinder(), Filtered<Shape_chain<Sign_of_gaussian_curvature>>({}, &parabolic), n);
  ask(Plane(), Filtered<Shape_chain<Is_planar>>({}, &planar), n);
  EXPECT_EQ(umbilic.fallbacks(), unsigned(n));
  EXPECT_EQ(parabolic.fallbacks(), unsigned(n));
  EXPECT_GT(planar.fallbacks(), unsigned(n) / 3) << "elsewhere the zeros come out as such";
  for (const Filter_statistics* s : {&umbilic, &parabolic, &planar})
    EXPECT_EQ(s->exact, 0u) << "no rationals for dyadic input";
  std::cout << "counts: filter, " << 3 * n << " decisions on degenerate input: "
            << umbilic.fallbacks() + parabolic.fallbacks() + planar.fallbacks()
            << " exactly, all in the ring\n";
}

TEST(Filter_stages, constants_that_are_no_doubles_need_rationals)
{
  const int n = 50;
  Filter_statistics s;
  ask(Sphere_with_third(), Filtered<Shape_chain<Is_umbilic>>({}, &s), n);
  EXPECT_EQ(s.exact, unsigned(n));
  EXPECT_EQ(s.exact_ring, 0u);
}

TEST(Filter_stages, division_needs_rationals)
{
  const int n = 50;
  Filter_statistics s;
  ask(Sphere_by_division(), Filtered<Shape_chain<Is_umbilic>>({}, &s), n);
  EXPECT_EQ(s.exact, unsigned(n));
  Filter_statistics generic;
  ask(Sphere_by_division(), Filtered<Shape_chain<Sign_of_mean_curvature>>({}, &generic), n);
  EXPECT_EQ(generic.fallbacks(), 0u);
}

TEST(Filter_stages, rational_input_starts_with_intervals)
{
  Random random(3);
  Filter_statistics generic, degenerate;
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign({}, &generic);
  const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &degenerate);
  const int n = 200;
  for (int i = 0; i < n; ++i)
  {
    const Coordinates<Q, 3> p{random.nonzero_rational(), random.rational(), random.rational()};
    EXPECT_EQ(*sign(Implicit_surface_3<Torus>(), p),
              exactly<Sign_of_gaussian_curvature>(Torus(), p));
    EXPECT_TRUE(*umbilic(Implicit_surface_3<Sphere>(), p));
  }
  EXPECT_EQ(generic.magnitude, 0u);
  EXPECT_GT(generic.interval, 19u * n / 20);
  EXPECT_EQ(degenerate.exact + degenerate.interval, unsigned(n));
  EXPECT_GT(degenerate.exact, unsigned(n) / 2);
}

TEST(Filter_stages, almost_umbilic)
{
  // Out of ten bits each: from clearly different to exactly equal.
  for (const double difference : {1e-1, 1e-4, 1e-8, 1e-13, 2.3e-16, 0.0})
  {
    const Almost_sphere f{1 + difference};
    Filter_statistics s;
    ask(f, Filtered<Shape_chain<Is_umbilic>>({}, &s), 20);
    if (difference >= 1e-8)
    {
      EXPECT_EQ(s.fallbacks(), 0u) << difference;
    }
    if (difference == 0)
    {
      EXPECT_EQ(s.exact_ring, 20u);
    }
  }
}

// --- Functions that no exact type has ------------------------------------------------------------

TEST(Filter_transcendental, generic_points_are_decided_by_intervals)
{
  Random random(4);
  Filter_statistics s;
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign({}, &s);
  for (int i = 0; i < 200; ++i)
  {
    const Point p = random_point(random);
    const auto answer = sign(Implicit_surface_3<Waves>(), p);
    ASSERT_TRUE(answer) << answer.refusal().evidence();
    const auto shape = Implicit_surface_3<Waves>().level_set_shape(p);
    EXPECT_EQ(*answer, sign_of_gaussian_curvature(*shape)) << "the double's";
  }
  EXPECT_EQ(s.interval, 200u);
}

TEST(Filter_transcendental, degenerate_points_are_undecided)
{
  Random random(5);
  Filter_statistics s;
  const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &s);
  for (int i = 0; i < 50; ++i)
  {
    const auto answer = umbilic(Implicit_surface_3<Sphere_by_logarithm>(), random_point(random));
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.refusal().code(), Refusal_code::UNDECIDED);
    EXPECT_FALSE(answer.refusal().evidence().empty());
  }
}

// The sign of log(3) - log(3), undecided by intervals and not there exactly.
struct Bare_difference_of_logarithms
{
  template <class NT>
  auto operator()(const NT& x) const
  {
    using F = Elementary_functions<NT>;
    return sign_decision(NT(F::log(x) - F::log(x)));
  }
};

TEST(Filter_transcendental, bare_decision_throws)
{
  const Filtered<Bare_difference_of_logarithms> filter;
  EXPECT_THROW(filter(3.0), Not_algebraic_error);
  EXPECT_EQ(effective_rounding(), FE_TONEAREST);
}

// --- Range ---------------------------------------------------------------------------------------

TEST(Filter_range, tiny_and_huge_points)
{
  Random random(6);
  for (const double size : {1e-300, 1e-160, 1e-80, 1e80, 1e160, 1e300})
    for (int i = 0; i < 10; ++i)
    {
      const Point p = random_point(random, size);
      const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign;
      const Filtered<Shape_chain<Is_umbilic>> umbilic;
      EXPECT_EQ(*sign(Implicit_surface_3<Torus>(), p),
                exactly<Sign_of_gaussian_curvature>(Torus(), p));
      EXPECT_TRUE(*umbilic(Implicit_surface_3<Sphere>(), p)) << size;
      EXPECT_EQ(*umbilic(Implicit_surface_3<Almost_sphere>(Almost_sphere{1 + 1e-15}), p), false);
    }
}

// x^2 + y^2 - tiny: K changes its sign where no double sees it.
TEST(Filter_range, coefficients_at_the_ends_of_the_range)
{
  const auto saddle = [](double c) {
    return Implicit_surface_3([c](const auto& x, const auto& y, const auto& z) {
      using NT = std::decay_t<decltype(x)>;
      return NT(z - (x * x + number_cast<NT>(c) * y * y));
    });
  };
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign;
  for (const double c : {1e-300, 1e300, 5e-324, 1.7e308})
  {
    EXPECT_EQ(*sign(saddle(c), Point{0, 0, 0}), CGAL::POSITIVE) << c;
    EXPECT_EQ(*sign(saddle(-c), Point{0, 0, 0}), CGAL::NEGATIVE) << c;
    EXPECT_EQ(*sign(saddle(0 * c), Point{0, 0, 0}), CGAL::ZERO) << c;
  }
}

// x^2 / 2 - 1e308, which is positive though x^2 overflows, to the largest double in some modes.
struct Overflow_on_the_way
{
  template <class NT>
  auto operator()(const NT& x) const
  {
    return sign_decision(NT(x * x * NT(0.5) - NT(1e308)));
  }
};

TEST(Filter_range, overflow_on_the_way)
{
  for (const int mode : rounding_modes)
  {
    const Rounding rounding(mode);
    const Filtered<Overflow_on_the_way> filter;
    EXPECT_EQ(filter(1e200), CGAL::POSITIVE) << mode;
    EXPECT_EQ(filter(-1e200), CGAL::POSITIVE) << mode;
    EXPECT_EQ(filter(1e-200), CGAL::NEGATIVE) << mode;
  }
}

// (x + y) - x - y divided by z, with x and y so that the first stages cannot tell.
struct Cancelling_quotient
{
  template <class NT>
  auto operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT difference = x + y - x - y;
    return sign_decision(NT(difference / z));
  }
};

TEST(Filter_range, quotients_by_powers_of_two)
{
  Filter_statistics s;
  const Filtered<Cancelling_quotient> filter({}, &s);
  for (const double z : {4.0, 0.25, 0x1p1000, 0x1p-1000, 0x1p-1060, 5e-324})
    EXPECT_EQ(filter(1.0, 1e-30, z), CGAL::ZERO) << z;
  EXPECT_EQ(filter(1.0, 1e-30, 3.0), CGAL::ZERO);
  EXPECT_EQ(s.fallbacks(), 7u);
  EXPECT_GE(s.exact_ring, 4u);
}

TEST(Filter_range, data_that_are_no_numbers_get_no_answer)
{
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const Filtered<Shape_chain<Is_umbilic>> umbilic;
  EXPECT_THROW(umbilic(Implicit_surface_3<Torus>(), Point{inf, 1, 1}), Shape_error);
  EXPECT_THROW(umbilic(Implicit_surface_3<Torus>(), Point{nan, 1, 1}), Shape_error);
  EXPECT_EQ(effective_rounding(), FE_TONEAREST);
}

// --- The rounding mode ---------------------------------------------------------------------------

// Zero, undecided until it is computed exactly; throws in the stage that computes in `Stage`.
template <class Stage, class Exception>
struct Thrower
{
  template <class NT>
  auto operator()(const NT& x, const NT& y) const
  {
    const NT difference = x + y - x - y;
    if constexpr (std::is_same_v<NT, Stage>)
      throw Exception("thrown by the chain");
    return sign_decision(difference);
  }
};

template <class Stage>
void expect_restored_after_exception()
{
  const Filtered<Thrower<Stage, std::logic_error>> filter;
  for (const int mode : rounding_modes)
  {
    const Rounding rounding(mode);
    if (std::is_same_v<Stage, Magnitude> && !Magnitude::is_safe_in_rounding_mode())
      continue; // the stage is passed over
    EXPECT_THROW(filter(1.0, 1e-30), std::logic_error);
    EXPECT_EQ(effective_rounding(), mode);
  }
}

TEST(Filter_rounding, restored_after_exceptions_in_each_stage)
{
  expect_restored_after_exception<Magnitude>();
  expect_restored_after_exception<Interval>();
  expect_restored_after_exception<Exact_ring>();
}

TEST(Filter_rounding, restored_after_exception_in_the_last_stage)
{
  const Filtered<Thrower<Q, std::logic_error>> filter;
  for (const int mode : rounding_modes)
  {
    const Rounding rounding(mode);
    EXPECT_THROW(filter(Q(Q(1) / 3), Q(Q(1) / 7)), std::logic_error);
    EXPECT_EQ(effective_rounding(), mode);
  }
}

// Zero, undecided until it is computed exactly; tells the rounding mode in which that is done.
struct Mode_of_exact_stages
{
  int* mode;

  template <class NT>
  auto operator()(const NT& x, const NT& y) const
  {
    if constexpr (std::is_same_v<NT, Exact_ring> || std::is_same_v<NT, Q>)
      *mode = effective_rounding();
    const NT difference = x + y - x - y;
    return sign_decision(difference);
  }
};

TEST(Filter_rounding, exact_stages_round_to_nearest)
{
  int seen = -1;
  const Filtered<Mode_of_exact_stages> filter(Mode_of_exact_stages{&seen});
  for (const int mode : rounding_modes)
  {
    const Rounding rounding(mode);
    EXPECT_EQ(filter(1.0, 1e-30), CGAL::ZERO);
    EXPECT_EQ(std::exchange(seen, -1), FE_TONEAREST) << "in the ring";
    EXPECT_EQ(filter(Q(Q(1) / 3), Q(Q(1) / 7)), CGAL::ZERO);
    EXPECT_EQ(std::exchange(seen, -1), FE_TONEAREST) << "in rationals";
    EXPECT_EQ(effective_rounding(), mode);
  }
}

TEST(Filter_rounding, errors_of_a_ring_stage_lead_to_the_next)
{
  Filter_statistics s;
  const Filtered<Thrower<Magnitude, Conversion_error>> first({}, &s);
  EXPECT_EQ(first(1.0, 1e-30), CGAL::ZERO);
  EXPECT_EQ(s.exact_ring, 1u);
  const Filtered<Thrower<Exact_ring, Conversion_error>> third({}, &s);
  EXPECT_EQ(third(1.0, 1e-30), CGAL::ZERO);
  EXPECT_EQ(s.exact, 1u);
}

TEST(Filter_rounding, restored_after_answers_and_of_no_influence)
{
  Random random(7);
  for (const int mode : rounding_modes)
  {
    const Rounding rounding(mode);
    Filter_statistics s;
    const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign({}, &s);
    const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &s);
    const Filtered<Shape_chain<Is_planar>> planar({}, &s);
    for (int i = 0; i < 100; ++i)
    {
      const Point p = random_point(random);
      EXPECT_EQ(*sign(Implicit_surface_3<Torus>(), p),
                exactly<Sign_of_gaussian_curvature>(Torus(), p));
      EXPECT_EQ(effective_rounding(), mode);
      EXPECT_TRUE(*umbilic(Implicit_surface_3<Sphere>(), p));
      EXPECT_FALSE(*umbilic(Implicit_surface_3<Almost_sphere>(Almost_sphere{1 + 1e-15}), p));
      EXPECT_TRUE(*planar(Implicit_surface_3<Plane>(), p));
      EXPECT_TRUE(*umbilic(Implicit_surface_3<Sphere_with_third>(), p));
      EXPECT_EQ(effective_rounding(), mode);
    }
    EXPECT_EQ(s.magnitude > 0, Magnitude::is_safe_in_rounding_mode());
    EXPECT_GT(s.exact_ring, 0u);
    EXPECT_GT(s.exact, 0u);
  }
}

// --- Threads -------------------------------------------------------------------------------------

// Runs decisions of all kinds in a rounding mode, and counts what is wrong.
template <class Sign, class Umbilic>
void work(const Sign& sign, const Umbilic& umbilic, int mode, unsigned seed,
          std::atomic<int>& wrong)
{
  const Rounding rounding(mode);
  Random random(seed);
  for (int i = 0; i < 100; ++i)
  {
    const Point p = random_point(random);
    wrong += *sign(Implicit_surface_3<Torus>(), p) !=
             exactly<Sign_of_gaussian_curvature>(Torus(), p);
    wrong += !*umbilic(Implicit_surface_3<Sphere>(), p);
    wrong += !*umbilic(Implicit_surface_3<Sphere_with_third>(), p);
    wrong += *umbilic(Implicit_surface_3<Almost_sphere>(Almost_sphere{1 + 1e-15}), p);
    wrong += effective_rounding() != mode;
  }
}

TEST(Filter_threads, one_filter_for_many)
{
  Filter_statistics s;
  const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign({}, &s);
  const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &s);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < 8; ++k)
    threads.emplace_back([&, k] { work(sign, umbilic, rounding_modes[k % 4], 100 + k, wrong); });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(s.magnitude + s.interval + s.exact_ring + s.exact, 8u * 100 * 4);
}

// A chain from which a thread is started: it inherits the rounding mode of the stage.
struct Thread_starter
{
  std::atomic<int>* wrong;
  std::atomic<int>* upward;

  template <class NT>
  auto operator()(const NT& x, const NT& y) const
  {
    std::thread([this] {
      const int mode = effective_rounding();
      *upward += mode == FE_UPWARD;
      const Filtered<Shape_chain<Sign_of_gaussian_curvature>> sign;
      const Filtered<Shape_chain<Is_umbilic>> umbilic;
      work(sign, umbilic, mode, 7, *wrong);
      *wrong += effective_rounding() != mode;
    }).join();
    const NT difference = x + y - x - y;
    return sign_decision(difference);
  }
};

TEST(Filter_threads, started_while_another_is_inside)
{
  std::atomic<int> wrong{0}, upward{0};
  const Filtered<Thread_starter> filter(Thread_starter{&wrong, &upward});
  EXPECT_EQ(filter(1.0, 1e-30), CGAL::ZERO);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(effective_rounding(), FE_TONEAREST);
  EXPECT_GE(upward, 1) << "the interval stage rounds upward";
}

// --- The first stage never certifies a wrong sign ------------------------------------------------

struct Tracked
{
  Magnitude m;
  Q q;
};

void expect_bound(const Tracked& x)
{
  const double error = x.m.error();
  if (std::isfinite(error) && std::isfinite(x.m.value()))
  {
    const Q difference = Q(x.m.value()) - x.q;
    EXPECT_LE(Q(CGAL::abs(difference)), Q(error)) << x.m;
  }
  const auto sign = sign_decision(x.m);
  if (sign.is_certain())
  {
    EXPECT_EQ(sign.make_certain(), CGAL::sign(x.q)) << x.m;
  }
  EXPECT_TRUE(CGAL::possibly(is_zero_decision(x.m)) || !CGAL::is_zero(x.q)) << x.m;
}

double random_double(Random& random)
{
  const double mantissa = random.real(-1, 1);
  switch (random.integer(0, 5))
  {
  case 0: return random.integer(-4, 4);
  case 1: return std::ldexp(mantissa, random.integer(-340, 340));
  case 2: return std::ldexp(mantissa, random.integer(-1074, -900)); // subnormal ones too
  default: return mantissa;
  }
}

// A program whose later steps cancel what earlier ones have computed.
int run_program(Random& random)
{
  std::vector<Tracked> x;
  const auto leaf = [&](double d) { x.push_back({Magnitude(d), Q(d)}); };
  const auto any = [&] { return x[random.integer(0, int(x.size()) - 1)]; };
  for (int i = 0; i < 3; ++i)
    leaf(random_double(random));
  int certain = 0;
  for (int step = 0; step < 14; ++step)
  {
    const Tracked a = any(), b = any();
    switch (random.integer(0, 5))
    {
    case 0: x.push_back({a.m + b.m, Q(a.q + b.q)}); break;
    case 1: x.push_back({a.m - b.m, Q(a.q - b.q)}); break;
    case 2:
    case 3: x.push_back({a.m * b.m, Q(a.q * b.q)}); break;
    case 4:
      if (!CGAL::is_zero(b.q))
        x.push_back({a.m / b.m, Q(a.q / b.q)});
      break;
    default: // what rounding has left of a: its value taken away, or its neighbour
      if (std::isfinite(a.m.value()))
      {
        const double near = random.integer(0, 1) ? a.m.value() : std::nextafter(a.m.value(), 0);
        x.push_back({a.m - Magnitude(near), Q(a.q - Q(near))});
      }
    }
    expect_bound(x.back());
    certain += sign_decision(x.back().m).is_certain();
  }
  return certain;
}

TEST(Filter_magnitude, bound_holds_in_random_programs)
{
  int certain = 0;
  for (const int mode : {FE_TONEAREST, FE_UPWARD})
  {
    const Rounding rounding(mode);
    ASSERT_TRUE(Magnitude::is_safe_in_rounding_mode());
    Random random(8);
    for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i)
      certain += run_program(random);
  }
  EXPECT_GT(certain, 2 * 3000 * 14 / 3) << "the bound is of use";
}

TEST(Filter_magnitude, not_used_where_overflow_does_not_show)
{
  for (const int mode : {FE_DOWNWARD, FE_TOWARDZERO})
  {
    const Rounding rounding(mode);
    EXPECT_FALSE(Magnitude::is_safe_in_rounding_mode());
  }
}

TEST(Filter_magnitude, long_sums_and_products)
{
  for (const int mode : {FE_TONEAREST, FE_UPWARD})
  {
    const Rounding rounding(mode);
    Random random(9);
    Tracked sum{Magnitude(0), Q(0)}, product{Magnitude(1), Q(1)};
    for (int i = 0; i < 3000; ++i)
    {
      const double d = random.real(-1, 1);
      sum = {sum.m + Magnitude(d), Q(sum.q + Q(d))};
    }
    for (int i = 0; i < 300; ++i)
    {
      const double d = random.real(0.9, 1.1);
      product = {product.m * Magnitude(d), Q(product.q * Q(d))};
    }
    expect_bound(sum);
    expect_bound(product);
    expect_bound({sum.m - Magnitude(sum.m.value()), Q(sum.q - Q(sum.m.value()))});
    expect_bound({product.m - Magnitude(product.m.value()), Q(product.q - Q(product.m.value()))});
    EXPECT_TRUE(sign_decision(product.m).is_certain());
  }
}

} // namespace
