#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/base/union_find.hpp"
#include "geometry/multi_patch.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::iga {

/// The points of grids on the faces of patches, the same to the last bit on both sides of an interface, on
/// all patches around an edge and at a corner, and along an edge that is one point. So surfaces and cells
/// made of them have no cracks, though patches agree only up to a tolerance.
///
/// The patch with the smallest number says where a face, an edge and a corner lie.
class SurfacePoints {
 public:
  /// @param model       how the patches meet
  /// @param patches     its patches in any space that contains the model's; must outlive this
  /// @param parameters  of the grid of every patch, both ends included, as many on both sides of an
  ///                    interface; must outlive this
  SurfacePoints(const geometry::MultiPatch& model, const std::vector<geometry::NurbsVolume>& patches,
                const std::vector<geometry::GridParameters<3>>& parameters);

  /// (3, points of the side's grid), the first of its tangent directions fastest; model units.
  /// @cost  O(degree) per point
  Eigen::Matrix3Xd face(int patch, geometry::Side side) const;

 private:
  // A face as another one's, whose parameters it has in its own order.
  struct FaceOwner {
    geometry::PatchFace face;
    geometry::FaceOrientation orientation;  // from this face to the owner
  };
  void join(const geometry::PatchFace& first, const geometry::PatchFace& second,
            const geometry::FaceOrientation& orientation);
  void join_collapsed(const geometry::MultiPatch& model);
  Eigen::Vector3d corner(int corner) const;
  Eigen::Matrix3Xd edge(int edge) const;
  Eigen::Matrix3Xd inside(const geometry::PatchFace& face) const;

  const std::vector<geometry::NurbsVolume>& patches_;
  const std::vector<geometry::GridParameters<3>>& parameters_;
  std::vector<FaceOwner> faces_;       // 6 a patch
  std::vector<char> collapsed_faces_;  // bit 1: along its first tangent direction, bit 2: along its second
  std::vector<char> collapsed_edges_;  // 12 a patch; true of owners if it is of any that they own
  SignedUnionFind edges_;              // 12 a patch
  UnionFind corners_;                  // 8 a patch
};

}  // namespace isopatch::iga
