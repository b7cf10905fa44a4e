#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace isopatch::app {

using Json = nlohmann::ordered_json;

inline Json to_json(const Eigen::Vector3d& v) {
  return Json::array({v[0], v[1], v[2]});
}

}  // namespace isopatch::app
