// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Constructions from constraints against surfaces that have a closed form, exactly at rational
// points; what does not hold, in words; the identities of redundant equations.

#include "exact_checks.h"
#include "random_rationals.h"

#include <CGAL/Shape_interrogation/Constraints/equal_distance.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/parametric_graph.h>
#include <CGAL/Shape_interrogation/Constraints/rolling_ball.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Constraints/trimming_surface.h>
#include <CGAL/Shape_interrogation/Constraints/variable_radius_blend.h>
#include <CGAL/Shape_interrogation/Constraints/verify_identities.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace testing_shapes;
using Point = Coordinates<Q, 3>;
using Values = std::vector<Q>;
constexpr int number_of_points = 30; // of which a few may coincide

Expression parse(const std::string& text) { return parse_expression(text, {"x", "y", "z"}); }

Implicit_entity_3 implicit(const std::string& f) { return Implicit_entity_3(parse(f)); }

Parametric_entity_3 parametric(const std::string& x, const std::string& y, const std::string& z,
                               const std::string& weight = "1")
{
  const auto read = [](const std::string& text) { return parse_expression(text, {"s", "t"}); };
  return Parametric_entity_3({read(x), read(y), read(z)}, "", read(weight));
}

Curve_entity_3 curve(const std::string& x, const std::string& y, const std::string& z,
                     const std::string& weight = "1")
{
  const auto read = [](const std::string& text) { return parse_expression(text, {"r"}); };
  return Curve_entity_3({read(x), read(y), read(z)}, "", read(weight));
}

// A rational point of the unit circle.
std::array<Q, 2> on_circle(const Q& t)
{
  const Q w = 1 + t * t;
  return {Q((1 - t * t) / w), Q(2 * t / w)};
}

Point on_sphere(Random& random)
{
  const Q u = random.nonzero_rational(), v = random.nonzero_rational();
  const Q w = 1 + u * u + v * v;
  return {Q(2 * u / w), Q(2 * v / w), Q((u * u + v * v - 1) / w)};
}

// a + t b
Point move(const Point& a, const Q& t, const Point& b)
{
  return {Q(a[0] + t * b[0]), Q(a[1] + t * b[1]), Q(a[2] + t * b[2])};
}

Values join(const std::vector<Values>& parts)
{
  Values all;
  for (const Values& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

Values values(const Point& p) { return {p[0], p[1], p[2]}; }

// The same data, whatever the length and the orientation of the normals.
template <class NT>
void expect_proportional(const Local_shape_3<NT>& a, const Local_shape_3<NT>& b)
{
  EXPECT_EQ(a.point(), b.point());
  const auto &m = a.normal(), &n = b.normal();
  const NT mu = internal::dot(m, n) / internal::dot(m, m);
  const auto x = a.shape_matrix(), y = b.shape_matrix();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(n[i], NT(mu * m[i]));
    for (int j = i; j < 3; ++j)
      EXPECT_EQ(y(i, j), NT(mu * x(i, j)));
  }
  EXPECT_EQ(gaussian_curvature(a), gaussian_curvature(b));
  EXPECT_EQ(squared_mean_curvature(a), squared_mean_curvature(b));
  const bool opposite = sign_decision(mu) == CGAL::NEGATIVE;
  EXPECT_EQ(sign_of_mean_curvature(a), opposite ? -sign_of_mean_curvature(b)
                                                : sign_of_mean_curvature(b));
}

// A system with its surface and, if there is one, the closed form of that, to which it is compared
// at 20 points or more.
class Construction
{
public:
  explicit Construction(Constraint_system system, const std::string& closed_form = "x")
    : m_system(std::move(system)), m_surface(m_system.n_space_system()),
      m_closed_form(Expression_function<3>(parse(closed_form)))
  {
    EXPECT_EQ(2, m_system.expected_dimension());
    EXPECT_TRUE(CGAL::certainly(verify_identities(m_system)));
  }

  ~Construction() { EXPECT_TRUE(m_points.empty() || m_points.size() >= 20u) << m_points.size(); }

  template <class NT>
  Local_shape_3<NT> shape(const std::vector<NT>& point) const
  {
    for (const auto& violation : m_system.violated(point))
      ADD_FAILURE() << violation.sentence;
    const auto result = m_surface(point);
    if (!result)
      throw std::runtime_error(result.refusal().evidence()); // fails the test
    return *result;
  }

  void expect_closed_form(const Values& point)
  {
    m_points.insert(point);
    const auto expected = m_closed_form(Point{point[0], point[1], point[2]});
    ASSERT_TRUE(expected) << expected.refusal().evidence();
    expect_proportional(*expected, shape(point));
  }

  const Constraint_system& system() const { return m_system; }

private:
  Constraint_system m_system;
  N_space_surface_3 m_surface;
  Implicit_surface_3<Expression_function<3>> m_closed_form;
  std::set<Values> m_points;
};

// --- Offsets -------------------------------------------------------------------------------------

TEST(Offset_system, sphere)
{
  const Q d = fraction(-3, 7); // of the radius 4/7
  const std::string sphere = "x^2+y^2+z^2-16/49";
  Construction of_implicit(offset_system(implicit("x^2+y^2+z^2-1"), d), sphere);
  Construction of_point(offset_system(Constraint_point_3{"", {0, 0, 0}}, fraction(4, 7)),
                              sphere);
  Construction of_patch(
    offset_system(parametric("2*s", "2*t", "s^2+t^2-1", "1+s^2+t^2"), d), sphere);
  EXPECT_EQ(6, of_implicit.system().number_of_variables());
  EXPECT_EQ(5, of_implicit.system().number_of_equations());
  EXPECT_EQ(5, of_patch.system().number_of_variables());
  Random random(1);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Point p = on_sphere(random), q = move(p, d, p);
    of_implicit.expect_closed_form(join({values(q), values(p)}));
    of_point.expect_closed_form(values(q));
    of_patch.expect_closed_form(
      join({values(q), {Q(p[0] / (1 - p[2])), Q(p[1] / (1 - p[2]))}}));
  }
}

