// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Draws the bar on one line of the standard error stream, ten times a second at most.

#include "Progress_bar.h"

#include "Json.h"

#include <algorithm>
#include <cstdio>

namespace interrogate {

void Progress_bar::start(const std::string& task)
{
  clear();
  m_task = printable(task).substr(0, 30);
  m_next = Clock::now() + std::chrono::seconds(1);
}

void Progress_bar::show(std::size_t done, std::size_t total)
{
  const Clock::time_point now = Clock::now();
  if (!m_enabled || now < m_next)
    return;
  m_next = now + std::chrono::milliseconds(100);
  m_drawn = true;
  if (total == 0)
  {
    std::fprintf(stderr, "\r\033[K%s: %zu", m_task.c_str(), done);
    return;
  }
  const std::size_t width = 40;
  const std::size_t filled = (std::min)(width, width * done / total);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %3zu %%", m_task.c_str(), bar.c_str(),
               (std::min)(std::size_t(100), 100 * done / total));
}

void Progress_bar::clear()
{
  if (m_drawn)
    std::fputs("\r\033[K", stderr);
  m_drawn = false;
}

} // namespace interrogate
