#pragma once

#include <string>

#include "geometry/brep/brep.hpp"

namespace isopatch::segmentation {

/// "z" where it is an axis, "(0.6, 0, 0.8)" elsewhere.
std::string direction_text(const Eigen::Vector3d& direction);

/// What a solid looks like before it is divided: "swept along z", "swept along z but for 2 rounds", "turned
/// about x", likewise with branches or bores across, which may come in pieces as well; "" for others, of
/// which some do too. Whether it can be divided so, dividing tells.
/// @cost  some milliseconds a face, however long dividing takes
std::string looks(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
