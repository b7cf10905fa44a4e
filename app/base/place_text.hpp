#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace isopatch::app {

/// "(x, y, z)": how messages and tables write a point or a vector.
std::string triple_text(std::string_view x, std::string_view y, std::string_view z);

/// The same of numbers.
/// @param digits  significant ones; 0: as many as tell the number from all others
std::string place_text(const Eigen::Vector3d& place, int digits = 0);

}  // namespace isopatch::app
