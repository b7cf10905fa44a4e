#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::segmentation {

/// Which points of a patch count: those whose Jacobian free control points can change.
enum class CountedPoints { inside_faces_and_interior, all_but_corners };

/// How far a spline volume is from a brick of given edges, finite for folded volumes too.
///
/// The integrand is |M|^2 / (3 chi^(2/3)) + (det M^2 + 1) / (8 chi) with M the Jacobian relative to the brick
/// and chi = (det M + sqrt(epsilon^2 + det M^2)) / 2: for epsilon -> 0 a barrier against folds, the first
/// term the inverse mean ratio.
/// @source Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov, Foldover-free maps in 50 lines of code,
/// ACM TOG 2021,
///         equations 2 to 5
class ShapeEnergy {
 public:
  /// @param lengths  edges of the brick, model units; its size also makes the determinant dimensionless
  /// @param extra    further parameters at which to look, along each direction
  /// @param weights  of the control points, which stay; empty for a B-spline
  ShapeEnergy(const std::array<geometry::KnotVector, 3>& knots, const Eigen::Vector3d& lengths,
              CountedPoints counted, const std::array<std::vector<double>, 3>& extra = {},
              const Eigen::VectorXd& weights = {});

  struct Value {
    double energy = 0;          ///< mean over the patch
    double smallest = 0;        ///< smallest det M at a counted point
    Eigen::Matrix3Xd gradient;  ///< of energy by control points, 1 / model units
  };
  /// @param points  control points, (3, n), model units
  /// @cost O(points of quadrature, 27 an element, times degree)
  Value operator()(const Eigen::Matrix3Xd& points, double epsilon) const;

 private:
  using Columns = std::array<Eigen::Matrix3Xd, 4>;  ///< values, then slopes along each direction
  Columns at_nodes(const Eigen::Matrix3Xd& coefficients) const;
  /// The transposed of `at_nodes`.
  Eigen::Matrix3Xd from_nodes(const Columns& columns) const;

  struct Direction {
    std::vector<double> nodes;
    std::vector<double> weights;
    Eigen::SparseMatrix<double, Eigen::RowMajor> values, slopes;
  };
  std::array<Direction, 3> directions_;
  Eigen::Vector3d lengths_;
  Eigen::VectorXd weights_;           ///< of the quadrature, zero where a point does not count
  Eigen::VectorXd control_weights_;   ///< empty for a B-spline
  Eigen::Matrix4Xd weight_function_;  ///< its values and slopes at the nodes
};

}  // namespace isopatch::segmentation
