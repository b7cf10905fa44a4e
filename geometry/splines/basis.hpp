#pragma once

#include <Eigen/Core>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {

/// The basis functions that live at one parameter.
struct BasisValues {
  int first = 0;           ///< index of the first nonzero function; degree + 1 of them follow
  Eigen::MatrixXd values;  ///< (order + 1, degree + 1): row k holds the k-th derivatives
};

/// B-spline basis functions and their derivatives up to `order` at t, clamped into the knot range.
/// @cost    O(degree^2 order)
/// @source  Piegl, Tiller, The NURBS Book, algorithm A2.3
BasisValues basis(const KnotVector& knots, double t, int order = 0);

/// The polynomials that the basis functions of one nonempty span are there, and their derivatives, at any t.
/// @return  (order + 1, degree + 1), for functions span - degree .. span
Eigen::MatrixXd basis_on_span(const KnotVector& knots, int span, double t, int order = 0);

/// Weights of the blossom (polar form): for a spline with coefficients c, the polynomial piece on span `span`
/// has the polar value sum_j row[j] c[span - degree + j] at the `degree` arguments given.
/// @cost    O(degree^2)
/// @source  Lyche, Morken, Spline Methods, chapter 2: product of the matrices R_1(t_1) ... R_p(t_p)
Eigen::RowVectorXd blossom_row(const KnotVector& knots, int span, const Eigen::VectorXd& arguments);

}  // namespace isopatch::geometry
