// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// The exact cases of Hartmann's normalform in every number type: its Hessian from three normal
// curvatures, by cases and without, and in the plane.

#include "oracle_ladder.h"
#include "oracle_surfaces.h"

#include <CGAL/Shape_interrogation/Analysis/hessian_by_cases.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>
#include <CGAL/Shape_interrogation/Curves/Implicit_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Parametric_curve_2.h>

namespace {

using namespace oracles;

// --- The Hessian of the normalform ---------------------------------------------------------------

template <class NT>
using Directions = std::array<Coordinates<NT, 3>, 3>;

// What a case with the form "curvatures" gives.
template <class NT>
struct Input
{
  Coordinates<NT, 3> normal;
  Directions<NT> directions;
  std::array<NT, 3> kappa;

  explicit Input(const Fields& inputs)
    : normal(point<NT, 3>(inputs.texts("normal"))), kappa(point<NT, 3>(inputs.texts("kappa")))
  {
    const std::vector<NT> d = numbers<NT>(inputs.texts("directions"));
    for (int i = 0; i < 9; ++i)
      directions[i / 3][i % 3] = d.at(i);
  }

  Result<Local_shape_3<NT>> shape() const
  {
    const NT zero(0);
    return shape_from_normal_curvatures<NT>({zero, zero, zero}, normal, directions, kappa);
  }
};

// The signs of the components of the normal, "++0".
template <class NT>
std::string signs(const Coordinates<NT, 3>& h)
{
  std::string text;
  for (const NT& x : h)
    text += "-0+"[int(CGAL::sign(x)) + 1];
  return text;
}

// The section of the paper that serves the pattern, as in the cases.
std::string branch(Normal_pattern pattern)
{
  const int axis = internal::vanishing_axis(pattern);
  return axis < 0 ? "4.1.1" : std::string("4.1.2 (h_") + "xyz"[axis] + "=0)";
}

std::string expected_name(const std::string& pattern)
{
  std::string name;
  for (int i = 0; i < 3; ++i)
    if (pattern[i] == '0')
      name += std::string("h") + "xyz"[i] + "=";
  return name.empty() ? "generic" : name + "0";
}

template <class NT>
Normal_pattern expect_pattern(const Coordinates<NT, 3>& h, const Case& c)
{
  const Normal_pattern pattern = normal_pattern(h);
  EXPECT_EQ(signs(h), c.inputs.text("pattern"));
  EXPECT_EQ(to_string(pattern), expected_name(c.inputs.text("pattern")));
  EXPECT_EQ(branch(pattern), c.expected.text("branch"));
  return pattern;
}

template <class NT>
void expect_curvatures(const Case& c)
{
  const Input<NT> input(c.inputs);
  const auto s = input.shape();
  ASSERT_TRUE(s) << s.refusal().evidence();
  expect_block(*s, c.expected, true);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(normal_curvature(*s, input.directions[i]), input.kappa[i]);
  const Normal_pattern pattern = expect_pattern(input.normal, c);
  EXPECT_EQ(case_directions(input.normal, pattern), input.directions);
  expect_matrix(hessian_by_cases(input.normal, pattern, input.kappa), NT(1), c.expected, "H_h");
}

template <class NT>
bool differs(const Symmetric_matrix_3<NT>& m, const std::vector<NT>& wrong)
{
  for (int i = 0; i < 9; ++i)
    if (m(i / 3, i % 3) != wrong.at(i))
      return true;
  return false;
}

// From a surface to the curvatures in the paper's directions, and back by the paper's cases.
template <class NT>
void expect_cases_agree(const Local_shape_3<NT>& s, const Case& c)
{
  const Fields& e = c.expected;
  const NT length = Elementary_functions<NT>::sqrt(s.normal_squared_length());
  Coordinates<NT, 3> h;
  for (int i = 0; i < 3; ++i)
    h[i] = s.normal()[i] / length;
  EXPECT_EQ(h, (point<NT, 3>(e.texts("unit_normal"))));
  const Normal_pattern pattern = expect_pattern(h, c);
  const Directions<NT> directions = case_directions(h, pattern);
  std::array<NT, 3> kappa;
  for (int i = 0; i < 3; ++i)
    kappa[i] = normal_curvature(s, directions[i]);
  EXPECT_EQ(kappa, (point<NT, 3>(e.texts("kappa_paper_directions"))));
  const auto by_cases = hessian_by_cases(h, pattern, kappa);
  expect_matrix(by_cases, NT(1), e, "H_h");
  if (e.has("printed_formula_gives_wrong_H_h"))
  {
    const auto wrong = numbers<NT>(e.texts("printed_formula_gives_wrong_H_h"));
    EXPECT_TRUE(differs(by_cases, wrong));
  }
  const auto solved = shape_from_normal_curvatures(s.point(), s.normal(), directions, kappa);
  ASSERT_TRUE(solved) << solved.refusal().evidence();
  const auto b = s.shape_matrix(), b_solved = solved->shape_matrix();
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
    {
      EXPECT_EQ(b_solved(i, j), b(i, j));
      EXPECT_EQ(NT(by_cases(i, j) * length), b(i, j));
    }
}

template <class NT>
Result<Local_shape_3<NT>> surface_shape(const Case& c)
{
  if (c.inputs.text("form") == "implicit")
    return implicit(c)(point<NT, 3>(c.inputs.texts("point")));
  return parametric(c)(point<NT, 2>(c.inputs.texts("at")));
}

bool is_from_curvatures(const Case& c) { return c.inputs.text("form") == "curvatures"; }

TEST(Oracles_normalform_hessian, exact)
{
  Count count("normalform_hessian", "exact rationals or one root");
  for (const Case& c : cases("normalform_hessian"))
  {
    SCOPED_TRACE(c.id);
    count.run();
    if (is_from_curvatures(c))
    {
      expect_curvatures<Q>(c);
      continue;
    }
    const auto s = surface_shape<Q>(c);
    ASSERT_TRUE(s) << s.refusal().evidence();
    expect_block(*s, c.expected, true);
    if (c.inputs.text("form") == "parametric")
    {
      EXPECT_EQ(s->point(), (point<Q, 3>(c.expected.texts("point"))));
      expect_forms(parametric(c).derivatives(point<Q, 2>(c.inputs.texts("at"))), c.expected);
    }
    // The unit normal has the root of q.
    expect_cases_agree(s->cast<Quadratic_field>(), c);
  }
  EXPECT_EQ(count.visited(), 19);
}

TEST(Oracles_normalform_hessian, cases_of_surfaces_in_exact_reals)
{
  int checked = 0;
  for (const Case& c : cases("normalform_hessian"))
    if (!is_from_curvatures(c))
    {
      SCOPED_TRACE(c.id);
      ++checked;
      const auto s = surface_shape<Real>(c);
      ASSERT_TRUE(s) << s.refusal().evidence();
      expect_cases_agree(*s, c);
    }
  EXPECT_EQ(checked, 8);
}

// A case as something that is called with numbers of any type: the input is the query.
struct From_curvatures
{
  template <class NT>
  Result<Local_shape_3<NT>> operator()(const std::vector<NT>& x) const
  {
    Coordinates<NT, 3> normal{x[0], x[1], x[2]};
    Directions<NT> d;
    for (int i = 0; i < 9; ++i)
      d[i / 3][i % 3] = x[3 + i];
    const NT zero(0);
    return shape_from_normal_curvatures<NT>({zero, zero, zero}, normal, d, {x[12], x[13], x[14]});
  }
};

std::vector<Q> query(const Case& c)
{
  Texts texts = c.inputs.texts("normal");
  for (const char* field : {"directions", "kappa"})
    texts.insert(texts.end(), c.inputs.texts(field).begin(), c.inputs.texts(field).end());
  return numbers<Q>(texts);
}

struct Normalform_cases
{
  static constexpr const char* name = "normalform_hessian";
  static constexpr int number = 19;

