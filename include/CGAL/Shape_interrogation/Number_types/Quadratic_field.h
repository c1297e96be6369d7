// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_QUADRATIC_FIELD_H
#define CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_QUADRATIC_FIELD_H

// Numbers a + b sqrt(c) over the rationals: CGAL::Sqrt_extension with a guard.
// In Release, Sqrt_extension multiplies numbers with different roots to a wrong result silently.

#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Number_types/reduced_square_root.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Sqrt_extension.h>

#include <ostream>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationNumberTypes
 * \brief is an element \f$ a + b \sqrt c \f$ of a real quadratic field over the rationals, exact in
 * all field operations and in every sign.
 *
 * The root \f$ c \f$ is carried by each number that has one; rational numbers mix with all.
 * \exception Mixed_roots_error when two numbers with different roots meet in one operation
 * \exception Division_by_zero_error on division by zero
 * \cgalModels{Field,RealEmbeddable}
 */
class Quadratic_field
{
public:
  using Rational = CGAL::Exact_rational;                                          //!< coefficients
  using Extension = CGAL::Sqrt_extension<Rational, Rational, Tag_false, Tag_false>; //!< storage

  Quadratic_field() : m_x(Rational(0)) {}                  //!< constructs zero.
  //! constructs an integer, of any built-in type.
  template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
  Quadratic_field(Integer a) : m_x(number_cast<Rational>(a)) {}
  //! constructs the exact value of `a`. \exception Conversion_error if it is not finite
  explicit Quadratic_field(double a) : m_x(number_cast<Rational>(a)) {}
  Quadratic_field(const Rational& a) : m_x(a) {}           //!< constructs a rational number.

  //! constructs \f$ a + b \sqrt c \f$, which is rational if the root is. \pre `c` is positive
  Quadratic_field(const Rational& a, const Rational& b, const Rational& c) : m_x(a, b, c)
  {
    CGAL_precondition_msg(CGAL::is_positive(c), "the root of a quadratic field must be positive");
    // The norm, by which a quotient divides, is zero only for zero if c is not a square.
    Rational root;
    if (internal::has_rational_root(c, root))
      m_x = Extension(Rational(a + b * root));
    reduce();
  }

  //! returns the rational part \f$ a \f$.
  const Rational& rational_part() const { return m_x.a0(); }
  //! returns the coefficient \f$ b \f$ of the root.
  Rational root_coefficient() const { return is_rational() ? Rational(0) : m_x.a1(); }
  //! returns \f$ c \f$, or 0 for a rational number.
  Rational root() const { return is_rational() ? Rational(0) : m_x.root(); }
  //! tells whether the number is rational.
  bool is_rational() const { return !m_x.is_extended(); }
  //! returns the number as the library's own type.
  const Extension& extension() const { return m_x; }

  CGAL::Sign sign() const { return m_x.sign(); } //!< returns the sign.

  //! compares.
  CGAL::Comparison_result compare(const Quadratic_field& y) const
  {
    guard(y);
    return m_x.compare(y.m_x);
  }

#ifndef DOXYGEN_RUNNING
  friend Quadratic_field operator+(const Quadratic_field& x) { return x; }
  friend Quadratic_field operator-(const Quadratic_field& x) { return Quadratic_field(-x.m_x); }
  Quadratic_field& operator+=(const Quadratic_field& y)
  {
    guard(y);
    m_x += y.m_x;
    return reduce();
  }
  Quadratic_field& operator-=(const Quadratic_field& y)
  {
    guard(y);
    m_x -= y.m_x;
    return reduce();
  }
  Quadratic_field& operator*=(const Quadratic_field& y)
  {
    guard(y);
    m_x *= y.m_x;
    return reduce();
  }
  Quadratic_field& operator/=(const Quadratic_field& y)
  {
    guard(y);
    if (CGAL::is_zero(y.m_x))
      throw Division_by_zero_error("division by zero in a quadratic field");
    m_x /= y.m_x;
    return reduce();
  }
  friend Quadratic_field operator+(Quadratic_field x, const Quadratic_field& y) { return x += y; }
  friend Quadratic_field operator-(Quadratic_field x, const Quadratic_field& y) { return x -= y; }
  friend Quadratic_field operator*(Quadratic_field x, const Quadratic_field& y) { return x *= y; }
  friend Quadratic_field operator/(Quadratic_field x, const Quadratic_field& y) { return x /= y; }
  friend bool operator==(const Quadratic_field& x, const Quadratic_field& y)
  {
    return x.compare(y) == EQUAL;
  }
  friend bool operator!=(const Quadratic_field& x, const Quadratic_field& y) { return !(x == y); }
  friend bool operator<(const Quadratic_field& x, const Quadratic_field& y)
  {
    return x.compare(y) == SMALLER;
  }
  friend bool operator>(const Quadratic_field& x, const Quadratic_field& y) { return y < x; }
  friend bool operator<=(const Quadratic_field& x, const Quadratic_field& y) { return !(y < x); }
  friend bool operator>=(const Quadratic_field& x, const Quadratic_field& y) { return !(x < y); }
  friend std::ostream& operator<<(std::ostream& out, const Quadratic_field& x)
  {
    if (x.is_rational())
      return out << x.m_x.a0();
    if (!CGAL::is_zero(x.m_x.a0()))
      out << x.m_x.a0() << (CGAL::is_negative(x.m_x.a1()) ? "" : "+");
    return out << x.m_x.a1() << "*sqrt(" << x.m_x.root() << ")";
  }
#endif

private:
  explicit Quadratic_field(const Extension& x) : m_x(x) { reduce(); }