TEST(Offset_system, cylinder)
{
  const Q d = fraction(2, 3);
  const std::string cylinder = "x^2+y^2-25/9";
  Construction of_implicit(offset_system(implicit("x^2+y^2-1"), d), cylinder);
  Construction of_axis(offset_system(curve("0", "0", "r"), fraction(5, 3)), cylinder);
  Random random(2);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [x, y] = on_circle(random.rational());
    const Point p{x, y, random.rational()}, q = move(p, d, Point{x, y, 0});
    of_implicit.expect_closed_form(join({values(q), values(p)}));
    of_axis.expect_closed_form(join({values(q), {p[2]}}));
  }
}

// The torus of radii 3 and 1/2 at the distance 1/2, and as a tube around a rational Bezier arc.
TEST(Offset_system, torus)
{
  const std::string torus = "(x^2+y^2+z^2+8)^2-36*(x^2+y^2)";
  Construction of_implicit(
    offset_system(implicit("(x^2+y^2+z^2+35/4)^2-36*(x^2+y^2)"), fraction(1, 2)), torus);
  const auto circle =
    Curve_entity_3::bezier({{3, 0, 0, 1}, {3, 3, 0, 1}, {0, 6, 0, 2}}, "the circle");
  Construction of_curve(offset_system(circle, 1), torus);
  EXPECT_EQ("p is the projection of q onto the circle",
            of_curve.system().constraints()[0].statement());
  Random random(3);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q t = random.rational();
    const auto [c, s] = on_circle(t);
    const auto [a, b] = on_circle(random.rational());
    const Point centre{Q(3 * c), Q(3 * s), 0}, n{Q(a * c), Q(a * s), b};
    const Point p = move(centre, fraction(1, 2), n), q = move(centre, 1, n);
    of_implicit.expect_closed_form(join({values(q), values(p)}));
    of_curve.expect_closed_form(join({values(q), {t}}));
  }
}

// No closed form: the formulas for the offset of any surface, with the root of N.N adjoined.
TEST(Offset_system, ellipsoid)
{
  using NT = Quadratic_field;
  const auto ellipsoid = implicit("x^2/4+y^2/9+z^2-1");
  const Implicit_surface_3<Expression_function<3>> base{
    Expression_function<3>(ellipsoid.function())};
  Random random(4);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q d = i % 2 == 0 ? fraction(3, 4) : fraction(-1, 8);
    Construction offset(offset_system(ellipsoid, d));
    const Point u = on_sphere(random), p{Q(2 * u[0]), Q(3 * u[1]), u[2]};
    const auto at_foot = base(p);
    ASSERT_TRUE(at_foot);
    const auto& n = at_foot->normal();
    const Q q = internal::dot(n, n), k = gaussian_curvature(*at_foot);
    const auto b = at_foot->shape_matrix();
    const NT s(0, 1, q), h = NT(Q(internal::trace(b) / 2)) / s;
    const NT den = NT(1) + NT(2 * d) * h + NT(Q(d * d * k));
    Symmetric_matrix_3<NT> expected_b;
    std::vector<NT> point;
    Coordinates<NT, 3> x, normal;
    for (int r = 0; r < 3; ++r)
    {
      normal[r] = NT(n[r]);
      x[r] = NT(p[r]) + NT(Q(d * n[r])) / s;
      point.push_back(x[r]);
      for (int c = r; c < 3; ++c)
      {
        const Q projector = Q(r == c) - n[r] * n[c] / q;
        expected_b(r, c) = (NT(b(r, c)) + s * NT(Q(d * k * projector))) / den;
      }
    }
    point.insert(point.end(), p.begin(), p.end());
    const Local_shape_3<NT> shape = offset.shape(point);
    expect_proportional(Local_shape_3<NT>(x, normal, expected_b), shape);
    const NT expected_h = (h + NT(Q(d * k))) / den;
    EXPECT_EQ(gaussian_curvature(shape), NT(NT(k) / den));
    EXPECT_EQ(squared_mean_curvature(shape), NT(expected_h * expected_h));
  }
}

TEST(Offset_system, distances_with_roots_are_squared_exactly)
{
  Construction offset(offset_system(implicit("z"), sqrt(Expression(2)) / 2));
  const auto residual = offset.system().violated(Values{0, 0, 1, 0, 0, 0});
  ASSERT_EQ(1u, residual.size());
  EXPECT_EQ("the distance of q and p is not 1/2*sqrt(2)", residual[0].sentence);
  EXPECT_EQ(Values{fraction(1, 2)}, residual[0].residuals);
  EXPECT_THROW(offset_system(implicit("z"), 0), Shape_error);
}

// --- Equal distance ------------------------------------------------------------------------------

TEST(Equal_distance, point_and_plane)
{
  Construction paraboloid(
    equal_distance(Constraint_point_3{"the focus", {0, 0, 1}}, implicit("z+1")), "x^2+y^2-4*z");
  Random random(5);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational(), y = random.rational();
    const Point q{x, y, Q((x * x + y * y) / 4)};
    paraboloid.expect_closed_form(join({values(q), {x, y, -1}}));
  }
}

TEST(Equal_distance, two_lines)
{
  Construction paraboloid(equal_distance(curve("r", "0", "1"), curve("0", "r", "-1")),
                                "y^2-x^2-4*z");
  EXPECT_EQ((std::vector<std::string>{"x", "y", "z", "p_A_r", "p_B_r"}),
            paraboloid.system().variables());
  Random random(6);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational(), y = random.rational();
    paraboloid.expect_closed_form({x, y, Q((y * y - x * x) / 4), x, y});
  }
}

