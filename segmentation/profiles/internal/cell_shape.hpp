#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation::planar {

constexpr double refused = std::numeric_limits<double>::infinity();

/// A side in the plane, run from its start.
struct SideShape {
  static constexpr int samples = 7;
  bool straight = true;
  std::array<Eigen::Vector2d, samples> points,
      derivatives;                                ///< at equal steps; of straight ones only the ends' points
  double start_direction = 0, end_direction = 0;  ///< radians, of the tangent
  double length = 0;                              ///< of the chord between its ends if straight

  Eigen::Vector2d point(int sample) const;
  Eigen::Vector2d derivative(int sample) const {
    return straight ? Eigen::Vector2d(points.back() - points.front()) : derivatives[sample];
  }
};
SideShape side_shape(const std::vector<Curve>& curves, const std::vector<Node>& nodes, const Side& side);

/// A part of a side, and the same side run the other way.
SideShape turned(const SideShape& shape);

/// What counts for the search, in radians.
struct ShapeRules {
  explicit ShapeRules(const QuadrangulationOptions& options);
  double smallest, largest, smallest_jacobian, angle_weight, length_weight;
  double smallest_in_triangle = 0.12, largest_in_triangle = 3.02;  ///< triangles are on their way to vanish
  double triangle = 8;                                             ///< what one costs, in quadrilaterals
  double invalid = 60;                                             ///< what a cell costs that must not stay
};

/// The angle between 0 and 2 pi from one direction counterclockwise to another, that inside a corner if the
/// first is that of the side that leaves and the second that of the side that arrives, looked at from the
/// corner.
double angle_between(double leaving, double arriving);

/// What the corners cost, without the quadrilateral itself, `refused` where one is out of range.
double corner_cost(const ShapeRules& rules, double angle);

/// What the lengths of opposite sides cost.
double length_cost(const ShapeRules& rules, double a, double b, double c, double d);

/// The least scaled determinant of the transfinite map of four sides, counterclockwise; negative if it is too
/// thin somewhere.
double least_jacobian(const std::array<const SideShape*, 4>& sides);

/// Cost of a cell: 1 and what its shape costs, or `refused`.
double cost_of(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides, int count);

/// Cost of a cell of a mesh: `rules.invalid` instead of `refused`.
double cost_of(const ShapeRules& rules, const std::vector<Curve>& curves, const CellMesh& mesh,
               const Cell& cell);

}  // namespace isopatch::segmentation::planar
