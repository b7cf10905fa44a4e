#include "segmentation/decomposition/combinatorics/internal/loop_candidates.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <set>
#include <utility>

#include "segmentation/decomposition/combinatorics/constructive_loop.hpp"
#include "segmentation/decomposition/combinatorics/internal/hexahedra_estimate.hpp"
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

// Through existing vertices, and some shorter ones with new vertices: a carrier seldom meets others.
void append_extending(std::vector<CuttingLoop>& loops, const CellGraph& graph, FaceId face,
                      const LoopOptions& options) {
  LoopOptions longer = options;
  longer.max_length = 2 * options.max_length;
  append(loops, extending_loops(graph, face, longer));
  LoopOptions through_new = options;
  through_new.may_be_split = edges_of_kind(graph, false);
  through_new.max_loops = 300;
  LoopList more = extending_loops(graph, face, through_new);
  std::erase_if(more.loops, [](const CuttingLoop& loop) { return loop.auxiliary_vertices() == 0; });
  append(loops, std::move(more));
}

std::vector<CuttingLoop> loops_extending_faces(const CellGraph& graph, const LoopOptions& options) {
  std::vector<CuttingLoop> loops;
  for (int f = 0; f < static_cast<int>(graph.faces.size()); ++f)
    append_extending(loops, graph, FaceId(f), options);
  return loops;
}

std::vector<CuttingLoop> loops_through_non_convex_edges(const CellGraph& graph, LoopOptions options) {
  std::vector<CuttingLoop> loops;
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

// What is known of a loop's cost without cutting.
double quick_cost(const CellGraph& graph, const CellIncidence& incidence, const CuttingLoop& loop,
                  const CostOptions& weight) {
  const double length = weight.length * std::abs(loop.length() - 4);
  if (loop.extends()) return length;
  return length + weight.auxiliary_edge * loop.auxiliary_edges() +
         weight.auxiliary_vertex * loop.auxiliary_vertices() +
         weight.hexahedra * estimate_change(graph, incidence, loop);
}

// One batch after the other, the best first; of equally good ones the first.
void keep_batch(const CellGraph& graph, const CellIncidence& incidence, std::vector<CuttingLoop>& loops,
                int size, int batch, const CostOptions& weight) {
  const auto count = static_cast<std::ptrdiff_t>(loops.size());
  const std::ptrdiff_t begin = std::min<std::ptrdiff_t>(count, static_cast<std::ptrdiff_t>(size) * batch);
  const std::ptrdiff_t end = std::min<std::ptrdiff_t>(count, begin + size);
  std::vector<std::pair<double, int>> order;
  for (int k = 0; k < static_cast<int>(count); ++k)
    order.emplace_back(quick_cost(graph, incidence, loops[k], weight), k);
  std::partial_sort(order.begin(), order.begin() + end, order.end());
  std::vector<CuttingLoop> best;
  for (std::ptrdiff_t k = begin; k < end; ++k) best.push_back(std::move(loops[order[k].second]));
  loops = std::move(best);
}

class CandidateList {
 public:
  CandidateList(const SearchCell& cell, const CellIncidence& incidence, HexahedraCount& count,
                const SearchOptions& options)
      : cell_(cell), incidence_(incidence), count_(count), options_(options) {}

  void add(const CuttingLoop& loop) {
    if (!known_.insert(normal_form(loop)).second || why_invalid(cell_.graph, incidence_, loop)) return;
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
                                           CandidateStage stage, int batch, HexahedraCount& count,
                                           const SearchOptions& options) {
  const CellGraph& graph = cell.graph;
  const CellIncidence incidence(graph);
  LoopOptions wanted;
  wanted.max_length = options.max_length;
  std::vector<CuttingLoop> loops, extending;
  if (stage == CandidateStage::non_convex) {
    if (options.extensions) extending = loops_extending_faces(graph, wanted);
    loops = loops_through_non_convex_edges(graph, wanted);
  }
  if (stage == CandidateStage::anywhere) loops = loops_anywhere(graph, wanted);
  if (stage == CandidateStage::new_vertices) loops = loops_with_new_vertices(graph, wanted);
  // Most of those that extend faces cost little to refuse, and the best are worth a longer look.
  keep_batch(graph, incidence, extending, 3 * options.considered, batch, options.cost);
  keep_batch(graph, incidence, loops, options.considered, batch, options.cost);
  CandidateList list(cell, incidence, count, options);
  // Of a solid with hundreds of sides there may be a hundred thousand.
  std::vector<CuttingLoop> first = proposed;
  const int most_proposed = 20 * options.considered;
  if (static_cast<int>(first.size()) > most_proposed)
    keep_batch(graph, incidence, first, most_proposed, 0, options.cost);
  for (const CuttingLoop& loop : first) list.add(loop);
  for (const CuttingLoop& loop : extending) list.add(loop);
  for (const CuttingLoop& loop : loops) list.add(loop);
  return std::move(list).sorted();
}

}  // namespace isopatch::segmentation
