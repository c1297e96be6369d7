// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Models of the concepts that have what the concepts ask for and nothing else: number types with
// the operations of a ring or a field only, functions, surfaces; and a number type that counts
// degrees.

#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

// --- Number types --------------------------------------------------------------------------------

namespace archetype {

using Q = CGAL::Exact_rational;

// Exact numbers with + - *, integers, and no comparison of any kind.
template <bool has_division>
class Number
{
public:
  Number() = default;
  explicit Number(int x) : m_x(x) {}
  explicit Number(const Q& x) : m_x(x) {}
  explicit Number(double) = delete;

  const Q& exact() const { return m_x; }

  friend Number operator-(const Number& a) { return Number(Q(-a.m_x)); }
  friend Number operator+(const Number& a, const Number& b) { return Number(Q(a.m_x + b.m_x)); }
  friend Number operator-(const Number& a, const Number& b) { return Number(Q(a.m_x - b.m_x)); }
  friend Number operator*(const Number& a, const Number& b) { return Number(Q(a.m_x * b.m_x)); }
  Number& operator+=(const Number& b) { return *this = *this + b; }
  Number& operator-=(const Number& b) { return *this = *this - b; }
  friend std::ostream& operator<<(std::ostream& out, const Number& x) { return out << x.m_x; }

private:
  Q m_x;
};

using Ring = Number<false>;

// Division besides.
using Field = Number<true>;
inline Field operator/(const Field& a, const Field& b) { return Field(Q(a.exact() / b.exact())); }

// The degree of a polynomial that is computed with: sums take the larger degree, products add.
// Terms that cancel are not noticed, so it is a bound. There is no sign: asking for one does not
// compile.
class Degree
{
public:
  Degree() = default;
  explicit Degree(int constant) : m_degree(constant == 0 ? -1 : 0) {}
  explicit Degree(double) = delete;
  static Degree of(int degree)
  {
    Degree d;
    d.m_degree = degree;
    return d;
  }

  int value() const { return m_degree; }

  friend Degree operator-(const Degree& a) { return a; }
  friend Degree operator+(const Degree& a, const Degree& b)
  {
    return of(std::max(a.m_degree, b.m_degree));
  }
  friend Degree operator-(const Degree& a, const Degree& b) { return a + b; }
  friend Degree operator*(const Degree& a, const Degree& b)
  {
    return a.m_degree < 0 || b.m_degree < 0 ? Degree() : of(a.m_degree + b.m_degree);
  }
  Degree& operator+=(const Degree& b) { return *this = *this + b; }
  Degree& operator-=(const Degree& b) { return *this = *this - b; }
  friend std::ostream& operator<<(std::ostream& out, const Degree& x)
  {
    return out << "degree " << x.m_degree;
  }

private:
  int m_degree = -1; // of zero
};

// What the two first have in common.
template <class NT>
struct Exact_traits
{
  using Sign = CGAL::Sign;
  using Boolean = bool;
  static constexpr bool is_exact = true, is_enclosure = false, is_light = false;
  static Sign sign(const NT& x) { return CGAL::sign(x.exact()); }
  static Boolean is_zero(const NT& x) { return CGAL::is_zero(x.exact()); }
  static bool is_finite(const NT&) { return true; }
};

} // namespace archetype

namespace CGAL {
namespace Shape_interrogation {

template <>
struct Number_type_traits<archetype::Ring> : archetype::Exact_traits<archetype::Ring> {};
template <>
struct Number_type_traits<archetype::Field> : archetype::Exact_traits<archetype::Field> {};

// In general position nothing is zero.
template <>
struct Number_type_traits<archetype::Degree>
{
  using Sign = CGAL::Sign;
  using Boolean = bool;
  static constexpr bool is_exact = false, is_enclosure = false, is_light = false;
  static Boolean is_zero(const archetype::Degree&) { return false; }
  static bool is_finite(const archetype::Degree&) { return true; }
};

} // namespace Shape_interrogation
} // namespace CGAL

namespace {

using namespace CGAL::Shape_interrogation;
using archetype::Degree;
using testing_shapes::Q;
using testing_shapes::Random;

// --- Functions -----------------------------------------------------------------------------------

struct Torus // a model of ImplicitFunction_3, of degree 4
{
  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT r = x * x + y * y;
    const NT s = r + z * z + NT(3);
    return s * s - NT(16) * r;
  }
};

