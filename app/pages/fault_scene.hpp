#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/pages/display_unit.hpp"

namespace isopatch::app {

/// A face of a solid as triangles.
struct FaultFace {
  std::string name;  ///< "part: face 3"
  std::string remark;
  bool is_faulty = false;
  Eigen::Matrix3Xd points;     ///< m
  Eigen::Matrix3Xi triangles;  ///< none where the face could not be triangulated
};

/// An edge of a solid as a polyline.
struct FaultLine {
  std::string name;
  bool is_faulty = false;
  Eigen::Matrix3Xd points;  ///< m
};

struct FaultPlace {
  std::string name;
  Eigen::Vector3d point;  ///< m
};

/// Solids that something is wrong with, in three dimensions: what is faulty stands out.
struct FaultScene {
  DisplayUnit length;
  std::vector<FaultFace> faces;
  std::vector<FaultLine> lines;
  std::vector<FaultPlace> places;
};

/// The JSON text of a scene; coordinates as base64 of single precision.
std::string fault_scene_json(const FaultScene& scene);

}  // namespace isopatch::app
