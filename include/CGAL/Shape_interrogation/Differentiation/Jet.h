// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_JET_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_JET_H

// Truncated Taylor polynomials as a number type: derivatives without derivatives.
// A coefficient that is zero by structure is marked in a mask, which the compiler folds away where
// it can and which saves the operation where it cannot (exact types).

#include <CGAL/Shape_interrogation/Differentiation/internal/monomials.h>
#include <CGAL/Shape_interrogation/Differentiation/internal/static_for.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/internal/inline.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>

#include <array>
#include <type_traits>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationDifferentiation
 * \brief is a polynomial in `N` variables truncated after the total degree `Order`, with the
 * arithmetic of a number type.
 *
 * Evaluating a function once over jets yields its value and all derivatives up to `Order`.
 * The coefficient of \f$ x_i x_j \f$ is stored, not the derivative:
 * \f$ \partial^2 f / \partial x_i^2 = 2 c_{ii} \f$, \f$ \partial^2 f / \partial x_i \partial x_j =
 * c_{ij} \f$.
 *
 * The ring operations need a ring `NT`; division and the elementary functions need a field (and the
 * function in `NT`, see `Elementary_functions`). Nothing branches on a value.
 *
 * \tparam NT a number type
 * \tparam N the number of variables, at least 1
 * \tparam Order the truncation degree, 1 to 4
 *
 * Complexity: a product costs \f$ O(\binom{2N+Order}{Order}) \f$ operations, fewer where
 * coefficients are zero by structure.
 */
template <class NT, int N, int Order = 2>
class Jet
{
  using Monomials = internal::Monomials<N, Order>;

public:
  using Number_type = NT;                      //!< the coefficients
  static constexpr int variables = N;          //!< the number of variables
  static constexpr int order = Order;          //!< the truncation degree
  static constexpr int size = Monomials::size; //!< the number of coefficients

  Jet() : m_mask(0) {} //!< constructs zero.

  //! constructs a constant.
  Jet(const NT& constant) : m_mask(1) { m_c[0] = constant; }

  //! constructs a constant from a small integer.
  template <class Integer, class = std::enable_if_t<std::is_arithmetic_v<Integer> &&
                                                    !std::is_same_v<Integer, NT>>>
  Jet(Integer constant) : Jet(NT(constant)) {}

  //! returns the variable with index `i` at `value`. \pre `0 <= i < N`
  [[gnu::always_inline]] static Jet variable(int i, const NT& value)
  {
    Jet x(value);
    internal::static_for<size>([&](auto k) CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA {
      if (k == 1 + i) x.m_c[k] = NT(1);
    });
    x.m_mask |= 2ull << i;
    return x;
  }

  //! returns the jet of `value + sum step[i] * t_i`: a point moving along given directions.
  static Jet along(const NT& value, const std::array<NT, N>& step)
  {
    Jet x(value);
    for (int i = 0; i < N; ++i)
    {
      x.m_c[1 + i] = step[i];
      x.m_mask |= 2ull << i;
    }
    return x;
  }

  //! returns the value.
  NT value() const { return coefficient(0); }

  //! returns the first derivative with respect to variable `i`.
  NT derivative(int i) const { return coefficient(1 + i); }

  //! returns the second derivative with respect to variables `i` and `j`.
  NT derivative(int i, int j) const
  {
    NT c = coefficient(Monomials::index(i, j));
    if (i == j)
      c += c;
    return c;
  }

  //! returns the Taylor coefficient at a storage index: 1, the variables, products of two, ...
  NT coefficient(int index) const { return has(index) ? m_c[index] : NT(0); }

  //! returns the Taylor coefficient of the monomial with the given exponents.
  NT coefficient(const std::array<int, N>& e) const { return coefficient(Monomials::index_of(e)); }

  //! tells whether the coefficient is zero by structure, without looking at its value.
  bool is_structurally_zero(int index) const { return !has(index); }

  //! tells whether all derivatives are zero by structure.
  bool is_constant() const { return m_mask <= 1u; }

#ifndef DOXYGEN_RUNNING
  friend Jet operator+(const Jet& a) { return a; }
  [[gnu::always_inline]] friend Jet operator-(const Jet& a)
  {
    if constexpr (is_light) return Opposite()(a);
    else return out_of_line(Opposite(), a);
  }
  [[gnu::always_inline]] friend Jet operator+(const Jet& a, const Jet& b)
  {
    if constexpr (is_light) return Sum()(a, b);
    else return out_of_line(Sum(), a, b);
  }
  [[gnu::always_inline]] friend Jet operator-(const Jet& a, const Jet& b)
  {
    if constexpr (is_light) return Difference()(a, b);
    else return out_of_line(Difference(), a, b);
  }
  [[gnu::always_inline]] friend Jet operator*(const Jet& a, const Jet& b)
  {
    if constexpr (is_light) return Product()(a, b);
    else return out_of_line(Product(), a, b);
  }
  [[gnu::always_inline]] friend Jet operator*(const Jet& a, const NT& s)
  {
    if constexpr (is_light) return Multiple()(a, s);
    else return out_of_line(Multiple(), a, s);
  }
  [[gnu::always_inline]] friend Jet operator*(const NT& s, const Jet& a) { return a * s; }
  friend Jet operator/(const Jet& a, const NT& s)
  {
    if (CGAL::certainly(is_zero_decision(s)))
      refuse_divisor();
    Jet r;
    r.m_mask = a.m_mask;
    internal::static_for<size>([&](auto k) { if (a.has(k)) r.m_c[k] = a.m_c[k] / s; });
    return r;
  }
  friend Jet operator/(const NT& s, const Jet& b) { return b.reciprocal() * s; }
  friend Jet operator/(const Jet& a, const Jet& b)
  {
    return b.is_constant() ? a / b.value() : a * b.reciprocal();
  }
  template <class I> using If_number =
    std::enable_if_t<std::is_arithmetic_v<I> && !std::is_same_v<I, NT>, Jet>;
  template <class I> friend If_number<I> operator*(const Jet& a, I s) { return a * NT(s); }
  template <class I> friend If_number<I> operator*(I s, const Jet& a) { return a * NT(s); }
  template <class I> friend If_number<I> operator/(const Jet& a, I s) { return a / NT(s); }
  template <class I> friend If_number<I> operator/(I s, const Jet& a) { return NT(s) / a; }