struct Saddle_map // a model of ParametricMap_3
{
  template <class NT>
  std::array<NT, 3> operator()(const NT& u, const NT& v) const
  {
    return {u, v, u * u - NT(2) * v * v + u * v};
  }
};

template <class NT>
Coordinates<NT, 3> converted(const Coordinates<Q, 3>& p)
{
  return {NT(p[0]), NT(p[1]), NT(p[2])};
}

TEST(Number_type_archetypes, decisions_need_a_ring)
{
  Random random(1);
  const Implicit_surface_3<Torus> torus;
  for (int i = 0; i < 20; ++i)
  {
    const auto p = random.nonzero_vector();
    const auto expected = torus.level_set_shape(p);
    const auto s = torus.level_set_shape(converted<archetype::Ring>(p));
    ASSERT_TRUE(s);
    EXPECT_EQ(sign_of_gaussian_curvature(*s), sign_of_gaussian_curvature(*expected));
    EXPECT_EQ(sign_of_mean_curvature(*s), sign_of_mean_curvature(*expected));
    EXPECT_EQ(is_umbilic(*s), is_umbilic(*expected));
    EXPECT_EQ(is_planar(*s), is_planar(*expected));
    EXPECT_EQ(is_parabolic(*s), is_parabolic(*expected));
    EXPECT_EQ(point_type(*s), point_type(*expected));
    const auto v = internal::cross(s->normal(), converted<archetype::Ring>(random.vector()));
    EXPECT_EQ(sign_of_normal_curvature(*s, v),
              sign_of_normal_curvature(*expected, {v[0].exact(), v[1].exact(), v[2].exact()}));
    EXPECT_EQ(s->opposite().normal()[0].exact(), Q(-s->normal()[0].exact()));
  }
}

TEST(Number_type_archetypes, parametrisations_too)
{
  const Parametric_surface_3<Saddle_map> surface;
  using archetype::Ring;
  const auto s = surface(Coordinates<Ring, 2>{Ring(3), Ring(-2)});
  ASSERT_TRUE(s);
  EXPECT_EQ(sign_of_gaussian_curvature(*s), CGAL::NEGATIVE);
  EXPECT_FALSE(is_umbilic(*s));
  EXPECT_EQ(s->scaled_shape_matrix()(0, 0).exact(),
            surface(Coordinates<Q, 2>{Q(3), Q(-2)})->scaled_shape_matrix()(0, 0));
}

TEST(Number_type_archetypes, refusals_in_a_ring)
{
  using archetype::Ring;
  const Implicit_surface_3<Torus> torus;
  const auto off = torus(Coordinates<Ring, 3>{Ring(1), Ring(1), Ring(1)});
  ASSERT_FALSE(off);
  EXPECT_EQ(off.refusal().code(), Refusal_code::NOT_ON_SURFACE);
  const auto singular = torus.level_set_shape(Coordinates<Ring, 3>{Ring(0), Ring(0), Ring(0)});
  ASSERT_FALSE(singular);
  EXPECT_EQ(singular.refusal().code(), Refusal_code::SINGULAR_POINT);
}

TEST(Number_type_archetypes, values_need_a_field)
{
  Random random(2);
  const Implicit_surface_3<Torus> torus;
  for (int i = 0; i < 20; ++i)
  {
    const auto p = random.nonzero_vector();
    const auto expected = torus.level_set_shape(p);
    const auto s = torus.level_set_shape(converted<archetype::Field>(p));
    ASSERT_TRUE(s);
    EXPECT_EQ(gaussian_curvature(*s).exact(), gaussian_curvature(*expected));
    EXPECT_EQ(squared_mean_curvature(*s).exact(), squared_mean_curvature(*expected));
    EXPECT_EQ(squared_curvature_gap(*s).exact(), squared_curvature_gap(*expected));
    EXPECT_EQ(s->shape_matrix()(0, 1).exact(), expected->shape_matrix()(0, 1));
    const auto v = internal::cross(expected->normal(), random.nonzero_vector());
    EXPECT_EQ(squared_normal_curvature(*s, converted<archetype::Field>(v)).exact(),
              squared_normal_curvature(*expected, v));
  }
}

// --- Functions as lambdas ------------------------------------------------------------------------

