// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_PACKED_POLYNOMIAL_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_PACKED_POLYNOMIAL_H

// Kronecker substitution: a polynomial with integer coefficients as its value at a power of two,
// so that a product of polynomials is one product of integers.

#include <CGAL/Shape_interrogation/Bernstein/internal/gmp_access.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {

// The value of a polynomial at a power of two: a sign and its limbs.
class Packed_polynomial
{
public:
  // Coefficient k goes to the slot `slots[k]`; each must fit `bits` bits with one to spare. With a
  // step of 2 only the slots with the parity of `first` count, and they move together.
  template <class Integer>
  Packed_polynomial(const std::vector<Integer>& coefficients, const std::vector<int>& slots,
                    std::size_t bits, int first = 0, int step = 1)
  {
    const std::size_t size = limbs_for((slots.back() / step + std::size_t(1)) * bits) + 1;
    std::vector<mp_limb_t> negative(size, 0), shifted(limbs_for(bits) + 1);
    m_limbs.assign(size, 0);
    for (std::size_t k = 0; k < coefficients.size(); ++k)
    {
      mpz_srcptr c = gmp_of(coefficients[k]);
      if (slots[k] % step != first || mpz_sgn(c) == 0)
        continue;
      const std::size_t at = slots[k] / step * bits;
      const std::size_t length = shift_up(shifted, c, at % GMP_NUMB_BITS);
      mp_limb_t* to = (mpz_sgn(c) < 0 ? negative : m_limbs).data() + at / GMP_NUMB_BITS;
      for (std::size_t i = 0; i < length; ++i)
        to[i] |= shifted[i]; // slots meet in a limb, not in a bit
    }
    subtract(negative);
  }

  // The product.
  Packed_polynomial(const Packed_polynomial& a, const Packed_polynomial& b)
    : m_is_negative(a.m_is_negative != b.m_is_negative)
  {
    if (a.m_limbs.empty() || b.m_limbs.empty())
      return;
    const bool is_longer = a.m_limbs.size() >= b.m_limbs.size();
    const auto& x = is_longer ? a.m_limbs : b.m_limbs;
    const auto& y = is_longer ? b.m_limbs : a.m_limbs;
    m_limbs.resize(x.size() + y.size());
    if (&a == &b)
      mpn_sqr(m_limbs.data(), x.data(), x.size());
    else
      mpn_mul(m_limbs.data(), x.data(), x.size(), y.data(), y.size());
  }

  explicit Packed_polynomial(mpz_srcptr value)
    : m_limbs(mpz_limbs_read(value), mpz_limbs_read(value) + mpz_size(value)),
      m_is_negative(mpz_sgn(value) < 0)
  {}

  void get(mpz_ptr value) const
  {
    mpz_t view;
    const mp_size_t size = static_cast<mp_size_t>(m_limbs.size());
    mpz_set(value, mpz_roinit_n(view, m_limbs.data(), m_is_negative ? -size : size));
  }

  // Reads the coefficients back. What is below a slot borrows from it where it is negative.
  template <class Integer>
  void unpack(std::vector<Integer>& coefficients, std::size_t bits)
  {
    const std::size_t width = limbs_for(bits), top = bits - (width - 1) * GMP_NUMB_BITS;
    const mp_limb_t mask = GMP_NUMB_MASK >> (GMP_NUMB_BITS - top);
    m_limbs.resize(limbs_for(coefficients.size() * bits) + width + 2, 0);
    std::vector<mp_limb_t> slot(width + 1);
    mp_limb_t carry = 0;
    for (std::size_t k = 0; k < coefficients.size(); ++k)
    {
      const std::size_t at = k * bits;
      shift_down(slot, m_limbs.data() + at / GMP_NUMB_BITS, at % GMP_NUMB_BITS);
      slot[width - 1] &= mask;
      // A carry out of the slot means that it was full and is now zero, one above it.
      mp_limb_t overflow = mpn_add_1(slot.data(), slot.data(), width, carry);
      overflow |= slot[width - 1] & ~mask ? 1 : 0;
      slot[width - 1] &= mask;
      const bool is_below = slot[width - 1] >> (top - 1);
      if (is_below)
        mpn_neg(slot.data(), slot.data(), width);
      slot[width - 1] &= mask;
      carry = overflow | (is_below ? 1 : 0);
      set(gmp_of(coefficients[k]), slot.data(), width, is_below != m_is_negative);
    }
  }

private:
  static std::size_t limbs_for(std::size_t bits)
  {
    return (bits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
  }

  // Writes the limbs of z times 2^shift and returns their number. \pre z is not 0
  static std::size_t shift_up(std::vector<mp_limb_t>& to, mpz_srcptr z, unsigned shift)
  {
    const std::size_t size = mpz_size(z);
    if (shift == 0)
    {
      std::copy_n(mpz_limbs_read(z), size, to.begin());
      return size;
    }
    to[size] = mpn_lshift(to.data(), mpz_limbs_read(z), size, shift);
    return size + (to[size] != 0 ? 1 : 0);
  }

  static void shift_down(std::vector<mp_limb_t>& to, const mp_limb_t* from, unsigned shift)
  {
    if (shift == 0)
      std::copy_n(from, to.size(), to.begin());
    else
      mpn_rshift(to.data(), from, to.size(), shift);
  }

  void subtract(const std::vector<mp_limb_t>& negative)
  {
    m_is_negative = mpn_cmp(m_limbs.data(), negative.data(), m_limbs.size()) < 0;
    if (m_is_negative)
      mpn_sub_n(m_limbs.data(), negative.data(), m_limbs.data(), m_limbs.size());
    else
      mpn_sub_n(m_limbs.data(), m_limbs.data(), negative.data(), m_limbs.size());
    while (!m_limbs.empty() && m_limbs.back() == 0)
      m_limbs.pop_back();
  }

  static void set(mpz_ptr z, const mp_limb_t* limbs, std::size_t size, bool is_negative)
  {
    while (size > 0 && limbs[size - 1] == 0)
      --size;
    std::copy_n(limbs, size, mpz_limbs_write(z, std::max<std::size_t>(size, 1)));
    const mp_size_t signed_size = static_cast<mp_size_t>(size);
    mpz_limbs_finish(z, is_negative ? -signed_size : signed_size);
  }

  std::vector<mp_limb_t> m_limbs;
  bool m_is_negative = false;
};

} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_INTERNAL_PACKED_POLYNOMIAL_H