TEST(Equal_distance, sphere_and_plane)
{
  Construction mixed(
    equal_distance(implicit("x^2+y^2+(z-3)^2-1"), parametric("s+t", "s-t", "0")),
    "x^2+y^2-8*z+8");
  Construction both(equal_distance(implicit("x^2+y^2+(z-3)^2-1"), implicit("z")),
                          "x^2+y^2-8*z+8");
  Random random(7);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational(), y = random.rational();
    const Point q{x, y, Q((x * x + y * y + 8) / 8)}, centre{0, 0, 3};
    const Point p = move(centre, Q(1 / (q[2] + 1)), move(q, -1, centre));
    mixed.expect_closed_form(
      join({values(q), values(p), {Q((x + y) / 2), Q((x - y) / 2)}}));
    both.expect_closed_form(join({values(q), values(p), {x, y, 0}}));
  }
}

// Three make a curve, here the axis of a corner: no second-order data of a surface.
TEST(Equal_distance, three_planes)
{
  const auto system = equal_distance(implicit("x"), implicit("y"), implicit("z"));
  EXPECT_EQ(1, system.expected_dimension());
  const Values point{1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0};
  EXPECT_TRUE(system.violated(point).empty());
  expect_refusal(Refusal_code::NOT_TWO_DIMENSIONAL,
                 N_space_surface_3(system.n_space_system())(point));
}

// --- Blends --------------------------------------------------------------------------------------

TEST(Rolling_ball, two_planes)
{
  Construction cylinder(rolling_ball(implicit("z"), implicit("y"), 1), "(y-1)^2+(z-1)^2-1");
  EXPECT_EQ(12, cylinder.system().number_of_variables());
  EXPECT_EQ(12, cylinder.system().number_of_equations());
  Random random(8);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational();
    const auto [c, s] = on_circle(random.rational());
    cylinder.expect_closed_form({x, Q(1 + c), Q(1 + s), x, 1, 1, x, 1, 0, x, 0, 1});
  }
}

// A ball of radius 1 between the plane and a sphere of radius 4.
TEST(Rolling_ball, plane_and_sphere)
{
  const std::string torus = "(x^2+y^2+(z-1)^2+15)^2-64*(x^2+y^2)";
  Construction both(rolling_ball(implicit("z"), implicit("x^2+y^2+(z+2)^2-16"), 1), torus);
  Construction mixed(
    rolling_ball(parametric("s", "t", "0"), implicit("x^2+y^2+(z+2)^2-16"), 1), torus);
  Random random(9);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [c, s] = on_circle(random.rational());
    const auto [a, b] = on_circle(random.rational());
    const Point centre{Q(4 * c), Q(4 * s), 1}, of_sphere{0, 0, -2};
    const Point q = move(centre, 1, Point{Q(a * c), Q(a * s), b});
    const Point p = move(of_sphere, fraction(4, 5), move(centre, -1, of_sphere));
    both.expect_closed_form(
      join({values(q), values(centre), {centre[0], centre[1], 0}, values(p)}));
    mixed.expect_closed_form(join({values(q), values(centre), {centre[0], centre[1]}, values(p)}));
  }
}

TEST(Rolling_ball, parallel_cylinders)
{
  Construction cylinder(rolling_ball(implicit("y^2+z^2-9"), implicit("(y-6)^2+z^2-9"), 2),
                              "(y-3)^2+(z-4)^2-4");
  Random random(10);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q x = random.rational(), f = fraction(3, 5);
    const auto [c, s] = on_circle(random.rational());
    cylinder.expect_closed_form({x, Q(3 + 2 * c), Q(4 + 2 * s), x, 3, 4, x, Q(3 * f), Q(4 * f),
                                 x, Q(6 - 3 * f), Q(4 * f)});
  }
}

// The centre moves on an ellipse. A canal surface has the curvatures 1/r along the circles and
// -k.e/(1 - r k.e) across, for the curvature vector k of the spine and the outward normal e.
TEST(Rolling_ball, crossing_cylinders)
{
  const Q radius = fraction(1, 2), rho = fraction(3, 2);
  Construction blend(rolling_ball(implicit("y^2+z^2-1"), implicit("x^2+z^2-1"), radius));
  Random random(11);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [s, c] = on_circle(random.fraction(1, 9, 9) + 1);
    const Point centre{Q(rho * s), Q(rho * s), Q(rho * c)};
    const Point pa{centre[0], s, c}, pb{s, centre[1], c};
    const Point u{0, s, c}, v{s, 0, c}, m = move(u, random.rational(), v);
    const Q factor = 2 * internal::dot(u, m) / internal::dot(m, m);
    const Point e = move(Point{0, Q(-s), Q(-c)}, factor, m); // u reflected, in the plane of u, v
    const Point q = move(centre, radius, e);
    const Point t{Q(rho * c), Q(rho * c), Q(-rho * s)}, bend{Q(-rho * s), Q(-rho * s), Q(-rho * c)};
    const Q speed = internal::dot(t, t);
    const Point k = move(bend, Q(-internal::dot(bend, t) / speed), t);
    const Q ke = internal::dot(k, e) / speed, across = -ke / (1 - radius * ke);
    Symmetric_matrix_3<Q> b;
    for (int r = 0; r < 3; ++r)
      for (int w = r; w < 3; ++w)
      {
        const Q along = Q(r == w) - e[r] * e[w] - t[r] * t[w] / speed;
        b(r, w) = along / radius + across * t[r] * t[w] / speed;
      }
    expect_proportional(
      Local_shape_3<Q>(q, e, b),
      blend.shape(join({values(q), values(centre), values(pa), values(pb)})));
  }
}

