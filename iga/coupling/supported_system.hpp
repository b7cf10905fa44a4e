#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/free_directions.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::iga {

/// What acts on the block rows of a system.
struct LoadOfRows {
  Eigen::VectorXd load;        ///< f, (3 block rows), N
  Eigen::VectorXd prescribed;  ///< what supports prescribe, (3 block rows), m
};

/// Brings supports into K u = f, in place, for one or several f: every block row is turned into the axes of
/// its frame, fixed components get the equation x = 0 with the mean diagonal entry as factor, and what they
/// prescribe moves to the load.
///
/// The unknowns become x with u = prescribed + axes * x; the block size stays 3 and the matrix symmetric.
/// @param rows          of the matrix, on this process
/// @param frame_of_row  one frame per block row; what it prescribes counts for nothing
/// @param loads         consistent; in the axes of the frames afterwards
void apply_supports(solvers::SymmetricBlockMatrix& stiffness, const solvers::SharedRows& rows,
                    const std::vector<const SupportFrame*>& frame_of_row, std::vector<LoadOfRows>& loads);

/// The same for a matrix alone, where nothing is prescribed.
void apply_supports(solvers::SymmetricBlockMatrix& stiffness, const FreeDirections& free,
                    const solvers::SharedRows& rows);

/// u = prescribed + axes * x for every block row. (3, block rows)
Eigen::Matrix3Xd displacement_of_rows(const Eigen::VectorXd& x,
                                      const std::vector<const SupportFrame*>& frame_of_row,
                                      const Eigen::VectorXd& prescribed);

/// One scalar multiplier: component `axis` (a column of the global node's frame) of two nodes is the same.
struct MultiplierRow {
  int global_node = 0;
  int first = 0;   ///< node
  int second = 0;  ///< node
  int axis = 0;
};

/// Rows that tie the m nodes of every global node by m - 1 pairs (its first node with each other one), in the
/// components that supports leave free: never redundant.
std::vector<MultiplierRow> multiplier_rows(const GlobalNodes& global,
                                           const std::vector<SupportFrame>& frames);

/// B with x(first) - x(second) = 0 in each row; x as in apply_supports, one block row per node.
/// @throws Error internal if the rank is not full: the rows, as edges between components of nodes, close a
/// circle
solvers::ConstraintMatrix multiplier_matrix(const std::vector<MultiplierRow>& rows, int nodes);

/// The multipliers of a known solution: (B B^T)^-1 B r, with the residual r = f - K u of every node in frame
/// axes. Closed form per global node: B B^T = I + 1 1^T.
Eigen::VectorXd recovered_multipliers(const std::vector<MultiplierRow>& rows, const GlobalNodes& global,
                                      const std::vector<SupportFrame>& frames,
                                      const Eigen::Matrix3Xd& residual);

}  // namespace isopatch::iga
