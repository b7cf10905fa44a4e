#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace isopatch::segmentation {

/// Control points with their weights; points are not multiplied by them.
struct RationalNet {
  Eigen::Matrix3Xd points;
  Eigen::VectorXd weights;
  bool operator==(const RationalNet&) const = default;

  static RationalNet of_size(Eigen::Index count) {
    return {Eigen::Matrix3Xd::Zero(3, count), Eigen::VectorXd::Ones(count)};
  }
  /// All weights 1.
  static RationalNet polynomial(Eigen::Matrix3Xd points) {
    const Eigen::Index count = points.cols();
    return {std::move(points), Eigen::VectorXd::Ones(count)};
  }
  bool is_rational() const {
    return std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 1; });
  }
  /// Points times weights, then the weights.
  Eigen::Matrix4Xd homogeneous() const {
    Eigen::Matrix4Xd result(4, points.cols());
    result << points * weights.asDiagonal(), weights.transpose();
    return result;
  }
};

/// Below it a weight is too small to work with: a corner's is 1, the middle one of an arc of 120 degrees 0.5.
inline constexpr double least_weight = 0.05;

inline bool has_fair_weights(const RationalNet& net) {
  return std::all_of(net.weights.begin(), net.weights.end(),
                     [](double weight) { return weight >= least_weight; });
}

}  // namespace isopatch::segmentation
