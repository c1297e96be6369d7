// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef INTERROGATE_READ_MEMBERS_H
#define INTERROGATE_READ_MEMBERS_H

// What constructions are made of: surfaces, curves in space and points, by name or in place.

#include "Json_place.h"
#include "Model.h"

#include <CGAL/Shape_interrogation/Constraints/Entity_3.h>

#include <cstddef>
#include <string>
#include <vector>

namespace interrogate {

// What a member may be. Parametric surfaces are those that have parameters, patches too.
enum : int
{
  IMPLICIT = 1,
  PARAMETRIC = 2,
  CURVE = 4,
  POINT = 8,
  SURFACE = IMPLICIT | PARAMETRIC,
  ENTITY = SURFACE | CURVE | POINT
};

// An ingredient with the ranges of its parameters, if it has any.
struct Member
{
  si::Entity_3 entity;
  std::vector<Range> domain;
};

// Where names of members are looked up.
struct Named_shapes
{
  const Model& model;         // the surfaces that are no constructions, and the curves
  const Json_place& surfaces; // all surfaces, as they are written
  const std::string& self;    // the name of the construction that is read
};

// Reads a member that is one of the allowed kinds, a sum of the above. Throws Unsupported, which is
// no error of the model, where a member is of a kind that this version does not offer.
Member read_member(const Json_place& place, const Named_shapes& shapes, int allowed);

// Reads the field "of" with a number of members from `least` to `most`; one stands without an array
// as well.
std::vector<Member> read_of(const Json_place& place, const Named_shapes& shapes,
                            std::size_t least, std::size_t most, int allowed);

} // namespace interrogate

#endif // INTERROGATE_READ_MEMBERS_H
