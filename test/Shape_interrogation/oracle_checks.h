// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ORACLE_CHECKS_H
#define SHAPE_INTERROGATION_TEST_ORACLE_CHECKS_H

// Comparison of a local shape with the block of fields that all surface cases have.

#include "oracles.h"

#include <CGAL/Shape_interrogation/Analysis/compare_principal_curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace oracles {

using namespace CGAL::Shape_interrogation;
using Q = CGAL::Exact_rational;
using Real = CORE::Expr;
using Interval = CGAL::Interval_nt<false>;

template <class NT>
NT number(const std::string& text)
{
  const Expression_tape tape({parse_number(text)}, 0, Expression_tape::Derivatives::NONE);
  return tape.evaluate(std::vector<NT>())[0];
}

template <class NT>
std::vector<NT> numbers(const Texts& texts)
{
  std::vector<NT> result;
  for (const std::string& text : texts)
    result.push_back(number<NT>(text));
  return result;
}

template <class NT, std::size_t n>
std::array<NT, n> point(const Texts& texts)
{
  std::array<NT, n> p;
  for (std::size_t i = 0; i < n; ++i)
    p[i] = number<NT>(texts.at(i));
  return p;
}

// The number, unless it takes roots that the number type has not got.
template <class NT>
std::optional<NT> number_if_representable(const std::string& text)
{
  try
  {
    return number<NT>(text);
  }
  catch (const Not_algebraic_error&) { return std::nullopt; }
  catch (const Mixed_roots_error&) { return std::nullopt; }
}

inline bool has_root(const Texts& texts)
{
  for (const std::string& text : texts)
    if (text.find("sqrt") != std::string::npos)
      return true;
  return false;
}

template <class NT>
void expect_equal(const NT& x, const Fields& expected, const std::string& field)
{
  EXPECT_EQ(x, number<NT>(expected.text(field))) << field;
}

// mu with `normal` = mu N for the N of the case, which must be the same for all components.
template <class NT>
NT factor_of_normal(const Local_shape_3<NT>& s, const Fields& e)
{
  const auto n = point<NT, 3>(e.texts("N"));
  int k = 0;
  while (CGAL::is_zero(n[k]))
    ++k;
  const NT mu = s.normal()[k] / n[k];
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(s.normal()[i], NT(mu * n[i])) << "normal, component " << i;
  return mu;
}

inline const char* name(Point_type type)
{
  static const char* const names[] = {"elliptic", "hyperbolic", "parabolic", "planar"};
  return names[static_cast<int>(type)];
}

template <class NT>
void expect_decisions(const Local_shape_3<NT>& s, const Fields& e)
{
  EXPECT_EQ(int(sign_of_gaussian_curvature(s)), e.integer("sign_K"));
  EXPECT_EQ(int(sign_of_mean_curvature(s)), e.integer("sign_H"));
  EXPECT_EQ(bool(is_umbilic(s)), e.flag("umbilic"));
  EXPECT_EQ(bool(is_planar(s)), e.flag("planar"));
  EXPECT_EQ(bool(is_parabolic(s)), e.text("point_type") == "parabolic");
  EXPECT_EQ(name(point_type(s)), e.text("point_type"));
}

template <class NT>
void expect_matrix(const Symmetric_matrix_3<NT>& m, const NT& factor, const Fields& e,
                   const std::string& field)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(m(i, j), NT(factor * number<NT>(e.texts(field).at(3 * i + j))))
        << field << " " << i << j;
}

