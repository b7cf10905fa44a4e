#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/coupling/support_frames.hpp"

namespace isopatch::iga {

/// The directions that supports leave to each block row; most rows have all three and cost nothing.
///
/// Unknowns x of a held row are components along its frame's axes, the fixed ones 0.
class FreeDirections {
 public:
  FreeDirections() = default;
  /// @param frame_of_row  one frame per block row
  explicit FreeDirections(const std::vector<const SupportFrame*>& frame_of_row);

  /// Displacements of the rows: axes * x, without what supports prescribe. (3 rows)
  Eigen::VectorXd to_space(Eigen::VectorXd x) const;
  /// Transpose: forces along the free axes, 0 along the fixed ones. (3 rows)
  Eigen::VectorXd to_free(Eigen::VectorXd force) const;
  /// One frame per row, prescribing nothing.
  std::vector<SupportFrame> frames(int rows) const;
  /// Whether the row can move along a coordinate axis at all.
  bool can_move(int row, int axis) const;

 private:
  struct Held {
    int row = 0;
    int free = 0;
    Eigen::Matrix3d axes;
  };
  const Held* find(int row) const;
  std::vector<Held> held_;  // by row
};

}  // namespace isopatch::iga
