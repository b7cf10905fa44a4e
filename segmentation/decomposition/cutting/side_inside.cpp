#include "segmentation/decomposition/cutting/side_inside.hpp"

#include <map>

namespace isopatch::segmentation {

SideInside side_inside(const geometry::CellComplex& complex, const std::vector<geometry::CellFaceUse>& side) {
  std::map<EdgeId, int> uses;
  for (const geometry::CellFaceUse& face : side)
    for (const geometry::EdgeUse& use : complex.face(face.face).loop) ++uses[use.edge];
  SideInside result;
  for (const auto& [edge, count] : uses)
    if (count > 1)
      result.edges.push_back(edge);
    else
      result.outline.insert({complex.edge(edge).start, complex.edge(edge).end});
  return result;
}

}  // namespace isopatch::segmentation
