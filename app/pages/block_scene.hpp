#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/pages/display_unit.hpp"
#include "app/pages/fault_scene.hpp"

namespace isopatch::app {

/// A part of a solid by its boundary.
struct BlockPiece {
  std::string name;
  std::string body;         ///< that it is a part of
  std::string file = {};    ///< that holds it, or ""
  double volume = 0;        ///< m^3; 0 of faces
  std::string remark = {};  ///< what there is to say besides: "cylinder, 3 cm^2"
  bool is_faulty = false;
  std::vector<std::string> faces = {};               ///< of the body, that it has a part of
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd(3, 0);  ///< m; a point of two faces occurs twice
  Eigen::Matrix3Xi triangles = Eigen::Matrix3Xi(3, 0);
  std::vector<Eigen::Matrix3Xd> edges = {};  ///< polylines, m
};

/// A line on a piece, which moves with it.
struct BlockLine {
  int piece = 0;
  Eigen::Matrix3Xd points;  ///< m
};

/// What solids are at one step of their way from triangles to hexahedra.
struct BlockStage {
  std::string name;
  std::vector<BlockPiece> pieces = {};
  std::vector<BlockLine> lines = {};  ///< T-joints, or what could not be cut through
  double apart = 0.5;  ///< how far pieces are drawn from each other at first, as a share of their way
  bool shows_triangles = false;  ///< whether the sides of triangles are drawn
};

/// Solids that were cut, step by step: drawn apart from each other.
struct BlockScene {
  DisplayUnit length;
  std::string lines_name;  ///< what the lines are
  std::vector<BlockStage> stages;
  std::vector<FaultFace> faces;  ///< faulty ones, which stay where they are
  std::vector<FaultPlace> places;
};

/// The JSON text of a scene; coordinates as base64 of single precision.
/// @cost  16 bytes a point
std::string block_scene_json(const BlockScene& scene);

}  // namespace isopatch::app
