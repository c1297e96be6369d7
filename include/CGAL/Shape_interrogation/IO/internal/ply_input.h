// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_INTERNAL_PLY_INPUT_H
#define CGAL_SHAPE_INTERROGATION_IO_INTERNAL_PLY_INPUT_H

// The grammar of PLY: a header that lists elements with their properties, then the numbers, as text
// or as little-endian bytes.

#include <CGAL/Shape_interrogation/IO/internal/number_output.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// Ends the reading of a file with a sentence for people.
struct Ply_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::DOUBLE;
  bool is_list = false;
  Ply_type count_type = Ply_type::UINT8;
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  bool text = true;
  std::vector<Ply_element> elements;
};

inline Ply_type ply_type(const std::string& name)
{
  static const std::array<std::array<const char*, 2>, 8> names{{
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"}, {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i][0] || name == names[i][1])
      return static_cast<Ply_type>(i);
  throw Ply_error("the header has a property of the unknown type '" + name + "'");
}

// The words of the next line that is not a comment.
inline std::vector<std::string> ply_header_words(std::istream& in)
{
  std::string line;
  while (std::getline(in, line))
  {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word; )
      words.push_back(word);
    if (!words.empty() && words[0] != "comment" && words[0] != "obj_info")
      return words;
  }
  throw Ply_error("the file ends before 'end_header'");
}

inline Ply_element ply_element(const std::vector<std::string>& words)
{
  Ply_element element;
  element.name = words[1];
  const char* const end = words[2].data() + words[2].size();
  const auto read = std::from_chars(words[2].data(), end, element.count);
  if (read.ec != std::errc() || read.ptr != end)
    throw Ply_error("the header has the element count '" + words[2] + "', not a number");
  return element;
}

inline Ply_property ply_property(const std::vector<std::string>& words)
{
  if (words.size() == 5 && words[1] == "list")
    return {words[4], ply_type(words[3]), true, ply_type(words[2])};
  if (words.size() == 3)
    return {words[2], ply_type(words[1]), false, Ply_type::UINT8};
  throw Ply_error("the header has a malformed 'property' line");
}

inline Ply_header read_ply_header(std::istream& in)
{
  if (ply_header_words(in) != std::vector<std::string>{"ply"})
    throw Ply_error("the first line is not 'ply'");
  Ply_header header;
  for (auto words = ply_header_words(in); words[0] != "end_header"; words = ply_header_words(in))
  {
    if (words[0] == "format" && words.size() == 3 &&
        (words[1] == "ascii" || words[1] == "binary_little_endian"))
      header.text = words[1] == "ascii";
    else if (words[0] == "element" && words.size() == 3)
      header.elements.push_back(ply_element(words));
    else if (words[0] == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(ply_property(words));
    else
      throw Ply_error("the header has a line '" + words[0] + "' that is not understood (formats:"
                      " ascii, binary_little_endian)");
  }
  return header;
}

// Reads the numbers behind the header. All types of PLY fit a double exactly.
class Ply_input
{
public:
  Ply_input(std::istream& in, bool text) : m_in(in), m_text(text) {}

  double number(Ply_type type) { return m_text ? text_number() : binary_number(type); }

private:
  double text_number()
  {
    if (!(m_in >> m_word))
      throw Ply_error("the file ends before all numbers are read");
    double x = 0;
    const char* const end = m_word.data() + m_word.size();
    const auto read = std::from_chars(m_word.data(), end, x);
    if (read.ec != std::errc() || read.ptr != end)
      throw Ply_error("'" + m_word + "' stands where a number was expected");
    return x;
  }

  double binary_number(Ply_type type)
  {
    switch (type)
    {
      case Ply_type::INT8: return binary<signed char>();
      case Ply_type::UINT8: return binary<unsigned char>();
      case Ply_type::INT16: return binary<std::int16_t>();
      case Ply_type::UINT16: return binary<std::uint16_t>();
      case Ply_type::INT32: return binary<std::int32_t>();
      case Ply_type::UINT32: return binary<std::uint32_t>();
      case Ply_type::FLOAT: return binary<float>();
      default: return binary<double>();
    }
  }

  template <class T>
  double binary()
  {
    std::array<char, sizeof(T)> bytes;
    if (!m_in.read(bytes.data(), sizeof(T)))
      throw Ply_error("the file ends before all numbers are read");
    return static_cast<double>(from_little_endian<T>(bytes.data()));
  }

  std::istream& m_in;
  bool m_text;
  std::string m_word;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_INTERNAL_PLY_INPUT_H
