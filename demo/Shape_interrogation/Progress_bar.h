// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_PROGRESS_BAR_H
#define INTERROGATE_PROGRESS_BAR_H

// A bar on the terminal for tasks that take longer than a second.

#include <chrono>
#include <cstddef>
#include <string>

namespace interrogate {

class Progress_bar
{
public:
  // Draws only if `enabled`; that is for a terminal.
  explicit Progress_bar(bool enabled) : m_enabled(enabled) {}
  ~Progress_bar() { clear(); }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void start(const std::string& task);
  // Shows the part that is done; a total of 0 is unknown.
  void show(std::size_t done, std::size_t total);
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  bool m_enabled;
  bool m_drawn = false;
  std::string m_task;
  Clock::time_point m_next;
};

} // namespace interrogate

#endif // INTERROGATE_PROGRESS_BAR_H
