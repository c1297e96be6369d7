// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Compiled with the flags of a user's program; the checks beside it take the flags from here.

#include <CGAL/Shape_interrogation.h>

int main() {}
