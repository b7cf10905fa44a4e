#include "segmentation/decomposition/combinatorics/canonical_code.hpp"

#include <fmt/format.h>

#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/combinatorics/internal/map_code.hpp"

namespace isopatch::segmentation {

CanonicalCode canonical_code(const CellGraph& graph, const CodeOptions& options) {
  if (graph.vertex_count >= 65000)
    throw Error(ErrorCode::unsupported,
                fmt::format("a cell of {} vertices has no code; 64,999 are the most", graph.vertex_count));
  const CellIncidence checked(graph);
  const PlanarMap map = planar_map(graph);
  const Darts around = darts(map);
  std::vector<char16_t> kinds;
  if (options.edge_kinds) {
    kinds.resize(map.corners.size());
    for (const CellGraph::Edge& edge : graph.edges) {
      const int dart = around.between(map, edge.start.value, edge.end.value);
      kinds[dart] = kinds[around.twin[dart]] = static_cast<char16_t>(edge.kind);
    }
  }
  return {map_code(map, around, kinds, options.mirror_images_are_equal)};
}

}  // namespace isopatch::segmentation
