#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/internal/loop_walk.hpp"
#include "segmentation/decomposition/combinatorics/loop_validity.hpp"

namespace isopatch::segmentation {
namespace {

// Vertices first, then the edges that may be split, as places of a walk.
class CellPlaces {
 public:
  CellPlaces(const CellGraph& graph, const CellIncidence& incidence, const std::vector<EdgeId>& may_be_split)
      : graph_(graph), incidence_(incidence) {
    for (int v = 0; v < graph.vertex_count; ++v) places_.push_back(LoopPlace::at(VertexId(v)));
    const std::set<EdgeId> distinct(may_be_split.begin(), may_be_split.end());
    for (const EdgeId edge : distinct) places_.push_back(LoopPlace::inside(edge));
    check_places(graph, places_);
    fill();
  }

  const PlaceGraph& graph() const { return walk_; }

  CuttingLoop loop(const std::vector<int>& path) const {
    CuttingLoop result;
    for (std::size_t k = 0; k < path.size(); ++k) {
      result.places.push_back(places_[path[k]]);
      result.steps.push_back(step(path[k], path[(k + 1) % path.size()]));
    }
    return result;
  }

 private:
  void fill() {
    walk_.faces = static_cast<int>(graph_.faces.size());
    std::vector<std::vector<int>> on(graph_.faces.size()), faces(places_.size());
    for (int p = 0; p < static_cast<int>(places_.size()); ++p)
      for (const FaceId face : faces_at(incidence_, places_[p])) {
        on[face.value].push_back(p);
        faces[p].push_back(face.value);
      }
    for (int p = 0; p < static_cast<int>(places_.size()); ++p) {
      std::vector<int> near;
      for (const int face : faces[p]) near.insert(near.end(), on[face].begin(), on[face].end());
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      std::erase_if(near, [&](int other) { return other == p || lies_on(p, other) || lies_on(other, p); });
      walk_.face.insert(walk_.face.end(), faces[p].begin(), faces[p].end());
      walk_.near.insert(walk_.near.end(), near.begin(), near.end());
      walk_.face_begin.push_back(static_cast<int>(walk_.face.size()));
      walk_.near_begin.push_back(static_cast<int>(walk_.near.size()));
    }
  }

  // Whether the one is a vertex inside an edge that ends at the other.
  bool lies_on(int inside, int vertex) const {
    if (!places_[inside].auxiliary() || places_[vertex].auxiliary()) return false;
    const CellGraph::Edge& edge = graph_.edge(places_[inside].edge);
    return edge.start == places_[vertex].vertex || edge.end == places_[vertex].vertex;
  }

  LoopStep step(int a, int b) const {
    if (!places_[a].auxiliary() && !places_[b].auxiliary())
      if (const auto edge = incidence_.edge_between(places_[a].vertex, places_[b].vertex))
        return LoopStep::along(*edge);
    for (int k = walk_.face_begin[a]; k < walk_.face_begin[a + 1]; ++k)
      for (int m = walk_.face_begin[b]; m < walk_.face_begin[b + 1]; ++m)
        if (walk_.face[k] == walk_.face[m]) return LoopStep::across(FaceId(walk_.face[k]));
    return {};
  }

  const CellGraph& graph_;
  const CellIncidence& incidence_;
  std::vector<LoopPlace> places_;
  PlaceGraph walk_;
};

// Collects the loops of a walk until there are too many.
LoopWalk::Visit collect_into(LoopList& list, const CellPlaces& places, int max_loops) {
  return [&list, &places, max_loops](const std::vector<int>& path) {
    list.complete = static_cast<int>(list.loops.size()) < max_loops;
    if (list.complete) list.loops.push_back(places.loop(path));
    return list.complete;
  };
}

void check_three_connected(const CellGraph& graph) {
  if (!is_three_connected(graph))
    throw Error(ErrorCode::not_three_connected,
                "loops are looked for in 3-connected cells; two vertices take this one apart: put auxiliary "
                "edges in its "
                "faces before");
}

void check_range(const char* field, int value, int least, int most) {
  if (value < least || value > most)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("LoopOptions::{} is {}, range {} .. {}", field, value, least, most));
}

int positive_modulo(int a, int n) {
  return ((a % n) + n) % n;
}

// Chains of consecutive sides of a face that are not convex, each as long as it can be: first side and
// number.
std::vector<std::pair<int, int>> non_convex_chains(const CellGraph& graph, const std::vector<EdgeId>& sides) {
  const int n = static_cast<int>(sides.size());
  const auto open = [&](int k) {
    return graph.edge(sides[positive_modulo(k, n)]).kind == EdgeKind::non_convex;
  };
  std::vector<std::pair<int, int>> chains;
  for (int k = 0; k < n; ++k) {
    if (!open(k) || open(k - 1)) continue;
    int count = 1;
    while (open(k + count)) ++count;
    chains.emplace_back(k, count);
  }
  return chains;
}

}  // namespace