// Balls around (t, t, t) with the radius t touch the planes and envelop a cone.
TEST(Variable_radius_blend, two_planes)
{
  const std::string cone = "2*(x^2+y^2+z^2)-(x+y+z)^2";
  const auto a = implicit("z"), b = implicit("y");
  Construction by_plane(variable_radius_blend(a, b, implicit("x-y")), cone);
  Construction by_patch(variable_radius_blend(a, b, parametric("s", "s", "t")), cone);
  Construction by_line(variable_radius_blend(a, b, curve("4*r", "9*r", "r")), cone);
  EXPECT_EQ(12, by_plane.system().number_of_variables());
  EXPECT_EQ(12, by_plane.system().number_of_equations());
  EXPECT_EQ(13, by_line.system().number_of_variables());
  Random random(12);
  for (int i = 0; i < number_of_points; ++i)
  {
    // A second point of the conic on a line through (1, 1, 0).
    const Point d = random.nonzero_vector();
    const Q sum = d[0] + d[1] + d[2], f = 2 * internal::dot(d, d) - sum * sum;
    const Q polar = 2 * (d[0] + d[1]) - 2 * sum;
    const Point q = move(Point{Q(-f), Q(-f), 0}, Q(2 * polar), d);
    const Q t = (q[0] + q[1] + q[2]) / 2;
    if (CGAL::is_zero(t))
      continue;
    const Values feet{t, t, 0, t, 0, t};
    by_plane.expect_closed_form(join({values(q), {t, t, t}, feet}));
    by_patch.expect_closed_form(join({values(q), {t, t}, feet}));
    by_line.expect_closed_form(join({values(q), {t, t, t}, feet, {Q(t / 7)}}));
  }
}

// --- Ruled surfaces ------------------------------------------------------------------------------

// The normals of a cylinder along its section with z = x: a conoid, given in three ways.
TEST(Trimming_surface, conoid)
{
  const std::string conoid = "z^2*(x^2+y^2)-x^2";
  const auto cylinder = implicit("x^2+y^2-1"), plane = implicit("x-z");
  const auto cylinder_patch = parametric("1-s^2", "2*s", "t*(1+s^2)", "1+s^2");
  Construction both(trimming_surface(cylinder, plane), conoid);
  Construction patch(trimming_surface(cylinder_patch, plane), conoid);
  Construction mixed(trimming_surface(cylinder, parametric("s", "t", "s")), conoid);
  EXPECT_EQ(7, both.system().number_of_variables());
  Random random(13);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q s = random.rational() / 10, lambda = random.fraction(1, 5, 9);
    const auto [x, y] = on_circle(s); // x is not 0: there the conoid is singular
    const Point p{x, y, x}, q = move(p, Q(2 * lambda), Point{x, y, 0});
    both.expect_closed_form(join({values(q), values(p), {lambda}}));
    mixed.expect_closed_form(join({values(q), values(p), {x, y, lambda}}));
    // The patch has the normal 2 (1 + s^2)^3 (x, y, 0), and q - p is multiplied by 1 + s^2.
    const Q w = 1 + s * s;
    patch.expect_closed_form(join({values(q), {s, x, Q(lambda / (w * w))}}));
  }
}

TEST(Trimming_surface, cone_of_a_sphere)
{
  Construction cone(trimming_surface(implicit("x^2+y^2+z^2-1"), implicit("z-3/5")),
                          "9*(x^2+y^2)-16*z^2");
  Random random(14);
  for (int i = 0; i < number_of_points; ++i)
  {
    const auto [c, s] = on_circle(random.rational());
    const Q lambda = random.fraction(1, 5, 9), k = fraction(4, 5);
    const Point p{Q(k * c), Q(k * s), fraction(3, 5)};
    cone.expect_closed_form(join({values(move(p, Q(2 * lambda), p)), values(p), {lambda}}));
  }
}

// A parabola, projected onto two planes in any mix, has a ruled surface that can be written down.
TEST(Ruled_by_projection, planes)
{
  const auto directrix = curve("r", "r^2", "1");
  const auto a = implicit("z"), b = implicit("y+1");
  const auto patch_a = parametric("s+t", "s", "0"), patch_b = parametric("s", "-1", "t");
  Construction ii(ruled_by_projection(directrix, a, b));
  Construction ip(ruled_by_projection(directrix, a, patch_b));
  Construction pi(ruled_by_projection(directrix, patch_a, b));
  Construction pp(ruled_by_projection(directrix, patch_a, patch_b));
  Construction line(ruled_by_projection(directrix, a, curve("r", "-1", "1")));
  const auto read = [](const std::string& text) { return parse_expression(text, {"r", "l"}); };
  const Parametric_surface_3 closed(
    Expression_function<2, 3>(std::vector{read("r"), read("l*r^2-1+l"), read("1-l")}));
  Random random(15);
  for (int i = 0; i < number_of_points; ++i)
  {
    const Q r = random.rational(), lambda = random.nonzero_rational(), r2 = r * r;
    const auto expected = closed(Coordinates<Q, 2>{r, lambda});
    ASSERT_TRUE(expected);
    const Values points = join({values(expected->point()), {r, r2, 1, r, r2, 0, r, -1, 1, r}});
    const Values st_a{r2, Q(r - r2)}, st_b{r, 1};
    expect_proportional(*expected, ii.shape(join({points, {lambda}})));
    expect_proportional(*expected, ip.shape(join({points, st_b, {lambda}})));
    expect_proportional(*expected, pi.shape(join({points, st_a, {lambda}})));
    expect_proportional(*expected, pp.shape(join({points, st_a, st_b, {lambda}})));
    expect_proportional(*expected, line.shape(join({points, {r, lambda}})));
  }
}

