#pragma once

#include <Eigen/Core>
#include <vector>

namespace isopatch::segmentation {

/// Distances between a face of a solid and its patch at equal parameters, on a grid of the face's frame.
struct DeviationGrid {
  std::vector<double> s, t;  ///< increasing from 0 to 1
  Eigen::VectorXd values;    ///< s running fastest, model units

  /// Between the points of the grid, bilinear.
  double at(double s, double t) const;
};

}  // namespace isopatch::segmentation
