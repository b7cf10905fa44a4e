#pragma once

#include <Eigen/Core>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

/// A region of a profile for which no division was found that is not folded: unsupported.
class DivisionError : public Error {
 public:
  /// @param place  where the last one is folded, in the profile's coordinates
  DivisionError(int region, const Eigen::Vector2d& place);
  int region() const { return region_; }
  const Eigen::Vector2d& place() const { return place_; }

 private:
  int region_;
  Eigen::Vector2d place_;
};

}  // namespace isopatch::segmentation