TEST(Function_models, lambdas)
{
  const Implicit_surface_3 sphere(
    [](const auto& x, const auto& y, const auto& z) { return x * x + y * y + z * z - 9; });
  const auto s = sphere(Coordinates<Q, 3>{Q(1), Q(2), Q(2)});
  ASSERT_TRUE(s);
  EXPECT_EQ(gaussian_curvature(*s), Q(Q(1) / 9));
  EXPECT_TRUE(is_umbilic(*s));
  const Parametric_surface_3 graph(
    [](const auto& u, const auto& v) { return std::array{u + 0, v + 0, 3 * u * v}; });
  const auto t = graph(Coordinates<Q, 2>{Q(0), Q(0)});
  ASSERT_TRUE(t);
  EXPECT_EQ(gaussian_curvature(*t), Q(-9));
  EXPECT_NEAR(gaussian_curvature(*graph(Coordinates<double, 2>{0, 0})), -9, 1e-12);
}

TEST(Function_models, with_state_and_by_value)
{
  std::vector<double> radii{1, 2, 5};
  std::vector<Result<Local_shape_3<double>>> shapes;
  for (const double r : radii)
    shapes.push_back(Implicit_surface_3([r](const auto& x, const auto& y, const auto& z) {
      return x * x + y * y + z * z - r * r;
    })(Coordinates<double, 3>{r, 0, 0}));
  for (std::size_t i = 0; i < radii.size(); ++i)
    EXPECT_NEAR(mean_curvature(*shapes[i]), 1 / radii[i], 1e-15);
}

// --- Surfaces ------------------------------------------------------------------------------------

// A model of ShapeSource_3 that holds no numbers: the sphere around the origin through the query.
struct Gauss_sphere
{
  template <class NT>
  using Query = Coordinates<NT, 3>;

  template <class NT>
  Result<Local_shape_3<NT>> operator()(const Coordinates<NT, 3>& n) const
  {
    const NT zero(0), one(1);
    const auto s =
      Local_shape_3<NT>::from_form(n, n, Symmetric_matrix_3<NT>(one, zero, zero, one, zero, one));
    if (auto refusal = internal::refuse_zero(s.normal_squared_length(),
                                             Refusal_code::SINGULAR_POINT, "the normal"))
      return *refusal;
    return s;
  }
};

// A model that holds numbers: the graph of (a x^2 + b y^2) / 2 at the origin; there is no query.
template <class NT>
struct Osculating_paraboloid
{
  using FT = NT;
  NT a, b;

  template <class To>
  Osculating_paraboloid<To> cast() const
  {
    return {number_cast<To>(a), number_cast<To>(b)};
  }

  Result<Local_shape_3<NT>> operator()(const Coordinates<NT, 3>& p) const
  {
    const NT zero(0);
    return Local_shape_3<NT>::from_form(
      p, {zero, zero, NT(1)}, Symmetric_matrix_3<NT>(NT(-a), zero, zero, NT(-b), zero, zero));
  }
};

