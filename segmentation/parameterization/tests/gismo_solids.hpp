#pragma once

#include <string>
#include <vector>

#include "segmentation/parameterization/assemble_complex.hpp"
#include "segmentation/parameterization/hex_complex.hpp"

namespace isopatch::segmentation::test {

/// A solid of trimmed surfaces as G+Smo writes it, read plainly and without a CAD kernel: the tests' second
/// opinion.
HexSolid gismo_solid(const std::string& path);

/// The nine solids of the chair stand, and the pairs of the file beside them.
struct ChairStand {
  std::vector<Hexahedron> blocks;
  std::vector<ListedPair> pairs;
};
ChairStand chair_stand(const std::string& folder);

}  // namespace isopatch::segmentation::test
