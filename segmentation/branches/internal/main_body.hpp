#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "segmentation/branches/internal/outline.hpp"

namespace isopatch::segmentation {

/// What stands on a turned body or is cut into it: faces that are not turned about its axis and hang
/// together.
struct Branch {
  std::vector<FaceId> faces;       ///< all of it
  std::vector<FaceId> neighbours;  ///< of the body, which it meets
  bool along_axis = false;         ///< a bore along the body's axis, beside it
  PlanView
      view;  ///< from the axis; x runs along it, or to a bore beside it; `along` is the branch's direction
  std::vector<Outline> outlines;  ///< of its walls that reach below `surface`
  std::vector<double> floors;     ///< heights of planes across it below `surface`, descending, m
  double surface = 0;  ///< height at which it begins: the radius of the outermost cylinder, or a plane, m
  double low = 0, high = 0;  ///< of the outlines along x, m
};

/// A solid seen as a turned body with branches.
struct MainBody {
  Eigen::Vector3d origin, axis;  ///< m; unit
  std::vector<FaceId> faces;     ///< turned about it
  std::vector<Branch> branches;
};

/// Ways to see a solid so, those with the most area that is turned first.
/// @throws Error unsupported  there are some, but each has a branch of another kind: says which face
std::vector<MainBody> main_bodies(const geometry::Brep& solid);

}  // namespace isopatch::segmentation