TEST(Source_models, without_numbers)
{
  const Interrogation_3<Gauss_sphere> sphere{Gauss_sphere()};
  EXPECT_TRUE(*sphere.is_umbilic(Coordinates<double, 3>{0.1, 0.2, 0.3}));
  EXPECT_EQ(*sphere.sign_of_mean_curvature(Coordinates<double, 3>{0.1, 0.2, 0.3}), CGAL::POSITIVE);
  const auto refused = sphere.is_umbilic(Coordinates<double, 3>{0, 0, 0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.refusal().code(), Refusal_code::SINGULAR_POINT);
  const Interrogation_3<Gauss_sphere, Exact_shape_traits_3> exact{Gauss_sphere()};
  EXPECT_EQ(gaussian_curvature(*exact.shape(Coordinates<Q, 3>{Q(2), Q(0), Q(0)})),
            Q(Q(1) / 4));
}

TEST(Source_models, with_numbers)
{
  Filter_statistics statistics;
  const Interrogation_3<Osculating_paraboloid<double>> surface({0.1, -0.2}, &statistics);
  const Coordinates<double, 3> origin{0, 0, 0};
  EXPECT_EQ(*surface.sign_of_gaussian_curvature(origin), CGAL::NEGATIVE);
  EXPECT_EQ(*surface.sign_of_normal_curvature(origin, {1, 0, 0}), CGAL::NEGATIVE);
  EXPECT_EQ(statistics.fallbacks(), 0u);
  const double next = std::nextafter(0.1, 1);
  const Filtered<Shape_chain<Is_umbilic>> umbilic({}, &statistics);
  EXPECT_FALSE(*umbilic(Prepared(Osculating_paraboloid<double>{0.1, next}), origin));
  EXPECT_TRUE(*umbilic(Prepared(Osculating_paraboloid<double>{0.1, 0.1}), origin));
  const Osculating_paraboloid<Q> rational{Q(Q(1) / 3), Q(Q(2) / 6)};
  EXPECT_TRUE(*umbilic(rational, Coordinates<Q, 3>{Q(0), Q(0), Q(0)}));
}

// What a filter needs is made for a filter only, and the data are held once.
template <class NT>
struct Counted_paraboloid : Osculating_paraboloid<NT>
{
  static inline int casts = 0;

  template <class To>
  Osculating_paraboloid<To> cast() const
  {
    ++casts;
    return Osculating_paraboloid<NT>::template cast<To>();
  }
};

TEST(Source_models, are_converted_for_a_filter_only)
{
  const Counted_paraboloid<Q> rational{{Q(1), Q(2)}};
  const Interrogation_3<Counted_paraboloid<Q>, Exact_shape_traits_3> exact(rational);
  EXPECT_EQ(*exact.sign_of_mean_curvature(Coordinates<Q, 3>{Q(0), Q(0), Q(0)}), CGAL::NEGATIVE);
  EXPECT_EQ(Counted_paraboloid<Q>::casts, 0);
  EXPECT_EQ(exact.source().b, Q(2));
  EXPECT_LE(sizeof(exact), sizeof(rational) + sizeof(void*));
  const Counted_paraboloid<double> saddle{{0.5, -2}};
  const Interrogation_3<Counted_paraboloid<double>> filtered(saddle);
  const int casts = Counted_paraboloid<double>::casts;
  EXPECT_GT(casts, 0);
  EXPECT_EQ(*filtered.sign_of_mean_curvature(Coordinates<double, 3>{0, 0, 0}), CGAL::POSITIVE);
  EXPECT_EQ(Counted_paraboloid<double>::casts, casts);
  EXPECT_EQ(filtered.source().b, -2);
}

// A model of ShapeSource_3 with a constant that no exact type has.
struct Infinite_source
{
  template <class NT>
  using Query = Coordinates<NT, 3>;

  template <class NT>
  Result<Local_shape_3<NT>> operator()(const Coordinates<NT, 3>& p) const
  {
    if (Number_type_traits<NT>::is_enclosure)
      return Refusal(Refusal_code::UNDECIDED, "it is infinite");
    return Gauss_sphere()(Coordinates<NT, 3>{p[0], p[1], number_cast<NT>(HUGE_VAL)});
  }
};

TEST(Source_models, without_exact_values)
{
  const Interrogation_3<Infinite_source> filtered{Infinite_source()};
  const Interrogation_3<Infinite_source, Exact_shape_traits_3> exact{Infinite_source()};
  const auto a = filtered.is_umbilic(Coordinates<double, 3>{1, 2, 3});
  const auto b = exact.is_umbilic(Coordinates<Q, 3>{Q(1), Q(2), Q(3)});
  const auto c = exact.shape(Coordinates<Q, 3>{Q(1), Q(2), Q(3)});
  ASSERT_FALSE(a || b || c);
  EXPECT_EQ(a.refusal().code(), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(b.refusal().code(), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_EQ(c.refusal().code(), Refusal_code::LIMIT_EXCEEDED);
  EXPECT_NE(c.refusal().evidence().find("not finite"), std::string::npos);
}

// --- Traits --------------------------------------------------------------------------------------

// Models of ShapeTraits_3 without a kernel.
template <class NT>
struct Plain_traits
{
  using FT = NT;
  struct Point_3 { NT x, y, z; };
  struct Vector_3 { NT x, y, z; };
  using Sign = CGAL::Sign;
  using Boolean = bool;
  using Exact = Q;
  using Is_filtered = CGAL::Tag_false;

  static Coordinates<NT, 3> coordinates(const Point_3& p) { return {p.x, p.y, p.z}; }
  static Coordinates<NT, 3> coordinates(const Vector_3& v) { return {v.x, v.y, v.z}; }
};

struct Plain_filtered_traits : Plain_traits<double>
{
  using Is_filtered = CGAL::Tag_true;
};

template <class Traits>
void expect_answers()
{
  using NT = typename Traits::FT;
  const Interrogation_3<Implicit_surface_3<Torus>, Traits> torus{Implicit_surface_3<Torus>()};
  const typename Traits::Point_3 p{NT(3), NT(0), NT(0)};
  EXPECT_EQ(*torus.sign_of_gaussian_curvature(p), CGAL::POSITIVE);
  EXPECT_EQ(*torus.sign_of_normal_curvature(p, typename Traits::Vector_3{NT(0), NT(1), NT(2)}),
            CGAL::POSITIVE);
  EXPECT_EQ(*torus.sign_of_normal_curvature(p, Coordinates<NT, 3>{NT(0), NT(1), NT(2)}),
            CGAL::POSITIVE);
  EXPECT_EQ(*torus.sign_of_normal_curvature(p, {NT(0), NT(1), NT(2)}), CGAL::POSITIVE);
  EXPECT_FALSE(*torus.is_umbilic(p) || *torus.is_planar(p) || *torus.is_parabolic(p));
  ASSERT_TRUE(torus.shape(p));
  EXPECT_EQ(torus.shape(p)->normal()[1], NT(0));
}

TEST(Traits_models, with_nothing_but_the_requirements)
{
  expect_answers<Plain_traits<double>>();
  expect_answers<Plain_traits<Q>>();
  expect_answers<Plain_filtered_traits>();
  expect_answers<Filtered_shape_traits_3<>>();
}

// --- Chains --------------------------------------------------------------------------------------

// The same surface by two functions: the other one has k (x + y + z)^2 in its second derivatives.
struct Round
{
  double k;

  template <class NT>
  NT operator()(const NT& x, const NT& y, const NT& z) const
  {
    const NT plane = x + y + z;
    return (plane + x * x + y * y + z * z) * (NT(1) + NT(k) * plane);
  }
};

// No double direction is tangent to most surfaces, and the sign is one of the surface all the same.
TEST(Chains, certified_normal_curvature_depends_on_the_surface_only)
{
  const Coordinates<double, 3> origin{0, 0, 0}, nearly_tangent{0.1, 0.2, -0.3};
  for (const double k : {0.0, 1e40, -1e40})
  {
    const Interrogation_3 surface{Implicit_surface_3(Round{k})};
    EXPECT_EQ(*surface.sign_of_normal_curvature(origin, nearly_tangent), CGAL::POSITIVE) << k;
  }
}

struct Sign_of_exponentials // of 0, which nothing can prove
{
  template <class NT>
  auto operator()(const NT& x) const
  {
    using F = Elementary_functions<NT>;
    return sign_decision(NT(F::exp(x) * F::exp(-x) - NT(1)));
  }
};

struct Sign_of_roots // sqrt(2) sqrt(3) - sqrt(6)
{
  template <class NT>
  auto operator()(const NT& x) const
  {
    using F = Elementary_functions<NT>;
    const NT product = F::sqrt(NT(x * NT(2))) * F::sqrt(NT(x * NT(3)));
    return sign_decision(NT(product - F::sqrt(NT(x * NT(6)))));
  }
};

TEST(Chains, bare_decision_that_no_stage_makes)
{
  Filter_statistics statistics;
  const Filtered<Sign_of_exponentials> exponentials({}, &statistics);
  EXPECT_THROW(exponentials(1.0), Not_algebraic_error);
  const Filtered<Sign_of_roots, Quadratic_field> roots({}, &statistics);
  EXPECT_THROW(roots(1.0), Not_algebraic_error);
  EXPECT_EQ(statistics.fallbacks(), 0u) << "no answer is counted";
  const Filtered<Sign_of_roots, CORE::Expr> real({}, &statistics);
  EXPECT_EQ(real(1.0), CGAL::ZERO);
  EXPECT_EQ(statistics.exact, 1u);
}

// --- Degrees -------------------------------------------------------------------------------------

Coordinates<Degree, 3> curve_of_degree(int e)
{
  return {Degree::of(e), Degree::of(e), Degree::of(e)};
}

// Along a curve of degree e on a surface of degree d the numerators have these degrees: so many
// exact zeros and one more prove that they vanish on the whole curve.
TEST(Degrees, implicit)
{
  for (const int e : {1, 2, 5})
  {
    const auto s = Implicit_surface_3<Torus>()(curve_of_degree(e));
    ASSERT_TRUE(s);
    const int d = 4;
    EXPECT_EQ(s->normal()[0].value(), (d - 1) * e);
    EXPECT_EQ(s->normal_squared_length().value(), 2 * (d - 1) * e);
    EXPECT_EQ(s->trace_numerator().value(), (3 * d - 4) * e) << "mean curvature";
    EXPECT_EQ(s->minors_numerator().value(), (4 * d - 6) * e) << "Gaussian curvature";
    EXPECT_EQ(umbilic_discriminant(*s).value(), (6 * d - 8) * e);
    EXPECT_EQ(s->scale().value(), 0);
  }
}

// All monomials u^i v^j with i <= m and j <= n.
struct Tensor_map
{
  int m, n;

  template <class NT>
  std::array<NT, 3> operator()(const NT& u, const NT& v) const
  {
    NT x(1), y(1);
    for (int i = 0; i < m; ++i)
      x = x * u + NT(2);
    for (int j = 0; j < n; ++j)
      y = y * v + NT(3);
    return {x * y, x * y - u, y * x + v};
  }
};

Local_shape_3<Degree> tensor_shape(int m, int n, bool along_u)
{
  return *Parametric_surface_3(Tensor_map{m, n})(
    Coordinates<Degree, 2>{Degree::of(along_u), Degree::of(!along_u)});
}

// The bidegrees of Elber and Cohen: (2m-1, 2n-1) of the normal and (6m-4, 6n-4) of the determinant
// of the second form.
TEST(Degrees, tensor_product_patches)
{
  for (const int m : {2, 3, 5})
    for (const int n : {2, 3})
    {
      EXPECT_EQ(tensor_shape(m, n, true).normal()[2].value(), 2 * m - 1);
      EXPECT_EQ(tensor_shape(m, n, false).normal()[2].value(), 2 * n - 1);
      EXPECT_EQ(tensor_shape(m, n, true).minors_numerator().value(), 6 * m - 4);
      EXPECT_EQ(tensor_shape(m, n, false).minors_numerator().value(), 6 * n - 4);
      EXPECT_EQ(tensor_shape(m, n, true).normal_squared_length().value(), 4 * m - 2);
    }
}

TEST(Degrees, from_frame)
{
  const Coordinates<Degree, 3> w1{Degree::of(2), Degree::of(1), Degree::of(0)},
    w2{Degree::of(3), Degree::of(3), Degree()};
  const auto s = Local_shape_3<Degree>::from_frame(curve_of_degree(1), w1, w2, Degree::of(5),
                                                   Degree::of(4), Degree::of(7));
  EXPECT_EQ(s.normal()[0].value(), 3); // zero components add nothing
  EXPECT_EQ(s.normal()[2].value(), 5);
  EXPECT_EQ(s.minors_numerator().value(), 12);
  EXPECT_EQ(s.trace_numerator().value(), std::max({4 + 7, 5 + 4, 6 + 5}));
}

// The claim itself: differences of an order above the degree vanish, of the degree they do not.
TEST(Degrees, numerators_have_the_degrees_that_are_counted)
{
  Random random(3);
  const auto p = random.nonzero_vector(), v = random.nonzero_vector();
  const int degree = Implicit_surface_3<Torus>()(curve_of_degree(1))->minors_numerator().value();
  std::vector<Q> values;
  for (int i = 0; i <= degree + 2; ++i)
    values.push_back(Implicit_surface_3<Torus>()
                       .level_set_shape(Coordinates<Q, 3>{
                         Q(p[0] + i * v[0]), Q(p[1] + i * v[1]), Q(p[2] + i * v[2])})
                       ->minors_numerator());
  for (int order = 1; order <= degree + 1; ++order)
  {
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      values[i] = values[i + 1] - values[i];
    values.pop_back();
    if (order == degree)
    {
      EXPECT_NE(values[0], Q(0));
    }
  }
  for (const Q& x : values)
    EXPECT_EQ(x, Q(0));
}

} // namespace
