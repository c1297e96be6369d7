// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_FUNCTIONS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_FUNCTIONS_H

// The elementary functions of intervals of many bits. As those of Interval_nt: what is partly
// outside of the domain has any value.

#include <CGAL/Shape_interrogation/Number_types/Errors.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <mpfi.h>

#include <string>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class NT>
struct Mpfi_functions
{
  static NT sqrt(const NT& x) { return inside(x, x.sign() >= ZERO, "sqrt", mpfi_sqrt); }
  static NT exp(const NT& x) { return x.apply(mpfi_exp); }
  static NT log(const NT& x) { return inside(x, x.sign() > ZERO, "log", mpfi_log); }
  static NT sin(const NT& x) { return x.apply(mpfi_sin); }
  static NT cos(const NT& x) { return x.apply(mpfi_cos); }
  static NT tan(const NT& x) { return x.apply(mpfi_tan); }
  static NT asin(const NT& x) { return inside(x, is_in_unit(x), "asin", mpfi_asin); }
  static NT acos(const NT& x) { return inside(x, is_in_unit(x), "acos", mpfi_acos); }
  static NT atan(const NT& x) { return x.apply(mpfi_atan); }
  static NT pi()
  {
    return NT(0).apply([](mpfi_ptr result, mpfi_srcptr) { mpfi_const_pi(result); });
  }

private:
  static Uncertain<bool> is_in_unit(const NT& x)
  {
    return ((NT(1) - x).sign() >= ZERO) & ((NT(1) + x).sign() >= ZERO);
  }

  template <class Function>
  static NT inside(const NT& x, const Uncertain<bool>& is_inside, const char* name, Function f)
  {
    if (CGAL::certainly_not(is_inside))
      throw Domain_error(std::string(name) + " of a number that is certainly outside its domain");
    return CGAL::certainly(is_inside) ? x.apply(f) : NT(Interval_nt<false>::largest());
  }
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_FUNCTIONS_H
