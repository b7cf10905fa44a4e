#include "segmentation/decomposition/parted_sides.hpp"

#include <map>

namespace isopatch::segmentation {

std::vector<PartedSide> parted_sides(const CellShapes& shapes, const SideOptions& options) {
  const geometry::CellComplex& complex = shapes.complex();
  std::vector<PartedSide> result;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const geometry::CellId cell(static_cast<int>(c));
    for (const auto& side : cell_sides(shapes, cell, options).faces) {
      if (side.size() < 2) continue;
      std::map<EdgeId, int> uses;
      for (const geometry::CellFaceUse& face : side)
        for (const geometry::EdgeUse& use : complex.face(face.face).loop) ++uses[use.edge];
      PartedSide parted{cell, {}};
      for (const auto& [edge, count] : uses)
        if (count > 1) parted.inside.push_back(edge);
      result.push_back(std::move(parted));
    }
  }
  return result;
}

}  // namespace isopatch::segmentation