// The example of Chuang and Hoffmann, from its curve and two surfaces: the equations are those of
// the appendix with cleared denominators, up to signs, the order and powers of 1 + s^2.
TEST(Ruled_by_projection, appendix)
{
  const auto system = ruled_by_projection(
    curve("3*(1-r^2)-(1+r^2)", "6*r", "8*(1+r^2)", "2*(1+r^2)"), implicit("(x+1)^2+y^2-1"),
    parametric("3*(1-s^2)", "t*(1+s^2)", "6*s", "1+s^2"));
  EXPECT_EQ(16, system.number_of_variables());
  EXPECT_EQ(15, system.number_of_equations());
  EXPECT_EQ(15, system.find_variable("lambda"));
  EXPECT_EQ(-1, system.find_variable("mu"));
  EXPECT_EQ(4, system.first_equation(2));
  const std::vector<std::string> names{"x",  "y",  "z",  "u0", "v0", "w0", "u1", "v1",
                                       "w1", "u2", "v2", "w2", "r",  "s",  "t",  "l"};
  std::vector<Expression> appendix;
  for (const char* text :
       {"u0*2*(1+r^2)-3*(1-r^2)+(1+r^2)", "2*(v0*(1+r^2)-3*r)", "(w0-4)*2*(1+r^2)",
        "(u1+1)^2+v1^2-1", "-2*(w0-w1)*v1", "2*(w0-w1)*(u1+1)",
        "2*(u0-u1)*v1-2*(v0-v1)*(u1+1)", "u2*(1+s^2)-3*(1-s^2)", "(v2-t)*(1+s^2)",
        "w2*(1+s^2)-6*s", "-12*s*(u0-u2)+6*(1-s^2)*(w0-w2)", "(v0-v2)*(1+s^2)^2",
        "x-(l*u1+(1-l)*u2)", "y-(l*v1+(1-l)*v2)", "z-(l*w1+(1-l)*w2)"})
    appendix.push_back(parse_expression(text, names));
  const Expression_tape ours(system.equations(), 16), theirs(appendix, 16);
  Random random(16);
  for (int i = 0; i < number_of_points; ++i)
  {
    Values x;
    for (int k = 0; k < 16; ++k)
      x.push_back(random.rational());
    EXPECT_EQ(ours.evaluate(x), theirs.evaluate(x));
  }

  std::vector<Quadratic_field> point;
  for (const char* text : {"3/34*sqrt(17)", "0", "2+6/17*sqrt(17)", "1", "0", "4", "0", "0", "4",
                           "3/17*sqrt(17)", "0", "12/17*sqrt(17)", "0", "(sqrt(17)-1)/4", "0",
                           "1/2"})
    point.push_back(
      Expression_tape({parse_number(text)}, 0).evaluate(std::vector<Quadratic_field>())[0]);
  EXPECT_EQ(CGAL::ZERO, sign_of_gaussian_curvature(Construction(system).shape(point)));
}

// --- Patches -------------------------------------------------------------------------------------

TEST(Parametric_graph, patches)
{
  Random random(17);
  for (const bool is_rational : {false, true})
  {
    std::vector<std::vector<Point>> points(4, std::vector<Point>(3));
    std::vector<std::vector<Q>> weights(is_rational ? 4 : 0, std::vector<Q>(3));
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
      {
        points[i][j] = {Q(3 * i + random.rational()), Q(3 * j + random.rational()),
                        random.rational()};
        if (is_rational)
          weights[i][j] = random.integer(1, 4);
      }
    const Bezier_surface_3<Q> patch(points, weights);
    // The same surface as a spline with the parameters in [2, 3] and [-1, 1].
    const Nurbs_surface_3<Q> spline(Knot_vector<Q>(3, rationals({2, 2, 2, 2, 3, 3, 3, 3})),
                                    Knot_vector<Q>(2, rationals({-1, -1, -1, 1, 1, 1})), points,
                                    weights);
    Construction graph(parametric_graph(Parametric_entity_3(patch)));
    Construction of_spline(parametric_graph(Parametric_entity_3(spline)));
    EXPECT_EQ(5, graph.system().number_of_variables());
    EXPECT_EQ(3, graph.system().number_of_equations());
    for (const Expression& e : graph.system().equations())
      EXPECT_TRUE(e.is_polynomial());
    for (int i = 0; i < number_of_points; ++i)
    {
      const Q s = random.in_unit_interval(), t = random.in_unit_interval();
      const auto expected = patch({s, t});
      ASSERT_TRUE(expected);
      const Values q = values(expected->point());
      expect_proportional(*expected, graph.shape(join({q, {s, t}})));
      expect_proportional(*expected, of_spline.shape(join({q, {Q(2 + s), Q(2 * t - 1)}})));
    }
  }
}

TEST(Parametric_entity, refuses_a_spline_with_knots)
{
  const std::vector<std::vector<Point>> points(3, std::vector<Point>(2, Point{0, 0, 0}));
  const Nurbs_surface_3<Q> spline(Knot_vector<Q>(1, rationals({0, 0, 1, 2, 2})),
                                  Knot_vector<Q>(1, rationals({0, 0, 1, 1})), points);
  try
  {
    Parametric_entity_3 entity(spline);
    ADD_FAILURE() << "accepted";
  }
  catch (const Shape_error& error)
  {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("2 pairs of knot spans"));
  }
}

// --- What does not hold --------------------------------------------------------------------------

