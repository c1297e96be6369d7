// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Runs the tasks contour and trichotomy: certified curves and areas on the patches of a surface.

#include "make_scalar.h"
#include "property_pieces.h"
#include "run_tasks.h"

#include <CGAL/Shape_interrogation/Property_surfaces/patch_contours.h>
#include <CGAL/Shape_interrogation/Property_surfaces/trichotomy_of_patch.h>

#include <cmath>
#include <utility>

namespace interrogate {

namespace {

using Piece = si::Surface_piece_3<Rational>;
using Pieces = std::vector<Piece>;

// The patches of a surface with rational data.
si::Result<Pieces> rational_patches(const Surface_model& surface)
{
  try
  {
    const auto patches = patches_of<Rational>(surface);
    if (patches)
      if (auto refusal = refuse_degrees(*patches))
        return *refusal;
    return patches;
  }
  catch (const si::Not_algebraic_error&)
  {
    return si::Refusal(si::Refusal_code::NOT_ALGEBRAIC,
                       "curves on a whole surface are for rational numbers only");
  }
}

// From the unit square to the parameters of the surface.
class To_parameters
{
public:
  explicit To_parameters(const Piece& piece)
  {
    const std::array<std::array<Rational, 2>, 2> ends{piece.u, piece.v};
    for (int axis = 0; axis < 2; ++axis)
    {
      m_low[axis] = si::number_cast<double>(ends[axis][0]);
      m_high[axis] = si::number_cast<double>(ends[axis][1]);
    }
  }

  double operator()(int axis, double x) const
  {
    return (1 - x) * m_low[axis] + x * m_high[axis];
  }
  Report_json operator()(const std::array<double, 2>& p) const
  {
    return {(*this)(0, p[0]) + 0.0, (*this)(1, p[1]) + 0.0}; // no -0
  }

private:
  std::array<double, 2> m_low, m_high;
};

Report_json points_of(const std::vector<std::array<double, 2>>& points,
                      const To_parameters& to_parameters)
{
  Report_json json = Report_json::array();
  for (const auto& p : points)
    json.push_back(to_parameters(p));
  return json;
}

Report_json box_of(const si::Unresolved_box_2& box, const To_parameters& to_parameters)
{
  return {{"box",
           {{to_parameters(0, box.low[0]), to_parameters(0, box.high[0])},
            {to_parameters(1, box.low[1]), to_parameters(1, box.high[1])}}},
          {"branches", box.branches}};
}

Report_json edges_of(const std::vector<si::Contour_edge_2>& edges, bool has_multiplicity)
{
  Report_json json = Report_json::array();
  for (const si::Contour_edge_2& edge : edges)
  {
    json.push_back({{"edge", (edge.axis == 0 ? "u" : "v") + std::to_string(edge.end)}});
    if (has_multiplicity)
      json.back()["multiplicity"] = edge.multiplicity;
  }
  return json;
}

// The parts of a report about contours, for one patch after the other.
class Contour_report
{
public:
  explicit Contour_report(bool has_spans) : m_has_spans(has_spans) {}

  void add(const si::Contour_2& contour, const Piece& piece, int span)
  {
    const To_parameters to_parameters(piece);
    const auto patch = piece.patch.cast<double>();
    const auto store = [&](Report_json& list, Report_json entry) {
      if (m_has_spans)
        entry["span"] = span;
      list.push_back(std::move(entry));
    };
    for (const si::Contour_curve_2& curve : contour.curves)
    {
      Report_json ends = Report_json::array();
      for (int end : curve.unresolved)
        ends.push_back(curve.is_closed ? "closed" : end < 0 ? "boundary" : "unresolved");
      store(m_curves, {{"parameters", points_of(curve.points, to_parameters)},
                       {"points", si::lifted(curve.points, patch)},
                       {"closed", curve.is_closed},
                       {"ended", ends}});
      m_closed += curve.is_closed;
    }
    for (const auto& p : contour.isolated_points)
      store(m_isolated, {{"parameters", to_parameters(p)}});
    for (Report_json& edge : edges_of(contour.edges, true))
      store(m_edges, edge);
    for (const si::Unresolved_box_2& box : contour.unresolved)
      store(m_unresolved, box_of(box, to_parameters));
    m_is_everything = m_is_everything && contour.is_everything;
    if (contour.is_everything && m_has_spans)
      m_everywhere.push_back(span);
  }

  void store(Report_json& fields) const
  {
    fields["identically_zero"] = m_is_everything;
    if (m_has_spans)
      fields["identically_zero_spans"] = m_everywhere;
    fields["curves"] = m_curves;
    fields["edges"] = m_edges;
    fields["isolated_points"] = m_isolated;
    fields["certified_topology"] = m_unresolved.empty();
    fields["unresolved"] = m_unresolved;
  }

