#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/pages/internal/base64.hpp"
#include "app/pages/internal/point_json.hpp"

namespace isopatch::app {

/// Points as base64 of single precision.
inline std::string points_text(const Eigen::Matrix3Xd& points) {
  std::vector<float> numbers;
  for (Eigen::Index i = 0; i < points.size(); ++i) numbers.push_back(static_cast<float>(points.data()[i]));
  return to_base64(numbers);
}

inline Json triangles_json(const Eigen::Matrix3Xi& triangles) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < triangles.size(); ++i) result.push_back(triangles.data()[i]);
  return result;
}

}  // namespace isopatch::app
