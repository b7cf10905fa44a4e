#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/read_blocks.hpp"

namespace isopatch::app {

/// A face as far as it can be drawn.
struct OutlinedFace {
  std::string name;            ///< the file's
  Eigen::Matrix3Xd points;     ///< m
  Eigen::Matrix3Xi triangles;  ///< none where the face cannot be triangulated
};

/// A solid as far as it can be drawn.
struct OutlinedSolid {
  std::string name;  ///< as of its block
  std::string file;
  std::vector<OutlinedFace> faces;      ///< in the order of the file
  std::vector<Eigen::Matrix3Xd> lines;  ///< edges, m
  std::size_t edge_count = 0, vertex_count = 0;
  geometry::SolidFault boundary;  ///< what keeps the faces from bounding a solid
  std::string state;              ///< that in words, or why the solid could not be read
};

/// What can be drawn of the solids of some files, whatever is wrong with them. Never fails: of a file that
/// cannot be read a solid without faces says why.
std::vector<OutlinedSolid> outlined_solids(const segmentation::BlockFiles& files);

}  // namespace isopatch::app
