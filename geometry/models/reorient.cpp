#include "geometry/models/reorient.hpp"

#include <algorithm>
#include <random>

#include "geometry/splines/permute.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

bool keeps_handedness(const PatchOrientation& orientation) {
  bool even = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j)
      if (orientation.from[i] > orientation.from[j]) even = !even;
    if (orientation.flipped[i]) even = !even;
  }
  return even;
}

}  // namespace

std::array<PatchOrientation, 48> patch_orientations() {
  std::array<PatchOrientation, 48> result;
  std::size_t count = 0;
  std::array<int, 3> from = {0, 1, 2};
  do {
    for (int flips = 0; flips < 8; ++flips)
      result[count++] = {from, {(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0}};
  } while (std::next_permutation(from.begin(), from.end()));
  std::stable_partition(result.begin(), result.end(), keeps_handedness);
  return result;
}

NurbsVolume reoriented(const NurbsVolume& volume, const PatchOrientation& orientation) {
  NurbsVolume result = permuted(volume, orientation.from);
  for (int d = 0; d < 3; ++d)
    if (orientation.flipped[static_cast<std::size_t>(d)]) result = reversed(result, d);
  return result;
}

Side reoriented(Side side, const PatchOrientation& orientation) {
  const auto at = std::find(orientation.from.begin(), orientation.from.end(), direction(side));
  const auto d = static_cast<std::size_t>(at - orientation.from.begin());
  return side_of(static_cast<int>(d), is_high(side) != orientation.flipped[d]);
}

FaceOrientation reoriented_face(Side side, const PatchOrientation& orientation) {
  const std::array<int, 2> before = tangents(side);
  const std::array<int, 2> after = tangents(reoriented(side, orientation));
  const auto at = [&](std::size_t i) { return static_cast<std::size_t>(after[i]); };
  return {orientation.from[at(0)] != before[0], orientation.flipped[at(0)], orientation.flipped[at(1)]};
}

PatchSet randomly_reoriented(const PatchSet& patches, unsigned seed) {
  // The engine's numbers are the same everywhere; those of the library's distributions are not.
  std::mt19937 random(seed);
  const auto all = patch_orientations();
  std::vector<PatchOrientation> drawn;
  PatchSet result;
  for (const NurbsVolume& patch : patches.patches) {
    drawn.push_back(all[random() % all.size()]);
    result.patches.push_back(reoriented(patch, drawn.back()));
  }
  const auto moved = [&](const PatchFace& face) {
    return PatchFace{face.patch, reoriented(face.side, drawn[static_cast<std::size_t>(face.patch.value)])};
  };
  for (const Boundary& boundary : patches.boundaries) {
    Boundary& copy = result.boundaries.emplace_back(Boundary{boundary.name, {}});
    for (const PatchFace& face : boundary.faces) copy.faces.push_back(moved(face));
  }
  const auto change = [&](const PatchFace& face) {
    return reoriented_face(face.side, drawn[static_cast<std::size_t>(face.patch.value)]);
  };
  for (const StatedInterface& stated : patches.interfaces)
    result.interfaces.push_back(
        {moved(stated.first), moved(stated.second),
         composed(composed(inverse(change(stated.first)), stated.orientation), change(stated.second))});
  return result;
}

}  // namespace isopatch::geometry
