// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_HELPERS_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_HELPERS_H

// What MPFI has no function for: the interval of any exact rational, and a point of any interval.

#include <gmp.h>
#include <mpfi.h>
#include <mpfr.h>

#include <locale>
#include <sstream>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

template <class Rational>
auto mpfi_set_rational(mpfi_ptr interval, const Rational& x) -> decltype(x.get_mpq_t(), void())
{
  mpfi_set_q(interval, x.get_mpq_t());
}

// Not every exact rational is that of GMP; all can be written.
template <class Rational, class... None>
void mpfi_set_rational(mpfi_ptr interval, const Rational& x, None...)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << x;
  mpq_t q;
  mpq_init(q);
  mpq_set_str(q, text.str().c_str(), 10);
  mpfi_set_q(interval, q);
  mpq_clear(q);
}

// The middle, which is inside if `number` has as many bits as the ends; without bounds another
// point.
inline int mpfi_middle(mpfr_ptr number, mpfi_srcptr x)
{
  if (mpfi_bounded_p(x))
    return mpfi_mid(number, x);
  const bool has_lower = !mpfr_inf_p(&x->left), has_upper = !mpfr_inf_p(&x->right);
  if (has_lower || has_upper)
    return mpfr_set(number, has_lower ? &x->left : &x->right, MPFR_RNDN);
  mpfr_set_zero(number, 1);
  return 0;
}

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_INTERNAL_MPFI_HELPERS_H
