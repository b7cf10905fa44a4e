#pragma once

#include <array>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// Another way to parametrize the same patch: one of 48, half of them turn a right-handed patch into a
/// left-handed one.
struct PatchOrientation {
  std::array<int, 3> from = {0, 1, 2};                  ///< direction d was direction from[d]
  std::array<bool, 3> flipped = {false, false, false};  ///< then turned around, by new direction

  auto operator<=>(const PatchOrientation&) const = default;
};

/// All 48, those that keep the handedness first.
std::array<PatchOrientation, 48> patch_orientations();

NurbsVolume reoriented(const NurbsVolume& volume, const PatchOrientation& orientation);

/// Where a side of the volume is found after `reoriented`.
Side reoriented(Side side, const PatchOrientation& orientation);

/// Where parameters of a side are found on that side after `reoriented`.
FaceOrientation reoriented_face(Side side, const PatchOrientation& orientation);

/// Every patch in an orientation drawn at random from all 48; boundaries and interfaces follow. The
/// model is the same body, which makes this the hardest test of everything that couples patches.
/// @param seed  the same seed gives the same orientations on every machine
PatchSet randomly_reoriented(const PatchSet& patches, unsigned seed);

}  // namespace isopatch::geometry
