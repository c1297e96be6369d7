// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SCHEDULE_TAPE_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SCHEDULE_TAPE_H

// Reorders instructions so that equal operations follow each other: the interpreter then decides
// once a run what to do. Done in windows, which keeps the results of neighbours close in memory.

#include <CGAL/Shape_interrogation/Differentiation/internal/Tape_instruction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

class Tape_scheduler
{
public:
  // Slots below `first_slot` are not written by the code.
  Tape_scheduler(std::vector<Tape_instruction>& code, std::uint32_t first_slot)
    : m_code(code), m_first_slot(first_slot)
  {}

  // Reorders the instructions from `begin` on. Returns the new slots by the old ones.
  std::vector<std::uint32_t> operator()(std::size_t begin)
  {
    constexpr std::size_t window = 2048;
    m_new_slots.resize(m_first_slot + m_code.size());
    for (std::size_t i = 0; i < m_first_slot + begin; ++i)
      m_new_slots[i] = static_cast<std::uint32_t>(i);
    for (; begin < m_code.size(); begin += window)
      schedule(begin, std::min(begin + window, m_code.size()));
    return std::move(m_new_slots);
  }

private:
  void schedule(std::size_t begin, std::size_t end)
  {
    const std::vector<Tape_instruction> old(m_code.begin() + begin, m_code.begin() + end);
    count_operands(old, begin);
    std::size_t next = begin;
    while (next < end)
    {
      auto& ready = *std::max_element(m_ready.begin(), m_ready.end(), [](auto& a, auto& b) {
        return a.size() < b.size();
      });
      for (std::size_t k = 0; k < ready.size(); ++k, ++next)
      {
        const std::uint32_t i = ready[k];
        m_new_slots[m_first_slot + begin + i] = static_cast<std::uint32_t>(m_first_slot + next);
        m_code[next] = renamed(old[i]);
        finish(old, i);
      }
      ready.clear();
    }
  }

  // Lists for each instruction of the window those that wait for it.
  void count_operands(const std::vector<Tape_instruction>& old, std::size_t begin)
  {
    m_missing.assign(old.size(), 0);
    m_waiting.assign(old.size(), {});
    for (std::uint32_t i = 0; i < old.size(); ++i)
    {
      for_each_slot(old[i], [&](std::uint32_t slot) {
        if (slot >= m_first_slot + begin)
        {
          ++m_missing[i];
          m_waiting[slot - m_first_slot - begin].push_back(i);
        }
      });
      if (m_missing[i] == 0)
        ready_for(old[i]).push_back(i);
    }
  }

  void finish(const std::vector<Tape_instruction>& old, std::uint32_t i)
  {
    for (const std::uint32_t user : m_waiting[i])
      if (--m_missing[user] == 0)
        ready_for(old[user]).push_back(user);
  }

  std::vector<std::uint32_t>& ready_for(const Tape_instruction& i)
  {
    return m_ready[static_cast<std::size_t>(i.operation)];
  }

  Tape_instruction renamed(Tape_instruction i) const
  {
    for_each_slot(i, [&](std::uint32_t& slot) { slot = m_new_slots[slot]; });
    return i;
  }

  std::vector<Tape_instruction>& m_code;
  std::uint32_t m_first_slot;
  std::vector<std::uint32_t> m_new_slots;
  std::vector<std::uint32_t> m_missing;
  std::vector<std::vector<std::uint32_t>> m_waiting;
  std::array<std::vector<std::uint32_t>, number_of_tape_operations> m_ready;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_SCHEDULE_TAPE_H
