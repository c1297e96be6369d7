// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_INTERNAL_SVG_PICTURE_H
#define CGAL_SHAPE_INTERROGATION_IO_INTERNAL_SVG_PICTURE_H

// The parts of a picture of a parameter domain: u to the right, v upward.

#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

inline std::string svg_number(double x, int digits = 2)
{
  std::array<char, 64> text;
  const auto end =
    std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed, digits);
  return std::string(text.data(), end.ptr);
}

// Text as it stands in XML. Control characters may not stand there.
inline std::string xml_text(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    switch (c)
    {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      default: escaped += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    }
  return escaped;
}

class Svg_picture
{
  using Point = std::array<double, 2>;

public:
  static constexpr double left = 64, top = 48, right = 24, bottom = 60, legend_line = 24;

  Svg_picture(std::ostream& out, double size, int legend_lines)
    : m_out(out), m_size(size), m_height(top + size + bottom + legend_lines * legend_line)
  {
    const std::string width = svg_number(left + size + right), height = svg_number(m_height);
    m_out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
          << height << "\" viewBox=\"0 0 " << width << ' ' << height
          << "\" font-family=\"sans-serif\" font-size=\"14\">\n"
             "<defs><pattern id=\"unresolved\" width=\"6\" height=\"6\""
             " patternUnits=\"userSpaceOnUse\"><rect width=\"6\" height=\"6\" fill=\"white\"/>"
             "<path d=\"M0 6L6 0\" stroke=\"#555555\"/></pattern></defs>\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  }

  Svg_picture(const Svg_picture&) = delete;
  Svg_picture& operator=(const Svg_picture&) = delete;
  ~Svg_picture() { m_out << "</svg>\n"; }

  double x(double u) const { return left + u * m_size; }
  double y(double v) const { return top + (1 - v) * m_size; }

  void text(double at_x, double at_y, const std::string& anchor, const std::string& text,
            const std::string& style = "")
  {
    m_out << "<text x=\"" << svg_number(at_x) << "\" y=\"" << svg_number(at_y)
          << "\" text-anchor=\"" << anchor << '"' << style << '>' << xml_text(text)
          << "</text>\n";
  }

  // Closed polygons of one area, with holes by their direction.
  void area(const std::vector<const std::vector<Point>*>& loops, const std::string& fill)
  {
    m_out << "<path fill=\"" << fill << "\" d=\"";
    for (const auto* loop : loops)
      write_path(*loop, true);
    m_out << "\"/>\n";
  }

  void line(const std::vector<Point>& points, bool is_closed, double width)
  {
    m_out << "<path fill=\"none\" stroke=\"black\" stroke-linejoin=\"round\" stroke-width=\""
          << svg_number(width) << "\" d=\"";
    write_path(points, is_closed);
    m_out << "\"/>\n";
  }

  void dot(const Point& p)
  {
    m_out << "<circle cx=\"" << svg_number(x(p[0])) << "\" cy=\"" << svg_number(y(p[1]))
          << "\" r=\"3\"/>\n";
  }

  // A rectangle that is seen however small the box is, on any colour.
  void mark(const Point& low, const Point& high)
  {
    const double least = 10;
    double width = (high[0] - low[0]) * m_size, height = (high[1] - low[1]) * m_size;
    width = width < least ? least : width;
    height = height < least ? least : height;
    mark_at(x((low[0] + high[0]) / 2) - width / 2, y((low[1] + high[1]) / 2) - height / 2, width,
            height);
  }

  // The square with five ticks on each axis. `range` is that of u and of v.
  void axes(const std::array<Point, 2>& range)
  {
    line({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true, 1);
    for (int i = 0; i <= 4; ++i)
    {
      const double t = i / 4.;
      const auto value = [&](int k) {
        std::array<char, 32> label;
        const auto end = std::to_chars(label.data(), label.data() + label.size(),
                                       range[k][0] + t * (range[k][1] - range[k][0]),
                                       std::chars_format::general, 4);
        return std::string(label.data(), end.ptr);
      };
      m_out << "<path stroke=\"black\" d=\"M" << svg_number(x(t)) << ' ' << svg_number(y(0))
            << "v5M" << svg_number(x(0)) << ' ' << svg_number(y(t)) << "h-5\"/>\n";
      text(x(t), y(0) + 20, "middle", value(0));
      text(x(0) - 9, y(t) + 5, "end", value(1));
    }
    text(x(0.5), y(0) + 42, "middle", "u", " font-style=\"italic\"");
    text(16, y(0.5) + 5, "middle", "v", " font-style=\"italic\"");
  }

  void legend(int line, const std::string& fill, const std::string& name)
  {
    const double at = top + m_size + bottom + line * legend_line;
    m_out << "<rect x=\"" << svg_number(left) << "\" y=\"" << svg_number(at - 6)
          << "\" width=\"24\" height=\"14\" stroke=\"black\" fill=\"" << fill << "\"/>\n";
    text(left + 34, at + 6, "start", name);
  }

  // The line of the legend for marks.
  void mark_legend(int line, const std::string& name)
  {
    const double at = top + m_size + bottom + line * legend_line;
    mark_at(left + 7, at - 4, 10, 10);
    text(left + 34, at + 6, "start", name);
  }

private:
  void mark_at(double at_x, double at_y, double width, double height)
  {
    for (const char* stroke : {"white\" stroke-width=\"5", "#D55E00\" stroke-width=\"2"})
      m_out << "<rect x=\"" << svg_number(at_x) << "\" y=\"" << svg_number(at_y) << "\" width=\""
            << svg_number(width) << "\" height=\"" << svg_number(height)
            << "\" fill=\"none\" stroke=\"" << stroke << "\"/>\n";
  }

  void write_path(const std::vector<Point>& points, bool is_closed)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_out << (i == 0 ? 'M' : 'L') << svg_number(x(points[i][0])) << ' '
            << svg_number(y(points[i][1]));
    if (is_closed)
      m_out << 'Z';
  }

  std::ostream& m_out;
  const double m_size, m_height;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_INTERNAL_SVG_PICTURE_H
