#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::iga {

/// The splines of a line that carry multipliers: those of the given knots that have one degree less on the
/// element at each reduced end, and two less where both ends are reduced and have one element between them.
/// There is one function fewer for each such end, so that the control point there, whose displacement others
/// share or a support holds, is left to these.
///
/// They add up to 1. Where nothing would be left there is one multiplier, the constant.
///
/// @param reduced  the low and the high end
/// @return  (functions of the line, multipliers): the coefficients of each
/// @source  Brivadis, Buffa, Wohlmuth, Wunderlich, Isogeometric mortar methods, 2015, section 4.3
Eigen::SparseMatrix<double> multiplier_coefficients(const geometry::KnotVector& knots,
                                                    const std::array<bool, 2>& reduced);

}  // namespace isopatch::iga
