#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace isopatch::app {

/// Something that a user should know though it stops nothing.
struct Warning {
  std::string text;
  std::optional<int> patch = std::nullopt;              ///< that it is about, from 0
  std::optional<Eigen::Vector3d> place = std::nullopt;  ///< of the undeformed part, m
};

}  // namespace isopatch::app
