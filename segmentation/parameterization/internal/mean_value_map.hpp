#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "segmentation/parameterization/internal/domain_mesh.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"

namespace isopatch::segmentation {

/// A bijective, piecewise linear map from a face's triangulated domain to the unit square.
class MeanValueMap {
 public:
  /// Lengths and angles are those of the surface; the outline goes where the blend has it.
  /// @param mesh  of the face
  /// @source Floater, Mean value coordinates, CAGD 2003, section 3; Floater, Parametrization and smooth
  ///         approximation of surface triangulations, CAGD 1997, for the bijectivity
  MeanValueMap(const FaceMap& blend, const DomainMesh& mesh);

  /// The domain point that goes to a point of the unit square.
  /// @cost some ten triangles
  Eigen::Vector2d domain_point(const Eigen::Vector2d& square) const;

  /// Smallest signed area of a triangle in the square relative to the mean; positive if the map is bijective.
  double smallest_area() const { return smallest_area_; }

 private:
  std::vector<Eigen::Vector2d> domain_;
  std::vector<Eigen::Vector2d> square_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::vector<int>> cells_;  ///< triangles at each cell of a grid of the square
  double smallest_area_ = 0;

  void sort_into_cells();
};

}  // namespace isopatch::segmentation
