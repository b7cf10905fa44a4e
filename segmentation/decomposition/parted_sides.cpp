#include "segmentation/decomposition/parted_sides.hpp"

#include "segmentation/decomposition/cutting/side_inside.hpp"

namespace isopatch::segmentation {

std::vector<PartedSide> parted_sides(const CellShapes& shapes, const SideOptions& options) {
  const geometry::CellComplex& complex = shapes.complex();
  std::vector<PartedSide> result;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const geometry::CellId cell(static_cast<int>(c));
    for (const auto& side : cell_sides(shapes, cell, options).faces) {
      if (side.size() < 2) continue;
      result.push_back({cell, side_inside(complex, side).edges});
    }
  }
  return result;
}

}  // namespace isopatch::segmentation
