#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A box of n x m x k patches with its edges along the axes, inside as distorted as wanted. Lengths in model
/// units.
struct BoxOptions {
  Eigen::Vector3d size = {1, 1, 1};        ///< positive
  Eigen::Vector3d origin = {0, 0, 0};      ///< the corner with the lowest coordinates
  std::array<int, 3> patches = {1, 1, 1};  ///< along x, y and z, 1 .. 1000 each
  /// The patches' corners are moved at random by up to half this share of a patch's size.
  /// Range 0 .. 0.55; 0 is regular.
  double distortion = 0;
  /// Patches become quadratic, their faces and edges curved: their control points other than the corners are
  /// moved at random by up to a quarter of this share of a patch's size.
  /// Range 0 .. 0.55, distortion + curvature at most 0.55; 0 is trilinear.
  double curvature = 0;
  /// Whether points in the box's own faces and edges move too, within them; the box stays the same box.
  bool distort_faces = true;
  unsigned seed = 1;  ///< the same seed gives the same box on every machine
  /// If given, every patch gets an orientation drawn at random from all 48, left-handed ones among them.
  std::optional<unsigned> orientation_seed = std::nullopt;
  bool operator==(const BoxOptions&) const = default;
};

/// @throws Error invalid_argument, naming field, value and range
void validate(const BoxOptions& options);

/// Patches of degree 1, or 2 if curved, x running fastest. For every seed det J > 0: a patch's derivatives,
/// in units of its size, differ by at most distortion + curvature < 1 / sqrt(3) from those of a brick.
/// Boundaries: x_min, x_max, y_min, y_max, z_min, z_max.
PatchSet box_model(const BoxOptions& options = {});

}  // namespace isopatch::geometry
