#include "segmentation/decomposition/geometric_oracle.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "segmentation/decomposition/cutting/corner_shape.hpp"
#include "segmentation/decomposition/cutting/plane_section.hpp"

namespace isopatch::segmentation {

bool is_finished(const BaseSolid& base) {
  return base.kind == BaseKind::hexahedron || base.kind == BaseKind::tetrahedron ||
         base.kind == BaseKind::simple || (base.kind == BaseKind::prism && base.sides == 3);
}

namespace {

/// Sections by planes through edges that are not convex; through any where all are.
std::vector<CuttingLoop> proposals(CellStore& store, const SearchCell& cell) {
  const CellStore::Entry& entry = store.entry(cell.handle);
  const CellShapes shapes(store.source(), entry.complex);
  std::vector<CuttingLoop> result;
  const bool convex = non_convex_count(cell.graph) == 0;
  for (std::size_t e = 0; e < cell.graph.edges.size() && !store.time_is_up(); ++e) {
    if (!convex && cell.graph.edges[e].kind != EdgeKind::non_convex) continue;
    for (SpacedLoop& loop :
         plane_sections(shapes, entry.sides, EdgeId(static_cast<int>(e)), 1e-7 * store.source().size())) {
      store.propose(cell.handle, loop.loop, loop.places);
      result.push_back(std::move(loop.loop));
    }
  }
  return result;
}

}  // namespace

SearchOracle geometric_oracle(CellStore& store) {
  SearchOracle oracle;
  oracle.cut = [&store](const SearchCell& cell, const CuttingLoop& loop) { return store.cut(cell, loop); };
  oracle.propose =
      [&store, known = std::make_shared<std::map<int, std::vector<CuttingLoop>>>()](const SearchCell& cell) {
        const auto found = known->find(cell.handle);
        if (found != known->end()) return found->second;
        std::vector<CuttingLoop> loops = proposals(store, cell);
        if (!store.time_is_up()) known->emplace(cell.handle, loops);
        return loops;
      };
  oracle.accepts = [&store](const SearchCell& cell, const BaseSolid& base) {
    // Tetrahedra around a point do not mind edges that are nearly flat.
    const CellStore::Entry& entry = store.entry(cell.handle);
    if (base.kind == BaseKind::convex) return entry.polyhedral && non_convex_count(entry.sides.graph) == 0;
    return is_finished(base) && non_convex_count(cell.graph) == 0 &&
           corners_open(CellShapes(store.source(), entry.complex), entry.sides);
  };
  return oracle;
}

}  // namespace isopatch::segmentation