  std::string line() const
  {
    if (m_is_everything)
      return "everywhere";
    std::string text = std::to_string(m_curves.size()) + " curves, " + std::to_string(m_closed) +
                       " of them closed";
    if (!m_edges.empty())
      text += ", " + std::to_string(m_edges.size()) + " edges";
    if (!m_isolated.empty())
      text += ", " + std::to_string(m_isolated.size()) + " isolated points";
    return text + (m_unresolved.empty()
                     ? "; the topology is proved"
                     : "; " + std::to_string(m_unresolved.size()) + " places are unresolved");
  }

private:
  bool m_has_spans, m_is_everything = true;
  std::size_t m_closed = 0;
  Report_json m_curves = Report_json::array(), m_edges = Report_json::array();
  Report_json m_everywhere = Report_json::array();
  Report_json m_isolated = Report_json::array(), m_unresolved = Report_json::array();
};

// Contours depend on the side of the surface where the property does.
bool is_odd(si::Property property)
{
  return property == si::Property::NORMAL_Z || property == si::Property::NORMAL_TWIST ||
         property == si::Property::SILHOUETTE;
}

template <class Progress>
si::Result<si::Contour_2> contour_on(const Piece& piece, const Contour_task& task, bool flip,
                                     Progress progress)
{
  if (task.plane)
  {
    si::Coordinates<Rational, 4> plane;
    for (int i = 0; i < 4; ++i)
      plane[i] = evaluate<Rational>((*task.plane)[i]);
    return si::plane_section(piece.patch, plane, {}, progress);
  }
  const si::Property property = task.property.property;
  si::Property_inputs<Rational> inputs = inputs_of<Rational>(task.property);
  Rational level = evaluate<Rational>(task.level);
  if (flip && is_odd(property))
    level = -level;
  if (flip)
    inputs.level = -inputs.level;
  return si::property_contour(piece, property, level, inputs, {}, progress);
}

Report_json area_of(const si::Area_range& range)
{
  return {to_json(make_scalar(range.lower)), to_json(make_scalar(range.upper))};
}

// Sums and places of all patches.
struct Trichotomy_sums
{
  std::array<si::Area_range, 4> areas;
  bool is_developable = true;
  si::Verdict regular = si::Verdict::YES;
  Report_json irregular = Report_json::array();

  void add(const si::Trichotomy& t, const Piece& piece, int span, bool flip, bool has_spans)
  {
    for (int k = 0; k < 4; ++k)
    {
      // Turned over, convex is concave.
      si::Area_range& sum = areas[flip && k < 2 ? 1 - k : k];
      sum.lower += t.areas[k].lower;
      sum.upper += t.areas[k].upper;
    }
    is_developable = is_developable && t.is_developable;
    const si::Regularity& r = t.regularity;
    if (r.verdict == si::Verdict::NO || regular == si::Verdict::YES)
      regular = r.verdict;
    const To_parameters to_parameters(piece);
    Report_json places = edges_of(r.edges, false);
    for (const auto& p : r.points)
      places.push_back({{"parameters", to_parameters(p)}});
    for (const auto& box : r.boxes)
      places.push_back({{"box", box_of(box, to_parameters)["box"]}});
    for (const si::Contour_curve_2& curve : r.poles.curves)
      places.push_back({{"poles", points_of(curve.points, to_parameters)}});
    for (const auto& edge : edges_of(r.poles.edges, false))
      places.push_back({{"pole", edge["edge"]}});
    for (Report_json& place : places)
    {
      if (has_spans)
        place["span"] = span;
      irregular.push_back(place);
    }
  }

  void store(Report_json& fields) const
  {
    fields["developable"] = is_developable;
    for (int k = 0; k < 4; ++k)
      fields["regions"][si::to_string(static_cast<si::Region>(k))] = area_of(areas[k]);
    fields["regular"] = regular == si::Verdict::UNDECIDED
                          ? Report_json("undecided")
                          : Report_json(regular == si::Verdict::YES);
    fields["irregular"] = irregular;
  }

  std::string line() const
  {
    std::string text = is_developable ? "developable" : "";
    for (int k = 0; k < 4; ++k)
      if (areas[k].upper != 0)
      {
        const double low = si::number_cast<double>(areas[k].lower);
        text += (text.empty() ? "" : ", ") +
                std::string(si::to_string(static_cast<si::Region>(k))) + " at least " +
                Report_json(std::floor(low * 1e6) / 1e6).dump();
      }
    return text;
  }
};

void undecided(const std::string& text, Task_result& result)
{
  result.status = result.code = "undecided";
  result.text = text;
}

} // namespace

void run_contour(const Model& model, const Contour_task& task, Progress_bar& progress,
                 Task_result& result)
{
  const Surface_model& surface = model.surfaces.at(task.property.surface);
  const si::Result<Pieces> pieces = rational_patches(surface);
  if (!pieces)
    return refuse(pieces.refusal(), result);
  Contour_report report(pieces->size() > 1);
  for (std::size_t k = 0; k < pieces->size(); ++k)
  {
    const auto contour =
      contour_on((*pieces)[k], task, surface.flip, [&](std::size_t, std::size_t) {
        progress.show(k, pieces->size());
        return true;
      });
    if (!contour)
      return refuse(contour.refusal(), result);
    report.add(*contour, (*pieces)[k], static_cast<int>(k));
  }
  report.store(result.fields);
  result.line = report.line();
  if (!result.fields["certified_topology"].get<bool>())
    undecided("the curves are not known in the boxes listed as unresolved: singular points, or"
              " parts too close to each other",
              result);
}

void run_trichotomy(const Model& model, const Trichotomy_task& task, Progress_bar& progress,
                    Task_result& result)
{
  const Surface_model& surface = model.surfaces.at(task.surface);
  const si::Result<Pieces> pieces = rational_patches(surface);
  if (!pieces)
    return refuse(pieces.refusal(), result);
  const bool has_spans = pieces->size() > 1;
  Contour_report boundary(has_spans);
  Trichotomy_sums sums;
  for (std::size_t k = 0; k < pieces->size(); ++k)
  {
    const Piece& piece = (*pieces)[k];
    const auto t = si::trichotomy_of_patch(piece, {}, [&](std::size_t, std::size_t) {
      progress.show(k, pieces->size());
      return true;
    });
    if (!t)
      return refuse(t.refusal(), result);
    sums.add(*t, piece, static_cast<int>(k), surface.flip, has_spans);
    boundary.add(t->boundary, piece, static_cast<int>(k));
  }
  sums.store(result.fields);
  boundary.store(result.fields["boundary"]);
  result.fields["unresolved"] = result.fields["boundary"]["unresolved"];
  result.line = sums.line();
}

} // namespace interrogate
