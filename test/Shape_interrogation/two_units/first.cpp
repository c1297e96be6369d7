// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// All headers read in two translation units: a function that is not inline would be defined twice.

#include "all_headers.h"

int second();

int main()
{
  return second();
}
