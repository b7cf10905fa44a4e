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
  PlanView view;                   ///< from the axis, where x runs; `along` is the branch's direction
  std::vector<Outline> outlines;   ///< of its walls that reach below `surface`
  std::vector<double> floors;      ///< heights of planes across it below `surface`, descending, m
  double surface = 0;              ///< radius of the outermost cylinder that it meets, m
  double low = 0, high = 0;        ///< of the outlines along the axis, m
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
