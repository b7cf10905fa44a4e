#include "segmentation/decomposition/combinatorics/internal/loop_candidates.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <utility>

#include "segmentation/decomposition/combinatorics/constructive_loop.hpp"
#include "segmentation/decomposition/combinatorics/internal/loop_excess.hpp"
#include "segmentation/decomposition/combinatorics/internal/separation.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/combinatorics/loop_validity.hpp"

namespace isopatch::segmentation {
namespace {

std::vector<EdgeId> edges_of_kind(const CellGraph& graph, bool non_convex) {
  std::vector<EdgeId> result;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    if ((graph.edges[e].kind == EdgeKind::non_convex) == non_convex) result.emplace_back(e);
  return result;
}

void append(std::vector<CuttingLoop>& loops, LoopList more) {
  std::move(more.loops.begin(), more.loops.end(), std::back_inserter(loops));
}

// New vertices on edges that are not convex would make two of one.
std::vector<EdgeId> splittable_impeding_edges(const CellGraph& graph, EdgeId edge) {
  std::vector<EdgeId> result = impeding_edges(graph, edge);
  std::erase_if(result, [&](EdgeId id) { return graph.edge(id).kind == EdgeKind::non_convex; });
  return result;
}

// Through existing vertices where that is possible; else short ones with new vertices.
LoopList loops_extending(const CellGraph& graph, FaceId face, LoopOptions options) {
  LoopList loops = extending_loops(graph, face, options);
  if (!loops.loops.empty()) return loops;
  options.may_be_split = edges_of_kind(graph, false);
  options.max_length = std::min(options.max_length, 6);
  options.max_loops = 500;
  return extending_loops(graph, face, options);
}

std::vector<CuttingLoop> loops_at_non_convex_edges(const CellGraph& graph, LoopOptions options) {
  std::vector<CuttingLoop> loops;
  for (int f = 0; f < static_cast<int>(graph.faces.size()); ++f)
    append(loops, loops_extending(graph, FaceId(f), options));
  for (const EdgeId edge : edges_of_kind(graph, true)) {
    options.may_be_split = splittable_impeding_edges(graph, edge);
    append(loops, valid_loops_through(graph, edge, options));
  }
  return loops;
}

// All, or the constructive one at least.
std::vector<CuttingLoop> loops_anywhere(const CellGraph& graph, const LoopOptions& options) {
  std::vector<CuttingLoop> loops = valid_loops(graph, options).loops;
  if (loops.empty() && graph.vertex_count > 4) loops.push_back(constructive_loop(graph));
  return loops;
}

// Short ones with new vertices anywhere.
std::vector<CuttingLoop> loops_with_new_vertices(const CellGraph& graph, LoopOptions options) {
  options.may_be_split = edges_of_kind(graph, false);
  options.max_length = std::min(options.max_length, 5);
  std::vector<CuttingLoop> loops = valid_loops(graph, options).loops;
  std::erase_if(loops, [](const CuttingLoop& loop) { return loop.auxiliary_vertices() == 0; });
  return loops;
}

// The part of a loop's cost that is known without cutting.
double quick_cost(const CellGraph& graph, const CellIncidence& incidence, const CuttingLoop& loop,
                  const CostOptions& weight) {
  return weight.length * std::abs(loop.length() - 4) + weight.auxiliary_edge * loop.auxiliary_edges() +
         weight.auxiliary_vertex * loop.auxiliary_vertices() +
         (loop.extends() ? -1000 : weight.hexahedra * excess_change(graph, incidence, loop));
}

// The first of equal loops stays; proposals come first and stay all.
void keep_best(const CellGraph& graph, const CellIncidence& incidence, std::vector<CuttingLoop>& loops,
               int most, const CostOptions& weight) {
  if (static_cast<int>(loops.size()) <= most) return;
  std::vector<std::pair<double, int>> order;
  for (int k = 0; k < static_cast<int>(loops.size()); ++k)
    order.emplace_back(quick_cost(graph, incidence, loops[k], weight), k);
  std::partial_sort(order.begin(), order.begin() + most, order.end());
  std::vector<CuttingLoop> best;
  for (int k = 0; k < most; ++k) best.push_back(std::move(loops[order[k].second]));
  loops = std::move(best);
}

class CandidateList {
 public:
  CandidateList(const SearchCell& cell, const CellIncidence& incidence, HexahedraCount& count,
                const SearchOptions& options)
      : cell_(cell), incidence_(incidence), count_(count), options_(options) {}

  void add(const CuttingLoop& loop) {
    if (!known_.insert(loop).second || why_invalid(cell_.graph, incidence_, loop)) return;
    const Separation cut = separate(cell_.graph, loop);
    if (!cut.pieces) return;
    const CostOptions& weight = options_.cost;
    const LoopCost cost =
        loop_cost(cell_.graph, incidence_, cell_.geometry, loop, *cut.pieces, count_, weight);
    const double pieces =
        weight.hexahedra * cost.hexahedra + weight.flat * cost.flat + weight.non_convex * cost.non_convex;
    list_.push_back({loop, cost.total - pieces, cost.total});
  }

  std::vector<LoopCandidate> sorted() && {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const LoopCandidate& a, const LoopCandidate& b) { return a.total < b.total; });
    return std::move(list_);
  }

 private:
  const SearchCell& cell_;
  const CellIncidence& incidence_;
  HexahedraCount& count_;
  const SearchOptions& options_;
  std::set<CuttingLoop> known_;
  std::vector<LoopCandidate> list_;
};

}  // namespace

std::vector<LoopCandidate> loop_candidates(const SearchCell& cell, const std::vector<CuttingLoop>& proposed,
                                           CandidateStage stage, HexahedraCount& count,
                                           const SearchOptions& options) {
  const CellGraph& graph = cell.graph;
  const CellIncidence incidence(graph);
  LoopOptions wanted;
  wanted.max_length = options.max_length;
  std::vector<CuttingLoop> loops;
  if (stage == CandidateStage::non_convex) loops = loops_at_non_convex_edges(graph, wanted);
  if (stage == CandidateStage::anywhere) loops = loops_anywhere(graph, wanted);
  if (stage == CandidateStage::new_vertices) loops = loops_with_new_vertices(graph, wanted);
  keep_best(graph, incidence, loops, options.considered, options.cost);
  CandidateList list(cell, incidence, count, options);
  for (const CuttingLoop& loop : proposed) list.add(loop);
  for (const CuttingLoop& loop : loops) list.add(loop);
  return std::move(list).sorted();
}

}  // namespace isopatch::segmentation
