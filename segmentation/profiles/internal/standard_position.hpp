#pragma once

#include <Eigen/Core>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/profile.hpp"

namespace isopatch::segmentation::planar {

/// A profile moved to the origin, turned so that its longest line lies along the x axis, and scaled to a box
/// of about 1.
struct StandardPosition {
  Profile profile;
  Eigen::Vector2d centre;
  Eigen::Matrix2d axes;  ///< of the standard position in the original one, scaled
};
StandardPosition standard_position(const Profile& profile);

}  // namespace isopatch::segmentation::planar