  template <class Run>
  static void for_each(Run run)
  {
    for (const Case& c : cases(name))
      if (is_from_curvatures(c))
        run(c, From_curvatures(), query(c));
      else if (c.inputs.text("form") == "implicit")
        run(c, implicit(c), point<Q, 3>(c.inputs.texts("point")));
      else
        run(c, parametric(c), point<Q, 2>(c.inputs.texts("at")));
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Oracles_normalform_hessian, Surface_cases, Normalform_cases);

// The formulas for the generic case lose their digits near a vanishing component, and the interval
// tells so; their result still contains the truth.
TEST(Oracles_normalform_hessian, case_formulas_in_intervals)
{
  int checked = 0;
  double widest = 0;
  for (const Case& c : cases("normalform_hessian"))
    if (is_from_curvatures(c))
    {
      SCOPED_TRACE(c.id);
      const Normal_pattern pattern = normal_pattern(Input<Q>(c.inputs).normal);
      Symmetric_matrix_3<Interval> m;
      {
        const Interval::Protector protector;
        const Input<Interval> input(c.inputs);
        m = hessian_by_cases(input.normal, pattern, input.kappa);
      }
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
        {
          EXPECT_TRUE(contains(m(i, j), number<Q>(c.expected.texts("H_h").at(3 * i + j))));
          widest = (std::max)(widest, m(i, j).sup() - m(i, j).inf());
        }
      ++checked;
    }
  EXPECT_EQ(checked, 11);
  EXPECT_GT(widest, 1) << "the twin with a component of 8e-21";
}

// --- Plane curves --------------------------------------------------------------------------------

template <class NT>
Result<Local_shape_2<NT>> curve_shape(const Case& c)
{
  const Fields& in = c.inputs;
  if (in.text("form") == "implicit")
    return Implicit_curve_2(Expression_function<2>(
      parse_expression(in.text("f"), in.texts("vars"))))(point<NT, 2>(in.texts("point")));
  std::vector<Expression> x;
  for (const std::string& text : in.texts("c"))
    x.push_back(parse_expression(text, {in.text("param")}));
  return Parametric_curve_2(Expression_function<1, 2>(x))(number<NT>(in.text("at")));
}

template <class NT>
NT squared_curvature(const Local_shape_2<NT>& s)
{
  const NT b = s.shape_number();
  NT k = b * b / s.normal_squared_length();
  return k;
}

// Everything, with the root of q in the field.
template <class NT>
void expect_curve(const Local_shape_2<NT>& s, const Fields& e)
{
  EXPECT_EQ(s.normal(), (point<NT, 2>(e.texts("N"))));
  EXPECT_EQ(s.normal_squared_length(), number<NT>(e.text("q")));
  EXPECT_EQ(int(CGAL::sign(s.numerator())), e.integer("sign_kappa"));
  EXPECT_EQ(squared_curvature(s), number<NT>(e.text("kappa_sq")));
  const NT length = Elementary_functions<NT>::sqrt(s.normal_squared_length());
  EXPECT_EQ(NT(s.shape_number() / length), number<NT>(e.text("kappa")));
  EXPECT_EQ(NT(s.opposite().shape_number() / length), NT(-number<NT>(e.text("kappa"))));
  const auto h = s.shape_matrix();
  const int place[] = {0, 1, 1, 2};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(NT(h[place[i]] / length), number<NT>(e.texts("H_h").at(i)));
  if (e.has("bordered_determinant"))
  {
    EXPECT_EQ(s.numerator(), NT(-number<NT>(e.text("bordered_determinant"))));
  }
  if (e.has("point"))
  {
    EXPECT_EQ(s.point(), (point<NT, 2>(e.texts("point"))));
  }
}

// Computes the shape in NT, and what has roots in Field.
template <class NT, class Field>
void run_curve(const Case& c, Count& count)
{
  count.run();
  const auto s = curve_shape<NT>(c);
  if (c.is_refused())
    return expect_refusal(s, c.expected);
  ASSERT_TRUE(s) << s.refusal().evidence();
  expect_curve(s->template cast<Field>(), c.expected);
}

void run_curve_in_intervals(const Case& c, Count& interval, Count& approximate)
{
  interval.run();
  approximate.run();
  Result<Local_shape_2<Interval>> s = Refusal(Refusal_code::UNDECIDED, "");
  Interval kappa_squared;
  {
    const Interval::Protector protector;
    s = curve_shape<Interval>(c);
    if (s)
      kappa_squared = squared_curvature(*s);
  }
  const auto d = curve_shape<double>(c);
  if (c.is_refused())
  {
    expect_refusal(s, c.expected);
    return expect_refusal(d, c.expected);
  }
  ASSERT_TRUE(s && d);
  const CGAL::Sign sign = CGAL::Sign(c.expected.integer("sign_kappa"));
  expect_decision(sign_decision(s->numerator()), sign, "sign of the curvature", interval);
  EXPECT_EQ(CGAL::sign(d->numerator()), sign);
  const std::string exact = c.expected.text("kappa_sq");
  EXPECT_TRUE(contains(kappa_squared, number<Q>(exact)));
  expect_near(squared_curvature(*d), kappa_squared, number<Real>(exact), "curvature squared",
              approximate);
}

struct Decide_sign_of_curve
{
  template <class Curve, class Query>
  auto operator()(const Curve& curve, const Query& p) const
  {
    using NT = std::decay_t<decltype(curve(p)->numerator())>;
    using Answer = Result<typename Number_type_traits<NT>::Sign>;
    const auto s = curve(p);
    return s ? Answer(sign_decision(s->numerator())) : Answer(s.refusal());
  }
};

void run_curve_filtered(const Case& c, Count& count)
{
  count.run();
  const Fields& in = c.inputs;
  const int sign = c.is_refused() ? 0 : c.expected.integer("sign_kappa");
  const Filtered<Decide_sign_of_curve> decide;
  if (in.text("form") == "implicit")
  {
    const Implicit_curve_2 curve(
      Expression_function<2>(parse_expression(in.text("f"), in.texts("vars"))));
    return expect_filtered(decide(curve, point<Q, 2>(in.texts("point"))), sign, c, count);
  }
  const Parametric_curve_2 curve(Expression_function<1, 2>(
    std::vector{parse_expression(in.texts("c")[0], {in.text("param")}),
                parse_expression(in.texts("c")[1], {in.text("param")})}));
  expect_filtered(decide(curve, number<Q>(in.text("at"))), sign, c, count);
}

TEST(Oracles_curve_normalform, all_number_types)
{
  Counts counts("curve_normalform");
  for (const Case& c : cases("curve_normalform"))
  {
    SCOPED_TRACE(c.id);
    // The curvature has the root of q, which no rational is; the shape has none.
    run_curve<Q, Quadratic_field>(c, counts.exact);
    run_curve<Quadratic_field, Quadratic_field>(c, counts.one_root);
    run_curve<Real, Real>(c, counts.real);
    run_curve_in_intervals(c, counts.interval, counts.approximate);
    run_curve_filtered(c, counts.filtered);
  }
  counts.expect_visited(4);
}

} // namespace
