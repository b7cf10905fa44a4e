#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {

/// Coefficients of a coarse space to those of a finer one that contains it: (fine size, coarse size).
using TransferMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// `knots` with further knots; values already present raise their multiplicity.
/// @throws Error invalid_argument if a new knot lies outside the open range or exceeds multiplicity `degree`
KnotVector with_knots(const KnotVector& knots, const std::vector<double>& inserted);

/// The degree raised by `times`, every inner knot's multiplicity with it: the continuity stays.
KnotVector with_degree_raised(const KnotVector& knots, int times);

/// Exact transfer to any finer space: knots inserted, degree raised, or both.
///
/// A fine coefficient is the blossom of the coarse spline at consecutive fine knots, which for equal degrees
/// is the Oslo algorithm and for each raise of the degree an average over the knot left out.
///
/// @throws Error invalid_argument if `fine` does not contain the space of `coarse`
/// @cost   O(fine size * degree^2) for insertion, times degree + 1 per raise
/// @source Ramshaw, Blossoms are polar forms, 1989; Lyche, Morken, Spline Methods, chapter 4
TransferMatrix transfer(const KnotVector& coarse, const KnotVector& fine);

/// Every inner knot with multiplicity `degree`: each element is a Bezier piece, neighbours share a
/// coefficient.
KnotVector bezier_knots(const KnotVector& knots);

}  // namespace isopatch::geometry
