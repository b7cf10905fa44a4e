#include "segmentation/decomposition/prospect.hpp"

#include <algorithm>
#include <variant>

#include "geometry/base/error.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "segmentation/decomposition/cutting/corner_shape.hpp"
#include "segmentation/decomposition/known_shape.hpp"
#include "segmentation/decomposition/looks.hpp"
#include "segmentation/decomposition/star_pieces.hpp"
#include "segmentation/decomposition/starting_cell.hpp"

namespace isopatch::segmentation {
namespace {

Prospect seen(const geometry::Brep& solid, const DecompositionOptions& options) {
  CellStore store(solid, options.cut, options.time_limit);
  const StartingCell start = starting_cell(store);
  const CellSides& sides = store.entry(start.cell.handle).sides;
  Prospect result;
  result.sides = static_cast<int>(start.cell.graph.faces.size());
  for (std::size_t e = 0; e < start.cell.graph.edges.size(); ++e) {
    const CellGraph::Edge& found = start.cell.graph.edges[e];
    if (found.kind != EdgeKind::non_convex) continue;
    const double flat = 180 + options.cut.sides.flat.degrees();
    std::vector<EdgeId>& list = found.angle && found.angle->degrees() < flat ? result.blunt : result.concave;
    for (const geometry::EdgeUse& use : sides.edges[e])
      if (const auto* edge =
              std::get_if<EdgeId>(&start.complex.curve(start.complex.edge(use.edge).curve).shape))
        list.push_back(*edge);
  }
  for (std::vector<EdgeId>* list : {&result.concave, &result.blunt}) std::sort(list->begin(), list->end());
  return result;
}

}  // namespace

bool corners_open(const geometry::Brep& hexahedron) {
  const geometry::CellComplex complex = geometry::one_cell(hexahedron);
  const CellShapes shapes(hexahedron, complex);
  return corners_open(shapes, cell_sides(shapes, geometry::CellId(0)));
}

Prospect prospect(const geometry::Brep& solid, const DecompositionOptions& options) {
  const bool looked_at = options.method != Method::cuts && !is_cut_by_hand(options);
  Prospect result;
  try {
    result = seen(solid, options);
  } catch (const geometry::SolidError& error) {
    result.refusal = error;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.refusal = geometry::SolidError(error.code(), error.what(), {});
  }
  if (looked_at) result.seen_as = looks(solid);
  // Where nothing else is seen, only dividing tells whether it comes in pieces, or in its triangles.
  if (result.refusal && result.seen_as.empty()) {
    std::optional<Decomposition> found = known_shape(solid, options).decomposition;
    if (!found) found = kept_triangles(solid, options);
    if (found) result.seen_as = found->report.seen_as;
  }
  if (!result.seen_as.empty()) result.refusal.reset();
  return result;
}

}  // namespace isopatch::segmentation
