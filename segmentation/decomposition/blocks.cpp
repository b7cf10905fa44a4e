#include "segmentation/decomposition/blocks.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "geometry/brep/cell_solids.hpp"

namespace isopatch::segmentation {

std::vector<geometry::BrepFile> blocks(const geometry::BrepFile& solid, const Decomposition& decomposition) {
  std::vector<geometry::BrepFile> result;
  for (geometry::Brep& cell : cell_solids(solid.brep, decomposition.complex)) {
    const std::string name = result.empty() ? solid.name : fmt::format("{}#{}", solid.name, result.size());
    result.push_back({std::move(cell), name, 0});
  }
  return result;
}

std::vector<geometry::ListedPair> block_pairs(const Decomposition& decomposition) {
  std::map<FaceId, std::pair<int, int>> first;
  std::vector<geometry::ListedPair> result;
  for (std::size_t c = 0; c < decomposition.complex.cells.size(); ++c) {
    const auto& faces = decomposition.complex.cells[c].faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const int block = static_cast<int>(c), face = static_cast<int>(f);
      const auto [found, fresh] = first.try_emplace(faces[f].face, block, face);
      if (!fresh) result.push_back({found->second.first, found->second.second, block, face});
    }
  }
  return result;
}

}  // namespace isopatch::segmentation
