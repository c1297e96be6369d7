// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases of implicit and parametric surfaces in every number type.

#include "oracle_ladder.h"
#include "oracle_surfaces.h"

namespace {

using namespace oracles;

struct Implicit_cases
{
  static constexpr const char* name = "implicit_curvature";
  static constexpr int number = 28;

  template <class Run>
  static void for_each(Run run)
  {
    for (const Case& c : cases(name))
      run(c, implicit(c), point<Q, 3>(c.inputs.texts("point")));
  }
};

struct Parametric_cases
{
  static constexpr const char* name = "parametric_curvature";
  static constexpr int number = 16;

  template <class Run>
  static void for_each(Run run)
  {
    for (const Case& c : cases(name))
      run(c, parametric(c), point<Q, 2>(c.inputs.texts("at")));
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Oracles_implicit_curvature, Surface_cases, Implicit_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(Oracles_parametric_curvature, Surface_cases, Parametric_cases);

// The stages of the filter that are for doubles only.
template <class Kind>
void run_filtered_doubles()
{
  Count count(Kind::name, "filtered, the query given in double");
  Surface_cases<Kind>::visit(count, [&](const Case& c, const auto& surface, const auto& query,
                                        const Q&) {
    const auto d = cast_argument<double>(query);
    if (cast_argument<Q>(d) != query)
      return count.skip(c.id, "its numbers are no doubles");
    run_filtered<Q>(c, surface, d, count);
  });
  EXPECT_EQ(count.undecided(), 0);
}

TEST(Oracles_implicit_curvature, filtered_doubles) { run_filtered_doubles<Implicit_cases>(); }
TEST(Oracles_parametric_curvature, filtered_doubles) { run_filtered_doubles<Parametric_cases>(); }

TEST(Oracles_implicit_curvature, exact)
{
  Count count("implicit_curvature", "exact rationals");
  Surface_cases<Implicit_cases>::visit(count, [&](const Case& c, const Implicit& surface,
                                                  const auto& p, const Q&) {
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

TEST(Oracles_parametric_curvature, exact)
{
  Count count("parametric_curvature", "exact rationals");
  Surface_cases<Parametric_cases>::visit(count, [&](const Case& c, const Parametric& surface,
                                                    const auto& uv, const Q&) {
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

} // namespace
