#include "segmentation/decomposition/blocks.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/brep/cell_solids.hpp"

namespace isopatch::segmentation {

std::vector<geometry::BrepFile> blocks(const geometry::BrepFile& solid, const Decomposition& decomposition) {
  std::vector<geometry::CellId> all;
  for (std::size_t c = 0; c < decomposition.complex.cells.size(); ++c) all.emplace_back(static_cast<int>(c));
  std::vector<geometry::BrepFile> result;
  for (geometry::Brep& cell : cell_solids(solid.brep, decomposition.complex, all)) {
    const std::string name = result.empty() ? solid.name : fmt::format("{}#{}", solid.name, result.size());
    result.push_back({std::move(cell), name, 0});
  }
  return result;
}

}  // namespace isopatch::segmentation
