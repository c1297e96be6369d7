// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Answers as fields of the report, and as lines for people.

#include "Report.h"

#include <mpfr.h>

#include <cstdio>

namespace interrogate {

namespace {

// A double in 17 digits, rounded in the given direction. The same in every locale.
std::string rounded(double x, mpfr_rnd_t direction)
{
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_d(value, x, MPFR_RNDN);
  std::string text;
  if (!mpfr_number_p(value))
    text = x < 0 ? "-inf" : "inf";
  else if (mpfr_zero_p(value))
    text = "0";
  else
  {
    mpfr_exp_t exponent;
    char* digits = mpfr_get_str(nullptr, &exponent, 10, 17, value, direction);
    text = digits;
    mpfr_free_str(digits);
    const std::size_t sign = text[0] == '-' ? 1 : 0;
    while (text.size() > sign + 1 && text.back() == '0')
      text.pop_back();
    if (text.size() > sign + 1)
      text.insert(sign + 1, ".");
    if (exponent != 1)
      text += "e" + std::to_string(exponent - 1);
  }
  mpfr_clear(value);
  return text;
}

// The sign counts as decided only where it is.
bool is_decided(const Signed_scalar& s) { return s.sign.has_value(); }

// A short text for the line on the terminal; exact where the number type is.
std::string brief(const Signed_scalar& s, const Task_result& result)
{
  const Scalar& x = s.value;
  if (result.number_type == "exact" && !x.exact.empty() && x.exact.size() <= 24)
    return x.exact;
  const std::string text = x.approx ? Report_json(*x.approx).dump() : "?";
  return s.sign ? text : text + " (sign undecided)";
}

std::string yes_or_no(const Decision& d) { return d ? (*d ? "yes" : "no") : "undecided"; }

void mark_undecided(Task_result& result, const std::string& what)
{
  if (result.status != "ok")
    return;
  result.status = result.code = "undecided";
  result.text = result.fields.contains("enclosure")
                  ? "the enclosure of the point does not decide " + what + "; an exact point can"
                  : "the number type " + result.number_type + " does not decide " + what +
                      "; an exact one can where the data are algebraic";
}

Report_json to_json(const Enclosure_answer& e)
{
  Report_json json = Report_json::object();
  json["box"] = Report_json::array();
  for (const Scalar& x : e.box)
    json["box"].push_back(to_json(x));
  json["fixed"] = Report_json::object();
  for (const auto& [variable, value] : e.fixed)
    json["fixed"][variable] = to_json(value);
  json["equations"] = e.equations;
  json["proved_by_identities"] = e.proved;
  json["others_contain_zero"] = true; // else the point is refused
  json["others"] = e.others;
  return json;
}

} // namespace

Report_json to_json(const Scalar& s)
{
  Report_json json;
  json["approx"] = s.approx ? Report_json(*s.approx) : Report_json(nullptr);
  if (!s.exact.empty())
    json["exact"] = s.exact;
  if (s.interval)
    json["interval"] = {rounded(s.interval->first, MPFR_RNDD),
                        rounded(s.interval->second, MPFR_RNDU)};
  return json;
}

Report_json sign_to_json(const Sign_decision& s)
{
  return s ? Report_json(*s) : Report_json("undecided");
}

Report_json to_json(const Signed_scalar& s)
{
  Report_json json = to_json(s.value);
  json["sign"] = sign_to_json(s.sign);
  if (s.squared)
    json["squared"] = to_json(*s.squared);
  return json;
}

Report_json to_json(const Decision& d) { return d ? Report_json(*d) : Report_json("undecided"); }

void store(const Surface_answer& a, Task_result& result)
{
  Report_json& json = result.fields;
  if (a.point)
    json["point"] = to_json(*a.point);
  json["normal"] = to_json(a.normal);
  json["normal_squared_length"] = to_json(a.normal_squared_length);
  json["gaussian_curvature"] = to_json(a.gaussian_curvature);
  json["sign_of_gaussian_curvature"] = sign_to_json(a.gaussian_curvature.sign);
  json["mean_curvature"] = to_json(a.mean_curvature);
  json["principal_curvatures"] = to_json(a.principal_curvatures);
  if (a.principal_directions)
    json["principal_directions"] = to_json(*a.principal_directions);
  json["umbilic"] = to_json(a.umbilic);
  json["planar"] = to_json(a.planar);
  json["shape_operator"] = to_json(a.shape_operator);
  if (a.normal_curvature)
    json["normal_curvature"] = to_json(*a.normal_curvature);
  if (!a.hessian_case.empty())
    json["hessian_case"] = a.hessian_case;
  if (a.enclosure)
    json["enclosure"] = to_json(*a.enclosure);
  result.line = "K = " + brief(a.gaussian_curvature, result) +
                ", H = " + brief(a.mean_curvature, result) +
                ", umbilic: " + yes_or_no(a.umbilic);
  if (a.normal_curvature)
    result.line += ", in the direction: " + brief(*a.normal_curvature, result);
  if (!is_decided(a.gaussian_curvature))
    mark_undecided(result, "the sign of the Gaussian curvature");
  if (!is_decided(a.mean_curvature))
    mark_undecided(result, "the sign of the mean curvature");
  if (!a.umbilic || !a.planar)
    mark_undecided(result, "whether the point is umbilic or planar");
  if (a.normal_curvature && !is_decided(*a.normal_curvature))
    mark_undecided(result, "the sign of the normal curvature");
}

void store(const Curve_answer& a, Task_result& result)
{
  Report_json& json = result.fields;
  json["point"] = to_json(a.point);
  json["normal"] = to_json(a.normal);
  json["normal_squared_length"] = to_json(a.normal_squared_length);
  json["curvature"] = to_json(a.curvature);
  json["hessian"] = to_json(a.hessian);
  result.line = "curvature = " + brief(a.curvature, result);
  if (!is_decided(a.curvature))
    mark_undecided(result, "the sign of the curvature");
}

} // namespace interrogate
