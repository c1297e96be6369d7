// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAMMAR_H
#define CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAMMAR_H

// The grammar of expressions in Boost.Spirit X3. Slow to compile: only parse_expression.h
// includes it. It recurses in parentheses alone, whose depth is checked before.

#include <CGAL/Shape_interrogation/Differentiation/internal/Expression_builder.h>

#include <boost/spirit/home/x3.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace CGAL {
namespace Shape_interrogation {
namespace internal {
namespace grammar {

namespace x3 = boost::spirit::x3;

using Iterator = std::string_view::const_iterator;

struct Builder_tag;

template <class Context>
Expression_builder& builder(const Context& context)
{
  return x3::get<Builder_tag>(context).get();
}

template <class Context>
std::string_view matched(const Context& context)
{
  const auto& range = x3::_attr(context);
  return std::string_view(&*range.begin(), static_cast<std::size_t>(range.size()));
}

// Actions that take the matched text, and actions that do not.
template <void (Expression_builder::*Member)(std::string_view)>
struct With_text
{
  template <class Context>
  void operator()(const Context& context) const { (builder(context).*Member)(matched(context)); }
};
template <void (Expression_builder::*Member)()>
struct Plainly
{
  template <class Context>
  void operator()(const Context& context) const { (builder(context).*Member)(); }
};

template <void (Expression_builder::*Member)(std::string_view)>
inline constexpr With_text<Member> with_text{};
template <void (Expression_builder::*Member)()>
inline constexpr Plainly<Member> plainly{};

using B = Expression_builder;

// The names of the rules are the words of the messages.
inline const x3::rule<struct Expression_tag> expression("a number, a name or '('");
inline const x3::rule<struct Term_tag> term("a number, a name or '('");
inline const x3::rule<struct Factor_tag> factor("a number, a name or '('");
inline const x3::rule<struct Primary_tag> primary("a number, a name or '('");
inline const x3::rule<struct Exponent_tag> exponent("an integer exponent");
inline const x3::rule<struct Closing_tag> closing(")");

inline const auto digits = +x3::ascii::digit;
inline const auto mantissa = (digits >> -('.' >> *x3::ascii::digit)) | ('.' >> digits);
inline const auto scale = x3::ascii::char_("eE") >> -x3::ascii::char_("+-") >> digits;
inline const auto numeral = x3::raw[x3::lexeme[mantissa >> -scale]];
inline const auto letter = x3::ascii::alpha | x3::ascii::char_('_');
inline const auto name = x3::raw[x3::lexeme[letter >> *(letter | x3::ascii::digit)]];
inline const auto sign = x3::raw[x3::ascii::char_("+-")];

inline const auto closing_def = x3::lit(')');

inline const auto call = x3::raw[x3::lit('(')][with_text<&B::begin_call>] > expression > closing;
inline const auto group = x3::raw[x3::lit('(')][with_text<&B::open>] > expression > closing;

inline const auto primary_def =
  numeral[with_text<&B::number>]
  | (name[with_text<&B::name>]
     >> ((call >> x3::eps[plainly<&B::end_call>]) | x3::eps[plainly<&B::variable>]))
  | (group >> x3::eps[plainly<&B::close>]);

inline const auto exponent_def = *sign[with_text<&B::exponent_sign>] >> primary;

inline const auto power =
  x3::eps[plainly<&B::begin_power>] >> primary
  >> *(x3::raw[x3::lit('^')][with_text<&B::caret>] > exponent) >> x3::eps[plainly<&B::end_power>];

inline const auto factor_def = x3::eps[plainly<&B::begin_factor>] >> *sign[with_text<&B::sign>]
                               >> power >> x3::eps[plainly<&B::end_factor>];

inline const auto term_def =
  factor >> *(x3::raw[x3::ascii::char_("*/")][with_text<&B::binary_operator>] > factor
              > x3::eps[plainly<&B::apply_operator>]);

inline const auto expression_def =
  term >> *(sign[with_text<&B::binary_operator>] > term > x3::eps[plainly<&B::apply_operator>]);

BOOST_SPIRIT_DEFINE(expression, term, factor, primary, exponent, closing)

} // namespace grammar
} // namespace internal
} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_DIFFERENTIATION_INTERNAL_EXPRESSION_GRAMMAR_H
