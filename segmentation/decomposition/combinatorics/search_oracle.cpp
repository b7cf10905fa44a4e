#include "segmentation/decomposition/combinatorics/search_oracle.hpp"

#include <utility>

#include "segmentation/decomposition/combinatorics/contraction.hpp"
#include "segmentation/decomposition/combinatorics/internal/separation.hpp"

namespace isopatch::segmentation {
namespace {

Eigen::Matrix3Xd derived_points(const DerivedGraph& piece, const CellGraph& graph,
                                const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) return {};
  Eigen::Matrix3Xd result(3, piece.graph.vertex_count);
  for (int v = 0; v < piece.graph.vertex_count; ++v) {
    const LoopPlace& place = piece.vertices[v];
    if (place.auxiliary())
      result.col(v) =
          (points.col(graph.edge(place.edge).start.value) + points.col(graph.edge(place.edge).end.value)) / 2;
    else
      result.col(v) = points.col(place.vertex.value);
  }
  return result;
}

std::vector<bool> derived_neighbours(const DerivedGraph& piece, const std::vector<bool>& has_neighbour) {
  std::vector<bool> result;
  for (const FaceOrigin& face : piece.faces) {
    bool found = face.is_new;
    for (const FaceId origin : face.faces)
      found = found || (!has_neighbour.empty() && has_neighbour[origin.value]);
    result.push_back(found);
  }
  return result;
}

}  // namespace

SearchOracle combinatorial_oracle() {
  SearchOracle oracle;
  oracle.cut = [](const SearchCell& cell, const CuttingLoop& loop) {
    CutAnswer answer;
    const Separation cut = separate(cell.graph, loop);
    answer.refusal = cut.fault;
    if (!cut.pieces) return answer;
    for (const DerivedGraph* part : {&cut.pieces->left, &cut.pieces->right}) {
      DerivedGraph piece = composed(*part, sides(part->graph));
      SearchCell& result = answer.pieces.emplace_back();
      result.geometry.points = derived_points(piece, cell.graph, cell.geometry.points);
      result.geometry.has_neighbour = derived_neighbours(piece, cell.geometry.has_neighbour);
      result.graph = std::move(piece.graph);
    }
    return answer;
  };
  return oracle;
}

}  // namespace isopatch::segmentation
