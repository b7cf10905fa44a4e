#include "segmentation/decomposition/combinatorics/internal/search_cells.hpp"

#include <functional>
#include <utility>

namespace isopatch::segmentation {
namespace {

CandidateStage after(CandidateStage stage) {
  return static_cast<CandidateStage>(static_cast<int>(stage) + 1);
}

bool is_accepted(const SearchOracle& oracle, const SearchCell& cell, const BaseSolid& solid) {
  if (!oracle.accepts && (solid.kind == BaseKind::simple || solid.kind == BaseKind::convex)) return false;
  return oracle.accepts ? oracle.accepts(cell, solid) : non_convex_count(cell.graph) == 0;
}

}  // namespace

int SearchCells::add(SearchCell cell) {
  if (!is_three_connected(cell.graph)) return -1;
  Entry entry;
  entry.base = base_solid(cell.graph);
  if (entry.base && !is_accepted(oracle_, cell, *entry.base)) entry.base.reset();
  entry.cost = cell_cost(cell.graph, count_, options_.cost);
  if (entry.base && entry.base->kind != BaseKind::hexahedron) entry.cost += options_.cost.divided;
  if (!entry.base) entry.other = other_solid(cell);
  if (entry.other)
    entry.other_cost = options_.cost.hexahedra * template_hexahedra(entry.other->kind, entry.other->sides) +
                       2 * options_.cost.divided;
  CodeOptions with_kinds;
  with_kinds.edge_kinds = true;
  entry.fingerprint = std::hash<CanonicalCode>()(canonical_code(cell.graph, with_kinds));
  entry.cell = std::move(cell);
  entries_.push_back(std::move(entry));
  return static_cast<int>(entries_.size()) - 1;
}

std::optional<BaseSolid> SearchCells::other_solid(const SearchCell& cell) const {
  if (const auto simple = simple_solid(cell.graph); simple && is_accepted(oracle_, cell, *simple))
    return simple;
  if (options_.finish != Finish::convex_solids) return std::nullopt;
  const BaseSolid convex = convex_solid(cell.graph);
  return is_accepted(oracle_, cell, convex) ? std::optional(convex) : std::nullopt;
}

const std::vector<CutOption>& SearchCells::options(int number, int wanted) {
  Entry& entry = entries_[static_cast<std::size_t>(number)];
  while (static_cast<int>(entry.options.size()) < wanted && entry.refusals < options_.refusals) {
    if (entry.next_candidate < entry.candidates.size())
      try_next(number);
    else if (!entry.options.empty() || !prepare_next_batch(entry))
      break;
  }
  return entry.options;
}

bool SearchCells::prepare_next_batch(Entry& entry) {
  std::vector<CuttingLoop> proposed;
  if (entry.batch < 0) {
    entry.stage =
        non_convex_count(entry.cell.graph) > 0 ? CandidateStage::non_convex : CandidateStage::anywhere;
    if (oracle_.propose) proposed = oracle_.propose(entry.cell);
  }
  entry.next_candidate = 0;
  for (; entry.stage != CandidateStage::none; entry.stage = after(entry.stage), entry.batch = -1) {
    entry.candidates = loop_candidates(entry.cell, proposed, entry.stage, ++entry.batch, count_, options_);
    if (!entry.candidates.empty()) return true;
  }
  entry.candidates.clear();
  entry.batch = 0;
  return false;
}

void SearchCells::try_next(int number) {
  // The deque keeps the entry where it is while its pieces are added.
  Entry& entry = entries_[static_cast<std::size_t>(number)];
  const LoopCandidate& candidate = entry.candidates[entry.next_candidate++];
  if (!entry.tried.insert(normal_form(candidate.loop)).second) return;
  CutAnswer answer = oracle_.cut(entry.cell, candidate.loop);
  ++evaluations_;
  CutOption option{candidate.loop, {}, candidate.penalty + answer.penalty};
  bool good = answer.pieces.size() > 1;
  for (SearchCell& piece : answer.pieces) {
    option.pieces.push_back(good ? add(std::move(piece)) : -1);
    good = good && option.pieces.back() >= 0;
  }
  if (good) {
    entry.options.push_back(std::move(option));
  } else {
    ++entry.refusals;
    ++refusals_;
  }
}

}  // namespace isopatch::segmentation
