#pragma once

#include <vector>

#include "segmentation/parameterization/hex_complex.hpp"

namespace isopatch::segmentation {

/// Two faces that are one, by the numbers that they have in their solids.
struct ListedPair {
  int first_block = 0, first_face = 0;
  int second_block = 0, second_face = 0;
};

struct ComplexOptions {
  /// Points of two blocks closer than this share of the size are one. Range (0, 0.05).
  double same_point = 1e-3;
};
void validate(const ComplexOptions& options);

/// Puts blocks together by a list of pairs.
/// @throws Error invalid_argument  a block or face that does not exist, a face in two pairs, no block
/// @throws Error not_conforming    a pair that does not meet: names the pair, the distance and the place
HexComplex hex_complex(std::vector<Hexahedron> blocks, const std::vector<ListedPair>& pairs,
                       const ComplexOptions& options = {});

/// Finds the pairs, and the partial contacts, from the geometry alone.
/// @cost O(faces^2)
HexComplex hex_complex(std::vector<Hexahedron> blocks, const ComplexOptions& options = {});

}  // namespace isopatch::segmentation
