// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_DOMAIN_TRIANGULATION_H
#define CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_DOMAIN_TRIANGULATION_H

// The constrained Delaunay triangulation of the unit square with the curves of a contour: exact
// predicates, and points on a lattice where no curve is near.

#include <CGAL/Shape_interrogation/Contours/Contour_2.h>
#include <CGAL/Shape_interrogation/Meshing/Divided_domain.h>
#include <CGAL/Shape_interrogation/Meshing/internal/Near_segments.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Neighbour k and side k are opposite corner k.
struct Domain_triangle
{
  std::array<int, 3> corners;            // anticlockwise, the least one first
  std::array<int, 3> neighbours;         // -1 outside
  std::array<bool, 3> is_constrained;
};

class Domain_triangulation
{
  using K = Exact_predicates_inexact_constructions_kernel;
  using Vb = Triangulation_vertex_base_with_info_2<int, K>;
  using Fb = Constrained_triangulation_face_base_2<K, Triangulation_face_base_with_info_2<int, K>>;
  using Tds = Triangulation_data_structure_2<Vb, Fb>;
  using Cdt = Constrained_Delaunay_triangulation_2<K, Tds, Exact_predicates_tag>;
  using Vertex = Cdt::Vertex_handle;
  using Face = Cdt::Face_handle;

public:
  Domain_triangulation(const Contour_2& contour, const Domain_options& options)
    : m_options(options), m_step((std::min)(1.0, options.edge_length)), m_near(m_step / 2)
  {
    for (int k = 0; k < 4; ++k)
      insert_edge(corner(k), corner(k + 1));
    for (const Unresolved_box_2& box : contour.unresolved)
      insert_box(box);
    for (const Domain_point& p : contour.isolated_points)
      insert_edge(p, p);
    for (const Contour_curve_2& curve : contour.curves)
      insert_curve(curve, contour.unresolved);
    insert_sides();
    insert_lattice();
    read();
  }

  // Unresolved boxes this narrow are points.
  static bool is_point(const Unresolved_box_2& box, const Domain_options& options)
  {
    return box.high[0] - box.low[0] <= options.point_width &&
           box.high[1] - box.low[1] <= options.point_width;
  }

  std::vector<Domain_point> points;
  std::vector<Domain_triangle> triangles;

private:
  static Domain_point corner(int k) { return {k % 4 == 1 || k % 4 == 2 ? 1. : 0., k % 4 / 2 * 1.}; }

  Vertex insert(const Domain_point& p)
  {
    const Vertex v = m_last == Vertex() ? m_cdt.insert(K::Point_2(p[0], p[1]))
                                        : m_cdt.insert(K::Point_2(p[0], p[1]), m_last->face());
    return m_last = v;
  }

  void insert_edge(const Domain_point& a, const Domain_point& b)
  {
    const Vertex v = insert(a), w = insert(b);
    if (v != w)
      m_cdt.insert_constraint(v, w);
    if (v == w || !((a[0] == b[0] && is_on_side(a[0])) || (a[1] == b[1] && is_on_side(a[1]))))
      m_near.add(a, b);
  }

  static bool is_on_side(double x) { return x == 0 || x == 1; }

  static Domain_point middle(const Unresolved_box_2& box)
  {
    Domain_point p;
    for (int k = 0; k < 2; ++k)
      p[k] = box.low[k] <= 0 ? 0 : box.high[k] >= 1 ? 1 : (box.low[k] + box.high[k]) / 2;
    return p;
  }

  void insert_box(const Unresolved_box_2& box)
  {
    if (is_point(box, m_options))
    {
      insert_edge(middle(box), middle(box));
      return;
    }
    const auto &a = box.low, &b = box.high;
    const std::array<Domain_point, 4> p{{{a[0], a[1]}, {b[0], a[1]}, {b[0], b[1]}, {a[0], b[1]}}};
    for (int k = 0; k < 4; ++k)
    {
      insert_edge(p[k], p[(k + 1) % 4]);
      const int axis = k % 2;
      const int n = static_cast<int>(std::ceil((b[axis] - a[axis]) / m_step));
      Domain_point q = p[k];
      for (int i = 1; i < n; ++i)
      {
        q[axis] = a[axis] + (b[axis] - a[axis]) * i / n;
        insert(q);
      }
    }
  }

