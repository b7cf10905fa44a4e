#include "segmentation/sweeps/rounds.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/brep/edge_angles.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// The smallest radius of curvature in the middle of a face; infinite on planes.
double radius_of(const Brep& solid, FaceId face) {
  const geometry::DomainBox domain = solid.domain(face);
  const Eigen::Vector2d middle = (domain.low + domain.high) / 2;
  const Eigen::Matrix<double, 3, 2> first = solid.derivatives(face, middle);
  const Eigen::Matrix3d second = solid.second_derivatives(face, middle);
  const Eigen::Vector3d normal = first.col(0).cross(first.col(1)).normalized();
  const Eigen::Matrix2d metric = first.transpose() * first;
  Eigen::Matrix2d bend;
  bend << normal.dot(second.col(0)), normal.dot(second.col(1)), normal.dot(second.col(1)),
      normal.dot(second.col(2));
  const Eigen::Matrix2d shape = metric.inverse() * bend;
  const double mean = shape.trace() / 2, gauss = shape.determinant();
  const double largest = std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
  return largest > 0 ? 1 / largest : std::numeric_limits<double>::infinity();
}

bool is_round(const Brep& solid, FaceId face, const std::vector<geometry::EdgeAngles>& angles,
              double largest_radius) {
  int smooth = 0;
  for (const auto& loop : solid.face(face).loops)
    for (const geometry::EdgeUse& use : loop)
      smooth += angles[static_cast<std::size_t>(use.edge.value)].convexity == geometry::Convexity::flat;
  return smooth >= 2 && radius_of(solid, face) <= largest_radius;
}

}  // namespace

Rounds rounds_in_the_way(const Brep& solid, double largest_radius) {
  const std::vector<geometry::EdgeAngles> angles = geometry::edge_angles(solid);
  std::optional<std::vector<FaceId>> fewest;
  for (const Eigen::Vector3d& along : floor_directions(solid)) {
    const std::vector<FaceId> others = neither_floor_nor_wall(solid, along);
    const bool all_round = std::all_of(others.begin(), others.end(), [&](FaceId face) {
      return is_round(solid, face, angles, largest_radius);
    });
    if (all_round && (!fewest || others.size() < fewest->size())) fewest = others;
  }
  Rounds result;
  if (fewest) result.faces = *fewest;
  for (const FaceId face : result.faces)
    result.largest_radius = std::max(result.largest_radius, radius_of(solid, face));
  return result;
}

}  // namespace isopatch::segmentation
