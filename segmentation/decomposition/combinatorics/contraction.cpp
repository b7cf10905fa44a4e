#include "segmentation/decomposition/combinatorics/contraction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"

namespace isopatch::segmentation {
namespace {

// A graph some of whose edges are to go: its darts, and which of them stay.
class Contraction {
 public:
  Contraction(const CellGraph& graph, const std::vector<EdgeId>& removed)
      : graph_(graph),
        map_(planar_map(graph)),
        around_(darts(map_)),
        edge_(map_.corners.size()),
        kept_(map_.corners.size(), 1) {
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      const int dart = around_.between(map_, graph.edges[e].start.value, graph.edges[e].end.value);
      edge_[dart] = edge_[around_.twin[dart]] = e;
      first_.push_back(dart);
    }
    for (const EdgeId id : removed) kept_[first_[id.value]] = kept_[around_.twin[first_[id.value]]] = 0;
    count_degrees();
  }

  std::optional<DerivedGraph> result() {
    if (!add_vertices() || !add_edges() || !add_faces()) return std::nullopt;
    return std::move(result_);
  }

 private:
  void count_degrees() {
    degree_.assign(map_.vertices, 0);
    for (std::size_t d = 0; d < kept_.size(); ++d) degree_[map_.corners[d]] += kept_[d];
  }

  // The kept dart after a kept one, around the joined faces.
  int after(int dart) const {
    int next = around_.next[dart];
    while (!kept_[next]) next = around_.next[around_.twin[next]];
    return next;
  }
  int end(int dart) const { return map_.corners[around_.next[dart]]; }

  bool add_vertices() {
    number_.assign(map_.vertices, -1);
    for (int v = 0; v < map_.vertices; ++v) {
      if (degree_[v] == 1) return false;
      if (degree_[v] < 3) continue;
      number_[v] = result_.graph.vertex_count++;
      result_.vertices.push_back(LoopPlace::at(VertexId(v)));
    }
    return result_.graph.vertex_count > 0;
  }

  bool add_edges() {
    std::vector<char> done(graph_.edges.size());
    std::set<std::pair<int, int>> known;
    for (const int dart : first_) {
      if (!kept_[dart] || done[edge_[dart]]) continue;
      const auto chain = chain_with(dart);
      if (!chain) return false;
      for (const int part : *chain) done[edge_[part]] = 1;
      const int a = map_.corners[chain->front()], b = end(chain->back());
      if (a == b || !known.insert(std::minmax(a, b)).second) return false;
      add_edge(*chain);
    }
    return true;
  }

  // Darts one after the other, from one vertex that stays to the next; nothing if there is none.
  std::optional<std::vector<int>> chain_with(int dart) const {
    int start = dart;
    while (number_[map_.corners[start]] < 0) {
      start = around_.twin[after(around_.twin[start])];
      if (start == dart) return std::nullopt;
    }
    std::vector<int> chain = {start};
    while (number_[end(chain.back())] < 0) chain.push_back(after(chain.back()));
    if (std::find(chain.begin(), chain.end(), dart) == chain.end()) return std::nullopt;
    return chain;
  }

  void add_edge(const std::vector<int>& chain) {
    const CellGraph::Edge& first = graph_.edges[edge_[chain.front()]];
    CellGraph::Edge edge{VertexId(number_[map_.corners[chain.front()]]), VertexId(number_[end(chain.back())]),
                         first.kind, first.angle};
    std::vector<EdgeStretch>& stretches = result_.edges.emplace_back();
    for (const int dart : chain) {
      const CellGraph::Edge& part = graph_.edges[edge_[dart]];
      edge.kind = std::max(edge.kind, part.kind);
      if (edge.angle != part.angle) edge.angle.reset();
      stretches.push_back({LoopPlace::at(VertexId(map_.corners[dart])), LoopPlace::at(VertexId(end(dart))),
                           EdgeId(edge_[dart]), FaceId()});
    }
    result_.graph.edges.push_back(edge);
  }

  bool add_faces() {
    UnionFind joined(map_.faces());
    for (std::size_t d = 0; d < kept_.size(); ++d)
      if (!kept_[d]) joined.unite(around_.face[d], around_.face[around_.twin[d]]);
    std::vector<int> place(map_.faces(), -1);
    for (int f = 0; f < map_.faces(); ++f) {
      int& at = place[joined.find(f)];
      if (at < 0) {
        at = static_cast<int>(result_.faces.size());
        result_.faces.emplace_back();
        result_.graph.faces.emplace_back();
      }
      result_.faces[at].faces.emplace_back(f);
    }
    std::vector<char> walked(kept_.size());
    for (int d = 0; d < static_cast<int>(kept_.size()); ++d)
      if (kept_[d] && !walked[d] &&
          !add_outline(d, result_.graph.faces[place[joined.find(around_.face[d])]], walked))
        return false;
    return std::all_of(result_.graph.faces.begin(), result_.graph.faces.end(),
                       [](const CellGraph::Corners& face) { return face.size() > 2; });
  }

  // False if the face has an outline already or touches itself.
  bool add_outline(int first, CellGraph::Corners& face, std::vector<char>& walked) const {
    if (!face.empty()) return false;
    int dart = first;
    do {
      walked[dart] = 1;
      if (const int vertex = number_[map_.corners[dart]]; vertex >= 0) face.emplace_back(vertex);
      dart = after(dart);
    } while (dart != first);
    std::set<VertexId> distinct(face.begin(), face.end());
    return distinct.size() == face.size();
  }

  const CellGraph& graph_;
  PlanarMap map_;
  Darts around_;
  std::vector<int> edge_, first_;  // the edge of each dart, a dart of each edge: from its start
  std::vector<char> kept_;
  std::vector<int> degree_, number_;
  DerivedGraph result_;
};

std::vector<EdgeId> flat_edges(const CellGraph& graph) {
  std::vector<EdgeId> result;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    if (graph.edges[e].kind == EdgeKind::flat) result.emplace_back(e);
  return result;
}

std::optional<DerivedGraph> three_connected_without(const CellGraph& graph,
                                                    const std::vector<EdgeId>& edges) {
  auto result = contracted(graph, edges);
  if (result && !is_three_connected(result->graph)) result.reset();
  return result;
}

}  // namespace

std::optional<DerivedGraph> contracted(const CellGraph& graph, const std::vector<EdgeId>& edges) {
  const CellIncidence checked(graph);
  for (const EdgeId edge : edges)
    if (edge.value < 0 || edge.value >= static_cast<int>(graph.edges.size()))
      throw Error(ErrorCode::invalid_argument, fmt::format("there is no edge {} to remove; the cell has {}",
                                                           edge.value, graph.edges.size()));
  return Contraction(graph, edges).result();
}

DerivedGraph sides(const CellGraph& graph) {
  const std::vector<EdgeId> flat = flat_edges(graph);
  if (auto all = three_connected_without(graph, flat)) return std::move(*all);
  std::vector<EdgeId> gone;
  std::optional<DerivedGraph> best = three_connected_without(graph, {});
  for (const EdgeId edge : flat) {
    gone.push_back(edge);
    if (auto next = three_connected_without(graph, gone))
      best = std::move(next);
    else if (best)
      gone.pop_back();
  }
  return best ? std::move(*best) : identity(graph);
}

}  // namespace isopatch::segmentation
