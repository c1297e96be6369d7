// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases of implicit and parametric surfaces in every number type.

#include "oracle_ladder.h"

#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

namespace {

using namespace oracles;

using Implicit = Implicit_surface_3<Expression_function<3>>;
using Parametric = Parametric_surface_3<Expression_function<2, 3>>;

Implicit implicit(const Case& c)
{
  return Implicit(
    Expression_function<3>(parse_expression(c.inputs.text("f"), c.inputs.texts("vars"))));
}

Parametric parametric(const Case& c)
{
  std::vector<Expression> s;
  for (const std::string& x : c.inputs.texts("S"))
    s.push_back(parse_expression(x, c.inputs.texts("params")));
  return Parametric(Expression_function<2, 3>(s));
}

// A certified decision is about the level set of the point; whether that is the surface is asked
// apart.
struct Level_set
{
  Implicit surface;

  template <class NT>
  auto operator()(const Coordinates<NT, 3>& p) const
  {
    return surface.level_set_shape(p);
  }
};

struct Is_on_surface
{
  template <class NT>
  auto operator()(const Implicit& surface, const Coordinates<NT, 3>& p) const
  {
    return is_zero_decision(surface.function()(p[0], p[1], p[2]));
  }
};

// Calls run(case, surface, point) for all cases of both kinds.
template <class Run>
void for_each_implicit(Count& count, Run run)
{
  for (const Case& c : cases("implicit_curvature"))
  {
    SCOPED_TRACE(c.id);
    run(c, implicit(c), point<Q, 3>(c.inputs.texts("point")));
  }
  EXPECT_EQ(count.visited(), 28);
}

template <class Run>
void for_each_parametric(Count& count, Run run)
{
  for (const Case& c : cases("parametric_curvature"))
  {
    SCOPED_TRACE(c.id);
    run(c, parametric(c), point<Q, 2>(c.inputs.texts("at")));
  }
  EXPECT_EQ(count.visited(), 16);
}

TEST(Oracles_implicit_curvature, exact)
{
  Count count("implicit_curvature", "exact rationals");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    count.run();
    const auto s = surface(p);
    if (c.is_refused())
      return expect_refusal(s, c.expected);
    ASSERT_TRUE(s) << s.refusal().evidence();
    EXPECT_EQ(s->point(), p);
    expect_block(*s, c.expected, true);
  });
}

TEST(Oracles_implicit_curvature, residual_off_the_surface)
{
  int found = 0;
  for (const Case& c : cases("implicit_curvature"))
    if (c.expected.has("residual"))
    {
      ++found;
      const auto p = point<Q, 3>(c.inputs.texts("point"));
      EXPECT_EQ(implicit(c).function()(p[0], p[1], p[2]),
                number<Q>(c.expected.text("residual")));
    }
  EXPECT_EQ(found, 1);
}

TEST(Oracles_implicit_curvature, interval)
{
  Count count("implicit_curvature", "intervals");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    run_interval<Q>(c, surface, p, count);
  });
  EXPECT_GT(count.decided(), count.undecided());
}

TEST(Oracles_implicit_curvature, approximate)
{
  Count count("implicit_curvature", "double");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    run_double<Q>(c, surface, p, count);
  });
}

TEST(Oracles_implicit_curvature, filtered)
{
  Count count("implicit_curvature", "filtered");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    const bool is_on = Filtered<Is_on_surface>()(surface, p);
    EXPECT_EQ(is_on, !c.expected.has("residual"));
    if (is_on)
      run_filtered<Q>(c, Level_set{surface}, p, count);
    else
      count.run();
  });
  EXPECT_EQ(count.undecided(), 0);
}

TEST(Oracles_implicit_curvature, filtered_doubles)
{
  Count count("implicit_curvature", "filtered, the point given in double");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    const auto d = cast_argument<double>(p);
    if (cast_argument<Q>(d) != p)
      return count.skip(c.id, "the point is not a double");
    const bool is_on = Filtered<Is_on_surface>()(surface, d);
    EXPECT_EQ(is_on, !c.expected.has("residual"));
    run_filtered<Q>(c, Level_set{surface}, d, count);
  });
  EXPECT_EQ(count.undecided(), 0);
}

TEST(Oracles_implicit_curvature, exact_real)
{
  Count count("implicit_curvature", "exact reals");
  for_each_implicit(count, [&](const Case& c, const Implicit& surface, const auto& p) {
    run_real(c, surface, p, count);
  });
}

// The first and second fundamental forms before they are combined.
void expect_forms(const Surface_derivatives_3<Q>& d, const Fields& e)
{
  const auto n = internal::cross(d.u, d.v);
  expect_equal(internal::dot(d.u, d.u), e, "E");
  expect_equal(internal::dot(d.u, d.v), e, "F");
  expect_equal(internal::dot(d.v, d.v), e, "G");
  const Q l = internal::dot(n, d.uu), m = internal::dot(n, d.uv), k = internal::dot(n, d.vv);
  expect_equal(l, e, "Lhat");
  expect_equal(m, e, "Mhat");
  expect_equal(k, e, "Nhat");
  expect_equal(Q(l * k - m * m), e, "det_Lhat");
}

TEST(Oracles_parametric_curvature, exact)
{
  Count count("parametric_curvature", "exact rationals");
  for_each_parametric(count, [&](const Case& c, const Parametric& surface, const auto& uv) {
    count.run();
    const auto s = surface(uv);
    const auto expected_point = point<Q, 3>(c.expected.texts("point"));
    EXPECT_EQ(surface.derivatives(uv).s, expected_point);
    if (c.is_refused())
      return expect_refusal(s, c.expected);
    ASSERT_TRUE(s) << s.refusal().evidence();
    EXPECT_EQ(s->point(), expected_point);
    expect_forms(surface.derivatives(uv), c.expected);
    expect_block(*s, c.expected, true);
  });
}

TEST(Oracles_parametric_curvature, interval)
{
  Count count("parametric_curvature", "intervals");
  for_each_parametric(count, [&](const Case& c, const Parametric& surface, const auto& uv) {
    run_interval<Q>(c, surface, uv, count);
  });
  EXPECT_GT(count.decided(), count.undecided());
}

TEST(Oracles_parametric_curvature, approximate)
{
  Count count("parametric_curvature", "double");
  for_each_parametric(count, [&](const Case& c, const Parametric& surface, const auto& uv) {
    run_double<Q>(c, surface, uv, count);
  });
}

TEST(Oracles_parametric_curvature, filtered)
{
  Count count("parametric_curvature", "filtered");
  for_each_parametric(count, [&](const Case& c, const Parametric& surface, const auto& uv) {
    run_filtered<Q>(c, surface, uv, count);
  });
  EXPECT_EQ(count.undecided(), 0);
}

TEST(Oracles_parametric_curvature, exact_real)
{
  Count count("parametric_curvature", "exact reals");
  for_each_parametric(count, [&](const Case& c, const Parametric& surface, const auto& uv) {
    run_real(c, surface, uv, count);
  });
}

} // namespace
