// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef SHAPE_INTERROGATION_TEST_ALL_HEADERS_H
#define SHAPE_INTERROGATION_TEST_ALL_HEADERS_H

// The headers of the whole package: those that take long to compile are not in the first one.

#include <CGAL/Shape_interrogation.h>

#include <CGAL/Shape_interrogation/Differentiation/parse_expression.h>
#include <CGAL/Shape_interrogation/IO/read_ply.h>
#include <CGAL/Shape_interrogation/IO/write_mesh.h>
#include <CGAL/Shape_interrogation/IO/write_ply.h>
#include <CGAL/Shape_interrogation/IO/write_polylines.h>
#include <CGAL/Shape_interrogation/IO/write_vtp.h>
#include <CGAL/Shape_interrogation/Meshing/color_by_property.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_implicit_surface.h>
#include <CGAL/Shape_interrogation/Meshing/mesh_patches.h>

#endif // SHAPE_INTERROGATION_TEST_ALL_HEADERS_H
