// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_BERNSTEIN_DECIDE_NONNEGATIVE_H
#define CGAL_SHAPE_INTERROGATION_BERNSTEIN_DECIDE_NONNEGATIVE_H

// Whether a polynomial is nowhere negative on the unit cube: proof by its coefficients, refutation
// by a point, both found by halving the cube.

#include <CGAL/Shape_interrogation/Bernstein/Certified_extreme.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/Subdivision_box.h>
#include <CGAL/Shape_interrogation/Bernstein/internal/boundary_factors.h>

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_interrogation {

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief names what was found out about a statement on a whole domain.
 */
enum class Verdict
{
  NO,       //!< it is false, and there is a witness
  YES,      //!< it is proved
  UNDECIDED //!< neither was found within the limit
};

//! \ingroup PkgShapeInterrogationBernstein
//! \brief returns the name of `verdict` as it stands in reports: `"yes"`, `"no"`, `"undecided"`.
inline const char* to_string(Verdict verdict)
{
  return verdict == Verdict::YES ? "yes" : verdict == Verdict::NO ? "no" : "undecided";
}

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief holds a verdict about polynomials on the unit cube, and the witness against them.
 */
template <class NT, int d>
struct Sign_verdict
{
  Verdict verdict = Verdict::UNDECIDED;     //!< what was found out
  std::optional<std::array<NT, d>> witness; //!< a point where the statement is false, for `NO`
};

namespace internal {

// Whether the coefficients of one of the arrays prove it for the box.
template <class Ring, int d>
bool is_proved(const std::vector<Coefficient_array<Ring, d>>& arrays)
{
  for (const auto& a : arrays)
  {
    bool is_nonnegative = true;
    for (std::size_t i = 0; is_nonnegative && i < a.numbers.size(); ++i)
      is_nonnegative = sign_of(a.numbers[i]) >= 0;
    if (is_nonnegative)
      return true;
  }
  return false;
}

// A corner of the box where all are negative.
template <class NT, int d>
std::optional<std::array<NT, d>> negative_corner(const Subdivision_box<NT, d>& box)
{
  std::array<int, 1 << d> negative{};
  std::array<std::array<NT, d>, 1 << d> corners;
  for (const auto& a : box.arrays)
  {
    int corner = 0;
    box.for_each_corner(a.degree, [&](const std::array<NT, d>& x, std::size_t place) {
      corners[corner] = x;
      negative[corner++] += sign_of(a.numbers[place]) < 0;
    });
  }
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    if (negative[corner] == static_cast<int>(box.arrays.size()))
      return corners[corner];
  return std::nullopt;
}

// Moves from the corner of a box to its centre until the test holds, which it does near the corner.
template <class NT, std::size_t d, class Test>
std::optional<std::array<NT, d>> move_inside(std::array<NT, d> corner, std::array<NT, d> centre,
                                             Test test)
{
  constexpr int most_halvings = 4096;
  for (int k = 0; k < most_halvings; ++k)
  {
    if (test(centre))
      return centre;
    for (std::size_t i = 0; i < d; ++i)
      centre[i] = (centre[i] + corner[i]) / NT(2);
  }
  return std::nullopt;
}

} // namespace internal

/*!
 * \ingroup PkgShapeInterrogationBernstein
 * \brief decides whether at every point of the unit cube at least one of the polynomials is not
 * negative; for a single one, whether it is nowhere negative.
 *
 * `YES` is a proof: where all Bernstein coefficients are at least 0, the polynomial is. `NO` comes
 * with a point where all are negative. A zero at a corner of the cube or along an edge does no
 * harm; one inside, touched from above, ends in `UNDECIDED` unless it is at a point that halving
 * reaches, and so does a margin that is too small for the limit. The answer is exact.
 *
 * \tparam NT an exact field number type
 * \param polynomials at least one
 * \param most_boxes how many boxes are looked at, as `Bound_limits::boxes`
 *
 * Complexity: \f$ O(n^{d+1}) \f$ additions of numbers for a box and the degree n.
 */
template <class NT, int d>
Sign_verdict<NT, d> decide_nonnegative(std::vector<Bernstein_polynomial<NT, d>> polynomials,
                                       std::size_t most_boxes = 2000)
{
  static_assert(Number_type_traits<NT>::is_exact, "a proof needs exact numbers");
  using Box = internal::Subdivision_box<NT, d>;
  using Point = std::array<NT, d>;
  const auto given = polynomials;
  const auto are_negative = [&](const Point& x) {
    for (const auto& p : given)
      if (internal::sign_of(NT(p(x))) >= 0)
        return false;
    return true;
  };
  bool is_divided = false;
  for (auto& p : polynomials)
  {
    std::vector<Bernstein_polynomial<NT, d>> one{std::move(p)};
    is_divided = internal::divide_by_boundary_factors(one) || is_divided;
    p = std::move(one.front());
  }
  most_boxes = internal::affordable_boxes(
    most_boxes, polynomials.front().scaled_coefficients().size());
  std::deque<Box> boxes{Box(internal::subdivision_arrays(polynomials))};
  for (std::size_t looked_at = 0; !boxes.empty(); ++looked_at)
  {
    const Box box = std::move(boxes.front());
    boxes.pop_front();
    if (internal::is_proved(box.arrays))
      continue;
    if (auto corner = internal::negative_corner(box))
    {
      if (is_divided && !are_negative(*corner))
        corner = internal::move_inside(*corner, box.centre(), are_negative);
      if (corner)
        return {Verdict::NO, corner};
    }
    if (looked_at >= most_boxes)
      return {};
    for (Box& half : box.split())
      boxes.push_back(std::move(half));
  }
  return {Verdict::YES, std::nullopt};
}

} // namespace Shape_interrogation
} // namespace CGAL

#endif // CGAL_SHAPE_INTERROGATION_BERNSTEIN_DECIDE_NONNEGATIVE_H
