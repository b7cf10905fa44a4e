#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/decomposition/combinatorics/cutting_loop.hpp"

namespace isopatch::segmentation {

/// Places of a loop in space, (3, places): vertices, and the midpoints of edges.
Eigen::Matrix3Xd place_points(const CellGraph& graph, const Eigen::Matrix3Xd& points,
                              const CuttingLoop& loop);

/// The normal of a closed polygon, counter-clockwise around it, as long as its area.
/// @source Newell's formula
Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& polygon);

/// Root mean square distance of a polygon's corners to their best plane, over the root of its area; 0 in a
/// plane.
double unevenness(const Eigen::Matrix3Xd& polygon);

/// The sum over the ends of auxiliary edges of |alpha1 - alpha2| / alpha, alpha being the corner that the end
/// divides; where the edge leaves its face there, (alpha + 2 over) / alpha, `over` being by how much.
double indirection(const CellGraph& graph, const CellIncidence& incidence, const Eigen::Matrix3Xd& points,
                   const CuttingLoop& loop);

/// The dihedral angles that a plane cut would leave at a step, in the pieces to the left and right, [0, 2
/// pi).
struct DividedAngle {
  double left = 0, right = 0;
  bool inside = true;  ///< they add up to the angle that was there
};
std::vector<DividedAngle> divided_angles(const CellGraph& graph, const CellIncidence& incidence,
                                         const Eigen::Matrix3Xd& points, const CuttingLoop& loop);

}  // namespace isopatch::segmentation
