#pragma once

#include <Eigen/Core>
#include <vector>

#include "solvers/scaled_system.hpp"

namespace isopatch::solvers {

/// The residuals of several right sides of one system: column k is `systems[k]->residual(z.col(k))` to the
/// last digits, but the matrix is gone through once for eight of them.
///
/// Sums are kept as a number and its rounding error, twice the digits of a double. One right side alone, and
/// systems that are spread over processes, go through `ScaledSystem::residual`.
///
/// @param systems  of one matrix, one for each column
/// @cost   one pass over the stored blocks for eight columns, some 16 operations an entry and column; a
/// quarter for one or two
/// @source Ogita, Rump, Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26 (2005), algorithm 5.3
Eigen::MatrixXd residuals(const std::vector<const ScaledSystem*>& systems, const Eigen::MatrixXd& z);

}  // namespace isopatch::solvers
