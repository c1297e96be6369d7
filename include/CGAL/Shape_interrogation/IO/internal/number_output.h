// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_IO_INTERNAL_NUMBER_OUTPUT_H
#define CGAL_SHAPE_INTERROGATION_IO_INTERNAL_NUMBER_OUTPUT_H

// Numbers as text that reads back to the same number in every locale, and as little-endian bytes.

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <string>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The shortest text that gives the number back: at most 17 significant digits for a double.
template <class T>
void write_text(std::ostream& out, T x)
{
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x);
  out.write(text.data(), end.ptr - text.data());
}

// The bits of a number in an unsigned integer of the same size.
template <class T>
std::uint64_t bits_of(T x)
{
  if constexpr (sizeof(T) == 1)
    return static_cast<unsigned char>(x);
  else if constexpr (sizeof(T) == 4)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &x, 4);
    return bits;
  }
  else
  {
    static_assert(sizeof(T) == 8, "a number of 1, 4 or 8 bytes is expected");
    std::uint64_t bits;
    std::memcpy(&bits, &x, 8);
    return bits;
  }
}

// Appends the bytes of a number, the least significant first.
template <class T>
void append_little_endian(std::string& bytes, T x)
{
  std::uint64_t bits = bits_of(x);
  for (std::size_t i = 0; i < sizeof(T); ++i, bits >>= 8)
    bytes.push_back(static_cast<char>(bits & 0xff));
}

// The inverse of append_little_endian().
template <class T>
T from_little_endian(const char* bytes)
{
  std::uint64_t bits = 0;
  for (std::size_t i = sizeof(T); i-- > 0; )
    bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  T x;
  if constexpr (sizeof(T) == 8)
    std::memcpy(&x, &bits, 8);
  else if constexpr (sizeof(T) == 4)
  {
    const std::uint32_t half = static_cast<std::uint32_t>(bits);
    std::memcpy(&x, &half, 4);
  }
  else if constexpr (sizeof(T) == 2)
    x = static_cast<T>(static_cast<std::uint16_t>(bits));
  else
    x = static_cast<T>(bits);
  return x;
}

// The bytes in base 64, padded at the end.
inline std::string to_base64(const std::string& bytes)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t left = bytes.size() - i;
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= left ? digits[three >> (18 - 6 * k) & 63] : '=');
  }
  return text;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_IO_INTERNAL_NUMBER_OUTPUT_H
