#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "segmentation/parameterization/internal/shape_energy.hpp"
#include "segmentation/parameterization/optimization_options.hpp"

namespace isopatch::segmentation {

/// A block whose control points depend on variables.
struct MovableBlock {
  std::array<geometry::KnotVector, 3> knots;
  Eigen::Matrix3Xd points;                             ///< where all variables are zero
  Eigen::SparseMatrix<double, Eigen::RowMajor> moves;  ///< (3 n, variables): of the points' coordinates
  Eigen::Vector3d lengths;                             ///< edges of the brick that it should resemble
  CountedPoints counted = CountedPoints::inside_faces_and_interior;
  std::array<std::vector<double>, 3> extra;  ///< further parameters at which to look for folds
  Eigen::VectorXd weights = {};              ///< of the control points; empty for a B-spline
};

struct OptimizedShapes {
  Eigen::VectorXd variables;
  double smallest_before = 0;  ///< smallest det J relative to the brick's, at the points looked at
  double smallest_after = 0;
  int evaluations = 0;
};

/// Untangles and smooths blocks, towards right angles and equal lengths: first an untangling phase, which may
/// start from folds and reduces the regularization until no sampled point is folded, then a quality phase
/// behind the barrier.
///
/// @return  variables with the largest smallest determinant of the phase reached
/// @source  Garanzha et al. 2021, section 3; minimized by L-BFGS of NLopt
OptimizedShapes optimize_shapes(const std::vector<MovableBlock>& blocks,
                                const OptimizationOptions& options = {});

}  // namespace isopatch::segmentation