  Jet& operator+=(const Jet& b) { return *this = *this + b; }
  Jet& operator-=(const Jet& b) { return *this = *this - b; }
  Jet& operator*=(const Jet& b) { return *this = *this * b; }
  Jet& operator/=(const Jet& b) { return *this = *this / b; }
#endif

  //! returns \f$ \sum_k t_k (x - x_0)^k \f$ for this jet \f$ x \f$ with value \f$ x_0 \f$: the
  //! function with the Taylor coefficients `t` at \f$ x_0 \f$ applied to the jet.
  Jet compose(const std::array<NT, Order + 1>& t) const
  {
    Jet nilpotent = *this;
    nilpotent.m_mask &= ~1ull;
    Jet r(t[Order]);
    for (int k = Order; k-- > 0;)
    {
      r = r * nilpotent;
      r.m_mask |= 1u;
      r.m_c[0] = t[k];
    }
    return r;
  }

  //! returns the jet without its constant and linear terms.
  Jet without_affine_part() const
  {
    Jet r = *this;
    r.m_mask &= ~((2ull << N) - 1);
    return r;
  }

  //! returns 1 divided by the jet. \exception Division_by_zero_error if the value is certainly zero
  Jet reciprocal() const
  {
    if (!has(0) || CGAL::certainly(is_zero_decision(m_c[0])))
      refuse_divisor();
    std::array<NT, Order + 1> t;
    t[0] = NT(1) / m_c[0];
    for (int k = 1; k <= Order; ++k)
    {
      NT next = t[k - 1] * t[0];
      t[k] = -next;
    }
    return compose(t);
  }

private:
  [[noreturn]] static void refuse_divisor()
  {
    throw Division_by_zero_error("division by an expression that is zero at this point");
  }

  static constexpr bool is_light = Number_type_traits<NT>::is_light;

  // The operations are inlined into the caller for light types only: there the masks become
  // constants and the zero terms vanish; for others the code would grow beyond all measure.
  struct Opposite
  {
    [[gnu::always_inline]] Jet operator()(const Jet& a) const
    {
      Jet r;
      r.m_mask = a.m_mask;
      internal::static_for<size>([&](auto k) CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA {
        if (a.has(k)) r.m_c[k] = -a.m_c[k];
      });
      return r;
    }
  };
  template <bool subtract>
  struct Combination
  {
    [[gnu::always_inline]] Jet operator()(const Jet& a, const Jet& b) const
    {
      Jet r;
      r.m_mask = a.m_mask | b.m_mask;
      internal::static_for<size>([&](auto k) CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA {
        const bool in_a = a.has(k), in_b = b.has(k);
        if (in_a && in_b)
          r.m_c[k] = subtract ? NT(a.m_c[k] - b.m_c[k]) : NT(a.m_c[k] + b.m_c[k]);
        else if (in_a) r.m_c[k] = a.m_c[k];
        else if (in_b) r.m_c[k] = subtract ? NT(-b.m_c[k]) : b.m_c[k];
      });
      return r;
    }
  };
  using Sum = Combination<false>;
  using Difference = Combination<true>;
  struct Product
  {
    [[gnu::always_inline]] Jet operator()(const Jet& a, const Jet& b) const
    {
      Jet r;
      internal::static_for<Monomials::number_of_products>([&](auto p)
                                                CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA {
        constexpr auto t = Monomials::products[p];
        constexpr int i = t.left, j = t.right, k = t.result;
        if (!a.has(i) || !b.has(j))
          return;
        if (r.has(k)) r.m_c[k] += a.m_c[i] * b.m_c[j];
        else r.m_c[k] = a.m_c[i] * b.m_c[j];
        r.m_mask |= 1ull << k;
      });
      return r;
    }
  };
  struct Multiple
  {
    [[gnu::always_inline]] Jet operator()(const Jet& a, const NT& s) const
    {
      Jet r;
      r.m_mask = a.m_mask;
      internal::static_for<size>([&](auto k) CGAL_SHAPE_INTERROGATION_INLINE_LAMBDA {
        if (a.has(k)) r.m_c[k] = a.m_c[k] * s;
      });
      return r;
    }
  };

  template <class F, class... Args>
  static Jet out_of_line(F operation, const Args&... args) { return operation(args...); }

  [[gnu::always_inline]] bool has(int k) const { return (m_mask >> k) & 1u; }

  std::array<NT, size> m_c;
  unsigned long long m_mask;
};

} // namespace Shape_interrogation
} // namespace CGAL

#include <CGAL/Shape_interrogation/Differentiation/internal/Jet_functions.h>

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_JET_H
