#include "segmentation/decomposition/cut_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/cutting/vertex_on_chain.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellId;

/// From the graph in which a loop was found to that of the same cell in the complex, by where vertices are.
class SameCell {
 public:
  SameCell(const CellStore::Entry& found, const CellShapes& shapes, const CellSides& sides, double same_point)
      : from_(found.sides), to_(sides) {
    for (const VertexId known : found.sides.vertices) {
      const Eigen::Vector3d& at = found.complex.vertex(known);
      const auto same = std::find_if(sides.vertices.begin(), sides.vertices.end(), [&](VertexId v) {
        return (shapes.complex().vertex(v) - at).norm() <= same_point;
      });
      if (same == sides.vertices.end()) throw Error(ErrorCode::internal, "a cell has lost a corner");
      vertex_.emplace_back(static_cast<int>(same - sides.vertices.begin()));
    }
  }

  VertexId operator()(VertexId id) const { return vertex_[static_cast<std::size_t>(id.value)]; }
  EdgeId operator()(EdgeId id) const {
    const CellGraph::Edge& edge = from_.graph.edge(id);
    const auto found = edge_between(to_.graph, (*this)(edge.start), (*this)(edge.end));
    if (!found) throw Error(ErrorCode::internal, "a cell has lost an edge");
    return *found;
  }
  FaceId operator()(FaceId id) const {
    CellGraph::Corners wanted = from_.graph.face(id);
    for (VertexId& vertex : wanted) vertex = (*this)(vertex);
    std::sort(wanted.begin(), wanted.end());
    for (std::size_t f = 0; f < to_.graph.faces.size(); ++f) {
      CellGraph::Corners corners = to_.graph.faces[f];
      std::sort(corners.begin(), corners.end());
      if (corners == wanted) return FaceId(static_cast<int>(f));
    }
    throw Error(ErrorCode::internal, "a cell has lost a side");
  }

 private:
  const CellSides& from_;
  const CellSides& to_;
  std::vector<VertexId> vertex_;
};

}  // namespace

int apply_cuts(const Brep& source, CellComplex& complex, CellId cell, const CutTree& tree,
               const CellStore& store, const CutOptions& options) {
  const double same_point = 1e-7 * source.size();
  std::vector<std::pair<int, CellId>> open = {{0, cell}};
  int cuts = 0;
  while (!open.empty()) {
    const auto [index, here] = open.back();
    open.pop_back();
    const CutTree::Node& node = tree.nodes[static_cast<std::size_t>(index)];
    if (!node.loop) continue;
    const CellStore::Entry& found = store.entry(node.cell.handle);
    const std::vector<Eigen::Vector3d> places = store.places(node.cell.handle, *node.loop);
    CellSides sides = cell_sides(CellShapes(source, complex), here, options.sides);
    PlacedLoop loop{*node.loop, std::vector<VertexId>(node.loop->places.size())};
    const SameCell same(found, CellShapes(source, complex), sides, same_point);
    for (std::size_t i = 0; i < loop.loop.places.size(); ++i) {
      LoopPlace& place = loop.loop.places[i];
      if (!place.auxiliary()) {
        place.vertex = same(place.vertex);
        continue;
      }
      place.edge = same(place.edge);
      loop.at[i] = vertex_on_chain(source, complex, sides.edges[static_cast<std::size_t>(place.edge.value)],
                                   places[i], same_point);
    }
    for (LoopStep& step : loop.loop.steps)
      if (step.auxiliary())
        step.face = same(step.face);
      else
        step.edge = same(step.edge);
    sides = cell_sides(CellShapes(source, complex), here, options.sides);
    CutAttempt attempt = cut_cell(source, complex, here, sides, loop, options);
    if (!attempt.cut)
      throw Error(ErrorCode::unsupported,
                  fmt::format("a cut that suits a cell by itself does not suit it among its neighbours: {}",
                              attempt.refusal));
    complex = std::move(attempt.cut->complex);
    ++cuts;
    open.emplace_back(node.pieces.at(0), attempt.cut->left);
    open.emplace_back(node.pieces.at(1), attempt.cut->right);
  }
  return cuts;
}

}  // namespace isopatch::segmentation
