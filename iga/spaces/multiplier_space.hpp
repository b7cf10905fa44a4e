#pragma once

#include <Eigen/SparseCore>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::iga {

/// The splines of a line that carry multipliers: those of the given knots that have one degree less on the
/// first and on the last element, and two less where these are one. There are two fewer than functions of the
/// line, as many as it has inner control points: so multipliers on a face leave the displacements of its
/// edges, which other faces and supports share, to these.
///
/// They add up to 1. Where the line has but two functions there is one multiplier, the constant.
///
/// @return  (functions of the line, multipliers): the coefficients of each
/// @source  Brivadis, Buffa, Wohlmuth, Wunderlich, Isogeometric mortar methods, 2015, section 4.3
Eigen::SparseMatrix<double> multiplier_coefficients(const geometry::KnotVector& knots);

}  // namespace isopatch::iga