void validate(const LoopOptions& options) {
  check_range("max_length", options.max_length, 3, 1000);
  check_range("max_loops", options.max_loops, 1, 1000000000);
}

LoopList valid_loops(const CellGraph& graph, const LoopOptions& options) {
  validate(options);
  check_three_connected(graph);
  const CellIncidence incidence(graph);
  const CellPlaces places(graph, incidence, options.may_be_split);
  LoopList list;
  LoopWalk(places.graph(), options.max_length, collect_into(list, places, options.max_loops)).all();
  return list;
}

LoopList valid_loops_through(const CellGraph& graph, EdgeId through, const LoopOptions& options) {
  validate(options);
  check_three_connected(graph);
  check_places(graph, {LoopPlace::inside(through)});
  const CellIncidence incidence(graph);
  std::vector<EdgeId> split = options.may_be_split;
  std::erase(split, through);
  const CellPlaces places(graph, incidence, split);
  LoopList list;
  const CellGraph::Edge& edge = graph.edge(through);
  LoopWalk(places.graph(), options.max_length, collect_into(list, places, options.max_loops))
      .starting_with({edge.start.value, edge.end.value});
  return list;
}

std::vector<EdgeId> impeding_edges(const CellGraph& graph, EdgeId edge) {
  check_places(graph, {LoopPlace::inside(edge)});
  const CellIncidence incidence(graph);
  const auto& [u, v, kind, angle] = graph.edge(edge);
  const CellGraph::Corners &left = graph.face(incidence.left(edge)),
                           &right = graph.face(incidence.right(edge));
  std::vector<EdgeId> result;
  for (const VertexId a : left)
    for (const VertexId b : right) {
      if (a == u || a == v || b == u || b == v) continue;
      if (const auto between = incidence.edge_between(a, b)) result.push_back(*between);
    }
  std::sort(result.begin(), result.end());
  return result;
}

LoopList extending_loops(const CellGraph& graph, FaceId face, const LoopOptions& options) {
  validate(options);
  check_three_connected(graph);
  if (face.value < 0 || face.value >= static_cast<int>(graph.faces.size()))
    throw Error(ErrorCode::invalid_argument, fmt::format("there is no face {} to extend; the cell has {}",
                                                         face.value, graph.faces.size()));
  const CellIncidence incidence(graph);
  const CellPlaces places(graph, incidence, options.may_be_split);
  const CellGraph::Corners& corners = graph.face(face);
  const int n = static_cast<int>(corners.size());
  LoopList list;
  for (const auto& [first, count] : non_convex_chains(graph, incidence.sides(face))) {
    // The face walks its chain forwards, with itself to the left.
    std::vector<int> chain;
    for (int k = 0; k <= count; ++k) chain.push_back(corners[(first + k) % n].value);
    const LoopWalk::Visit visit = [&, length = count](const std::vector<int>& path) {
      CuttingLoop loop = places.loop(path);
      for (int k = 0; k < length; ++k) loop.steps[k].extension = Extension::left;
      if (why_invalid(graph, incidence, loop)) return true;
      list.complete = static_cast<int>(list.loops.size()) < options.max_loops;
      if (list.complete) list.loops.push_back(std::move(loop));
      return list.complete;
    };
    LoopWalk(places.graph(), options.max_length, visit).starting_with(chain);
  }
  return list;
}

}  // namespace isopatch::segmentation