// Everything that is rational in the data. `mu` is positive.
template <class NT>
void expect_rational_block(const Local_shape_3<NT>& s, const NT& mu, const Fields& e)
{
  EXPECT_EQ(s.normal_squared_length(), NT(mu * mu * number<NT>(e.text("q"))));
  expect_matrix(s.shape_matrix(), mu, e, "B");
  const NT cq = s.scale() * s.normal_squared_length();
  EXPECT_EQ(s.trace_numerator(), NT(cq * mu * number<NT>(e.text("trB"))));
  EXPECT_EQ(NT(s.minors_numerator() * s.normal_squared_length()),
            NT(cq * cq * mu * mu * number<NT>(e.text("minors2B"))));
  EXPECT_EQ(umbilic_discriminant(s),
            NT(cq * cq * mu * mu * number<NT>(e.text("umbilic_discriminant"))));
  expect_equal(gaussian_curvature(s), e, "K");
  expect_equal(squared_mean_curvature(s), e, "H_sq");
  expect_equal(squared_curvature_gap(s), e, "kappa_gap_sq");
  if (e.has("projector_kappa_max"))
  {
    const auto projector = projector_on_max_direction(s);
    ASSERT_TRUE(projector);
    expect_matrix(*projector, NT(1), e, "projector_kappa_max");
  }
  if (e.flag("umbilic"))
  {
    EXPECT_EQ(projector_on_max_direction(s).refusal().code(), Refusal_code::AMBIGUOUS);
  }
}

// The principal curvatures in the smallest field that has the texts: NT, one root, or exact reals.
template <class Field, class NT>
bool compare_principals(const Local_shape_3<NT>& s, const Fields& e)
{
  const auto low = number_if_representable<Field>(e.text("kappa_min"));
  const auto high = number_if_representable<Field>(e.text("kappa_max"));
  if (!low || !high)
    return false;
  const auto t = s.template cast<Field>();
  EXPECT_EQ(compare_principal_curvature(t, Principal::MIN, *low), CGAL::EQUAL);
  EXPECT_EQ(compare_principal_curvature(t, Principal::MAX, *high), CGAL::EQUAL);
  EXPECT_EQ(compare_principal_curvature(t, Principal::MAX, *low),
            e.flag("umbilic") ? CGAL::EQUAL : CGAL::LARGER);
  EXPECT_EQ(compare_principal_curvature(t, Principal::MIN, *high),
            e.flag("umbilic") ? CGAL::EQUAL : CGAL::SMALLER);
  return true;
}

// H, H_h and the principal curvatures have roots.
template <class NT>
void expect_roots(const Local_shape_3<NT>& s, const Fields& e)
{
  if (!compare_principals<NT>(s, e) && !compare_principals<Quadratic_field>(s, e))
    compare_principals<Real>(s, e);
  EXPECT_EQ(compare_principal_curvatures(s, Principal::MIN, s, Principal::MAX),
            e.flag("umbilic") ? CGAL::EQUAL : CGAL::SMALLER);
  const auto t = s.template cast<Real>();
  EXPECT_EQ(mean_curvature(t), number<Real>(e.text("H")));
  EXPECT_EQ(mean_curvature(t.opposite()), number<Real>(e.text("H_opposite_sign_convention")));
  const auto b = s.shape_matrix();
  const Real length = CGAL::sqrt(t.normal_squared_length());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const Real h = number_cast<Real>(b(i, j)) / length;
      EXPECT_EQ(h, number<Real>(e.texts("H_h").at(3 * i + j))) << "H_h " << i << j;
    }
}

template <class NT>
void expect_block(const Local_shape_3<NT>& s, const Fields& e, bool same_normal)
{
  const NT mu = factor_of_normal(s, e);
  if (same_normal)
  {
    EXPECT_EQ(mu, NT(1));
  }
  ASSERT_TRUE(CGAL::is_positive(mu)) << "the normal has the other orientation";
  expect_decisions(s, e);
  expect_rational_block(s, mu, e);
  expect_roots(s, e);
}

template <class T>
void expect_refusal(const Result<T>& s, const Fields& e)
{
  ASSERT_FALSE(s) << "there must be no answer";
  EXPECT_EQ(to_string(s.refusal().code()), e.text("reason")) << s.refusal().evidence();
}

} // namespace oracles

#endif // SHAPE_INTERROGATION_TEST_ORACLE_CHECKS_H