TEST(Violations, in_words)
{
  auto sphere = implicit("x^2+y^2+z^2-1");
  sphere.set_name("f");
  const auto system = offset_system(sphere, 1);
  EXPECT_TRUE(system.violated(Values{2, 0, 0, 1, 0, 0}).empty());

  const auto wrong = system.violated(Values{2, 0, 0, 0, 1, 0});
  ASSERT_EQ(2u, wrong.size());
  EXPECT_EQ(1, wrong[0].constraint);
  EXPECT_EQ("p is not the projection of q onto f", wrong[0].sentence);
  EXPECT_EQ((Values{0, 0, 4}), wrong[0].residuals);
  EXPECT_EQ("the distance of q and p is not 1", wrong[1].sentence);
  EXPECT_EQ(Values{4}, wrong[1].residuals);
  EXPECT_EQ("p is not on f", system.violated(Values{0, 0, 3, 0, 0, 2})[0].sentence);

  const std::vector<double> near{2, 1e-9, 0, 1, 0, 0};
  EXPECT_EQ(1u, system.violated(near).size());
  EXPECT_TRUE(system.violated(near, 1e-8).empty());
  using Interval = CGAL::Interval_nt<true>;
  const Interval wide(-0.125, 0.125);
  EXPECT_TRUE(system.violated(std::vector<Interval>{2, wide, wide, 1, wide, wide}).empty());
  EXPECT_EQ(1u, system.violated(std::vector<Interval>{3, wide, wide, 1, 0, 0}).size());
}

// The bounds of a ruled surface: its segments out of its lines.
TEST(Bounds, of_variables)
{
  const auto system = trimming_surface(implicit("x^2+y^2+z^2-1"), implicit("z"));
  const std::vector<N_space_bound> bounds{{system.find_variable("lambda"), fraction(-1, 3), 1}};
  const auto refusal = [&](const auto& lambda) {
    using NT = std::decay_t<decltype(lambda)>;
    const NT x = NT(1) + NT(2) * lambda;
    const std::vector<NT> point{x, NT(0), NT(0), NT(1), NT(0), NT(0), lambda};
    return refuse_outside_bounds(point, bounds, system.variables());
  };
  EXPECT_FALSE(refusal(fraction(-1, 3)));
  EXPECT_FALSE(refusal(Q(1)));
  EXPECT_FALSE(refusal(-1.0 / 3));
  EXPECT_TRUE(refusal(1.0000001));
  using Interval = CGAL::Interval_nt<true>;
  EXPECT_FALSE(refusal(Interval(-2, -0.25)));
  EXPECT_TRUE(refusal(Interval(1.25, 2)));
  const Q beyond = fraction(-1, 3) - Q(1) / Q("1267650600228229401496703205376");
  ASSERT_TRUE(refusal(beyond));
  EXPECT_EQ(Refusal_code::OUTSIDE_DOMAIN, refusal(beyond)->code());
  EXPECT_EQ("lambda = 2 is outside of the bounds [-1/3, 1]", refusal(Q(2))->evidence());
}

TEST(Constraint_system, names_of_variables)
{
  Constraint_system system("m");
  EXPECT_EQ("m", system.projected_point().name);
  const auto p = system.add_point("p");
  const Expression t = system.add_scalar("t");
  EXPECT_EQ((std::vector<std::string>{"x", "y", "z", "p_x", "p_y", "p_z", "t"}),
            system.variables());
  EXPECT_EQ("p_y", to_string(p.coordinates[1], system.variables()));
  EXPECT_EQ("t", to_string(t, system.variables()));
  for (const char* name : {"x", "p_x", "pi", "sqrt", "", "2a", "a b", "a'"})
    EXPECT_THROW(system.add_scalar(name), Shape_error) << name;
  EXPECT_THROW(system.add_point("p"), Shape_error);
  EXPECT_EQ(7, system.number_of_variables());
}

// Each word of the vocabulary holds where it should, and says so where it does not.
TEST(Vocabulary, points_and_vectors)
{
  Constraint_system system;
  const auto& q = system.projected_point();
  const Constraint_point_3 o{"o", {0, 0, 0}}, a{"a", {2, 0, 0}}, b{"b", {0, 2, 0}, 2};
  const Expression lambda = system.add_scalar("lambda");
  require_on_line(system, q, o, a);
  require_dividing(system, q, a, b, lambda);
  require_parallel(system, vector_between(o, q), vector_between(o, a));
  require_multiple(system, vector_between(o, q), vector_between(o, a), lambda);
  require_orthogonal(system, vector_between(o, q), vector_between(o, b));
  require_equal_distances(system, q, o, a, b);
  require_coplanar(system, q, o, a, b);
  EXPECT_EQ(15, system.number_of_equations());
  EXPECT_TRUE(CGAL::certainly(verify_identities(system)));

  const auto sentences = [&](const Values& values) {
    std::vector<std::string> result;
    for (const auto& violation : system.violated(values))
      result.push_back(violation.sentence);
    return result;
  };
  EXPECT_EQ(std::vector<std::string>{
              "the distance of q and o is not the distance of a and b"},
            sentences({2, 0, 0, 1}));
  EXPECT_EQ((std::vector<std::string>{
              "q is not on the line of o and a",
              "q is not the sum of lambda times a and 1 - lambda times b",
              "the vector from o to q is not parallel to the vector from o to a",
              "the vector from o to q is not lambda times the vector from o to a",
              "the vector from o to q is not orthogonal to the vector from o to b",
              "the distance of q and o is not the distance of a and b",
              "q is not in the plane of o, a and b"}),
            sentences({1, 1, 1, 2}));
}

