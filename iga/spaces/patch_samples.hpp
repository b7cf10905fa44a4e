#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace isopatch::iga {

/// One patch and its fields at the points of a grid of parameters, the first direction running fastest.
struct PatchSamples {
  std::array<std::vector<double>, 3> parameters;  ///< increasing, both ends of the patch included
  /// Which of the parameters are ends of elements, increasing; in a grid coarser than the elements not all
  /// ends are there.
  std::array<std::vector<int>, 3> element_ends;
  Eigen::Matrix3Xd points;         ///< undeformed, m
  Eigen::Matrix3Xd displacements;  ///< m; no columns without a solution
  Eigen::VectorXd von_mises;       ///< Pa; empty without a solution
  /// xx, yy, zz, xy, yz, zx, Pa; no columns without a solution
  Eigen::Matrix<double, 6, Eigen::Dynamic> stress;
  Eigen::Matrix3Xd principal;  ///< principal stresses, the largest first, Pa; no columns without a solution
  Eigen::VectorXd scaled_jacobian;  ///< det J over the product of its columns' lengths, -1 .. 1

  std::array<int, 3> sizes() const {
    return {static_cast<int>(parameters[0].size()), static_cast<int>(parameters[1].size()),
            static_cast<int>(parameters[2].size())};
  }
};

/// How finely a part is sampled for pictures.
struct SamplingOptions {
  double chord = 5e-4;       ///< largest distance between curve and chord, of the model's size; above 0
  double field = 5e-3;       ///< the same of displacement and von Mises stress, of their ranges; above 0
  int most_per_element = 8;  ///< pieces per element and direction, 1 .. 64
  std::int64_t most_points = 250'000;  ///< where more would be needed the grid is made coarser; at least 8
                                       ///< for each patch are taken
};
/// @throws Error invalid_argument naming field, value and range
void validate(const SamplingOptions& options);

}  // namespace isopatch::iga
