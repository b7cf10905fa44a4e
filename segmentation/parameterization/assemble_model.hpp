#pragma once

#include <vector>

#include "geometry/hex/listed_pair.hpp"
#include "segmentation/parameterization/hex_model.hpp"

namespace isopatch::segmentation {

using geometry::ListedPair;

struct AssemblyOptions {
  /// Points of two blocks closer than this share of the size are one. Range (0, 0.05); 0: 1e-3, but 1e-5
  /// where most faces that meet within 1e-3 agree to 1e-6, so that blocks of exact solids which nearly meet
  /// are not pulled together.
  double same_point = 0;
  bool operator==(const AssemblyOptions&) const = default;
};
void validate(const AssemblyOptions& options);

/// Puts solids together by a list of pairs.
/// @throws Error invalid_argument  a block or face that does not exist, a face in two pairs, no block
/// @throws Error not_conforming    a pair that does not meet: names the pair, the distance and the place
/// @throws Error unsupported       a solid that is no topological hexahedron: names what is in the way
HexModel hex_model(std::vector<geometry::BrepFile> solids, const std::vector<ListedPair>& pairs,
                   const AssemblyOptions& options = {});

/// Puts solids together of which it is known in part how they meet.
/// @param groups  by solid: solids of one group meet in pairs of the list and nowhere else, those of
/// different groups,
///                and all of group -1, wherever they are found to
/// @throws Error as above
/// @cost O(faces^2) boxes compared
HexModel hex_model(std::vector<geometry::BrepFile> solids, const std::vector<ListedPair>& pairs,
                   const std::vector<int>& groups, const AssemblyOptions& options = {});

/// Finds the pairs from the geometry alone, and the T-joints: sides that lie in larger ones.
/// @throws Error as above
/// @cost O(faces^2)
HexModel hex_model(std::vector<geometry::BrepFile> solids, const AssemblyOptions& options = {});

}  // namespace isopatch::segmentation