// The same surface from single words as from the construction, which adds the same variables.
TEST(Vocabulary, foot_points)
{
  const auto sphere = implicit("x^2+y^2+z^2-1");
  const auto patch = parametric("2*s", "2*t", "s^2+t^2-1", "1+s^2+t^2");
  const auto line = curve("0", "0", "2*r", "1+r^2");
  const auto same = [](const Constraint_system& a, const Constraint_system& b) {
    EXPECT_EQ(a.variables(), b.variables());
    Values point;
    for (int i = 0; i < a.number_of_variables(); ++i)
      point.push_back(fraction(i + 2, 3));
    const int n = a.number_of_variables();
    EXPECT_EQ(Expression_tape(a.equations(), n).evaluate(point),
              Expression_tape(b.equations(), n).evaluate(point));
  };
  {
    Constraint_system system;
    const auto p = system.add_point("p");
    require_on(system, p, sphere);
    require_projection(system, system.projected_point(), p, sphere);
    require_distance(system, system.projected_point(), p, 3);
    same(system, offset_system(sphere, 3));
  }
  {
    Constraint_system system;
    const auto p = add_foot_point(system, system.projected_point(), "p", patch);
    require_distance(system, system.projected_point(), p, 3);
    same(system, offset_system(patch, -3));
  }
  {
    Constraint_system system;
    const Expression r = system.add_scalar("p_r");
    const auto p = line.point("p", r);
    require_orthogonal(system, vector_between(p, system.projected_point()),
                       {"the tangent", line.tangent(r)});
    require_distance(system, system.projected_point(), p, 3);
    same(system, offset_system(line, 3));
    const auto z = Expression_tape({p.cartesian()[2]}, 4).evaluate(Values{0, 0, 0, 2});
    EXPECT_EQ(Values{fraction(4, 5)}, z);
  }
  Constraint_system system;
  const auto p = system.add_point("p");
  require_foot_point(system, system.projected_point(), p, line);
  EXPECT_EQ(6, system.find_variable("p_r"));
  EXPECT_EQ(4, system.number_of_equations());
}

// Functors make the same entities as expressions; normals are made of both kinds of surfaces.
TEST(Vocabulary, functors_and_normals)
{
  const Implicit_entity_3 paraboloid(
    [](const auto& x, const auto& y, const auto& z) { return x * x + y * y - z; }, "A");
  const Parametric_entity_3 patch(
    [](const auto& s, const auto& t) {
      using NT = std::decay_t<decltype(s)>;
      return std::array<NT, 3>{s, t, s * s + t * t};
    },
    "B");
  const Curve_entity_3 circle(
    [](const auto& r) {
      using NT = std::decay_t<decltype(r)>;
      return std::array<NT, 4>{1 - r * r, 2 * r, 1 + r * r, 1 + r * r};
    },
    "C");
  Constraint_system system;
  const auto& q = system.projected_point();
  const Expression s = system.add_scalar("s"), t = system.add_scalar("t"),
                   r = system.add_scalar("r");
  require_on(system, q, paraboloid);
  require_on(system, q, patch, {s, t});
  require_on(system, q, circle, r);
  const auto normal = normal_at(patch, q, {s, t});
  require_parallel(system, normal_at(paraboloid, q), normal);
  EXPECT_EQ("the normal of A at q is parallel to the normal of B at q",
            system.constraints().back().statement());
  EXPECT_TRUE(system.constraints().back().is_redundant());
  const auto [c, d] = on_circle(3);
  EXPECT_TRUE(system.violated(Values{c, d, 1, c, d, 3}).empty());
  EXPECT_EQ(3u, system.violated(Values{d, c, 1, c, d, 3}).size());
  EXPECT_EQ("q is not the point of C at r",
            system.violated(Values{c, d, 1, c, d, 2}).at(0).sentence);
}

// --- What is refused -----------------------------------------------------------------------------

