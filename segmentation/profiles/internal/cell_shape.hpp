#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
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
  double turning = 0;  ///< radians, of the tangent from start to end, all bends taken positive
  double slant = 0;    ///< of a chord: 0 along the drawing's axes and at 45 degrees to them, at most 1
  double length = 0;   ///< of the chord between its ends if straight

  Eigen::Vector2d point(int sample) const {
    if (!straight) return points[sample];
    const double at = static_cast<double>(sample) / (samples - 1);
    return (1 - at) * points.front() + at * points.back();
  }
  Eigen::Vector2d derivative(int sample) const {
    return straight ? Eigen::Vector2d(points.back() - points.front()) : derivatives[sample];
  }
};
SideShape side_shape(const std::vector<Curve>& curves, const std::vector<Node>& nodes, const Side& side);

/// How far a direction is from multiples of 45 degrees: 0 to 1.
double slant_of(const Eigen::Vector2d& along);

/// A part of a side, and the same side run the other way.
SideShape turned(const SideShape& shape);

/// Least of determinant over mean determinant: below it a quadrilateral is too thin somewhere.
constexpr double thinnest_at_all = 0.04;

/// What counts for the search, in radians.
struct ShapeRules {
  explicit ShapeRules(const QuadrangulationOptions& options);
  double smallest, largest, largest_turn, smallest_jacobian, angle_weight, turn_weight, length_weight,
      aspect_weight, slant_weight, good_jacobian;
  double thinnest = thinnest_at_all;
  double smallest_in_triangle = 0.12, largest_in_triangle = 3.02;  ///< triangles are on their way to vanish
  double triangle = 8;                                             ///< what one costs, in quadrilaterals
  double invalid = 60;    ///< what a cell costs that must not stay, at most: less where it is less folded
  double not_valid = 30;  ///< cells that cost more must not stay
};

/// The angle between 0 and 2 pi from one direction counterclockwise to another, that inside a corner if the
/// first is that of the side that leaves and the second that of the side that arrives, looked at from the
/// corner.
double angle_between(double leaving, double arriving);

/// What the corners cost, without the quadrilateral itself, `refused` where one is out of range.
double corner_cost(const ShapeRules& rules, double angle);

/// What the sides cost, counterclockwise; `Sides` have length, turning and slant.
template <class Sides>
double sides_cost(const ShapeRules& rules, const Sides& a, const Sides& b, const Sides& c, const Sides& d) {
  const auto squared = [](double p, double q) { return (p - q) * (p - q) / ((p + q) * (p + q)); };
  const auto beyond = [](double p, double q) { return std::max(0.0, (p + q) / std::numbers::pi - 1); };
  return rules.length_weight * (squared(a.length, c.length) + squared(b.length, d.length)) +
         rules.aspect_weight * squared(a.length + c.length, b.length + d.length) +
         rules.turn_weight * (beyond(a.turning, c.turning) + beyond(b.turning, d.turning)) +
         rules.slant_weight * (a.slant + b.slant + c.slant + d.slant);
}

/// The least scaled determinant of the transfinite map of four sides, counterclockwise; negative if it is too
/// thin somewhere.
double least_jacobian(const std::array<const SideShape*, 4>& sides);

/// Least over mean determinant of that map.
double thinness(const std::array<const SideShape*, 4>& sides);

/// How much longer two opposite sides are than they are apart where they are nearest: 1 of a square, 10 of a
/// needle of 1 by 10; 1e6 at most.
double slenderness(const std::array<const SideShape*, 4>& sides);

/// Whether Jacobian and thinness are at least so much, for corners that are within the rules; quicker.
bool map_stands(const std::array<const SideShape*, 4>& sides, double smallest, double thinnest);

/// Cost of a cell: 1 and what its shape costs, or `refused`.
double cost_of(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides, int count);

/// The same, from `rules.not_valid` to `rules.invalid` instead of `refused`.
double bounded_cost_of(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides, int count);

/// Cost of a cell of a mesh: from `rules.not_valid` to `rules.invalid` instead of `refused`.
double cost_of(const ShapeRules& rules, const std::vector<Curve>& curves, const CellMesh& mesh,
               const Cell& cell);

}  // namespace isopatch::segmentation::planar