  void guard(const Quadratic_field& y) const
  {
    if (m_x.is_extended() && y.m_x.is_extended() && m_x.root() != y.m_x.root())
      throw Mixed_roots_error("numbers with sqrt(" + text(m_x.root()) + ") and sqrt(" +
                              text(y.m_x.root()) + ") meet: one root is allowed in this number"
                              " type");
  }
  static std::string text(const Rational& x)
  {
    std::ostringstream out;
    out << x;
    return out.str();
  }

  // A number whose root part vanished must not carry the root on.
  Quadratic_field& reduce()
  {
    if (m_x.is_extended() && CGAL::is_zero(m_x.a1()))
      m_x = Extension(m_x.a0());
    return *this;
  }

  Extension m_x;
};

#ifndef DOXYGEN_RUNNING

template <>
struct Number_cast<double, Quadratic_field>
{
  static double cast(const Quadratic_field& x)
  {
    return x.is_rational() ? number_cast<double>(x.rational_part()) : internal::nearest_double(x);
  }
};

template <>
struct Number_cast<CORE::Expr, Quadratic_field>
{
  static CORE::Expr cast(const Quadratic_field& x)
  {
    const CORE::Expr a = number_cast<CORE::Expr>(x.rational_part());
    if (x.is_rational())
      return a;
    return a + number_cast<CORE::Expr>(x.root_coefficient()) *
                 CGAL::sqrt(number_cast<CORE::Expr>(x.root()));
  }
};

// sqrt(n/d) = r sqrt(c) / d with n d = r^2 c; numbers with a root may be squares in their field.
template <>
struct Elementary_functions<Quadratic_field> : internal::No_functions<Quadratic_field>
{
  static Quadratic_field sqrt(const Quadratic_field& x)
  {
    if (x.sign() == NEGATIVE)
      throw Domain_error("sqrt of a negative number");
    if (!x.is_rational())
      return root_in_field(x);
    const Reduced_square_root root = reduced_square_root(x.rational_part());
    if (root.radicand == 1)
      return Quadratic_field(root.factor);
    return Quadratic_field(Quadratic_field::Rational(0), root.factor, root.radicand);
  }

private:
  using Rational = Quadratic_field::Rational;

  // (y + z sqrt(c))^2 = a + b sqrt(c) for y^2 = (a +- n) / 2, n^2 = a^2 - b^2 c, z = b / (2 y).
  static Quadratic_field root_in_field(const Quadratic_field& x)
  {
    const Rational a = x.rational_part(), b = x.root_coefficient(), c = x.root();
    const Rational norm = a * a - b * b * c;
    Rational n, y;
    if (!CGAL::is_negative(norm) && internal::has_rational_root(norm, n))
      for (const Rational& candidate : {Rational((a + n) / 2), Rational((a - n) / 2)})
        if (CGAL::is_positive(candidate) && internal::has_rational_root(candidate, y))
        {
          const Quadratic_field root(y, Rational(b / (2 * y)), c);
          return root.sign() == NEGATIVE ? -root : root;
        }
    throw Not_algebraic_error("sqrt of a number with a root is not in the quadratic field");
  }
};

#endif // DOXYGEN_RUNNING

} // namespace Shape_interrogation

#ifndef DOXYGEN_RUNNING

template <>
class Algebraic_structure_traits<Shape_interrogation::Quadratic_field>
  : public Algebraic_structure_traits_base<Shape_interrogation::Quadratic_field, Field_tag>
{
public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;
};

template <>
class Real_embeddable_traits<Shape_interrogation::Quadratic_field>
  : public INTERN_RET::Real_embeddable_traits_base<Shape_interrogation::Quadratic_field, Tag_true>
{
  using NT = Shape_interrogation::Quadratic_field;

public:
  struct Sgn
  {
    using argument_type = NT;
    using result_type = CGAL::Sign;
    CGAL::Sign operator()(const NT& x) const { return x.sign(); }
  };
  struct Compare
  {
    using first_argument_type = NT;
    using second_argument_type = NT;
    using result_type = CGAL::Comparison_result;
    CGAL::Comparison_result operator()(const NT& x, const NT& y) const { return x.compare(y); }
  };
  struct To_double
  {
    using argument_type = NT;
    using result_type = double;
    double operator()(const NT& x) const { return CGAL::to_double(x.extension()); }
  };
  struct To_interval
  {
    using argument_type = NT;
    using result_type = std::pair<double, double>;
    std::pair<double, double> operator()(const NT& x) const
    {
      return CGAL::to_interval(x.extension());
    }
  };
};

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_NUMBER_TYPES_QUADRATIC_FIELD_H