template <class Function>
std::string message(Function function)
{
  try
  {
    function();
  }
  catch (const Shape_error& error) { return error.what(); }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A variable in a given point would be an unknown of the construction.
TEST(Refused, given_points_with_variables)
{
  const Expression x = Expression::variable(0);
  const Entity_3 sphere = implicit("x^2+y^2+z^2-1");
  const Constraint_point_3 moving{"m", {0, x, 0}}, heavy{"h", {1, 2, 3}, 1 + x * x};
  for (const Constraint_point_3& p : {moving, heavy})
  {
    const std::string expected = "the given point " + p.name + " has a coordinate with variables";
    EXPECT_TRUE(contains(message([&] { equal_distance(sphere, p); }), expected));
    EXPECT_TRUE(contains(message([&] { equal_distance(sphere, implicit("z"), p); }), expected));
    EXPECT_TRUE(contains(message([&] { offset_system(p, 1); }), expected));
    EXPECT_TRUE(contains(message([&] { rolling_ball(p, sphere, 1); }), expected));
    EXPECT_TRUE(contains(message([&] { variable_radius_blend(p, sphere, implicit("z")); }),
                         expected));
    EXPECT_TRUE(contains(message([&] { ruled_by_projection(curve("r", "0", "0"), sphere, p); }),
                         expected));
  }
  const Constraint_point_3 root{"", {sqrt(Expression(2)), 1 - Expression::pi(), 0}};
  EXPECT_EQ("", message([&] { equal_distance(sphere, root); }));
  const Constraint_point_3 imaginary{"i", {sqrt(Expression(-2)), 0, 0}};
  EXPECT_TRUE(contains(message([&] { equal_distance(sphere, imaginary); }),
                       "a coordinate of the given point i is not a real number: sqrt"));
  // In a system of one's own a point may be an unknown of it.
  Constraint_system system;
  const auto p = system.add_point("p");
  EXPECT_EQ("", message([&] { add_foot_point(system, system.projected_point(), "f", p); }));
}

TEST(Refused, points_at_infinity)
{
  const Constraint_point_3 far{"far", {1, 0, 0}, 0}, a{"a", {1, 0, 0}}, b{"b", {2, 0, 0}};
  EXPECT_TRUE(contains(message([&] { equal_distance(a, far); }), "far has the weight 0"));
  EXPECT_TRUE(contains(message([&] { equal_distance(far, a); }), "far has the weight 0"));
  Constraint_system system;
  const auto& q = system.projected_point();
  EXPECT_TRUE(contains(message([&] { require_equal_distances(system, q, far, a); }), "weight 0"));
  EXPECT_TRUE(contains(message([&] { require_equal_distances(system, q, a, b, far); }),
                       "weight 0"));
  EXPECT_TRUE(contains(message([&] { require_distance(system, q, far, 1); }), "weight 0"));
  EXPECT_EQ(0, system.number_of_equations());
}

TEST(Refused, distances_that_are_not_real)
{
  const Entity_3 sphere = implicit("x^2+y^2+z^2-1"), plane = implicit("z");
  const Expression i2 = sqrt(Expression(-2)), x = Expression::variable(0);
  const Expression nested = sqrt(sqrt(Expression(2)) - 2);
  for (const Expression& d : {i2, Expression(3 * i2), Expression(i2 * sqrt(Expression(-3))),
                              Expression(x * i2), nested, log(Expression(-1))})
  {
    EXPECT_TRUE(contains(message([&] { offset_system(sphere, d); }),
                         "the distance of the offset is not a real number"))
      << to_string(d);
    EXPECT_TRUE(contains(message([&] { rolling_ball(sphere, plane, d); }),
                         "the radius of the ball is not a real number"));
    Constraint_system system;
    const Constraint_point_3 o{"o", {0, 0, 0}};
    EXPECT_TRUE(contains(
      message([&] { require_distance(system, system.projected_point(), o, d); }),
      "the distance of q and o is not a real number"));
    EXPECT_EQ(0, system.number_of_equations());
  }
  for (const Expression& d : {sqrt(2 - sqrt(Expression(2))), sqrt(x), Expression(-3)})
    EXPECT_EQ("", message([&] { offset_system(sphere, d); })) << to_string(d);
}

// A sentence that names both could not be told apart.
TEST(Refused, two_entities_of_one_name)
{
  const auto named = [](auto entity, const std::string& name) {
    entity.set_name(name);
    return entity;
  };
  const auto sphere = named(implicit("x^2+y^2+z^2-1"), "f");
  const auto plane = named(implicit("z"), "f");
  const auto patch = named(parametric("s", "t", "s*t"), "f");
  const auto line = named(curve("r", "0", "1"), "f");
  const std::string expected = "something else with the name 'f'";
  EXPECT_TRUE(contains(message([&] { equal_distance(sphere, plane); }), expected));
  EXPECT_TRUE(contains(message([&] { equal_distance(sphere, patch); }), expected));
  EXPECT_TRUE(contains(message([&] { rolling_ball(patch, line, 1); }), expected));
  EXPECT_TRUE(contains(message([&] { trimming_surface(patch, sphere); }), expected));
  EXPECT_TRUE(contains(message([&] { ruled_by_projection(line, patch, implicit("z")); }),
                       expected));
  EXPECT_TRUE(contains(
    message([&] { variable_radius_blend(implicit("x"), implicit("y"), named(plane, "A")); }),
    "'A'"));
  const Constraint_point_3 a{"a", {1, 0, 0}}, other{"a", {2, 0, 0}}, q{"q", {3, 0, 0}};
  EXPECT_TRUE(contains(message([&] { equal_distance(a, other); }), "'a'"));
  EXPECT_TRUE(contains(message([&] { offset_system(q, 1); }), "'q'"));
  // The same thing twice is one thing, also if it was made twice.
  EXPECT_EQ("", message([&] { equal_distance(sphere, sphere); }));
  EXPECT_EQ("", message([&] { equal_distance(patch, named(parametric("s", "t", "s*t"), "f")); }));
  EXPECT_EQ("", message([&] { equal_distance(a, Constraint_point_3{"a", {1, 0, 0}}); }));
  EXPECT_EQ("", message([&] { equal_distance(named(sphere, "q"), named(plane, "p_A")); }));
}

// A refusal leaves the system as it was.
TEST(Refused, nothing_is_added)
{
  const auto sphere = implicit("x^2+y^2+z^2-1");
  auto patch = parametric("s", "t", "s*t");
  patch.set_name("f");
  const auto line = curve("r", "0", "1");
  Constraint_system system;
  const auto& q = system.projected_point();
  for (const char* name : {"a_z", "b_t", "c_r", "d_t"})
    system.add_scalar(name);
  const auto d = system.add_point("d");
  auto other = sphere;
  other.set_name("f");
  require_on(system, q, other);
  const auto expect_refused = [&](auto function) {
    const std::vector<std::string> variables = system.variables();
    const int equations = system.number_of_equations();
    EXPECT_NE("", message(function));
    EXPECT_EQ(variables, system.variables());
    EXPECT_EQ(equations, system.number_of_equations());
  };
  expect_refused([&] { add_foot_point(system, q, "a", sphere); });
  expect_refused([&] { add_foot_point(system, q, "b", patch); });
  expect_refused([&] { add_foot_point(system, q, "c", line); });
  expect_refused([&] { add_foot_point(system, q, "d", patch); });
  expect_refused([&] { add_foot_point(system, q, "e", patch); }); // the name f
  expect_refused([&] { require_foot_point(system, q, d, patch); });
  expect_refused([&] { system.add_point("a"); });
  expect_refused([&] { system.add_point("q"); });
  EXPECT_EQ("", message([&] { add_foot_point(system, q, "e", line); }));
}

TEST(Identities, wrong_and_undecidable_ones)
{
  Constraint_system system;
  const auto& x = system.projected_point().coordinates;
  system.add(Constraint("q", "anywhere", {x[0] * x[1], x[1]}, 1, {{1, -x[0]}}));
  EXPECT_TRUE(CGAL::certainly(verify_identities(system)));
  Constraint_system with_root = system;
  system.add(Constraint("q", "somewhere", {x[0], x[1]}, 1, {{x[1], x[0]}}));
  EXPECT_TRUE(CGAL::certainly_not(verify_identities(system)));
  with_root.add(Constraint("q", "far", {exp(x[0]), x[1]}, 1, {{x[1], -exp(x[0])}}));
  EXPECT_FALSE(CGAL::is_certain(verify_identities(with_root)));
}

} // namespace
