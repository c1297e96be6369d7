// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

#ifndef CGAL_SHAPE_INTERROGATION_H
#define CGAL_SHAPE_INTERROGATION_H

// Everything but meshing, files and the text parser, which cost seconds to compile: for quick
// starts. Programs that compile often include what they use.

#include <CGAL/Shape_interrogation/Number_types/Answer_union.h>
#include <CGAL/Shape_interrogation/Number_types/Elementary_functions.h>
#include <CGAL/Shape_interrogation/Number_types/Errors.h>
#include <CGAL/Shape_interrogation/Number_types/Filter_answer.h>
#include <CGAL/Shape_interrogation/Number_types/Filtered.h>
#include <CGAL/Shape_interrogation/Number_types/Number_type_traits.h>
#include <CGAL/Shape_interrogation/Number_types/Prepared.h>
#include <CGAL/Shape_interrogation/Number_types/Quadratic_field.h>
#include <CGAL/Shape_interrogation/Number_types/Wide_interval.h>
#include <CGAL/Shape_interrogation/Number_types/Wide_precision.h>
#include <CGAL/Shape_interrogation/Number_types/cast_argument.h>
#include <CGAL/Shape_interrogation/Number_types/number_cast.h>
#include <CGAL/Shape_interrogation/Number_types/reduced_square_root.h>
#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>
#include <CGAL/Shape_interrogation/Bernstein/Certified_extreme.h>
#include <CGAL/Shape_interrogation/Bernstein/bounds.h>
#include <CGAL/Shape_interrogation/Bernstein/decide_nonnegative.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_function.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_functions.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_limits.h>
#include <CGAL/Shape_interrogation/Differentiation/Expression_tape.h>
#include <CGAL/Shape_interrogation/Differentiation/Jet.h>
#include <CGAL/Shape_interrogation/Differentiation/Parse_error.h>
#include <CGAL/Shape_interrogation/Differentiation/Sparse_pattern.h>
#include <CGAL/Shape_interrogation/Differentiation/parse_decimal.h>
#include <CGAL/Shape_interrogation/Differentiation/print_expression.h>
#include <CGAL/Shape_interrogation/Differentiation/record_expression.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_2.h>
#include <CGAL/Shape_interrogation/Waist/Local_shape_3.h>
#include <CGAL/Shape_interrogation/Waist/Refusal.h>
#include <CGAL/Shape_interrogation/Waist/Symmetric_matrix_3.h>
#include <CGAL/Shape_interrogation/Waist/Unoriented_shape_3.h>
#include <CGAL/Shape_interrogation/Curves/Bezier_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Curve_derivatives_2.h>
#include <CGAL/Shape_interrogation/Curves/Implicit_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Knot_vector.h>
#include <CGAL/Shape_interrogation/Curves/Nurbs_curve_2.h>
#include <CGAL/Shape_interrogation/Curves/Parametric_curve_2.h>
#include <CGAL/Shape_interrogation/Splines/Spline_function.h>
#include <CGAL/Shape_interrogation/Splines/Spline_piece.h>
#include <CGAL/Shape_interrogation/Splines/spline_algebra.h>
#include <CGAL/Shape_interrogation/Surfaces/Bezier_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Implicit_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_batch.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_bound.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_condition.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_corrector.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_cross_checks.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_enclosure.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_evaluator.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_refinement.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_shape_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/N_space_system.h>
#include <CGAL/Shape_interrogation/Surfaces/Nurbs_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Parametric_surface_3.h>
#include <CGAL/Shape_interrogation/Surfaces/Patch_edge.h>
#include <CGAL/Shape_interrogation/Surfaces/Surface_derivatives_3.h>
#include <CGAL/Shape_interrogation/Surfaces/access.h>
#include <CGAL/Shape_interrogation/Surfaces/decide_at.h>
#include <CGAL/Shape_interrogation/Surfaces/height_jet.h>
#include <CGAL/Shape_interrogation/Surfaces/intersection_system.h>
#include <CGAL/Shape_interrogation/Constraints/Constraint.h>
#include <CGAL/Shape_interrogation/Constraints/Constraint_point_3.h>
#include <CGAL/Shape_interrogation/Constraints/Constraint_system.h>
#include <CGAL/Shape_interrogation/Constraints/Curve_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/Entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/Implicit_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/Parametric_entity_3.h>
#include <CGAL/Shape_interrogation/Constraints/directions.h>
#include <CGAL/Shape_interrogation/Constraints/distance.h>
#include <CGAL/Shape_interrogation/Constraints/equal_distance.h>
#include <CGAL/Shape_interrogation/Constraints/incidence.h>
#include <CGAL/Shape_interrogation/Constraints/offset_system.h>
#include <CGAL/Shape_interrogation/Constraints/parametric_graph.h>
#include <CGAL/Shape_interrogation/Constraints/projection.h>
#include <CGAL/Shape_interrogation/Constraints/prove_by_identities.h>
#include <CGAL/Shape_interrogation/Constraints/rolling_ball.h>
#include <CGAL/Shape_interrogation/Constraints/ruled_by_projection.h>
#include <CGAL/Shape_interrogation/Constraints/trimming_surface.h>
#include <CGAL/Shape_interrogation/Constraints/variable_radius_blend.h>
#include <CGAL/Shape_interrogation/Constraints/verify_identities.h>
#include <CGAL/Shape_interrogation/Analysis/Dupin_indicatrix.h>
#include <CGAL/Shape_interrogation/Analysis/Fundamental_forms.h>
#include <CGAL/Shape_interrogation/Analysis/asymptotic_directions.h>
#include <CGAL/Shape_interrogation/Analysis/compare_principal_curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/hessian_by_cases.h>
#include <CGAL/Shape_interrogation/Analysis/normal_curvature.h>
#include <CGAL/Shape_interrogation/Analysis/principal_directions.h>
#include <CGAL/Shape_interrogation/Analysis/shape_from_normal_curvatures.h>
#include <CGAL/Shape_interrogation/Analysis/three_tangents.h>
#include <CGAL/Shape_interrogation/Analysis/umbilics.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Bound_verdict.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface.h>
#include <CGAL/Shape_interrogation/Property_surfaces/Property_surface_maker.h>
#include <CGAL/Shape_interrogation/Property_surfaces/patch_of_expressions.h>
#include <CGAL/Shape_interrogation/Property_surfaces/property_bounds.h>
#include <CGAL/Shape_interrogation/Traits/Interrogation_3.h>
#include <CGAL/Shape_interrogation/Traits/Shape_traits_3.h>
#include <CGAL/Shape_interrogation/Traits/questions.h>

#endif // CGAL_SHAPE_INTERROGATION_H
