#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace isopatch::segmentation::test {

/// A trimmed surface: its outline's curves over [0, 1] in its domain.
struct PlainFace {
  std::vector<std::function<Eigen::Vector2d(double)>> curves;
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> surface;
};

/// The faces of a solid of trimmed surfaces as G+Smo writes it, read plainly and without a CAD kernel: the
/// tests' second opinion.
std::vector<PlainFace> gismo_faces(const std::string& path);

}  // namespace isopatch::segmentation::test