  void insert_curve(const Contour_curve_2& curve, const std::vector<Unresolved_box_2>& boxes)
  {
    std::vector<Domain_point> line = curve.points;
    const auto end_in_point = [&](int end) {
      return curve.unresolved[end] >= 0 && is_point(boxes[curve.unresolved[end]], m_options);
    };
    if (curve.is_closed)
      line.push_back(line.front());
    else
    {
      if (end_in_point(0))
        line.insert(line.begin(), middle(boxes[curve.unresolved[0]]));
      if (end_in_point(1))
        line.push_back(middle(boxes[curve.unresolved[1]]));
    }
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      insert_edge(line[i], line[i + 1]);
  }

  // On each side at equal distances, not next to the ends of curves. Curves may run along it.
  void insert_sides()
  {
    std::vector<Domain_point> ends;
    for (const Vertex v : m_cdt.finite_vertex_handles())
      if (is_on_side(v->point().x()) || is_on_side(v->point().y()))
        ends.push_back({v->point().x(), v->point().y()});
    const int n = static_cast<int>(std::ceil(1 / m_step));
    for (int k = 0; k < 4; ++k)
      for (int i = 1; i < n; ++i)
      {
        const double t = double(i) / n;
        const Domain_point p{k % 2 == 0 ? t : k / 2 * 1., k % 2 == 0 ? k / 2 * 1. : t};
        if (std::none_of(ends.begin(), ends.end(), [&](const Domain_point& q) {
              return std::hypot(q[0] - p[0], q[1] - p[1]) < m_step / 4;
            }))
          insert(p);
      }
  }

  void insert_lattice()
  {
    const int n = static_cast<int>(std::ceil(1 / m_step));
    const int rows = static_cast<int>(std::ceil(1 / (m_step * 0.8660254)));
    for (int j = 1; j < rows; ++j)
      for (int i = 0; i < n; ++i)
      {
        const Domain_point p{(i + (j % 2) * 0.5) / n, double(j) / rows};
        if (p[0] > 0 && !m_near.is_near(p))
          insert(p);
      }
  }

  void read()
  {
    for (const Vertex v : m_cdt.finite_vertex_handles())
      v->info() = -1;
    std::vector<Vertex> vertices(m_cdt.finite_vertex_handles().begin(),
                                 m_cdt.finite_vertex_handles().end());
    std::sort(vertices.begin(), vertices.end(), [](Vertex a, Vertex b) {
      return a->point() < b->point();
    });
    for (const Vertex v : vertices)
    {
      v->info() = static_cast<int>(points.size());
      points.push_back({v->point().x(), v->point().y()});
    }
    read_triangles();
  }

  // In an order that depends on the corners alone.
  void read_triangles()
  {
    std::vector<std::pair<std::array<int, 3>, std::pair<Face, int>>> faces;
    for (const Face f : m_cdt.all_face_handles())
      f->info() = -1;
    for (const Face f : m_cdt.finite_face_handles())
    {
      int first = 0;
      for (int k = 1; k < 3; ++k)
        if (f->vertex(k)->info() < f->vertex(first)->info())
          first = k;
      std::array<int, 3> corners;
      for (int k = 0; k < 3; ++k)
        corners[k] = f->vertex((first + k) % 3)->info();
      faces.push_back({corners, {f, first}});
    }
    std::sort(faces.begin(), faces.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t t = 0; t < faces.size(); ++t)
      faces[t].second.first->info() = static_cast<int>(t);
    for (const auto& [corners, place] : faces)
    {
      Domain_triangle triangle{corners, {}, {}};
      for (int k = 0; k < 3; ++k)
      {
        const int l = (place.second + k) % 3;
        triangle.neighbours[k] = place.first->neighbor(l)->info();
        triangle.is_constrained[k] = place.first->is_constrained(l);
      }
      triangles.push_back(triangle);
    }
  }

  const Domain_options& m_options;
  const double m_step;
  Near_segments m_near;
  Cdt m_cdt;
  Vertex m_last;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_MESHING_INTERNAL_DOMAIN_TRIANGULATION_H
